"""The page of a study, and the bands that a run shows of one, in a browser: python3 study_page_test.py PROGRAM FOLDER"""

import csv
import json
import pathlib
import shutil

import browser
from browser import By, Keys, number, place, run
from viewer_pages import ViewerPages, surface_block


class StudyPage(ViewerPages):
    def test_a_study_shows_values_bands_and_what_an_error_costs(self):
        run("converge", "two_blocks", "--meshes", "1/2,1,2", "--only", "step", "--only", "chance", "--ensemble", "2", "--quiet",
            "--of", "energy.kinetic", "--of", "energy.internal", "--out", "study", "--page", "study.html", "--json", "study.json",
            "--csv", "study.csv")
        study = json.loads(place("study.json").read_text())
        self.open("study.html")
        self.assertEqual(self.one("#status").text, "done")
        self.assertIn(study["sentence"], self.one("#sentence").text)
        rows = [[cell.text for cell in row.find_elements(By.CSS_SELECTOR, "th, td")] for row in self.all("#quantity_table tbody tr")]
        self.assertEqual([row[0].split(" ")[0] for row in rows], ["energy.kinetic", "energy.internal"])
        for row, quantity in zip(rows, study["quantities"], strict=True):
            self.assertEqual(row[-1], quantity["verdict"])
            for text, value in zip(row[1:4], quantity["values"], strict=True):
                self.assertAlmostEqual(number(text), value, delta=1e-5 * abs(value))
        self.assertEqual(len(self.all("#run_table tbody tr")), 3 + 1 + 2)
        self.assertEqual(len(self.all("#source_table tbody tr")), 2)
        banded = sum(quantity["band"] is not None for quantity in study["quantities"])
        self.assertEqual(len(self.all("#values .plot")), 2)
        self.assertEqual(len(self.all("#values .plot .band")), banded)
        self.assertEqual(len(self.all("#values .plot circle.run")), 2 * 3)
        self.assertEqual(len(self.all("#costs .plot")), banded)
        self.assert_points_are_inside()
        with open(place("study.csv"), encoding="utf-8") as file:
            lines = list(csv.DictReader(file))
        self.assertEqual(len(lines), 2 * len(study["points"]))
        self.assertEqual({line["run"] for line in lines}, {point["settings"] for point in study["points"]})
        self.assertEqual(float(lines[0]["value"]), study["quantities"][0]["values"][0])
        picture = self.all("#pictures img")
        if picture:
            self.assertGreater(self.browser.execute_script("return arguments[0].naturalWidth", picture[0]), 400)
        else:
            self.assertIn("No pictures: ", self.one("#pictures .note").text)

    def test_the_coarsest_and_the_finest_run_are_seen_beside_each_other(self):
        """With one camera, one time and one scale of colours, each with its own mesh: that of the runs themselves."""
        shutil.rmtree(place("seen"), ignore_errors=True)
        run("converge", "taylor_bar", "--meshes", "1/4,1/2,1", "--only", "mesh", "--quiet", "--of", "energy.kinetic", "--set", "time.end=0.02",
            "--out", "seen", "--page", "seen.html", environment={"PINBALL_PYTHON": "/no/such/python"})
        self.open_page("seen.html")
        packed = json.loads(place("seen.html").read_text().split('id="surfaces">')[1].split("</script>")[0])
        self.assertEqual([one["mesh"] for one in packed], ["1/4", "1"])
        for one, folder in zip(packed, ["mesh_1_4", "mesh_1"], strict=True):
            self.assertEqual(one["surface"], json.loads(surface_block(f"seen/{folder}")))
            self.assertEqual(len(one["surface"]["times"]), 9)
            summary = json.loads(place(f"seen/{folder}/summary.json").read_text())
            self.assertEqual(one["surface"]["times"][-1], summary["end_time"])
        self.assertEqual(len(self.all("#viewer canvas")), 2)
        self.assertEqual(len(self.all("#viewer select[aria-label=field]")), 1)
        self.assertIn("Shape and fields", self.texts("nav a"))
        summaries = [json.loads(place(f"seen/{folder}/summary.json").read_text()) for folder in ("mesh_1_4", "mesh_1")]
        for title, mesh, summary in zip(self.texts(".drawing .title"), ["1/4", "1"], summaries, strict=True):
            self.assertTrue(title.startswith(f"mesh {mesh}, {summary['elements']:,} elements, t = "), title)
        self.assertGreater(summaries[1]["elements"], 20 * summaries[0]["elements"])

        state = """return viewer.all.map((v) => [v.camera.axes, v.camera.height, v.camera.centre, v.surface.fields[v.field].name,
                                                 v.surface.fields[v.field].range])"""
        times = "return viewer.all.map((v) => v.surface.times[v.frame])"
        before = self.js(state)
        self.assertEqual(before[0], before[1])
        self.assertEqual(self.js(times), [summaries[0]["end_time"]] * 2)
        canvas = self.all("#viewer canvas")[1]
        canvas.send_keys(Keys.ARROW_LEFT, Keys.ARROW_UP, ",")
        after = self.js(state)
        self.assertEqual(after[0], after[1])
        self.assertNotEqual(after[0][0], before[0][0], "turned")
        coarse, fine = self.js(times)
        self.assertEqual(coarse, packed[0]["surface"]["times"][-2], "a state back in time")
        self.assertEqual(fine, packed[1]["surface"]["times"][-2])
        self.assertLessEqual(abs(coarse - fine), summaries[0]["dt"]["max"], "each at the end of a step of its own")
        name, shown = after[0][3:]
        ranges = [field["range"] for one in packed for field in one["surface"]["fields"] if field["name"] == name]
        self.assertEqual(shown, [min(r[0] for r in ranges), max(r[1] for r in ranges)])
        drawn = self.js("viewer.all.forEach((v) => v.drawNow()); return viewer.all.map((v) => v.canvas.toDataURL())")
        self.assertNotEqual(*drawn)

    def test_a_study_whose_runs_all_fail_says_so(self):
        run("converge", "two_blocks", "--meshes", "1/2,1,2", "--only", "mesh", "--quiet", "--of", "energy.kinetic", "--out", "none",
            "--set", "guard.energy_error=1e-12", "--page", "failed.html", status=1)
        self.open("failed.html")
        self.assertEqual(self.one("#viewer .note").text, "No run has left fields of its bodies.")
        self.assertEqual(self.all("#viewer canvas"), [])

    def test_a_run_shows_the_bands_that_were_kept(self):
        scene = place("kept.toml")
        scene.write_text((pathlib.Path(__file__).resolve().parents[2] / "data/scenes/two_blocks.toml").read_text())
        run("converge", "kept.toml", "--meshes", "1/2,1,2", "--only", "mesh", "--quiet", "--of", "upper_velocity_z", "--out", "kept_study", "--keep")
        (band,) = json.loads(place("kept.converged.json").read_text())["quantities"]
        run("run", "kept.toml", "--quiet", "--out", "kept")
        self.open("kept/index.html")
        self.assertIn("Error bands", self.texts("nav a"))
        cells = [cell.text for cell in self.all("#band_table tbody tr th, #band_table tbody tr td")]
        self.assertEqual(cells[0], "upper_velocity_z [m/s]")
        self.assertAlmostEqual(number(cells[1]), band["value"], delta=1e-4)
        self.assertAlmostEqual(number(cells[2]), band["error"], delta=0.06 * band["error"])
        self.assertAlmostEqual(number(cells[3].split(" to ")[0]), band["low"], delta=1e-4)
        self.assertEqual(cells[5], band["verdict"])

    def assert_points_are_inside(self):
        """Points of a plot lie in it, and no two of a curve at one place."""
        for drawing in self.all(".plot svg"):
            width, height = (float(v) for v in drawing.get_dom_attribute("viewBox").split()[2:])
            for circle in drawing.find_elements(By.CSS_SELECTOR, "circle"):
                self.assertTrue(0 < float(circle.get_dom_attribute("cx")) < width, circle.get_dom_attribute("cx"))
                self.assertTrue(0 < float(circle.get_dom_attribute("cy")) < height, circle.get_dom_attribute("cy"))

    def test_a_study_says_why_there_are_no_pictures(self):
        run("converge", "two_blocks", "--meshes", "1/2,1,2", "--only", "mesh", "--quiet", "--of", "energy.kinetic", "--out", "study",
            "--page", "bare.html", environment={"PINBALL_PYTHON": "/no/such/python"})
        self.open("bare.html")
        self.assertEqual(self.one("#pictures .note").text, "No pictures: /no/such/python does not start (No such file or directory)")
        self.assertEqual(self.all("#source_table"), [])


if __name__ == "__main__":
    browser.main()
