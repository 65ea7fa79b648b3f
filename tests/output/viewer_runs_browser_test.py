"""The viewer in pages of all kinds of runs, in a browser: python3 viewer_runs_browser_test.py PROGRAM FOLDER"""

import base64
import json
import shutil
import signal
import subprocess
import time
import zlib

import browser
from browser import place, run
from viewer_pages import ViewerPages, files_of, surface_block


class OtherRuns(ViewerPages):
    def test_a_run_without_fields_shows_its_first_and_last_state(self):
        run("run", "rod_plate", "--quiet", "--out", "bare", "--set", "output.field_times=[]", "--set", "time.end=2e-5")
        self.open_viewer("bare")
        self.assertEqual(self.js("return viewer.surface.times"), [0, 2e-5])
        self.assertGreater(self.js("return viewer.surface.fields.length"), 5)

    def test_fifty_thousand_elements_at_thirty_times_are_a_page_of_six_megabytes(self):
        run("run", "rod_plate", "--refine", "3", "--quiet", "--out", "large", "--set", "output.field_times=[]", "--set", "time.end=2.5e-5",
            "--set", f"output.field_interval={2.5e-5 / 29!r}")
        self.assertLess(place("large/index.html").stat().st_size, 6e6)
        self.open_viewer("large")
        self.assertEqual(self.js("return viewer.surface.times.length"), 30)
        self.assertGreater(self.js("return viewer.surface.faces.count"), 18000)

    def test_a_run_that_was_killed_and_goes_on_has_the_same_page(self):
        settings = ["rod_plate", "--quiet", "--refine", "2", "--set", "output.field_times=[]", "--set", "output.field_interval=2e-6", "--set", "time.end=2e-5"]
        shutil.rmtree(place("broken"), ignore_errors=True)
        run("run", *settings, "--out", "whole")
        process = subprocess.Popen([browser.program, "run", *settings, "--out", "broken", "--checkpoint-every", "50"], cwd=browser.folder,
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        for _ in range(2000):
            if (place("broken/fields_0003.vtu")).exists() and place("broken/checkpoint.pinball").exists():
                break
            time.sleep(0.005)
        process.send_signal(signal.SIGKILL)
        process.wait()
        self.assertFalse(place("broken/fields_0010.vtu").exists(), "it was killed before its end")
        run("run", "--restart", "broken/checkpoint.pinball", "--out", "broken", "--quiet")
        self.assertEqual(surface_block("broken"), surface_block("whole"))

    def test_numbers_are_those_of_the_mesh_file(self):
        run("run", "crushed_tube", "--quiet", "--out", "tube", "--set", "time.steps=20", "--set", "output.field_interval=0", "--set", "output.field_times=[0]")
        (_, mesh), = files_of("tube")
        self.open_viewer("tube")
        for kind, numbers in (("elements", mesh.cell_data["element_number"]), ("nodes", mesh.point_data["node_number"])):
            list_ = self.js("return viewer.surface[arguments[0]]", kind)
            expected = [int(numbers[int(p)]) for p in list_["place"]]
            self.assertEqual(list_["number"], expected)
            self.assertTrue(any(n >= 0 and n != p for n, p in zip(expected, list_["place"])), "numbers that are no places")

    def test_a_program_without_zlib_has_the_same_numbers_as_they_are(self):
        run("run", "two_blocks", "--quiet", "--out", "plain", "--set", "time.steps=20")
        page, packed = place("plain/index.html"), json.loads(surface_block("plain"))
        self.open_viewer("plain")
        numbers = "const {frames, faces} = viewer.surface; return [[...faces.corners], frames.map((f) => [...f.positions, ...f.fields].map((c) => [...c]))]"
        expected = self.js(numbers)
        bytes_ = base64.b64decode(packed["data"])
        if packed["encoding"] == "deflate":
            bytes_ = zlib.decompress(bytes_)
        plain = {**packed, "encoding": "none", "data": base64.b64encode(bytes_).decode()}
        page.write_text(page.read_text().replace(surface_block("plain"), json.dumps(plain)))
        self.open_viewer("plain")
        self.assertEqual(self.js(numbers), expected)
        self.assertGreater(len(expected[0]), 20)

    def test_variants_are_seen_beside_each_other(self):
        """With one camera, one time and one scale of colours, each with its own state."""
        run("compare", "rod_plate", "--vary", "contact.enforcement=penalty,lagrange", "--repeat", "1", "--quiet", "--set", "time.end=2e-5",
            "--page", "compare.html")
        self.open_page("compare.html")
        self.assertEqual(len(self.all("#viewer canvas")), 2)
        self.assertEqual(len(self.all("#viewer select[aria-label=field]")), 1)
        self.js("viewer.look('side'); viewer.camera.turn(30, 10); viewer.chooseField(0); viewer.step(4); viewer.cutAlong('z');")
        both = self.js("""return viewer.all.map((v) => [v.camera.axes, v.camera.height, v.cutPlane().at, v.frame, v.surface.fields[v.field].name,
                                                        v.surface.fields[v.field].range])""")
        self.assertEqual(both[0], both[1])
        titles = self.texts(".drawing .title")
        self.assertIn("penalty", titles[0])
        self.assertIn("lagrange", titles[1])
        kinetic = json.loads(place("compare.html").read_text().split('id="comparison">')[1].split("</script>")[0])["variants"]
        self.assertNotEqual(*[v["summary"]["state_hash"] for v in kinetic])
        self.assertNotEqual(*self.js("return viewer.all.map((v) => [...v.surface.frames[8].fields[0]])"), "states of their own")
        self.js("viewer.frame = 8; viewer.all.forEach((v) => v.showFrame(8)); viewer.cutAlong(''); viewer.all.forEach((v) => v.drawNow());")
        drawn = self.js("return viewer.all.map((v) => v.canvas.toDataURL())")
        self.assertNotEqual(*drawn)

    def test_without_webgl_there_is_a_sentence(self):
        script = self.browser.execute_cdp_cmd("Page.addScriptToEvaluateOnNewDocument", {"source": """
            const get = HTMLCanvasElement.prototype.getContext;
            HTMLCanvasElement.prototype.getContext = function (kind, ...more) { return kind === 'webgl2' ? null : get.call(this, kind, ...more); };"""})
        try:
            run("run", "two_blocks", "--quiet", "--out", "none", "--set", "time.steps=20")
            self.open("none/index.html")
            self.assertIn("WebGL 2", self.one("#viewer .note").text)
            self.assertEqual(self.all("#viewer canvas"), [])
            self.expect_curves()
        finally:
            self.browser.execute_cdp_cmd("Page.removeScriptToEvaluateOnNewDocument", {"identifier": script["identifier"]})

    def test_what_cannot_be_read_is_told(self):
        run("run", "two_blocks", "--quiet", "--out", "told", "--set", "time.steps=20")
        page = place("told/index.html")
        page.write_text(page.read_text().replace(surface_block("told"), json.dumps({"error": "cannot read fields_0001.vtu"})))
        self.open("told/index.html")
        self.assertEqual(self.one("#viewer .note").text, "The bodies cannot be shown here: cannot read fields_0001.vtu.")


if __name__ == "__main__":
    browser.main()
