"""The viewer in the page of a run, in a browser: python3 viewer_browser_test.py PROGRAM FOLDER"""

import importlib.util
import io
import shutil
import time
import unittest

import browser
from browser import ActionChains, By, Keys, number, place, run
from viewer_pages import Image, ViewerPages, files_of, np

FACES = [(0, 4, 7, 3), (1, 2, 6, 5), (0, 1, 5, 4), (3, 7, 6, 2), (0, 3, 2, 1), (4, 5, 6, 7)]


def value_of(mesh, name):
    values = mesh.point_data.get(name, mesh.cell_data.get(name)).astype(float)
    return np.linalg.norm(values, axis=1) if values.ndim > 1 else values


@unittest.skipIf(np is None, "NumPy and Pillow read pictures and fields")
class Viewer(ViewerPages):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        run("run", "rod_plate", "--quiet", "--out", "rod")
        cls.files = files_of("rod")

    def setUp(self):
        self.open_viewer("rod")

    # ---- Numbers ----

    def test_every_number_is_that_of_the_files(self):
        surface = self.js("const {frames, faces, ...s} = viewer.surface; return s;")
        self.assertEqual(surface["times"], [at for at, _ in self.files])
        nodes, elements = surface["nodes"]["place"], surface["elements"]["place"]
        names = [field["name"] for field in surface["fields"]]
        written = [n for n, v in {**self.files[0][1].point_data, **self.files[0][1].cell_data}.items()
                   if v.dtype == np.float32 and n != "stress"]
        self.assertEqual(names, written)
        for k, (_, mesh) in enumerate(self.files):
            seen = np.unique(mesh.hexahedra[mesh.cell_data["alive"] != 0])
            is_seen = np.isin(nodes, seen) & np.array(self.js("""const {surface} = viewer, seen = new Array(surface.nodes.count).fill(false);
                for (let f = 0; f < surface.faces.count; ++f) if (faceIsThere(surface.faces, f, arguments[0]))
                  surface.faces.corners.subarray(4 * f, 4 * f + 4).forEach((n) => { seen[n] = true; });
                return seen;""", k))
            self.assertGreater(is_seen.sum(), 1500)
            at = np.array(self.js("return Array.from({length: viewer.surface.nodes.count}, (_, i) => placeOf(viewer.surface, arguments[0], i));", k))
            half = 0.5 * np.array(surface["steps"])[np.array(surface["nodes"]["body"], int)]
            wrong = np.abs(at - mesh.points[nodes]) - half * (1 + 1e-6)
            self.assertLessEqual(wrong[is_seen].max(), 0.0)
            self.assertLess(half.max(), 8.0 / 65000, "half a step of what a body takes")
            for f, field in enumerate(surface["fields"]):
                of_nodes = field["of"] == "nodes"
                shown = self.js("""const [k, f, count] = arguments; return Array.from({length: count}, (_, i) => valueOf(viewer.surface, k, f, i));""",
                                k, f, len(nodes if of_nodes else elements))
                there = is_seen if of_nodes else mesh.cell_data["alive"][elements] != 0
                wrong = np.abs(np.array(shown, float) - value_of(mesh, field["name"])[nodes if of_nodes else elements])
                self.assertLessEqual(wrong[there].max(), 0.5001 * field["step"], field["name"])
                self.assertAlmostEqual(field["step"] * 4094, field["range"][1] - field["range"][0], delta=1e-9 * field["range"][1])

    def test_faces_are_those_between_what_is_there_and_what_is_not(self):
        for k, (_, mesh) in enumerate(self.files):
            alive = mesh.cell_data["alive"] != 0
            count = {}
            for corners, body in zip(mesh.hexahedra[alive], mesh.cell_data["body"][alive]):
                for face in FACES:
                    key = (int(body), *sorted(int(corners[i]) for i in face))
                    count[key] = count.get(key, 0) + 1
            expected = {key for key, n in count.items() if n == 1}
            drawn = self.js("""const {faces, nodes, elements} = viewer.surface, list = [];
                for (let f = 0; f < faces.count; ++f) if (faceIsThere(faces, f, arguments[0]))
                  list.push([elements.body[faces.element[f]], ...[...faces.corners.subarray(4 * f, 4 * f + 4)].map((n) => nodes.place[n]).sort((a, b) => a - b)]);
                return list;""", k)
            self.assertEqual({tuple(face) for face in drawn}, expected)
            self.assertEqual(len(drawn), len(expected))
        self.assertLess((self.files[-1][1].cell_data["alive"] != 0).sum(), 1842, "some are eroded")

    # ---- Pictures ----

    def reference(self, view, frame, field):
        """What `pinball view` draws, its Frame and size."""
        if importlib.util.find_spec("vtkmodules") is None or shutil.which("Xvfb") is None:
            self.skipTest("pinball view needs VTK and Xvfb")
        from view.drawing import Drawing
        from view.fields import read_pvd
        from view.options import parser
        from view.sheet import Layout
        low, high = self.js("return viewer.surface.fields.find((f) => f.name === arguments[0]).range", field)
        entry = read_pvd(str(place("rod/fields.pvd")))[frame]
        arguments = [str(place("rod")), "--view", view, "--times", repr(entry[0]), "--field", field, "--no-edges", "--size", "700",
                     f"--range={low!r},{high!r}"]
        run("view", *arguments, "--out", str(place("reference.png")))
        drawn = Drawing([entry], parser().parse_args(arguments)).frame
        layout = Layout(1, drawn.aspect, 700)
        x, y = layout.place(0)
        width, height = layout.panel
        with Image.open(place("reference.png")) as image:
            picture = image.convert("RGB").crop((x, y + layout.title, x + width, y + layout.title + height))
        return np.asarray(picture).astype(float), drawn, layout.panel

    def test_draws_what_fields_png_shows(self):
        """Outlines and colours, pixel by pixel, within bounds that a wrong field, time or side is far beyond."""
        from view.camera import VIEWS

        def differences(drawn, expected):
            ours, theirs = drawn[..., 3] > 127, (expected < 250).any(axis=-1)  # paper is white, and no body is
            both = ours & theirs
            return 1.0 - both.sum() / (ours | theirs).sum(), np.abs(drawn[..., :3] - expected)[both].mean()

        cases = [("iso", 2, "plastic_strain"), ("iso", 1, "von_mises"), ("back", 1, "velocity"), ("top", 2, "pressure")]
        for view, frame, field in cases:
            with self.subTest(f"{field} from {view}"):
                expected, drawn, size = self.reference(view, frame, field)
                self.js("viewer.edges = false;")
                self.look(drawn.centre.tolist(), float(drawn.height), *VIEWS[view], size)
                self.choose(field, frame)
                outline, colour = differences(self.picture(), expected)
                self.assertLess(outline, 0.01, "share of pixels")
                self.assertLess(colour, 5.0, "of 255")
                self.assertGreater(max(*differences(self.picture()[:, ::-1], expected)), 0.03, "the mirror image")
                self.choose(field, (frame + 1) % 3)
                self.assertGreater(differences(self.picture(), expected)[0], 0.02, "another time")
                self.choose("corner_share" if field != "velocity" else "von_mises", frame)
                self.assertGreater(differences(self.picture(), expected)[1], 20.0, "another field")

    def test_is_seen_on_a_dark_page(self):
        features = [{"name": "prefers-color-scheme", "value": "dark"}]
        self.browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": features})
        try:
            drawn = self.picture()
            self.assertEqual(drawn[2, 2, 3], 0.0, "the page shows through where nothing is")
            self.js("document.querySelector('.surface').scrollIntoView()")
            box = self.js("const r = viewer.canvas.getBoundingClientRect(); return [r.left, r.top, r.right, r.bottom]")
            page = np.asarray(Image.open(io.BytesIO(self.browser.get_screenshot_as_png())).convert("L")).astype(float)
            corner = page[int(box[1]) + 40:int(box[1]) + 60, int(box[2]) - 60:int(box[2]) - 20]
            self.assertLess(corner.max(), 60.0)
            self.assertGreater(page[int(box[1]):int(box[3]), int(box[0]):int(box[2])].max(), 150.0)
        finally:
            self.browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": []})

    def test_bar_has_range_name_and_unit(self):
        for field, unit in [("von_mises", "psi"), ("velocity", "in/s"), ("plastic_strain", "")]:
            self.choose(field, 2)
            name = self.one(".colour_bar .name").text
            self.assertEqual(unit in name, True, name)
            low, high = self.js("return viewer.surface.fields[viewer.field].range")
            ticks = [number(text) for text in self.texts(".colour_bar .tick")]
            self.assertGreater(len(ticks), 2)
            power = [int("".join("0123456789"["⁰¹²³⁴⁵⁶⁷⁸⁹".index(c)] for c in part)) for part in [name.partition("10")[2].split(" ")[0].split("]")[0]] if part]
            scale = 10.0 ** power[0] if power else 1.0
            self.assertTrue(all(low - 1e-9 <= tick * scale <= high * (1 + 1e-9) for tick in ticks), (ticks, low, high))

    # ---- What a reader does ----

    def test_picks_the_element_and_the_node_under_the_pointer(self):
        mesh = self.files[1][1]
        self.choose("von_mises", 1)
        camera = self.js("viewer.drawNow(); return {axes: viewer.camera.axes, centre: viewer.camera.centre, height: viewer.camera.height}")
        size = self.js("return [viewer.canvas.clientWidth, viewer.canvas.clientHeight]")
        picked = set()
        for across, up in [(0.0, 0.0), (0.2, -0.03), (-0.15, 0.1), (0.35, -0.05), (-0.3, 0.05)]:
            pixel = [round(across * size[1]), round(-up * size[1])]
            expected = self.foremost(mesh, camera, pixel[0] / size[1] * camera["height"], -pixel[1] / size[1] * camera["height"])
            self.js("viewer.pick(null)")
            self.browser.execute_script("arguments[0].scrollIntoView({block: 'center'})", self.one(".drawing canvas"))
            ActionChains(self.browser).move_to_element_with_offset(self.one(".drawing canvas"), *pixel).click().perform()
            if expected is None:
                self.assertEqual(self.all(".picked table"), [])
                continue
            picked.add(expected[0])
            for kind, index in zip(("elements", "nodes"), expected):
                rows = {row.find_element(By.TAG_NAME, "th").text: [cell.text for cell in row.find_elements(By.TAG_NAME, "td")]
                        for row in self.all(f"#picked_{kind} tbody tr")}
                self.assertEqual(int(rows["number"][0]), index)
                body = mesh.cell_data["body"][expected[0]]
                self.assertEqual(rows["body"][0], ["rod", "plate"][body])
                self.expect_values(rows, mesh, kind, index)
        self.assertGreater(len(picked), 2)

    def expect_values(self, rows, mesh, kind, index):
        fields = {f["name"]: f for f in self.js("return viewer.surface.fields") if f["of"] == kind}
        labels = {"von_mises": "von Mises stress", "plastic_strain": "effective plastic strain"}
        for name, field in fields.items():
            value = value_of(mesh, name)[index]
            shown = number(rows[labels.get(name, name.replace("_", " "))][0])
            self.assertAlmostEqual(shown, value, delta=0.5001 * field["step"] + 5e-4 * abs(value), msg=name)
        if kind == "nodes":
            for axis, value in zip("xyz", mesh.points[index]):
                self.assertAlmostEqual(number(rows[axis][0]), value, delta=1e-4 + 5e-5 * abs(value))

    def foremost(self, mesh, camera, right, up):
        """(element, node) that the camera sees at a point, found by other means than the page's; None: nothing."""
        axes = np.array(camera["axes"])
        seen = (mesh.points - np.array(camera["centre"])) @ axes.T
        best, found = -np.inf, None
        for e in np.flatnonzero(mesh.cell_data["alive"]):
            box = seen[mesh.hexahedra[e]]
            if (box[:, :2].max(axis=0) < (right, up)).any() or (box[:, :2].min(axis=0) > (right, up)).any():
                continue
            for face in FACES:
                corners = mesh.hexahedra[e][list(face)]
                for triangle in (corners[[0, 1, 2]], corners[[0, 2, 3]]):
                    a, b, c = seen[triangle]
                    matrix = np.array([b[:2] - a[:2], c[:2] - a[:2]]).T
                    if abs(np.linalg.det(matrix)) < 1e-14:
                        continue
                    v, w = np.linalg.solve(matrix, np.array([right, up]) - a[:2])
                    depth = a[2] + v * (b[2] - a[2]) + w * (c[2] - a[2])
                    if min(v, w, 1 - v - w) >= 0 and depth > best:
                        best = depth
                        found = int(e), int(corners[np.argmin(((seen[corners][:, :2] - (right, up)) ** 2).sum(axis=1))])
        return found

    def test_finds_by_number(self):
        number_of = self.one(".find input")
        number_of.send_keys("500" + Keys.ENTER)
        self.assertIn("500 of plate", self.one("#picked_elements caption").text)
        number_of.clear()
        number_of.send_keys("999999" + Keys.ENTER)
        self.assertIn("no element 999999 at a surface", self.one(".find output").text)

    def test_time_is_that_of_the_curves(self):
        panel = self.panel("Energy")
        times = [at for at, _ in self.files]
        for across in (0.15, 0.5, 0.97):
            self.hover(panel, across)
            now = 1e-6 * float(panel.find_element(By.CSS_SELECTOR, ".now").text.split()[1])
            nearest = int(np.argmin(np.abs(np.array(times) - now)))
            self.assertEqual(self.js("return viewer.frame"), nearest)
            self.assertIn(f"{1e6 * times[nearest]:.4g} µs", self.one(".drawing .title").text)
        slider = self.one("#viewer .player input")
        slider.send_keys(Keys.HOME)
        self.assertEqual(panel.find_element(By.CSS_SELECTOR, ".now").text, "at 0 µs")
        slider.send_keys(Keys.ARROW_RIGHT)
        self.assertAlmostEqual(float(panel.find_element(By.CSS_SELECTOR, ".now").text.split()[1]), 1e6 * times[1], delta=0.5)

    def test_plays_to_the_end(self):
        button = self.one("#viewer .player button")
        button.click()
        self.assertEqual(button.text, "Pause")
        self.assertLess(self.js("return viewer.frame"), 2)
        for _ in range(100):
            if button.text == "Play":
                break
            time.sleep(0.05)
        self.assertEqual(button.text, "Play")
        self.assertEqual(self.js("return viewer.frame"), 2)

    def test_hides_and_cuts(self):
        covered = lambda: (self.picture()[..., 3] > 127).sum()
        self.choose("von_mises", 0)
        whole = covered()
        plate = self.all(".legend.bodies button")[1]
        self.js("arguments[0].scrollIntoView({block: 'center'})", plate)
        plate.click()
        self.assertEqual(plate.get_attribute("aria-pressed"), "false")
        rod = covered()
        self.assertTrue(0 < rod < 0.5 * whole, (rod, whole))
        plate.click()
        self.assertEqual(covered(), whole)
        self.js("viewer.look('top')")
        from_above = covered()
        for other, keeps in ((False, lambda x: x >= 0.0), (True, lambda x: x <= 0.0)):
            self.js("Object.assign(viewer.cut, {axis: 'x', at: 0, other: arguments[0]}); viewer.updateCut();", other)
            columns = np.flatnonzero((self.picture()[..., 3] > 127).any(axis=0)) + 0.5
            width, height, centre = self.js("return [viewer.canvas.width, viewer.camera.height / viewer.canvas.height, viewer.camera.centre[0]]")
            places = centre + (columns - 0.5 * width) * height
            self.assertTrue(all(keeps(x + (1.5 * height if not other else -1.5 * height)) for x in places), (other, places.min(), places.max()))
            self.assertLess(covered(), from_above)
            self.assertGreater(covered(), 0.1 * from_above)

    def test_turns_moves_and_zooms(self):
        canvas = self.one(".drawing canvas")
        self.js("arguments[0].scrollIntoView({block: 'center'})", canvas)
        camera = lambda: self.js("const {azimuth, elevation, height, centre} = viewer.camera; return [azimuth, elevation, height, centre]")
        before = camera()
        ActionChains(self.browser).move_to_element(canvas).click_and_hold().move_by_offset(-50, 20).release().perform()
        self.assertAlmostEqual(camera()[0], before[0] + 20.0, delta=0.5)
        self.assertAlmostEqual(camera()[1], before[1] + 8.0, delta=0.5)
        self.assertEqual(self.all(".picked table"), [], "a drag picks nothing")
        scrolled = self.js("return scrollY")
        for focused in (False, True):
            self.js("arguments[0] ? viewer.canvas.focus() : document.activeElement.blur()", focused)
            height = camera()[2]
            ActionChains(self.browser).scroll_by_amount(0, 0).perform()
            self.js("viewer.canvas.dispatchEvent(new WheelEvent('wheel', {deltaY: -200, bubbles: true, cancelable: true, clientX: 300, clientY: 300}))")
            (self.assertLess if focused else self.assertEqual)(camera()[2], height)
        self.assertEqual(self.js("return scrollY"), scrolled)
        canvas.send_keys("6")
        self.assertEqual(camera()[:2], [0, 90])
        canvas.send_keys(Keys.ARROW_LEFT)
        self.assertEqual(camera()[0], 5)
        canvas.send_keys("r")
        self.assertEqual(camera()[:2], [25, 25])
        canvas.send_keys(Keys.SHIFT + Keys.ARROW_UP)
        self.assertNotEqual(camera()[3], before[3])


if __name__ == "__main__":
    browser.main()
