"""What bench/state_hashes runs, and what it calls a difference: state_hashes_parts_test.py."""

import os
import struct
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "bench"))

from state_hashes_parts import cases, fingerprint

RECORDED = {"status": 0, "steps": 10, "energy": {"kinetic": 1.5}, "bodies": [{"name": "rod", "velocity": [0.0, 1.0]}]}


class Differences(unittest.TestCase):
    def found(self, **changed):
        return fingerprint.differences(RECORDED, {**RECORDED, **changed})

    def test_equal(self):
        self.assertEqual(self.found(), [])

    def test_a_number_far_inside(self):
        self.assertEqual(self.found(bodies=[{"name": "rod", "velocity": [0.0, 1.0000000000000002]}]),
                         [("bodies[0].velocity[1]", 1.0, 1.0000000000000002)])

    def test_a_new_key_is_none_and_a_vanished_one_is_one(self):
        self.assertEqual(self.found(new=1, energy={"kinetic": 1.5, "new": 2}), [])
        self.assertEqual(self.found(energy={}), [("energy.kinetic", 1.5, "nothing")])

    def test_another_length_and_another_type(self):
        self.assertEqual([place for place, _, _ in self.found(bodies=[])], ["bodies"])
        self.assertEqual(self.found(steps=10.0), [("steps", 10, 10.0)])


class Fingerprints(unittest.TestCase):
    def test_messages_without_the_place_of_the_last_good_state(self):
        self.assertEqual(fingerprint.message("off by 3 % in step 4; the last good state, of step 1, is in x\nmore\n"), "off by 3 % in step 4")
        self.assertEqual(fingerprint.message(""), "")

    def test_refused_without_a_summary(self):
        with tempfile.TemporaryDirectory() as folder:
            self.assertEqual(fingerprint.of_run(2, "no\n", folder), {"status": 2, "message": "no"})

    def test_a_bit_in_history_or_fields_shows_in_its_column_or_array(self):
        def vtu(last):
            tags = '<DataArray Name="stress" offset="0"/><DataArray type="Float32" offset="16"/>'
            return (f'{tags}<AppendedData encoding="raw">\n_').encode() + struct.pack("<QQQQ", 8, 1, 8, last)

        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "file")
            read = []
            for last in (1, 2):
                with open(path, "wb") as file:
                    file.write(vtu(last))
                fields = fingerprint.fields(path)
                with open(path, "w", encoding="utf-8") as file:
                    file.write(f"# units: none\nstep,time\n1,0\n2,{last}\n")
                read.append({**fields, **fingerprint.history(path)})
        self.assertEqual({name for name in read[0] if read[0][name] != read[1][name]}, {"points", "time"})
        self.assertEqual(set(read[0]), {"points", "stress", "step", "time"})


class Cases(unittest.TestCase):
    def test_every_scene_is_there_and_quick_is_a_part_of_full(self):
        full, quick = cases.all_cases(quick=False), cases.all_cases(quick=True)
        self.assertLess({case.name for case in quick}, {case.name for case in full})
        scenes = {name.removesuffix(".toml") for name in os.listdir(os.path.join(cases.ROOT, cases.SCENES)) if name.endswith(".toml")}
        for form in (full, quick):
            self.assertEqual({case.scene for case in form}, scenes)

    def test_every_contact_has_to_happen(self):
        for case in cases.all_cases(quick=False):
            if any(setting.startswith("contact.enforcement=") for setting in case.settings) and case.status == 0:
                self.assertIn("contact", case.needs)


if __name__ == "__main__":
    unittest.main()
