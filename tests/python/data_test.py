"""Data of the Python package: fields, texts, equality, pickles and copies. PYTHONPATH names the package's folder."""

import copy
import gc
import json
import pathlib
import pickle
import random
import re
import unittest

import numpy as np
import pinball

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
SCENES = sorted(path.stem for path in (ROOT / "data" / "scenes").glob("*.toml"))

# C++ structs of scenes by their Python classes, with the fields that have another name in Python.
CLASSES = {"PlaneConstraint": "SymmetryPlane", "FixedConstraint": "Fixed", "NodalLoad": "Load",
           "PowerHardeningSettings": "PowerHardening", "JohnsonCookSettings": "JohnsonCook", "JohnsonHolmquistSettings": "JohnsonHolmquist", "DruckerPragerSettings": "DruckerPrager", "CrushableFoamSettings": "CrushableFoam", "EquationOfStateSettings": "EquationOfState", "FluidSettings": "Fluid", "MooneyRivlinSettings": "MooneyRivlin", "OgdenSettings": "Ogden", "OrthotropicSettings": "Orthotropic",
           "ErosionSettings": "Erosion"}
NAMES = {("Scene", "constraints"): "symmetry_planes", ("Scene", "fixed_constraints"): "fixed"}
HEADERS = ["scene.hpp", "scene_boundary.hpp", "scene_contact.hpp", "scene_material.hpp", "mesh_settings.hpp", "contact/contact_settings.hpp"]


def structs():
    """(struct, its members) of the headers that describe a scene."""
    for header in HEADERS:
        text = re.sub(r"//.*", "", (ROOT / "solver" / header).read_text())
        for name, body in re.findall(r"^struct (\w+) \{\n(.*?)^\};", text, re.M | re.S):
            body = re.sub(r"<[^<>]*>|\{[^{}]*\}|=[^;]*", "", re.sub(r"<[^<>]*>", "", body))  # types, then values
            members = re.findall(r"^  [\w:]+ (\w+(?:, \w+)*)\s*;", body, re.M)
            yield name, [member for declaration in members for member in declaration.split(", ")
                         if member != "operator"]


class Lists(unittest.TestCase):
    def names(self, materials):
        return [material.name for material in materials]

    def materials(self, names):
        return pinball.Scene(materials=[pinball.Material(name=name) for name in names]).materials

    def test_do_what_python_lists_do(self):
        extra = pinball.Material(name="x")
        changes = [lambda l: l.append(extra), lambda l: l.insert(1, extra), lambda l: l.insert(-99, extra), lambda l: l.insert(99, extra),
                   lambda l: l.extend([extra, l[0]]), lambda l: l.pop(), lambda l: l.pop(1), lambda l: l.remove(l[2]),
                   lambda l: l.reverse(), lambda l: l.clear(), lambda l: l.__setitem__(-1, extra), lambda l: l.__delitem__(0),
                   lambda l: l.__setitem__(slice(1, 3), [extra] * 4), lambda l: l.__delitem__(slice(None, None, 2)),
                   lambda l: l.__iadd__([extra])]
        for number, change in enumerate(changes):
            ours, pythons = self.materials("abcd"), list(self.materials("abcd"))
            change(ours)
            change(pythons)
            self.assertEqual(self.names(ours), self.names(pythons), f"change {number}")
        ours = self.materials("abcd")
        self.assertEqual(self.names(ours[1:3]), ["b", "c"])
        self.assertEqual(self.names(reversed(ours)), ["d", "c", "b", "a"])
        self.assertEqual((len(ours), ours.index(ours[2]), ours.count(ours[0]), ours[1] in ours, extra in ours), (4, 2, 1, True, False))
        self.assertFalse(self.materials(""))

    def test_show_their_elements_and_copy_slices(self):
        ours = self.materials("ab")
        ours[-1].name = "c"
        ours[:][0].name = "d"
        self.assertEqual(self.names(ours), ["a", "c"])

    def test_have_the_same_elements_however_they_change(self):
        """What a reference changes is in the list as long as its element is, and nowhere else."""
        draw = random.Random(5)
        long = "long enough that its text is no part of the element"
        for run in range(200):
            ours, pythons, held = self.materials("abcdef"), list(self.materials("abcdef")), []

            def new(count):
                return [pinball.Material(name=f"{long} {draw.random()}") for _ in range(count)]
            for step in range(12):
                size = len(ours)
                for i in draw.sample(range(size), min(size, 2)):
                    held.append((ours[i], pythons[i]))
                i, j, more = draw.randint(-1, size), draw.randint(0, size), new(draw.randint(0, 20))
                change = draw.choice([lambda l: l.append(pinball.Material(name=f"last {step}")), lambda l: l.insert(i, pinball.Material(name=str(step))),
                                      lambda l: l.extend(more), lambda l: l.__delitem__(slice(i, j)), lambda l: l.reverse(),
                                      lambda l: l.__delitem__(slice(None, None, draw.choice([-2, 3]))) if step == 7 else None,
                                      lambda l: l.__setitem__(slice(i, j), more), lambda l: l.pop() if l else None,
                                      lambda l: l.__setitem__(0, pinball.Material(name=f"set {step}")) if l else None])
                state = draw.getstate()
                for values in (ours, pythons):
                    draw.setstate(state)
                    change(values)
                pythons = [copy.copy(one) if any(one is new for new in more) else one for one in pythons]
                for number, (one, other) in enumerate(held):
                    one.name = other.name = f"{long}: {run} {step} {number}"
                self.assertEqual(self.names(ours), self.names(pythons), f"run {run}, step {step}")
                self.assertEqual([one.name for one, _ in held], [other.name for _, other in held])

    def test_that_are_replaced_are_no_longer_of_the_scene(self):
        scene = pinball.Scene(bodies=[pinball.Body(name="a rod with a long name", mesh=pinball.BlockMesh())])
        bodies, body, mesh = scene.bodies, scene.bodies[0], scene.bodies[0].mesh
        body.mesh = pinball.SphereMesh(radius=2)
        mesh.size = [1, 2, 3]
        self.assertEqual((mesh.size, scene.bodies[0].mesh), ([1, 2, 3], pinball.SphereMesh(radius=2)))
        scene.bodies += [pinball.Body(name="b")] * 20
        self.assertIs(scene.bodies, bodies)
        body.name = "another rod with a long name"
        self.assertEqual(scene.bodies[0].name, body.name)
        ball = body.mesh
        scene.bodies = [pinball.Body(name="new")]
        body.name, ball.radius = "an old rod with a long name", 3
        bodies.append(pinball.Body(name="more"))
        self.assertEqual((len(bodies), bodies[0].name, bodies[0].mesh.radius), (22, body.name, 3))
        self.assertEqual(scene.bodies, [pinball.Body(name="new")])
        contact = scene.contact
        scene.contact = type(contact)()
        scene.contact.friction = 0.3
        contact.friction = 0.1
        self.assertEqual(scene.contact.friction, 0.3)

    def test_that_are_nested_keep_what_another_took_the_place_of(self):
        """Sections of a block are elements of vectors: the old ones were freed while Python had them."""
        sections = [[], [], [pinball.BlockSection(length=5.0, elements=7)]]
        mesh = pinball.BlockMesh(size=[1, 1, 5], elements=[1, 1, 7], sections=sections)
        old = mesh.sections[2][0]
        others = []
        for i in range(200):
            mesh.sections = [[], [], [pinball.BlockSection(length=2.0, elements=3)] * (1 + i % 4)]
            others.append(pinball.BlockMesh(sections=[[], [], [pinball.BlockSection(length=9.0, elements=i + 1)]]))
        self.assertEqual((old.length, old.elements, mesh.sections[2][0].length), (5.0, 7, 2.0))

    def test_keep_what_is_taken_out(self):
        bodies = pinball.Scene(bodies=[pinball.Body(name=f"a body with a long name {i}", mesh=pinball.SphereMesh(radius=i)) for i in range(9)]).bodies
        last, mesh = bodies[8], bodies[4].mesh
        del bodies[:]
        gc.collect()
        bodies.extend([pinball.Body(name="x" * 100)] * 50)
        self.assertEqual((last.name, last.mesh.radius, mesh.radius), ("a body with a long name 8", 8, 4))

    def test_refuse_what_is_no_element_and_keep_what_they_have(self):
        ours = self.materials("ab")
        with self.assertRaisesRegex(TypeError, "Materials: Material expected, str given"):
            ours.append("c")
        with self.assertRaisesRegex(TypeError, "Materials: Material expected, Body given"):
            ours[0] = pinball.Body()
        with self.assertRaises(TypeError):
            ours[0:1] = [1]
        for place in (2, -3, 2**70):
            with self.assertRaises(IndexError):
                ours[place]
        for place in ("a", 0.0, None):
            with self.assertRaises(TypeError):
                ours[place]
            with self.assertRaises(TypeError):
                ours[place] = pinball.Material()
            with self.assertRaises(TypeError):
                del ours[place]
        self.assertEqual(self.names(ours), ["a", "b"])


class Fields(unittest.TestCase):
    def test_of_a_scene_are_all_there(self):
        seen = 0
        for struct, members in structs():
            if struct == "DampingSettings":  # Scene.damping is its only member
                continue
            data = getattr(pinball, CLASSES.get(struct, struct))
            for member in members:
                if (struct, member) in (("ArrayMesh", "owner"), ("SceneSource", "given"), ("FileMesh", "held")):  # not for hosts
                    continue
                self.assertTrue(hasattr(data, NAMES.get((struct, member), member)), f"{struct}.{member}")
                seen += 1
        self.assertGreater(seen, 100)

    def test_are_described_by_repr(self):
        material = pinball.Material(name="steel", density=7850)
        self.assertEqual(repr(material), "Material(name='steel', density=7850.0)")
        self.assertEqual(eval(repr(material), vars(pinball)), material)
        self.assertEqual(repr(pinball.Scene()), "Scene()")
        scene = pinball.Scene(materials=[material])
        self.assertEqual(repr(scene), "Scene(materials=[Material(name='steel', density=7850.0)])")

    def test_refuse_what_has_another_type(self):
        with self.assertRaisesRegex(TypeError, r"Material.density: float expected, str given"):
            pinball.Material(density="heavy")
        with self.assertRaisesRegex(TypeError, r"Scene.materials: Materials expected, int given"):
            pinball.Scene().materials = 1
        with self.assertRaisesRegex(TypeError, r"Body.velocity: .*float.* expected, list given"):
            pinball.Body(velocity=["a", 0, 0])

    def test_refuse_to_lose_what_is_changed_in_place(self):
        """A list of numbers or texts that a field shows is a copy: what is changed in it would be lost."""
        changes = [lambda l: l.__setitem__(0, l[0]), lambda l: l.__setitem__(slice(0, 1), [l[0]]), lambda l: l.__delitem__(0), lambda l: l.append(l[0]),
                   lambda l: l.extend(l), lambda l: l.insert(0, l[0]), lambda l: l.pop(), lambda l: l.remove(l[0]),
                   lambda l: l.clear(), lambda l: l.sort(), lambda l: l.sort(reverse=True), lambda l: l.reverse()]
        seen = 0
        for name, data in vars(pinball).items():
            if not isinstance(data, type) or name.endswith("Result") or "kwargs" not in str(data.__init__.__doc__):
                continue
            for field in data.__annotations__:
                shown = getattr(data(), field)
                for each in [shown, *shown] if isinstance(shown, list) else []:
                    if not isinstance(each, list):
                        continue
                    for change in changes[3 if not each else 0:]:
                        if not each and change in (changes[3], changes[5], changes[7]):
                            continue
                        with self.assertRaisesRegex(TypeError, rf"{name}\.{field} shows a copy"):
                            change(each)
                        seen += 1
        self.assertGreater(seen, 300)

    def test_show_lists_that_are_lists(self):
        body = pinball.Body(velocity=[1, 2, 3], velocity_gradient=[[1, 0, 0], [0, 1, 0], [0, 0, 1]])
        for again in (copy.copy(body.velocity), copy.deepcopy(body.velocity), pickle.loads(pickle.dumps(body.velocity)), list(body.velocity)):
            again.append(4.0)
            self.assertEqual((again, type(again)), ([1, 2, 3, 4], list))
        gradient = copy.deepcopy(body.velocity_gradient)
        gradient[2][1] = 7.0
        body.velocity_gradient = gradient
        self.assertEqual(body.velocity_gradient, [[1, 0, 0], [0, 1, 0], [0, 7, 1]])
        self.assertEqual((json.dumps(body.velocity), repr(body.velocity)), ("[1.0, 2.0, 3.0]", "[1.0, 2.0, 3.0]"))
        output = pinball.OutputSettings(fields=["stress"])
        output.fields += ["alive"]
        self.assertEqual(output.fields, ["stress", "alive"])
        output.fields *= 2
        self.assertEqual(output.fields, ["stress", "alive"] * 2)

    def test_make_meshes(self):
        made = pinball.SphereMesh(radius=1.0, core=[2, 2], ring=2)
        self.assertEqual((made.radius, made.section), (1.0, pinball.Section("full")))
        cylinder = pinball.Scene(
            materials=[pinball.Material(name="m", density=1, bulk_modulus=1, shear_modulus=1)],
            bodies=[pinball.Body(name="b", material="m",
                                 mesh=pinball.CylinderMesh(radius=1, length=2, core=2, ring=1, layers=3))])
        cylinder.time.end = 1
        self.assertEqual(pinball.Simulation(cylinder).elements, 36)


class Copies(unittest.TestCase):
    def test_of_all_scenes_are_equal(self):
        self.assertGreater(len(SCENES), 20)
        for name in SCENES:
            try:
                scene = pinball.read_scene(name)
            except pinball.InputError:  # one that needs a variant
                continue
            for again in (pickle.loads(pickle.dumps(scene)), copy.deepcopy(scene), copy.copy(scene)):
                self.assertEqual(again, scene, name)
                self.assertEqual(repr(again), repr(scene), name)

    def test_are_apart(self):
        scene = pinball.read_scene("two_bars")
        again = copy.deepcopy(scene)
        again.bodies[0].name = "another"
        self.assertEqual(scene.bodies[0].name, "bar1")
        self.assertNotEqual(again, scene)

    def test_of_arrays_keep_them(self):
        coordinates = np.arange(24, dtype=np.float32).reshape(8, 3)
        mesh = pinball.ArrayMesh(coordinates, np.arange(1, 9).reshape(1, 8), first_index=1)
        again = pickle.loads(pickle.dumps(mesh))
        self.assertEqual(again, mesh)
        self.assertEqual(repr(again), "ArrayMesh(8 nodes, 1 element)")
        coordinates[0, 0] = 7
        self.assertNotEqual(again, mesh)
        self.assertEqual(mesh.coordinates[0, 0], 7)  # the caller's own
        view = again.coordinates
        del again
        np.testing.assert_array_equal(view[7], [21, 22, 23])
        self.assertEqual(view.dtype, np.float32)

    def test_of_results_are_equal(self):
        simulation = pinball.Simulation(pinball.read_scene("two_bars"))
        simulation.run_until(1.0)
        row = simulation.history_row()
        again = pickle.loads(pickle.dumps(row))
        self.assertEqual(again, row)
        self.assertEqual(again.energy.total, row.energy.total)
        self.assertIn("BodyResult(name='bar1'", repr(again))

    def test_give_the_same_bits(self):
        hashes = set()
        for scene in (pinball.read_scene("two_blocks"), pickle.loads(pickle.dumps(pinball.read_scene("two_blocks")))):
            simulation = pinball.Simulation(scene)
            simulation.run()
            hashes.add(simulation.state_hash)
        self.assertEqual(len(hashes), 1)


class Package(unittest.TestCase):
    def test_has_the_version_of_the_library(self):
        version = re.findall(r"#define PINBALL_VERSION_(?:MAJOR|MINOR|PATCH) (\d+)",
                             (ROOT / "solver" / "base" / "version.h").read_text())
        self.assertEqual(pinball.__version__, ".".join(version))

    def test_shows_its_classes_as_its_own(self):
        self.assertEqual((pinball.Scene.__module__, pinball.InputError.__module__), ("pinball", "pinball"))


if __name__ == "__main__":
    unittest.main()
