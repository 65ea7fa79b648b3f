"""Pure functions of the viewer (python/view)."""

import math
import os
import pathlib
import sys
import tempfile
import tomllib
import types
import unittest

from recorded_paraview import run_state

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "python"))

import numpy as np
from PIL import Image

from view.camera import Camera, Frame, VIEWS, corners_of, parse_view
from view.colours import limits_of, make_colours
from view.drawing import points_seen
from view.fields import BadInput, Mesh, read_pvd
from view.history_plot import plot_history
from view.labels import power_of_ten, readable_powers, round_length, tick_texts, time_scale
from view.page import LARGEST_FRAME, Film, frame_data, pictures, put_into_page
from view.paraview import state_text
from view.quantity import Quantity, default_field, shown
from view.selection import chosen_bodies, choose_entries, elements_of, mirror_scales, parse_cut
from view.sheet import DARK, LIGHT, PAPER, Layout, Sheet, Surround, number_of_columns

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


class Fields(unittest.TestCase):
    def test_of_a_list_without_times_or_files_are_none(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "fields.pvd")
            for entry in ('timestep="1" file="a.vtu"', 'file="a.vtu"', 'timestep="1"', 'timestep="soon" file="a.vtu"'):
                with open(path, "w", encoding="utf-8") as file:
                    file.write(f"<VTKFile><Collection><DataSet {entry}/></Collection></VTKFile>")
                if entry.count("=") == 2 and "soon" not in entry:
                    self.assertEqual(read_pvd(path), [(1.0, os.path.join(folder, "a.vtu"))])
                else:
                    with self.assertRaisesRegex(BadInput, "a DataSet without a time and a file"):
                        read_pvd(path)


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

    def test_pressure_has_a_sign_and_displacement_a_length(self):
        mesh = two_cubes()
        mesh.cell_data["pressure"] = np.array([-1.0, 2.0])
        mesh.point_data["displacement"] = np.tile([0.0, 3.0, 4.0], (16, 1))
        mesh.components["displacement"] = list("xyz")
        mesh.units["length"] = "mm"
        pressure, displacement = Quantity("pressure", mesh), Quantity("displacement", mesh)
        self.assertEqual((pressure.label, pressure.signed, pressure.changes_sign("x")), ("pressure [N/m²]", True, False))
        self.assertEqual(pressure.of(mesh).tolist(), [-1.0, 2.0])
        self.assertEqual((displacement.label, displacement.signed), ("displacement [mm]", False))
        self.assertEqual(set(displacement.of(mesh)), {5.0})

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
        self.assertEqual(time_scale([0.0, 0.08], "ms"), (1e3, "µs"), "as the axes of the page")
        self.assertEqual(time_scale([0.0, 0.5], "s"), (1.0, "s"))
        self.assertEqual(time_scale([0.0, 1e-30], "s"), (1e9, "ns"), "there is no shorter name")
        self.assertEqual(time_scale([0.0, 1e-5], "lbf"), (1.0, "lbf"))
        self.assertEqual(readable_powers("N/m^2"), "N/m²")

    def test_round_lengths(self):
        self.assertEqual([round_length(x) for x in (1.0, 4.9, 0.073)], [1.0, 2.0, 0.05])


    def test_ticks_differ(self):
        self.assertEqual(tick_texts([22534.9, 22535.0, 22535.1]), ["22534.9", "22535", "22535.1"])
        self.assertEqual(tick_texts([-0.5, 0.0, 0.5]), ["−0.5", "0", "0.5"])
        self.assertEqual(tick_texts([0.0]), ["0"])
        self.assertEqual(power_of_ten(9.7e8), (1e8, "×10⁸"))
        self.assertEqual(power_of_ten(2e-5), (1e-5, "×10⁻⁵"))
        self.assertEqual(power_of_ten(0.0), (1.0, ""))


class Layouts(unittest.TestCase):
    def test_columns(self):
        self.assertEqual(number_of_columns(4, 1.5), 4)
        self.assertEqual(number_of_columns(4, 0.5), 2)
        self.assertEqual(number_of_columns(1, 1.0), 1)

    def test_panels_do_not_overlap_and_fit(self):
        layout = Layout(4, 0.5, 1600, 1.1)
        self.assertLessEqual(layout.width, 1602)
        (x0, y0), (x3, y3) = layout.place(0), layout.place(3)
        self.assertGreaterEqual(x3, x0 + layout.panel[0])
        self.assertGreaterEqual(y3, y0 + layout.panel[1])
        self.assertLessEqual(y3 + layout.title + layout.panel[1], layout.drawn)
        self.assertLessEqual(layout.drawn + layout.strip, layout.height)
        self.assertEqual((layout.width % 2, layout.height % 2), (0, 0))


def sheets_of_colours(colours):
    """A Sheet for each, of one drawing of that colour in the middle of nothing."""
    layout = Layout(1, 0.5, 300, 1.0)
    frame = Frame(Camera(25.0, 25.0), corners_of([0, 0, 0], [2, 1, 1]))
    bar = make_colours(types.SimpleNamespace(name="x", signed=False, label="strain"), (0, 1), [])
    surround = Surround(layout, frame, "mm", bar)
    sheets = []
    for time, colour in enumerate(colours):
        drawing = Image.new("RGBA", layout.panel, (0, 0, 0, 0))
        drawing.paste(colour, (10, 10, layout.panel[0] - 10, layout.panel[1] - 10))
        sheets.append(Sheet(layout, (drawing,), (f"t = {time} ms",), surround))
    return sheets


class Sheets(unittest.TestCase):
    def test_nothing_lies_over_the_bodies(self):
        """In the place of a drawing there is nothing of axes and measure: those have a strip below it."""
        (sheet,) = sheets_of_colours(["red"])
        layout = sheet.layout
        around = np.asarray(sheet.surround(LIGHT))
        self.assertEqual(around[layout.title : layout.drawn, : layout.panel[0], 3].max(), 0)
        self.assertGreater(around[layout.drawn :, : layout.panel[0], 3].max(), 0, "axes and a measure are there")
        for pixels, name in ((around[:3], "top"), (around[:, :1], "left"), (around[:, -1:], "right"), (around[-1:], "bottom")):
            self.assertEqual(pixels[..., 3].max(), 0, f"nothing is cut off at the {name}")

    def test_pages_are_seen_through_and_paper_is_white(self):
        (sheet,) = sheets_of_colours(["red"])
        self.assertEqual(sheet.on(DARK).getpixel((0, 0))[3], 0)
        self.assertEqual(sheet.on_paper().getpixel((0, 0)), (255, 255, 255))
        lightness = lambda ink: np.asarray(sheet.on(ink).convert("RGBA")).reshape(-1, 4)
        dark, light = lightness(DARK), lightness(LIGHT)
        written = light[:, 3] == 255
        self.assertGreater(dark[written][:, :3].mean(), light[written][:, :3].mean(), "what is written is lighter on dark pages")


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
        sheets = sheets_of_colours(["red", "blue"])
        film = Film()
        for sheet in sheets:
            film.add(sheet)
        text = pictures(sheets[0], film, "strain <b>")
        self.assertIn('data-titles="[&quot;t = 0 ms&quot;, &quot;t = 1 ms&quot;]"', text)
        self.assertEqual(text.count("data:image/webp;base64,"), 2)
        self.assertEqual(text.count("prefers-color-scheme: dark"), 2, "the picture, and what is around the film")
        self.assertIn("strain &lt;b&gt;", text)
        self.assertNotIn(' alt=""', text.replace('alt="" src="data:image/png', ""), "all but what is around a film is described")

    def test_large_frames_are_made_smaller(self):
        noise = np.random.default_rng(1).integers(0, 256, (400, 400, 3), dtype=np.uint8)
        self.assertLess(len(frame_data(Image.fromarray(noise))), 1.2 * LARGEST_FRAME)


class Histories(unittest.TestCase):
    COLUMNS = ["time", "dt", "kinetic", "total", "balance_error", "momentum_x", "momentum_y", "momentum_z", "rod_velocity_x",
               "rod_velocity_y", "rod_velocity_z", "rod_mass_remaining"]

    def drawn(self, **columns):
        """The picture of a history, (height, width, 3): 50 rows that are constant but for these columns."""
        constant = {"dt": 1.0, "kinetic": 2.0, "total": 2.0, "rod_mass_remaining": 1.0}
        rows = [[columns.get(name, lambda i: i if name == "time" else constant.get(name, 0.0))(i) for name in self.COLUMNS]
                for i in range(50)]
        with tempfile.TemporaryDirectory() as folder:
            text = "\n".join(",".join(repr(float(value)) for value in row) for row in rows)
            pathlib.Path(folder, "history.csv").write_text(",".join(self.COLUMNS) + "\n" + text + "\n")
            plot_history(folder, os.path.join(folder, "history.png"))
            return np.asarray(Image.open(os.path.join(folder, "history.png")).convert("RGB")).astype(int)

    def purple(self, picture):
        """Pixels of the curve of the time step."""
        return int((np.abs(picture - [148, 103, 189]).sum(axis=2) < 40).sum())

    def test_a_constant_step_is_drawn(self):
        steps = {"round-off": lambda i: 0.0208 + 1e-17 * (i % 3), "the same": lambda i: 3.3e-6, "zero": lambda i: 0.0,
                 "no number": lambda i: math.nan if i > 25 else 1.0, "growing": lambda i: 1.0 + i}
        for name, dt in steps.items():
            self.assertGreater(self.purple(self.drawn(dt=dt)), 150, name)

    def test_round_off_is_no_motion(self):
        noise = {f"{name}_{k}": lambda i: (-1) ** i * 1e-19 for name in ("momentum", "rod_velocity") for k in "xyz"}
        still, noisy = self.drawn(), self.drawn(**noise)
        blue = lambda picture: int((np.abs(picture[440:] - [31, 119, 180]).sum(axis=2) < 40).sum())
        self.assertLess(abs(blue(noisy) - blue(still)), 200, "no more curves than of zero")


class ParaViewStates(unittest.TestCase):
    def state(self, field, options=(), bodies=(0, 1)):
        """What a state file does in a ParaView that records it: {variable or registration name: object}."""
        mesh = two_cubes()
        quantity = Quantity(field, mesh)
        camera = Camera(25.0, 25.0)
        names = ["rod", "plate"]
        drawing = types.SimpleNamespace(
            quantity=quantity, camera=camera, frame=Frame(camera, mesh.points), names=names, bodies=list(bodies), cut=None,
            options=types.SimpleNamespace(edges=True, mirror=""), colours=make_colours(quantity, (0.0, 0.5), names))
        for name, value in dict(options).items():
            setattr(drawing.options if hasattr(drawing.options, name) else drawing, name, value)
        with tempfile.TemporaryDirectory() as folder:
            there = pathlib.Path(folder, "moved")
            there.mkdir()
            (there / "fields.pvd").write_text("")
            (there / "fields_paraview.py").write_text(state_text(drawing))
            recorded = run_state(there / "fields_paraview.py")
            self.assertEqual(recorded["fields"].FileName, str(there / "fields.pvd"), "beside the state, wherever that is")
            (there / "fields.pvd").unlink()
            with self.assertRaisesRegex(RuntimeError, "fields.pvd is not there: start ParaView in"):
                run_state(there / "fields_paraview.py")
        return drawing, recorded

    def test_colours_are_those_of_the_pictures(self):
        drawing, recorded = self.state("plastic_strain")
        points = np.array(recorded["colours"].RGBPoints).reshape(-1, 4)
        self.assertEqual((points[0, 0], points[-1, 0]), (0.0, 0.5))
        np.testing.assert_allclose(points[[0, -1], 1:], drawing.colours.table[[0, -1], :3], atol=1e-8)
        self.assertTrue((np.diff(points[:, 0]) > 0.0).all())
        self.assertEqual(recorded["ColorBy"], ("CELLS", "plastic_strain"))
        self.assertEqual(recorded["bar"].Title, "effective plastic strain")

    def test_components_have_the_names_that_paraview_has(self):
        for field, array in (("velocity", ("POINTS", "velocity", "Magnitude")), ("velocity_y", ("POINTS", "velocity", "Y")),
                             ("stress_yz", ("CELLS", "stress", "yz"))):
            self.assertEqual(self.state(field)[1]["ColorBy"], array)

    def test_the_view_is_that_of_the_pictures(self):
        drawing, recorded = self.state("body", {"mirror": "y", "cut": parse_cut("x<0.5")}, bodies=[1])
        view = recorded["view"]
        toward = np.subtract(view.CameraPosition, view.CameraFocalPoint)
        np.testing.assert_allclose(toward / np.linalg.norm(toward), drawing.camera.toward, atol=1e-6)
        width, height = view.ViewSize
        self.assertGreaterEqual(2.0 * view.CameraParallelScale, drawing.frame.height - 1e-6)
        self.assertGreaterEqual(2.0 * view.CameraParallelScale * width / height, drawing.frame.width)
        self.assertEqual(recorded["colours"].Annotations, ["0", "rod", "1", "plate"])
        self.assertEqual([recorded[name].kind for name in ("body 1", "cut", "mirror Y")], ["Threshold", "Clip", "Reflect"])
        self.assertEqual(recorded["cut"].ClipType.Normal, [-1.0, 0.0, 0.0])
        self.assertIs(recorded["mirror Y"].Input, recorded["cut"])
        self.assertIs(recorded["shown"].Input, recorded["mirror Y"])


class Scenes(unittest.TestCase):
    def test_those_that_come_along_leave_what_pictures_need(self):
        scenes = sorted(pathlib.Path(__file__).parents[2].joinpath("data", "scenes").glob("*.toml"))
        self.assertGreater(len(scenes), 20)
        for path in scenes:
            scene = tomllib.loads(path.read_text())
            output = scene.get("output", {})
            if path.stem == "block":
                continue  # a hundred steps to be measured
            self.assertTrue("field_interval" in output or output.get("field_times"), path.name)
            if "field_interval" in output:
                self.assertAlmostEqual(scene["time"]["end"] / output["field_interval"], 30, delta=6, msg=path.name)


if __name__ == "__main__":
    sys.exit(unittest.main())
