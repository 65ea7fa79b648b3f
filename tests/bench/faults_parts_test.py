"""What bench/faults makes of a source text: which faults its rules find, how they are planted, and how results are judged."""

import os
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "bench"))

from faults_parts import building, judging, outputs, planting, quick_tests  # noqa: E402
from faults_parts.fault import STATEMENT, Fault  # noqa: E402
from faults_parts.named import all_named, text_of  # noqa: E402
from faults_parts.rules import candidates  # noqa: E402

SOURCE = """namespace pinball {

constexpr double known = 0.5 + 0.25;

double length(const Fields& f, double a, double b) {
  const double sum = a + 2.5 * b;
  if (a < b && b > 0) sum_up(a);
  for (std::size_t i = 0; i < 3; ++i) total += part[i];
  const double read = f.number(3, "sf", 1.0);
  counts.last = part[0];
  archive(a, part_.b, sum_);
  fail_at(f.place(), "a + b");
  return sum - read;  // a - b
}

constexpr int twice(int a) {
  return a + a;
}

}  // namespace pinball
"""


def found(rule):
    return {(fault.right, fault.wrong) for fault in candidates("solver/x/y.cpp", SOURCE) if fault.rule == rule}


class Rules(unittest.TestCase):
    def test_turn_signs(self):
        self.assertIn(("a + 2.5 * b", "a - 2.5 * b"), found("sign"))

    def test_find_factors(self):
        self.assertIn(("a + 2.5 * b", "1.05 * (a + 2.5 * b)"), found("factor"))
        self.assertIn(("2.5", "2.625"), found("factor"))

    def test_take_other_indices(self):
        self.assertIn(("part[0]", "part[1]"), found("index"))

    def test_turn_comparisons_and_never_branch(self):
        self.assertIn(("a < b && b > 0", "a > b && b > 0"), found("comparison"))
        self.assertIn(("a < b && b > 0", "a < b || b > 0"), found("comparison"))
        self.assertEqual(found("condition"), {("a < b && b > 0", "false")})

    def test_leave_out_statements_and_the_first_of_a_loop(self):
        self.assertEqual(found("omitted"), {("counts.last = part[0];", "")})
        self.assertEqual(found("first"), {("0", "1")})

    def test_pass_over_fields_of_cards(self):
        self.assertEqual(found("card"), {('f.number(3, "sf", 1.0)', "double(1.0)")})
        self.assertEqual(found("field"), {("3", "4")})

    def test_leave_members_of_a_state_unread(self):
        self.assertEqual(found("unread"), {(m, f"::pinball_faults::unread({m})") for m in ("a", "part_.b", "sum_")})
        for fault in candidates("solver/x/y.cpp", SOURCE):
            if fault.rule == "unread":
                self.assertEqual(SOURCE[fault.begin:fault.begin + len(fault.right)], fault.right)

    def test_of_headers_find_what_of_a_state_is_saved(self):
        headers = [file for file in planting.sources(["step"]) if file.endswith(".hpp")]
        self.assertIn("solver/step/energy_ledger.hpp", headers)
        self.assertNotIn("solver/step/guards.hpp", headers)
        self.assertEqual({fault.rule for file in headers for fault in planting.faults_of(file)}, {"unread"})

    def test_leave_constants_and_messages_alone(self):
        for fault in candidates("solver/x/y.cpp", SOURCE):
            self.assertNotIn("constexpr", SOURCE[SOURCE.rfind("\n", 0, fault.begin):fault.begin])
            self.assertFalse(fault.right.startswith(("a + a", "fail_at")), fault)


class Planting(unittest.TestCase):
    def test_keeps_every_line_where_it_was(self):
        right = "first +\n      second"
        text = f"a = {right};\ncall();\nlast\n"
        faults = {3: Fault("x", right, "first -\n second", begin=text.index(right)),
                  7: Fault("x", "call();", "", STATEMENT, begin=text.index("call"))}
        planted = planting.planted_text(text, faults)
        self.assertEqual(planted.split("\n", 2)[1], "#line 1")
        body = planted.split("\n", 2)[2].split("\n")
        self.assertEqual(body[0], "a = (::pinball_faults::on(3) ? (first - second) : (first + second))")
        self.assertEqual(body[2], "{ if (!::pinball_faults::on(7)) { call(); } }")
        self.assertEqual(body[3], "last")

    def test_every_fault_with_a_name_has_its_place(self):
        named, gone = all_named()
        self.assertGreater(len(named), 80)
        self.assertLess(len(gone), 5, "texts change; these faults are to be written anew: " + "; ".join(gone))
        self.assertEqual(len({fault.name for fault in named}), len(named))
        for one in named:
            self.assertEqual(text_of(one.file)[one.begin:one.begin + len(one.right)], one.right)
            self.assertFalse(planting.overlaps(one, [other for other in named if other is not one]), one.what)

    def test_choice_is_the_same_each_time_and_no_two_overlap(self):
        class Options:
            count, seed, files, rooms, only, unnamed = 60, 5, 4, ["formats", "contact", "mesh"], "", False
        first, second = planting.choose(Options), planting.choose(Options)
        self.assertEqual(first, second)
        by_rule = [fault for fault in first.values() if fault.rule != "named"]
        self.assertEqual(len(by_rule), 60)
        self.assertEqual({fault.room for fault in by_rule}, set(Options.rooms))
        for number, fault in first.items():
            self.assertFalse(planting.overlaps(fault, [f for n, f in first.items() if n != number]))

    def test_choice_without_names_has_more_of_rooms_that_are_asked_for_twice(self):
        class Options:
            count, seed, files, rooms, only, unnamed = 30, 0, 4, ["rigid", "contact", "rigid"], "", True
        for Options.seed in range(1, 7):
            faults = planting.choose(Options).values()
            self.assertNotIn("named", {fault.rule for fault in faults})
            # Of two that overlap one goes, and the next of its room comes, whatever the sources are.
            self.assertEqual([sum(fault.room == room for fault in faults) for room in ("rigid", "contact")], [20, 10])

    def test_what_does_not_compile_is_blamed(self):
        text = "one\ntwo\nthree\n"
        faults = {1: Fault("solver/a.cpp", "two", "x", begin=4), 2: Fault("solver/a.cpp", "three", "x", begin=8)}
        said = "/tree/solver/a.cpp:1:2: note: in here\n/tree/solver/a.cpp:3:1: error: no match\n/tree/solver/a.cpp:2:1: note: candidate"
        self.assertEqual(building.blamed(said, "/tree", faults, {"solver/a.cpp": text}), {2})
        self.assertEqual(building.blamed(said.replace("error", "note"), "/tree", faults, {"solver/a.cpp": text}), {1, 2})


class Tests(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def made(self, name="t", text="exit 0", room="mesh"):
        path = os.path.join(self.folder.name, name)
        with open(path, "w", encoding="utf-8") as file:
            file.write(f"#!/bin/sh\n{text}\n")
        os.chmod(path, 0o755)
        return quick_tests.Test(name, [path], room, {}, self.folder.name)

    def test_what_a_test_comes_by_is_read(self):
        test = self.made(text='printf "\\001" | dd of="$PINBALL_FAULTS_SEEN" bs=1 seek=7 conv=notrunc status=none')
        self.assertTrue(quick_tests.traced(test, os.path.join(self.folder.name, "scratch"), 60))
        self.assertEqual(test.seen, {7})

    def test_a_fault_is_noticed_by_a_test_that_fails_dies_or_does_not_end(self):
        for text, how in (("exit $((PINBALL_FAULT == 7))", "fails"), ("kill -SEGV $$", "signal 11"), ("sleep 60", "does not end")):
            quick_tests.SHORTEST_LIMIT, kept = 1, quick_tests.SHORTEST_LIMIT
            try:
                test = self.made(text=text)
                test.seen = frozenset({7})
                name, said, _, whole = quick_tests.caught_by(7, Fault("solver/mesh/a.cpp", "a", "b"), [test], self.folder.name, 100)
            finally:
                quick_tests.SHORTEST_LIMIT = kept
            self.assertEqual((name, said, whole), ("t", how, True))

    def test_only_tests_that_come_by_a_fault_run_short_ones_and_those_of_its_room_first(self):
        near, far, short, other = (self.made(n, room=r) for n, r in (("near", "mesh"), ("far", "formats"), ("short", "formats"), ("other", "mesh")))
        near.seen = far.seen = short.seen = frozenset({7})
        near.seconds, far.seconds, short.seconds = 4, 1, 0.5
        self.assertEqual([some[0].name for _, some in quick_tests.batches(7, "mesh", [far, other, near, short])], ["short", "near", "far"])


class Outputs(unittest.TestCase):
    def test_are_those_of_decks_of_each_format(self):
        names = [run.name for run in outputs.all_runs()]
        for name in ("rigid.k", "impact.inp", "rigid.inp", "blocks_0000.rad", "taylor_bar_0000.rad"):
            self.assertIn(name, names)


class Judging(unittest.TestCase):
    def verdicts(self, **counts):
        return [{"verdict": kind.replace("_", " "), "room": "mesh", "rule": "sign", "file": "f", "what": "a|b", "by": None, "how": ""}
                for kind, count in counts.items() for _ in range(count)]

    def test_share_is_of_the_faults_that_change_something(self):
        some = self.verdicts(noticed=18, not_noticed=1, unfinished=1, changes_nothing_seen=30, not_come_by=9)
        self.assertEqual(judging.share_of(some), (0.9, 20))
        text, share = judging.table(some, 60, 500)
        self.assertEqual(share, 0.9)
        self.assertIn("90.0 % of these are noticed", text)
        self.assertIn("| mesh | 59 | 18 | 1 | 30 | 9 | 90 % of 20 |", text)
        self.assertIn("a\\|b", text)


if __name__ == "__main__":
    unittest.main()
