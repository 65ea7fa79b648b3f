"""pinball.view in a browser, as a notebook shows it: viewer_test.py PROGRAM FOLDER"""

import html.parser
import json
import pathlib
import sys

import pinball

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "output"))
import browser  # noqa: E402
from browser import Keys, place, run  # noqa: E402
from viewer_pages import ViewerPages  # noqa: E402


class Frames(html.parser.HTMLParser):
    """The attributes of all that is an element."""

    def __init__(self, text):
        super().__init__()
        self.found = []
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        self.found.append((tag, dict(attributes)))


class Notebook(ViewerPages):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        run("run", "rod_plate", "--quiet", "--out", "rod", "--set", "time.end=2e-5", "--set", "output.field_times=[0, 1e-5, 2e-5]")

    def show(self, *views):
        """Opens a page that has them as a notebook has them, and goes into the first one."""
        page = "<!doctype html><title>notebook</title><meta charset=utf-8><link rel=icon href='data:,'>"
        place("notebook.html").write_text(page + "".join(view._repr_html_() for view in views), encoding="utf-8")
        self.open("notebook.html")
        self.go_into(0)

    def go_into(self, index):
        self.browser.switch_to.default_content()
        self.browser.switch_to.frame(self.all("iframe")[index])
        self.wait_for_viewer()

    def tearDown(self):
        self.browser.switch_to.default_content()

    def test_shows_the_bodies_and_nothing_else(self):
        self.show(pinball.view(place("rod")))
        packed = json.loads(place("rod/index.html").read_text().split('id="surface">')[1].split("</script>")[0])
        self.assertEqual(self.js("return viewer.surface.times"), packed["times"])
        self.assertEqual(self.js("return [viewer.surface.faces.count, viewer.surface.nodes.count]"), [packed["faces"], packed["nodes"]])
        seen = [section.get_attribute("id") for section in self.all("main > section") if section.is_displayed()]
        self.assertEqual(seen, ["viewer"])
        self.assertFalse(self.one("header").is_displayed())
        self.assertEqual(self.all("figure"), [], "no curves")
        self.assertGreater(self.js("""viewer.drawNow(); const {canvas} = viewer, copy = document.createElement('canvas');
            [copy.width, copy.height] = [canvas.width, canvas.height];
            const context = copy.getContext('2d'); context.drawImage(canvas, 0, 0);
            return context.getImageData(0, 0, copy.width, copy.height).data.filter((v, i) => i % 4 === 3 && v > 200).length;"""), 5000)

    def test_can_be_turned_and_played(self):
        self.show(pinball.view(place("rod")))
        before = self.js("return [viewer.camera.azimuth, viewer.frame]")
        self.one("canvas").send_keys(Keys.ARROW_LEFT, ",")
        after = self.js("return [viewer.camera.azimuth, viewer.frame]")
        self.assertNotEqual(after[0], before[0])
        self.assertEqual(after[1], before[1] - 1)

    def test_several_are_apart(self):
        self.show(pinball.view(place("rod")), pinball.view(place("rod")))
        self.one("canvas").send_keys(",")
        self.assertEqual(self.js("return viewer.frame"), 1)
        self.go_into(1)
        self.assertEqual(self.js("return viewer.frame"), 2)

    def test_pages_of_several_runs_are_seen_beside_each_other(self):
        run("compare", "two_blocks", "--vary", "contact.beta=0.5,1", "--repeat", "1", "--quiet", "--set", "time.steps=40", "--page", "compare.html")
        run("converge", "two_blocks", "--meshes", "1/2,1,2", "--only", "mesh", "--quiet", "--of", "energy.kinetic", "--out", "study",
            "--page", "study.html", environment={"PINBALL_PYTHON": "/no/such/python"})
        for page, names in ("compare.html", ["0.5, ", "1, "]), ("study.html", ["mesh 1/2, 16 elements, ", "mesh 2, 1,024 elements, "]):
            self.show(pinball.view(place(page)))
            titles = self.texts(".drawing .title")
            self.assertTrue(all(title.startswith(name) for title, name in zip(titles, names, strict=True)), titles)

    def test_is_one_element_without_what_it_does_not_show(self):
        view = pinball.view(str(place("rod")), height=333)
        (tag, attributes), = Frames(view._repr_html_()).found
        self.assertEqual(tag, "iframe")
        self.assertEqual(attributes["srcdoc"], view.page)
        self.assertEqual(attributes["sandbox"], "allow-scripts", "a page in a notebook has no part of it")
        self.assertIn("height:333px", attributes["style"])
        whole = place("rod/index.html").read_text()
        self.assertIn('"state_hash":', whole)
        self.assertNotIn('"state_hash":', view.page)
        self.assertIn('id="history">{"columns":[],"data":[]}', view.page)
        begin, _, end = whole.partition("<!-- /pictures -->")
        place("drawn.html").write_text(f'{begin}<img alt="" src="data:image/png;base64,AAAA"><!-- /pictures -->{end}')
        self.assertEqual(pinball.view(place("drawn.html")).page, view.page, "no pictures")

    def test_stays_when_the_folder_is_another_run(self):
        run("run", "two_blocks", "--quiet", "--out", "taken", "--set", "time.steps=20")
        view = pinball.view(place("taken"))
        kept = view._repr_html_()
        run("run", "two_bars", "--quiet", "--out", "taken", "--set", "time.steps=20")
        self.assertEqual(view._repr_html_(), kept)
        self.assertNotEqual(pinball.view(place("taken"))._repr_html_(), kept)

    def test_says_what_it_expects(self):
        with self.assertRaisesRegex(pinball.InputError, r"^view: .*nothing \(No such file or directory\): expected the folder of a run"):
            pinball.view(place("nothing"))
        place("other.html").write_text("<p>A page of another program")
        with self.assertRaisesRegex(pinball.InputError, "other.html: expected a page with bodies"):
            pinball.view(place("other.html"))
        place("other.html").write_bytes(b"\xff\xfe")
        with self.assertRaisesRegex(pinball.InputError, r"other.html \(no text\): expected"):
            pinball.view(place("other.html"))

    def test_a_page_without_such_a_viewer_is_shown_as_it_is(self):
        page = place("rod/index.html").read_text().replace("viewer_alone", "older")
        place("older.html").write_text(page)
        self.assertEqual(pinball.view(place("older.html")).page, page)


if __name__ == "__main__":
    browser.main()
