"""Pure functions of the viewer (python/view)."""

import math
import os
import pathlib
import sys
import tempfile
import types
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "python"))

import numpy as np
from PIL import Image

from view.camera import Camera, Frame, VIEWS, corners_of, parse_view
from view.colours import limits_of, make_colours
from view.drawing import points_seen
from view.fields import BadInput, Mesh
from view.labels import readable_powers, round_length, time_scale
from view.page import LARGEST_FRAME, frame_data, pictures, put_into_page
from view.quantity import Quantity, default_field, shown
from view.selection import chosen_bodies, choose_entries, elements_of, mirror_scales, parse_cut
from view.sheet import Layout, number_of_columns

UNIT_CUBE = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]], dtype=float)


def two_cubes():
    """Body 0 from x = 0 to 1, body 1 from 2 to 3."""
    mesh = Mesh(np.concatenate([UNIT_CUBE, UNIT_CUBE + [2, 0, 0]]), np.arange(16).reshape(2, 8))
    mesh.cell_data = {"alive": np.array([1, 1]), "body": np.array([0, 1]), "plastic_strain": np.array([0.0, 0.5]),
                      "stress": np.arange(12.0).reshape(2, 6), "von_mises": np.array([3.0, 4.0])}
    mesh.point_data = {"velocity": np.tile([3.0, -4.0, 0.0], (16, 1))}
    mesh.components = {"velocity": list("xyz"), "stress": ["xx", "yy", "zz", "xy", "yz", "zx"]}
    mesh.units = {"velocity": "m/s", "stress": "N/m^2"}
    return mesh


class Cameras(unittest.TestCase):
    def test_names_look_where_they_say(self):
        expected = {"side": (0, -1, 0), "back": (0, 1, 0), "right": (1, 0, 0), "left": (-1, 0, 0), "top": (0, 0, 1),
                    "bottom": (0, 0, -1)}
        for name, toward in expected.items():
            np.testing.assert_allclose(Camera(*VIEWS[name]).toward, toward, atol=1e-15, err_msg=name)
        np.testing.assert_allclose(Camera(*VIEWS["side"]).right, (1, 0, 0), atol=1e-15)
        np.testing.assert_allclose(Camera(*VIEWS["top"]).up, (0, 1, 0), atol=1e-15)

    def test_axes_are_a_right_handed_unit_frame(self):
        camera = Camera(37.0, -20.0)
        axes = np.array([camera.right, camera.up, camera.toward])
        np.testing.assert_allclose(axes @ axes.T, np.eye(3), atol=1e-15)
        self.assertAlmostEqual(np.linalg.det(axes), 1.0)

    def test_angles_are_read(self):
        self.assertEqual(parse_view("-30,20"), (-30.0, 20.0))
        for wrong in ("up", "1", "1,2,3", "0,91", "nan,0"):
            with self.assertRaises(BadInput, msg=wrong):
                parse_view(wrong)

    def test_frame_holds_all_points(self):
        camera = Camera(25.0, 25.0)
        points = corners_of([0, 0, 0], [4, 2, 1])
        frame = Frame(camera, points)
        right, up = (points - frame.centre) @ camera.right, (points - frame.centre) @ camera.up
        self.assertLess(np.abs(right).max(), 0.5 * frame.width)
        self.assertGreater(np.abs(right).max(), 0.45 * frame.width)
        self.assertLess(np.abs(up).max(), 0.5 * frame.height)


class Selections(unittest.TestCase):
    def test_planes(self):
        cut = parse_cut("y<0.5")
        self.assertEqual((cut.normal, cut.origin.tolist()), ((0.0, -1.0, 0.0), [0.0, 0.5, 0.0]))
        self.assertEqual(parse_cut("x=-1e-3").normal, (1.0, 0.0, 0.0))
        for wrong in ("w=1", "x=", "x=nan", "x", "x==1"):
            with self.assertRaises(BadInput, msg=wrong):
                parse_cut(wrong)

    def test_times(self):
        entries = [(0.1 * i, str(i)) for i in range(11)]
        self.assertEqual([path for _, path in choose_entries(entries, None, 4)], ["0", "3", "7", "10"])
        self.assertEqual([path for _, path in choose_entries(entries, [0.52, 0.0, 0.48], 4)], ["0", "5"])
        self.assertEqual(len(choose_entries(entries[:2], None, 4)), 2)

    def test_bodies(self):
        names = ["rod", "plate"]
        self.assertEqual(chosen_bodies(names, None, ["rod"]), [1])
        self.assertEqual(chosen_bodies(names, ["rod"], None), [0])
        with self.assertRaisesRegex(BadInput, "--only: no body rods; there are: rod, plate"):
            chosen_bodies(names, ["rods"], None)
        with self.assertRaises(BadInput):
            chosen_bodies(names, ["rod"], ["rod"])

    def test_elements_without_corners_or_mass_are_left_out(self):
        mesh = two_cubes()
        self.assertEqual(elements_of(mesh, [0, 1]).tolist(), [0, 1])
        self.assertEqual(elements_of(mesh, [1]).tolist(), [1])
        mesh.cell_data["alive"][0] = 0
        self.assertEqual(shown(mesh).tolist(), [False, True])
        mesh.points[8, 0] = math.nan
        self.assertEqual(len(elements_of(mesh, [0, 1])), 0)

    def test_mirror(self):
        self.assertEqual(mirror_scales(""), [(1, 1, 1)])
        self.assertEqual(mirror_scales("xy"), [(1, 1, 1), (-1, 1, 1), (1, -1, 1), (-1, -1, 1)])
        for wrong in ("w", "xx", "x,y"):
            with self.assertRaises(BadInput, msg=wrong):
                mirror_scales(wrong)

    def test_points_seen_follow_cut_and_mirror(self):
        mesh, both = two_cubes(), np.array([0, 1])
        self.assertEqual(points_seen(mesh, both, None, mirror_scales("y"))[:, 1].min(), -1.0)
        seen = points_seen(mesh, both, parse_cut("x<0.5"), mirror_scales(""))
        self.assertEqual((seen[:, 0].min(), seen[:, 0].max()), (0.0, 0.5))
        self.assertEqual(len(points_seen(mesh, both, parse_cut("x>9"), mirror_scales(""))), 0)


class Quantities(unittest.TestCase):
    def test_scalars_components_and_magnitudes(self):
        mesh = two_cubes()
        self.assertEqual(Quantity("von_mises", mesh).of(mesh).tolist(), [3.0, 4.0])
        self.assertEqual(Quantity("stress_yy", mesh).of(mesh).tolist(), [1.0, 7.0])
        self.assertEqual(set(Quantity("velocity", mesh).of(mesh)), {5.0})
        self.assertEqual(Quantity("velocity_y", mesh).label, "velocity y [m/s]")
        self.assertEqual(Quantity("von_mises", mesh).label, "von Mises stress [N/m²]")
        with self.assertRaisesRegex(BadInput, "no field strain in the output; there are: velocity, .*stress_zx"):
            Quantity("strain", mesh)

    def test_the_default_is_strain_where_there_is_any(self):
        mesh = two_cubes()
        self.assertEqual(default_field([mesh]), "plastic_strain")
        mesh.cell_data["alive"][1] = 0  # nobody sees the strain of the eroded
        self.assertEqual(default_field([mesh]), "von_mises")

    def test_which_mirror_images_change_sign(self):
        mesh = two_cubes()
        self.assertTrue(Quantity("velocity_y", mesh).changes_sign("y"))
        self.assertTrue(Quantity("stress_xy", mesh).changes_sign("y"))
        self.assertFalse(Quantity("stress_xy", mesh).changes_sign("xy"))
        self.assertFalse(Quantity("stress_yy", mesh).changes_sign("y"))
        self.assertFalse(Quantity("velocity", mesh).changes_sign("y"))


class Colouring(unittest.TestCase):
    def test_ranges(self):
        self.assertEqual(limits_of([np.array([1.0, 2.0]), np.array([math.nan, 3.0])], False), (0.0, 3.0))
        self.assertEqual(limits_of([np.array([-5.0, 2.0])], True), (-5.0, 5.0))
        self.assertEqual(limits_of([np.zeros(3)], False), (0.0, 1.0))

    def test_lightness_falls_all_the_way(self):
        table = make_colours(types.SimpleNamespace(name="x", signed=False, label=""), (0, 1), []).table
        self.assertTrue((np.diff(table[:, :3] @ [0.2126, 0.7152, 0.0722]) < 0.0).all())


class Words(unittest.TestCase):
    def test_times_and_units(self):
        self.assertEqual(time_scale([0.0, 2.5e-5], "s"), (1e6, "µs"))
        self.assertEqual(time_scale([0.0, 2.5e-5], "ms"), (1.0, "ms"))
        self.assertEqual(readable_powers("N/m^2"), "N/m²")

    def test_round_lengths(self):
        self.assertEqual([round_length(x) for x in (1.0, 4.9, 0.073)], [1.0, 2.0, 0.05])


class Layouts(unittest.TestCase):
    def test_columns(self):
        self.assertEqual(number_of_columns(4, 1.5), 4)
        self.assertEqual(number_of_columns(4, 0.5), 2)
        self.assertEqual(number_of_columns(1, 1.0), 1)

    def test_panels_do_not_overlap_and_fit(self):
        layout = Layout(4, 0.5, 1600)
        self.assertLessEqual(layout.width, 1602)
        (x0, y0), (x3, y3) = layout.place(0), layout.place(3)
        self.assertGreaterEqual(x3, x0 + layout.panel[0])
        self.assertGreaterEqual(y3, y0 + layout.panel[1])
        self.assertLessEqual(y3 + layout.title + layout.panel[1], layout.height)
        self.assertEqual((layout.width % 2, layout.height % 2), (0, 0))


class Pages(unittest.TestCase):
    def test_pictures_come_between_the_marks_in_place_of_older_ones(self):
        with tempfile.TemporaryDirectory() as folder:
            self.assertIsNone(put_into_page(folder, "x"), "no page")
            page = pathlib.Path(folder, "index.html")
            page.write_text("<p>a</p>")
            self.assertIsNone(put_into_page(folder, "x"), "no marks")
            page.write_text("<p>a</p><!-- pictures -->old<!-- /pictures --><p>b</p>")
            for content in ("first", "second"):
                put_into_page(folder, content)
            self.assertEqual(page.read_text(), "<p>a</p><!-- pictures -->\nsecond\n<!-- /pictures --><p>b</p>")

    def test_a_film_is_one_image_for_each_time(self):
        frames = [Image.new("RGB", (40, 30), colour) for colour in ("red", "blue")]
        text = pictures(b"png", frames, [0.0, 1.5], "ms", "strain <b>")
        self.assertIn('data-times="[0.0, 1.5]" data-unit="ms"', text)
        self.assertEqual(text.count("data:image/webp;base64,"), 2)
        self.assertIn("strain &lt;b&gt;", text)

    def test_large_frames_are_made_smaller(self):
        noise = np.random.default_rng(1).integers(0, 256, (400, 400, 3), dtype=np.uint8)
        self.assertLess(len(frame_data(Image.fromarray(noise))), 1.2 * LARGEST_FRAME)


if __name__ == "__main__":
    sys.exit(unittest.main())
