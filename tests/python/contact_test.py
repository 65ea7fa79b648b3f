"""Contact alone in Python, beside the same host in C: contact_test.py INCLUDE_FOLDER ARCHIVE FOLDER"""

import gc
import pathlib
import subprocess
import sys
import unittest

import numpy as np
import pinball

FOLDER, ARCHIVE, INCLUDE = (pathlib.Path(sys.argv.pop()) for _ in range(3))
HOST = pathlib.Path(__file__).resolve().parent.parent / "embedding" / "two_bars.c"
BARS, LENGTH, DT, MODULUS = 2, 10, 0.05, 100.0
RADIUS_FACTOR = 0.8059959770082347


def host_in_c():
    """Momentum, energies and velocities as texts."""
    FOLDER.mkdir(parents=True, exist_ok=True)
    program = FOLDER / "two_bars"
    subprocess.run(["cc", "-std=c11", "-O1", "-ffp-contract=off", f"-I{INCLUDE}", HOST, ARCHIVE, "-lstdc++", "-lgomp",
                    "-lpthread", "-lm", "-o", program], check=True)
    lines = subprocess.run([program], check=True, stdout=subprocess.PIPE, text=True).stdout.splitlines()
    return dict(line.split() for line in lines)


class Bars:
    """The two bars of two_bars.c, operation by operation."""

    def __init__(self, number=np.float64, index=np.int32, records=3):
        nodes = BARS * (LENGTH + 1) * 4
        self.x, self.v, self.f = (np.zeros((nodes, records), number)[:, :3] for _ in range(3))
        for bar in range(BARS):
            for layer in range(LENGTH + 1):
                at = slice((bar * (LENGTH + 1) + layer) * 4, (bar * (LENGTH + 1) + layer) * 4 + 4)
                self.x[at] = [[bar * (LENGTH + 0.5) + layer, y, z] for y, z in ((0, 0), (1, 0), (1, 1), (0, 1))]
                self.v[at, 0] = 0.1 if bar == 0 else 0.0
        first = np.array([(bar * (LENGTH + 1) + i) * 4 for bar in range(BARS) for i in range(LENGTH)])
        self.corners = (first[:, None] + np.arange(8)).astype(index)
        self.body = np.repeat(np.arange(BARS, dtype=np.int32), LENGTH)
        self.mass = np.zeros(nodes, number)
        for element in self.corners:
            self.mass[element] += 1.0 / 8
        self.modulus = np.array([MODULUS / 3], number)

    def contact(self, **changes):
        return pinball.Contact(**{"position": self.x, "mass": self.mass, "corners": self.corners, "body": self.body,
                                  "bulk_modulus": self.modulus, "part": np.zeros(len(self.corners), np.int32),
                                  "beta": 3.0, "radius_factor": RADIUS_FACTOR, "self": 0, **changes})

    def add_spring_forces(self):
        stiffness, energy = MODULUS / 4, 0.0
        for element in self.corners:
            for left, right in zip(element[:4], element[4:]):
                stretch = self.x[right, 0] - self.x[left, 0] - 1.0
                self.f[left, 0] += stiffness * stretch
                self.f[right, 0] -= stiffness * stretch
                energy += 0.5 * stiffness * stretch * stretch
        return energy

    def kinetic_energy(self, step):
        total = 0.0
        for m, v, f in zip(self.mass, self.v, self.f):
            terms = [v[k] * (m * v[k] + f[k] * step) for k in range(3)]
            total += (terms[0] + terms[1] + terms[2]) / 2
        return total

    def momentum(self, first, last):
        total = 0.0
        for i in range(first, last):
            total += self.mass[i] * self.v[i, 0]
        return total

    def run(self, contact, steps=160):
        for step in range(steps + 1):
            before, after = (0.0 if step == 0 else DT), (0.0 if step == steps else DT)
            self.f[:] = 0
            energy = self.add_spring_forces()
            contact.update(self.x, self.v, before)
            result = contact.add_forces(self.f, after)
            if step == steps:
                energy += self.kinetic_energy(before) + result.stored + result.dissipated
            self.v += self.f / self.mass[:, None] * (before + after) / 2
            self.x += self.v * after
        return energy, result


class TwoBars(unittest.TestCase):
    def test_have_the_bits_of_the_host_in_c(self):
        expected = host_in_c()
        bars = Bars()
        energy, result = bars.run(bars.contact())
        half = len(bars.x) // 2
        self.assertGreater(result.searches, 0)
        for name, value in {"momentum_final": bars.momentum(0, 2 * half), "energy_final": energy,
                            "contact_dissipated": result.dissipated, "velocity_bar1": bars.momentum(0, half) / 10,
                            "velocity_bar2": bars.momentum(half, 2 * half) / 10}.items():
            self.assertEqual(value, float(expected[name]), name)

    def test_have_one_result_for_any_layout(self):
        ends = []
        for arrays in ({}, {"index": np.int64}, {"records": 4}, {"records": 7}):
            bars = Bars(**arrays)
            contact = bars.contact(enforcement="lagrange", threads=2)
            bars.run(contact)
            ends.append(bars.v.copy())
        for end in ends[1:]:
            np.testing.assert_array_equal(end, ends[0])
        self.assertGreater(ends[0][-1, 0], 0.05)

    def test_in_float(self):
        bars = Bars(number=np.float32)
        bars.run(bars.contact())
        other = Bars()
        other.run(other.contact())
        np.testing.assert_allclose(bars.v, other.v, atol=2e-4)  # places of float are good to 1e-6

    def test_may_be_of_temporary_arrays(self):
        bars = Bars()
        contact = pinball.Contact(bars.x.copy(), bars.mass.copy(), bars.corners.tolist(), body=bars.body.tolist(),
                                  bulk_modulus=[MODULUS / 3] * len(bars.corners), beta=3.0, self=0,
                                  radius_factor=RADIUS_FACTOR)
        gc.collect()
        bars.run(contact)
        other = Bars()
        other.run(other.contact())
        np.testing.assert_array_equal(bars.v, other.v)

    def test_take_flags_of_any_whole_numbers(self):
        bars = Bars()
        count = len(bars.corners)
        contact = bars.contact(hidden_faces=[0] * count)
        for alive in ([1] * count, [True] * count, np.ones(count, np.int64), np.ones(count, np.uint8)):
            contact.update(bars.x, bars.v, 0.0, alive=alive)
            contact.add_forces(bars.f, 0.0)
        with self.assertRaisesRegex(pinball.InputError, "alive: expected whole numbers, got float64"):
            contact.update(bars.x, bars.v, 0.0, alive=[1.0] * count)


class Spheres(unittest.TestCase):
    def test_push_each_other_apart(self):
        x = np.array([[0.0, 0, 0], [1.9, 0, 0]])
        contact = pinball.Contact(x, np.ones(2), sphere_node=[0, 1], sphere_radius=[1.0, 1.0],
                                  sphere_bulk_modulus=[10.0, 10.0])
        velocity = np.array([[0.5, 0, 0], [-0.5, 0, 0]])
        for before in (0.0, 0.1):
            force = np.zeros((2, 3))
            contact.update(x, velocity, before)
            result = contact.add_forces(force, 0.1)
            x += 0.1 * velocity
        self.assertEqual(result.pairs, 1)
        self.assertLess(force[0, 0], 0)
        np.testing.assert_array_equal(force[0], -force[1])


class Errors(unittest.TestCase):
    def test_are_exceptions_that_name_the_argument(self):
        bars = Bars()
        for changes, message in [
            ({"beta": -1.0}, "beta"),
            ({"method": "balls"}, 'options.method: unknown value "balls"'),
            ({"mass": bars.mass[:-1]}, "mass: expected 88 numbers, got 87"),
            ({"corners": bars.corners + 1000}, "corners"),
            ({"body": bars.body.astype(np.int64) << 32}, "body: expected numbers that int32 can hold"),
            ({"body": [0.0] * len(bars.body)}, "body: expected whole numbers, got float64"),
            ({"hidden_faces": [256] * len(bars.body)}, "hidden_faces: expected numbers that uint8 can hold"),
            ({"hidden_faces": [-1] * len(bars.body)}, "hidden_faces: expected numbers that uint8 can hold"),
            ({"mass": [1j] * len(bars.mass)}, "mass: expected numbers, got complex128"),
            ({"position": bars.x.astype(int)}, "position: expected numbers of float64 or float32, got int64"),
            ({"position": bars.x[:, :2]}, "position: expected an array of shape"),
        ]:
            with self.assertRaisesRegex(pinball.InputError, message):
                bars.contact(**changes)
        with self.assertRaisesRegex(TypeError, "no option \"bta\""):
            bars.contact(bta=1)

    def test_of_calls_leave_the_contact_as_it_was(self):
        bars = Bars()
        contact = bars.contact()
        with self.assertRaisesRegex(pinball.InputError, "expected a call of update"):
            contact.add_forces(bars.f, DT)
        contact.update(bars.x, bars.v, 0.0)
        with self.assertRaises(pinball.InputError):
            contact.update(bars.x, bars.v, DT)
        read_only = bars.f.copy()
        read_only.flags.writeable = False
        for force in (read_only, bars.f.astype(np.float32), bars.f[:-1]):
            with self.assertRaises(pinball.InputError):
                contact.add_forces(force, DT)
        self.assertEqual(contact.add_forces(bars.f, DT).pairs, 0)


if __name__ == "__main__":
    unittest.main()
