"""The pages of runs, comparisons and verifications, in a browser: python3 page_browser_test.py PROGRAM FOLDER"""

import csv
import json

import browser
from browser import By, Keys, Pages, number, place, run

# A pixel, as `pinball view` puts pictures.
PIXEL = ("data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNk+M9QDwADhgGAWjR9awAAAABJRU5ErkJggg==")


class RunPage(Pages):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        run("run", "rod_plate", "--quiet", "--out", "run", "--set", "time.end=2e-5", "--set", "contact.enforcement=penalty",
            "--set", "output.field_interval=0")

    def setUp(self):
        self.open("run/index.html")

    def test_tells_what_the_run_was(self):
        self.assertEqual(self.one("#status").text, "done")
        self.assertIn("Copper rod", self.one("h1").text)
        figures = dict(text.split("\n") for text in self.texts("#figures .figure"))
        self.assertEqual(figures["elements"], "1,842")
        summary = json.loads(place("run/summary.json").read_text())
        self.assertEqual(figures["state"], summary["state_hash"])
        self.assertEqual(self.all(".error"), [])
        for part in ["Energies", "Bodies", "Momentum", "Contact and forces", "Where the time went", "The scene"]:
            self.assertIn(part, self.texts("h2"))
        self.assertEqual(self.texts("nav a"), [h for h in self.texts("h2") if h], "links to what is there")

    def test_draws_curves(self):
        self.expect_curves()

    def test_small_energies_have_panels_of_their_own(self):
        large, small = self.values(self.panel("Energy")), self.values(self.panel("Small energies"))
        smallest = self.values(self.panel("Small energies, smallest"))
        self.assertIn("kinetic", large)
        self.assertIn("total", large)
        self.assertIn("contact stored", small)
        self.assertIn("hourglass", {**small, **smallest})
        self.assertFalse(set(large) & set(small))
        self.assertIn("lbf in", self.panel("Small energies").find_element(By.CSS_SELECTOR, ".axis").text)

    def test_every_curve_is_that_of_its_column(self):
        with open(place("run/history.csv"), encoding="utf-8") as file:
            rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
        columns = {"Momentum": "momentum_{}", **{title: "{}" for title in ("Energy", "Small energies", "Small energies, smallest")}}
        for body in ["rod", "plate"]:
            columns.update({f"Velocity of {body}": body + "_velocity_{}", f"Contact force on {body}": body + "_contact_force_{}"})
        seen = set()
        for title, column in columns.items():
            for row in self.panel(title).find_elements(By.CSS_SELECTOR, "details tbody tr"):
                name, *shown = [cell.get_attribute("textContent") for cell in row.find_elements(By.CSS_SELECTOR, "th, td")]
                key = column.format(name.replace(" ", "_"))
                values = [float(r[key]) for r in rows]
                seen.add(key)
                for text, value in zip(shown, [values[0], min(values), max(values), values[-1]], strict=True):
                    self.assertAlmostEqual(number(text.split(" at ")[0]), value, delta=1e-3 * abs(value) + 1e-300, msg=f"{title}: {key}")
        for key in ["kinetic", "internal", "hourglass", "total", "momentum_y", "momentum_z", "rod_velocity_x", "plate_contact_force_z"]:
            self.assertIn(key, seen)

    def test_energies_have_the_largest_of_their_columns(self):
        with open(place("run/history.csv"), encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        for line in self.all("#energy_table tbody tr"):
            name, _, _, shown, *_ = [cell.text for cell in line.find_elements(By.CSS_SELECTOR, "th, td")]
            largest = max((float(row[name.replace(" ", "_")]) for row in rows), key=abs)
            self.assertAlmostEqual(number(shown), largest, delta=6e-5 * abs(largest), msg=name)

    def test_shows_the_contact_force_on_each_body(self):
        for body in ["rod", "plate"]:
            panel = self.panel(f"Contact force on {body}")
            self.assertEqual(set(self.values(panel)), {"x", "y", "z"})
            self.assertRegex(panel.find_element(By.CSS_SELECTOR, ".axis").text, r"\[(10.+ )?lbf\]$")

    def test_hovering_shows_values_at_one_time_in_all_panels(self):
        panel = self.panel("Energy")
        self.assertEqual(set(self.values(panel).values()), {""})
        self.hover(panel)
        values = self.values(panel)
        self.assertNotIn("", values.values())
        self.assertRegex(values["kinetic"], r"^4\.\d+×10⁶$")
        now = panel.find_element(By.CSS_SELECTOR, ".now").text
        self.assertRegex(now, r"^at [\d.]+ µs$", "the unit of the axis")
        self.assertIn("time [µs]", panel.text)
        other = self.panel("Momentum")
        self.assertEqual(other.find_element(By.CSS_SELECTOR, ".now").text, now)
        self.hover(panel, 0.8)
        self.assertNotEqual(panel.find_element(By.CSS_SELECTOR, ".now").text, now)

    def test_arrow_keys_move_through_time(self):
        chart = self.panel("Momentum").find_element(By.CSS_SELECTOR, ".chart")
        chart.send_keys(Keys.ARROW_RIGHT)
        first = self.panel("Momentum").find_element(By.CSS_SELECTOR, ".now").text
        chart.send_keys(Keys.ARROW_RIGHT)
        self.assertRegex(first, "^at ")
        self.assertNotEqual(self.panel("Momentum").find_element(By.CSS_SELECTOR, ".now").text, first)

    def test_legend_hides_a_curve(self):
        panel = self.panel("Momentum")
        pixels = lambda: self.browser.execute_script("""
            const canvas = arguments[0].querySelector('canvas');
            return canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data.filter((v) => v > 0).length;""", panel)
        before = pixels()
        button = panel.find_element(By.CSS_SELECTOR, ".legend button")
        self.browser.execute_script("arguments[0].scrollIntoView({block: 'center'})", button)
        button.click()
        self.assertEqual(button.get_attribute("aria-pressed"), "false")
        self.assertLess(pixels(), before)

    def test_filters_the_keys_of_the_scene(self):
        rows = lambda: [text for text, _ in self.shown("#keys tbody tr")]
        everything = rows()
        self.assertGreater(len(everything), 60)
        self.one("#scene_keys input[type=search]").send_keys("contact skin")
        self.assertEqual(rows(), ["contact.skin 0.5 default"])
        self.one("#scene_keys input[type=search]").clear()
        box = self.one("#scene_keys input[type=checkbox]")
        box.click()
        chosen = rows()
        self.assertLess(len(chosen), len(everything))
        self.assertIn("time.end 2e-05 s", chosen)
        self.assertFalse([row for row in chosen if row.endswith("default")])
        self.assertIn("--set time.end=2e-5", self.one("#scene_keys pre code").text)

    def test_shows_phases_and_what_was_skipped(self):
        phases = {row.text.split(" 0")[0].split(" 1")[0] for row in self.all("#phases tbody tr")}
        self.assertTrue(any(name.startswith("internal forces") for name in phases), phases)
        self.assertTrue(self.all("#phases .bar"))
        self.assertIn("searches for contact", self.one("#skipped table").text)

    def test_fits_a_phone_and_its_colours_follow_the_reader(self):
        self.browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride",
                                     {"width": 390, "height": 800, "deviceScaleFactor": 1, "mobile": True})
        self.browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": [{"name": "prefers-color-scheme", "value": "dark"}]})
        try:
            self.open("run/index.html")
            self.assertLessEqual(self.browser.execute_script("return document.documentElement.scrollWidth"), 390)
            self.assertEqual(self.browser.execute_script("return getComputedStyle(document.body).backgroundColor"), "rgb(20, 23, 27)")
            self.expect_curves()
        finally:
            self.browser.execute_cdp_cmd("Emulation.clearDeviceMetricsOverride", {})
            self.browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": []})

    def test_plays_the_frames_that_were_put_in(self):
        page = place("run/index.html")
        frames = "".join(f'<img loading="lazy" alt="frame {i}" src="{PIXEL}">' for i in range(3))
        begin, end = "<!-- pictures -->", "<!-- /pictures -->"
        head, rest = page.read_text().split(begin)
        titles = '[&quot;t = 0 ms&quot;, &quot;t = 0.5 ms&quot;, &quot;t = 1 ms (3 of 4 elements)&quot;]'
        stage = f'<div class="stage" style="--top:5%;--width:80%"><img class="surround" alt="" src="{PIXEL}">{frames}</div>'
        film = f'<div class="frames" data-titles="{titles}">{stage}</div>'
        (page.parent / "film.html").write_text(head + begin + film + end + rest.split(end)[1])
        self.open("run/film.html")
        shown = lambda: [image.get_attribute("alt") for image in self.all(".frames img:not(.surround)")
                         if image.get_attribute("hidden") is None]
        self.assertEqual(shown(), ["frame 0"])
        slider = self.one(".frames .player input")
        slider.send_keys(Keys.END)
        self.assertEqual(shown(), ["frame 2"])
        self.assertEqual(self.one(".frames .player output").text, "t = 1 ms (3 of 4 elements)")
        self.one(".frames .player button").click()
        self.assertEqual(self.one(".frames .player button").text, "Pause")


class Panels(Pages):
    """Curves of all kinds of numbers, put into a page in place of its own."""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        run("run", "two_blocks", "--quiet", "--out", "panels", "--set", "time.steps=20", "--set", "output.field_interval=0")

    def with_blocks(self, name, **changes):
        """A page with other columns of the history, {name: function of its values}, and other parts of the summary."""
        text = place("panels/index.html").read_text()
        for block, change in changes.items():
            head, rest = text.split(f'id="{block}">', 1)
            content, tail = rest.split("</script>", 1)
            text = f'{head}id="{block}">{json.dumps(change(json.loads(content)))}</script>{tail}'
        place(f"panels/{name}.html").write_text(text)
        self.open(f"panels/{name}.html")

    def with_columns(self, name, **columns):
        def change(history):
            rows = len(history["data"][0])
            for column, value in columns.items():
                history["data"][history["columns"].index(column)] = [value(i, rows) for i in range(rows)]
            return history
        self.with_blocks(name, history=change)

    def ticks(self, panel, axis="y"):
        return [text for text, _ in self.shown(f".dygraph-axis-label-{axis}", panel)]

    def expect_readable(self, panel):
        ticks = self.ticks(panel)
        self.assertGreater(len(ticks), 2)
        self.assertEqual(len(set(ticks)), len(ticks), ticks)
        for text, height in self.shown(".dygraph-axis-label-y", panel):
            self.assertLess(height, 24, f"{text} is on one line")
        self.assertEqual(len(set(self.ticks(panel, "x"))), len(self.ticks(panel, "x")))

    def test_ticks_differ_whatever_the_numbers_are(self):
        kinds = {
            "constant": lambda i, n: 2.2535e4, "zero": lambda i, n: 0.0, "one": lambda i, n: 1e-8,
            "tiny range": lambda i, n: 22535.0 + 0.03 * i / n, "round-off": lambda i, n: 22535.0 + 1e-9 * i,
            "huge": lambda i, n: 1e300 * i / n, "small": lambda i, n: 1e-300 * (i + 1), "denormal": lambda i, n: 5e-324 * i,
            "negative": lambda i, n: -3.0 - 1e-3 * i, "both signs": lambda i, n: (-1) ** i * 10.0 ** i,
            "gap": lambda i, n: None if i == 1 else 5.0 + i}
        for name, values in kinds.items():
            with self.subTest(name):
                self.with_columns("kinds", dt=values, balance_error=values)
                for title in ("Time step", "Error of the balance, of the initial total"):
                    self.expect_readable(self.panel(title))
                self.expect_curves()

    def test_ticks_of_a_comparison_differ_where_curves_hardly_do(self):
        run("compare", "two_blocks", "--vary", "time.cfl=0.5,0.6", "--repeat", "1", "--quiet", "--page", "narrow.html", "--set",
            "time.steps=20")
        page = place("narrow.html")
        head, rest = page.read_text().split('id="curves">', 1)
        content, tail = rest.split("</script>", 1)
        for spread in (0.05, 1e-6):
            curves = json.loads(content)
            for k, curve in enumerate(curves):
                rows = len(curve["data"][0])
                curve["data"][curve["columns"].index("total")] = [22535.0 + spread * (k + i / rows) for i in range(rows)]
            page.write_text(f'{head}id="curves">{json.dumps(curves)}</script>{tail}')
            self.open("narrow.html")
            self.expect_readable(self.panel("total energy"))
            self.expect_curves()

    def test_hovering_and_axes_have_one_unit(self):
        self.with_columns("units", dt=lambda i, n: 2e-7 * (i + 1), time=lambda i, n: 1e-6 * i)
        panel = self.panel("Time step")
        axes = [axis.text for axis in panel.find_elements(By.CSS_SELECTOR, ".axis")]
        self.assertEqual(axes, ["Time step [µs]", "time [µs]"])
        self.hover(panel, 1.0)
        now = panel.find_element(By.CSS_SELECTOR, ".now").text
        self.assertRegex(now, r"^at \d+ µs$")
        self.assertAlmostEqual(float(self.values(panel)["time step"]), 0.2 * (int(now.split()[1]) + 1), delta=1e-4)

    def test_what_is_no_number_is_told(self):
        self.with_columns("nan", kinetic=lambda i, n: None if i > 2 else 1.0 + i, hourglass=lambda i, n: None)
        told = self.texts("#energies .note.bad")
        self.assertTrue(any(text.startswith("kinetic is no number at") for text in told), told)
        self.assertTrue(any(text.startswith("hourglass is no number at") for text in told), told)
        self.assertNotIn("hourglass", " ".join(self.texts("#energies > .note")), "zero throughout")

    def test_round_off_is_no_motion(self):
        noise = lambda i, n: (-1) ** i * 1e-16
        self.with_columns("noise", **{f"lower_velocity_{k}": noise for k in "xyz"}, **{f"momentum_{k}": noise for k in "xyz"})
        titles = self.texts("figure.panel h3")
        self.assertNotIn("Velocity of lower", titles)
        self.assertNotIn("Momentum", titles)
        self.assertIn("Velocity of upper", titles)
        self.assertIn("Velocity of lower: zero but for round-off.", self.texts("#bodies .note"))

    def test_warnings_come_first_and_leave_room(self):
        for count, shown in ((0, 0), (1, 1), (8, 8), (20, 6)):
            text = "bodies went into each other by up to 40 % of the radii of their pinballs: try a larger contact.beta"
            self.with_blocks("warned", summary=lambda s: {**s, "warnings": [f"{i}: {text}" for i in range(count)]})
            self.assertEqual(len(self.all("#warnings > ul li")), shown)
            if count == 0:
                continue
            self.assertIn("One warning" if count == 1 else f"{count} warnings", self.texts("nav a"))
            self.assertLess(self.one("#warnings").location["y"], self.one("#energies").location["y"])
            if count > shown:
                self.assertEqual(self.one("#warnings summary").text, f"{count - shown} more warnings")
                self.assertEqual(len(self.all("#warnings li")), count)

    def test_energies_that_are_not_sound_are_red_with_what_to_try(self):
        told = "hourglass forces made energy out of nothing: try a finer mesh"
        change = lambda checks: [{**check, "warning": told if "made" in check["what"] else None} for check in checks]
        self.with_blocks("unsound", checks=change)
        rows = {row.find_element(By.TAG_NAME, "th").text: row for row in self.all("#energy_checks tbody tr")}
        self.assertIn("error of the balance, of the energy in motion", rows)
        wrong = rows["energy that hourglass forces made, of the internal energy"]
        self.assertIn("try a finer mesh", wrong.text)
        self.assertEqual(wrong.find_element(By.CSS_SELECTOR, ".bad").value_of_css_property("color"), "rgba(179, 38, 30, 1)")
        self.assertIn("sound", rows["hourglass energy, of the internal energy"].text)
        names = self.texts("#energy_table tbody th")
        self.assertEqual(names[-1], "total")
        self.assertIn("kinetic", names)


class OtherPages(Pages):
    def test_a_run_that_was_stopped_says_so(self):
        run("run", "two_blocks", "--quiet", "--out", "stopped", "--set", "time.steps=20")
        page = place("stopped/index.html")
        head, rest = page.read_text().split('id="summary">')
        summary, tail = rest.split("</script>", 1)
        summary = json.dumps({**json.loads(summary), "status": "stopped"})
        page.write_text(f'{head}id="summary">{summary}</script>{tail}')
        self.open("stopped/index.html")
        self.assertEqual(self.one("#status").text, "stopped")
        self.assertIn("before its end", self.one("header .note").text)

    def test_a_failed_run_tells_its_error_first(self):
        run("run", "rod_plate", "--quiet", "--out", "failed", "--set", "guard.energy_error=1e-9", "--set", "time.end=2e-5", status=1)
        self.open("failed/index.html")
        self.assertEqual(self.one("#status").text, "failed")
        self.assertIn("energy", self.one(".error").text)
        self.assertEqual(self.one(".error").get_attribute("role"), "alert")
        self.assertLess(self.one(".error").location["y"], self.one("#figures").location["y"])

    def test_without_dygraphs_there_are_figures_in_place_of_curves(self):
        run("run", "two_blocks", "--quiet", "--out", "bare", "--set", "time.steps=20")
        page = place("bare/index.html")
        head, rest = page.read_text().split("/* The code that draws the curves", 1)
        page.write_text(head + rest[rest.index("</script>"):])
        self.open("bare/index.html")
        self.assertEqual(self.all("figure.panel canvas"), [])
        panel = self.panel("Energy")
        self.assertIn("built without dygraphs", panel.text)
        self.assertIn("kinetic", panel.find_element(By.TAG_NAME, "table").text)

    def test_a_run_without_contact_or_probes_leaves_these_out(self):
        run("run", "patch_test", "--quiet", "--out", "patch", "--set", "time.steps=5")
        self.open("patch/index.html")
        self.assertNotIn("Probes", self.texts("h2"))

    def test_a_comparison_has_the_unit_of_each_quantity(self):
        place("spin.toml").write_text("""
            units = "g-mm-ms"
            time.end = 0.01
            rigid_body = [{ name = "drum", bodies = ["bar"], angular_velocity = [0, 0, 100] }]
            [[material]]
            name = "m"
            model = "elastic"
            density = 2.7e-3
            bulk_modulus = 7e4
            shear_modulus = 3e4
            [[body]]
            name = "bar"
            material = "m"
            mesh = { type = "block", size = [4, 1, 1], elements = [4, 1, 1] }
            """)
        run("compare", str(place("spin.toml")), "--vary", "time.cfl=0.5,0.6", "--repeat", "1", "--quiet", "--page", "spin.html")
        self.open("spin.html")
        axis = lambda title: self.panel(title).find_element(By.CSS_SELECTOR, ".axis").text
        self.assertIn("[1/ms]", axis("drum angular velocity z"))
        self.assertRegex(axis("drum centre x"), r"mm\]$")

    def test_a_comparison_lays_curves_over_each_other(self):
        run("compare", "rod_plate", "--vary", "contact.enforcement=penalty,lagrange", "--repeat", "1", "--quiet", "--set", "time.end=1e-5",
            "--page", "compare.html")
        self.open("compare.html")
        self.expect_curves()
        panel = self.panel("contact damped energy")
        self.assertEqual(set(self.values(panel)), {"penalty", "lagrange"})
        self.hover(panel)
        self.assertNotIn("", self.values(panel).values())
        self.assertEqual(len(self.all("#variant_times tbody tr")), 2)
        shown = lambda: sum(row.is_displayed() for row in self.all("#variant_results tbody tr"))
        before = shown()
        self.one("#results input[type=checkbox]").click()
        self.assertLess(shown(), before)
        self.assertGreater(shown(), 0)

    def test_a_run_beside_another_program_has_its_curves_and_differences(self):
        place("other.csv").write_text("time,KINETIC ENERGY,SPRING ENERGY\n0,1e5,0\n1e-5,2e5,0\n2e-5,1e5,0\n")
        run("compare", "two_blocks", "--with", str(place("other.csv")), "--quiet", "--set", "time.end=2e-5", "--page", "beside.html")
        self.open("beside.html")
        panel = self.panel("KINETIC ENERGY")
        self.assertEqual(set(self.values(panel)), {"here", "other.csv"})
        rows = self.texts("#beside_0 tbody tr")
        self.assertEqual(len(rows), 1)
        self.assertIn("kinetic + kinetic_below_zero", rows[0])
        self.assertIn("Not compared: SPRING ENERGY.", self.one("#beside").text)

    def test_a_verification_has_its_rows(self):
        run("verify", "two_blocks", "uniaxial_strain", "--page", "verify.html", "--json", "verify.json")
        rows = json.loads(place("verify.json").read_text())["rows"]
        self.open("verify.html")
        shown = lambda: [row for row in self.all("#row_table tbody tr") if row.is_displayed()]
        self.assertEqual(len(shown()), len(rows))
        self.assertEqual(len(self.all("#row_table .bar")), len(rows))
        self.one("#rows input[type=search]").send_keys("two_blocks restitution")
        self.assertEqual(len(shown()), sum(r["scene"] == "two_blocks" and "restitution" in r["quantity"] + r["source"] for r in rows))
        self.one("#rows input[type=search]").clear()
        self.all("#rows input[type=checkbox]")[0].click()
        self.assertEqual(len(shown()), sum(not r["pass"] for r in rows))


if __name__ == "__main__":
    browser.main()
