"""How bench/serial reads stacks, and what it counts as one thread's."""

import unittest

from bench_command import load_command

serial = load_command("serial")

TEXT = """pinball 17 1.5:    5000000 cpu-clock:
\t          2d9fe8 pinball::RangeOf<pinball::Some::work(long)::{lambda(long)#1}>::work+0xf8 (/a/pinball)
\t          300a72 pinball::Contact<double>::search+0xd2 (/a/pinball)
\t          300a73 pinball::Solver<double>::make_step+0xd2 (/a/pinball)
\tffffffffffffffff [unknown] ([unknown])

pinball 17 1.6:    5000000 cpu-clock:
\t          1111111 __memset_avx2+0x1 (/lib/libc.so.6)
\t          300a72 pinball::Contact<double>::search+0xd9 (/a/pinball)
\t          300a73 pinball::Solver<double>::make_step+0xd2 (/a/pinball)

pinball 17 1.7:    5000000 cpu-clock:
\t          300a72 pinball::history_row<double>+0xd9 (/a/pinball)
\t          300a73 pinball::Recorder::record+0xd2 (/a/pinball)
\t          300a74 pinball::Simulation::step+0xd2 (/a/pinball)

pinball 17 1.8:    5000000 cpu-clock:
\t          300a72 pinball::update_tile<double, pinball::F{1, (pinball::K)2}>+0xd9 (/a/pinball)

pinball 17 1.8:    5000000 cpu-clock:
\t          300a72 pinball::update_element_pack<simd<double, A>, pinball::F{1, (pinball::K)2}>+0xd9 (/a/pinball)
\t          300a72 pinball::update_element_pack<simd<double, A>, pinball::F{1, (pinball::K)2}>+0xd9 (/a/pinball)

pinball 17 1.8:    5000000 cpu-clock:
\t          300a72 pinball::update_tetrahedron_pack<simd<double, A>, pinball::F{1, (pinball::K)2}>+0xd9 (/a/pinball)

pinball 17 1.9:    5000000 cpu-clock:
\t          300a72 pinball::volume_by_quadrature+0xd9 (/a/pinball)
\t          300a72 pinball::build_model<double>+0xd9 (/a/pinball)
"""


class Serial(unittest.TestCase):
    def test_stacks(self):
        stacks = list(serial.stacks_of(TEXT))
        self.assertEqual(len(stacks), 7)
        self.assertEqual(stacks[1], ["__memset_avx2", "pinball::Contact<double>::search", "pinball::Solver<double>::make_step"])
        self.assertEqual([serial.kind_of(stack) for stack in stacks], ["shared", "step", "after", "shared", "shared", "shared", None])

    def test_shares(self):
        kinds, functions = serial.shares_of(serial.stacks_of(TEXT))
        self.assertEqual(kinds, {"shared": 4, "step": 1, "after": 1})
        self.assertEqual(functions["step", "pinball::Contact<double>::search < pinball::Solver<double>::make_step"], 1)
        lines = serial.table(kinds, functions)
        self.assertIn("6 samples", lines[0])
        self.assertEqual(lines[1].split(), ["16.67", "%", "in", "steps"])


if __name__ == "__main__":
    unittest.main()
