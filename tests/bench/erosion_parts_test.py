"""What bench/erosion reads of a deck, and the scene that it makes of it."""

import os
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "bench"))

from study_parts import deck

CUBE = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]


def two_cubes(held):
    """Deck of a cube on another; held(x, y, z) of each node: tc."""
    lines = ["*KEYWORD", "*CONTROL_TERMINATION", "       7.5", "*NODE"]
    number = 0
    for z0 in (0.0, 2.0):
        for x, y, z in CUBE:
            number += 1
            lines.append(f"{number:8d}{float(x):16.6E}{float(y):16.6E}{z + z0:16.6E}{held(x, y, z + z0):8d}{0:8d}")
    lines += ["*ELEMENT_SOLID"]
    for part in (1, 2):
        lines.append("".join(f"{v:8d}" for v in [part, part, *range(8 * part - 7, 8 * part + 1)]))
    lines += ["*PART", "Target", "         1         1         2", "Striker", "         2         1         1",
              "*MAT_PLASTIC_KINEMATIC", f"{1:10d}{2.0:10}{3.0:10}{0.25:10}{0.01:10}{1.0:10}{1.0:10}", f"{'':20}{0.8:10}",
              "*MAT_PLASTIC_KINEMATIC", f"{2:10d}{4.0:10}{3.0:10}{0.25:10}{0.01:10}{'':10}{1.0:10}", "$ a comment", "",
              "*INITIAL_VELOCITY_GENERATION", f"{2:10d}{1:10d}{'':10}{0.5:10}{0.0:10}{-1.5:10}",
              "*CASE_BEGIN_1", "*INITIAL_VELOCITY_GENERATION", f"{2:10d}{1:10d}{'':10}{9.0:10}", "*CASE_END_1",
              "*DATABASE_GLSTAT", "       0.1", "*END", "*NODE", "what stands after the end is not read"]
    return "\n".join(lines) + "\n"


def read(text):
    with tempfile.TemporaryDirectory() as where:
        path = os.path.join(where, "deck.k")
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        return deck.read(path)


def written(given, seed=None):
    with tempfile.TemporaryDirectory() as where:
        with open(deck.write_scene(given, where, seed), encoding="utf-8") as scene:
            with open(os.path.join(where, "mesh.msh"), encoding="utf-8") as mesh:
                return scene.read(), mesh.read()


class Decks(unittest.TestCase):
    def test_what_is_read(self):
        given = read(two_cubes(lambda x, y, z: 0))
        self.assertEqual((len(given.nodes), len(given.elements), given.end), (16, 2, 7.5))
        self.assertEqual(given.velocities, [(2, 0.5, 0.0, -1.5)])
        self.assertEqual(given.materials[1], {"density": 2.0, "young_modulus": 3.0, "poisson_ratio": 0.25,
                                              "yield_stress": 0.01, "plastic_modulus": 1.5, "erosion_strain": 0.8})
        self.assertEqual(given.materials[2]["erosion_strain"], 0.0)
        self.assertIn("*DATABASE_GLSTAT", given.ignored)

    def test_the_scene_and_its_mesh(self):
        scene, mesh = written(read(two_cubes(lambda x, y, z: 7 if z == 0 else 2 if y == 0 else 0)))
        self.assertIn('name = "target"\nmaterial = "m2"', scene)
        self.assertIn("velocity = [0.5, 0.0, -1.5]", scene)
        self.assertEqual(scene.count('type = "symmetry"'), 2)
        self.assertEqual(scene.count('type = "fixed"'), 1)
        self.assertIn("directions = ['x', 'y', 'z']\nplane = { point = [0.0, 0.0, 0.0], normal = [0.0, 0.0, 1.0] }", scene)
        self.assertIn("$Elements\n2\n1 5 2 1 1 1 2 3 4 5 6 7 8\n", mesh)

    def test_only_free_nodes_are_moved(self):
        given = read(two_cubes(lambda x, y, z: 2 if y == 0 else 0))
        plain, moved = written(given)[1].splitlines(), written(given, seed=1)[1].splitlines()
        self.assertEqual(sum(a != b for a, b in zip(plain, moved)), 8)
        self.assertEqual(moved, written(given, seed=1)[1].splitlines())

    def test_held_nodes_off_planes_are_refused(self):
        with self.assertRaises(deck.Unreadable):
            written(read(two_cubes(lambda x, y, z: 7 if (x, y, z) == (1, 1, 1) else 0)))


if __name__ == "__main__":
    unittest.main()
