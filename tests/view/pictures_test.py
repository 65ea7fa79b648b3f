"""What is on the pictures of `pinball view`: pictures_test.py PROGRAM. Skipped (status 77) where VTK or Xvfb is missing."""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

try:
    import vtkmodules  # noqa: F401
    from PIL import Image, ImageSequence
except ModuleNotFoundError as error:
    print(f"skipped: no {error.name}")
    sys.exit(77)
if shutil.which("Xvfb") is None:
    print("skipped: no Xvfb")
    sys.exit(77)

import numpy as np

PROGRAM = pathlib.Path(sys.argv.pop(1)).resolve()
# Two blocks of 1 x 1 x 1 that part: one at x < 0, one at x > 1, in whose middle lies a third, small one.
SCENE = """
time.end = 1.0
time.steps = 4
output.field_interval = 1e-9
material = [{name = "m", model = "elastic", density = 1.0, bulk_modulus = 1.0, shear_modulus = 1.0}]
[[body]]
name = "left"
material = "m"
position = [-1.5, 0, 0]
velocity = [-1.0, 0, 0]
mesh = {type = "block", size = [1, 1, 1], elements = [2, 2, 2]}
[[body]]
name = "right"
material = "m"
position = [0.5, 0, 0]
mesh = {type = "block", size = [1, 1, 1], elements = [2, 2, 2]}
[[body]]
name = "core"
material = "m"
position = [0.9, 0.4, 0.4]
mesh = {type = "block", size = [0.2, 0.2, 0.2], elements = [1, 1, 1]}
"""
HUES = {"left": "blue", "right": "orange", "core": "green"}  # view/colours.py, BODIES


def hue(pixel):
    red, green, blue = (int(c) for c in pixel)
    if min(red, green, blue) > 245:
        return "white"
    if max(red, green, blue) - min(red, green, blue) < 12:
        return "grey"
    return "blue" if blue >= max(red, green) else "orange" if red >= max(green, blue) else "green"


class Pictures(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        cls.out = pathlib.Path(cls.folder.name, "out")
        scene = pathlib.Path(cls.folder.name, "blocks.toml")
        scene.write_text(SCENE)
        subprocess.run([PROGRAM, "run", scene, "--quiet", "--out", cls.out], check=True, stdout=subprocess.DEVNULL)
        cls.outputs = (cls.out / "fields.pvd").read_text().count("<DataSet")

    def view(self, *options):
        environment = {key: value for key, value in os.environ.items() if key != "DISPLAY"}
        done = subprocess.run([PROGRAM, "view", self.out, *options], env=environment, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True)
        self.assertEqual(done.returncode, 0, done.stdout)
        return [pathlib.Path(line) for line in done.stdout.splitlines()]

    def picture(self, *options):
        """(height, width, 3) of one time, body by body, from the side; without the bar at the right."""
        file = self.out / "one.png"
        self.view("--field", "body", "--view", "side", "--no-edges", "--times", "0", "--size", "400", "--out", str(file),
                  *options)
        image = np.asarray(Image.open(file).convert("RGB"))
        return image[:, : int(0.8 * image.shape[1])]

    def hues(self, *options):
        """Share of the picture that each hue covers."""
        image = self.picture(*options)[::2, ::2].reshape(-1, 3)
        found = [hue(pixel) for pixel in image]
        return {name: found.count(name) / len(found) for name in ("white", "blue", "orange", "green")}

    def test_bodies_are_where_they_should_be(self):
        image = self.picture()
        middle = image.shape[0] // 2
        row = [hue(pixel) for pixel in image[middle]]
        blue, orange = ([i for i, h in enumerate(row) if h == name] for name in ("blue", "orange"))
        self.assertGreater(len(blue), 40)
        self.assertAlmostEqual(len(orange) / len(blue), 1.0, delta=0.15)
        self.assertLess(max(blue), min(orange))
        self.assertEqual(set(row[max(blue) + 2:min(orange) - 2]), {"white"})

    def test_from_behind_they_change_sides(self):
        row = [hue(pixel) for pixel in self.picture("--view", "back")[80]]
        self.assertLess(row.index("orange"), row.index("blue"))

    def test_what_is_inside_is_seen_in_a_cut_alone(self):
        self.assertLess(self.hues()["green"], 0.001)
        cut = self.hues("--cut", "y=0.5")
        self.assertGreater(cut["green"], 0.005)
        self.assertGreater(cut["orange"], 5 * cut["green"], "the section of the body around it is closed")

    def test_hidden_bodies_are_absent(self):
        without = self.hues("--hide", "right")
        self.assertLess(without["orange"], 0.001)
        self.assertGreater(without["green"], 0.005)
        self.assertGreater(self.hues("--only", "left")["blue"], 0.3)

    def test_the_mirror_image_is_drawn(self):
        alone, both = self.hues("--only", "left", "--view", "top"), self.hues("--only", "left", "--view", "top", "--mirror", "x")
        self.assertGreater(both["white"], alone["white"], "between the two")
        self.assertGreater(both["blue"], 0.2)
        image = self.picture("--only", "left", "--view", "side", "--mirror", "x").astype(int)
        row = [pixel for pixel in image[image.shape[0] // 2] if hue(pixel) == "blue"]
        np.testing.assert_allclose(row[5], row[-5], atol=8, err_msg="in the same light")

    def test_all_is_made_by_default(self):
        files = self.view()
        self.assertEqual([file.name for file in files], ["fields.png", "animation.webp", "fields_paraview.py", "index.html", "history.png"])
        state = files.pop(2).read_text()
        compile(state, "fields_paraview.py", "exec")
        self.assertNotIn(str(self.out), state, "the folder may be moved")
        page = files.pop(2).read_text()
        self.assertIn("data:image/png;base64,", page)
        self.assertIn("prefers-color-scheme: dark", page)
        self.assertEqual(page.count('<img loading="lazy"'), self.outputs)
        for file in files:
            with Image.open(file) as image:
                self.assertGreater(image.width, 600, file)
                image.verify()

    def test_films_have_a_frame_for_each_output(self):
        self.assertEqual(self.outputs, 5)
        for kind in ("webp", "gif"):
            (film,) = self.view("--view", "side", "--size", "300", "--animation", str(self.out / f"film.{kind}"))
            with Image.open(film) as image:
                frames = [np.asarray(frame.convert("RGB")) for frame in ImageSequence.Iterator(image)]
            self.assertEqual(len(frames), self.outputs)
            self.assertEqual(len({frame.tobytes() for frame in frames}), self.outputs, "each of another time")

    def test_another_run_beside_has_the_same_scale_of_colours(self):
        other = self.out.parent / "other"
        subprocess.run([PROGRAM, "run", self.out.parent / "blocks.toml", "--quiet", "--out", other, "--refine", "2",
                        "--set", "body.left.velocity=[-2, 0, 0]"], check=True, stdout=subprocess.DEVNULL)
        options = ["--field", "velocity", "--view", "side", "--no-edges", "--size", "600", "--only", "left"]
        file = self.out / "two.png"

        def darkest(*more):
            """Of each half: the colour of the body."""
            self.view(*options, "--out", str(file), *more)
            image = np.asarray(Image.open(file).convert("L"))[: int(0.8 * 300), : int(0.8 * 600)]
            return [int(np.percentile(half[half < 240], 20)) for half in np.array_split(image, 2, axis=1)]

        first, second = darkest("--beside", str(other))
        self.assertGreater(first, second + 20, "half as fast, and not as dark")
        first, second = darkest("--beside", str(self.out))
        self.assertAlmostEqual(first, second, delta=3)

    def test_a_run_beside_needs_a_place(self):
        done = subprocess.run([PROGRAM, "view", self.out, "--beside", self.out], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        self.assertEqual(done.returncode, 2, done.stdout)
        self.assertIn("--beside: expected --out FILE.png or --page FILE.html", done.stdout)
        done = subprocess.run([PROGRAM, "view", self.out, "--page", __file__], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        self.assertEqual(done.returncode, 1, done.stdout)
        self.assertIn("between which pictures go", done.stdout)

    @unittest.skipIf(shutil.which("ffmpeg") is None, "no ffmpeg")
    def test_films_by_ffmpeg(self):
        for kind in ("mp4", "webm"):
            (film,) = self.view("--size", "300", "--animation", str(self.out / f"film.{kind}"))
            count = subprocess.run(["ffprobe", "-v", "error", "-count_frames", "-show_entries", "stream=nb_read_frames", "-of",
                                    "csv=p=0", film], check=True, stdout=subprocess.PIPE, text=True).stdout
            self.assertEqual(int(count.strip().strip(",")), self.outputs)

    def test_a_film_without_ffmpeg_says_so(self):
        done = subprocess.run([PROGRAM, "view", self.out, "--animation", "film.mp4"], env={**os.environ, "PATH": "/nowhere"},
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        self.assertEqual(done.returncode, 2)
        self.assertIn("ffmpeg", done.stdout)

    def test_a_file_that_cannot_be_written(self):
        done = subprocess.run([PROGRAM, "view", self.out, "--out", "/nowhere/a.png"], stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True)
        self.assertEqual(done.returncode, 1, done.stdout)
        self.assertIn("/nowhere/a.png", done.stdout)


if __name__ == "__main__":
    sys.exit(unittest.main())
