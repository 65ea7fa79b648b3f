"""What bench/report reads from compilers and object files, on small samples: report_parts_test.py."""

import os
import sys
import tempfile
import unittest
from unittest import mock

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "bench"))

from report_parts import builds, machine_code, measuring, pointers, remarks, verdict

# `objdump -d -C --no-show-raw-insn -l` of three functions.
OBJDUMP = """
solver/contact.o:     file format elf64-x86-64

Disassembly of section .text:

0000000000000000 <pinball::forces(double, std::vector<int>)::{lambda(long)#1}>:
pinball::forces():
/tree/kernels/simd.hpp:12
   0:\tvfmadd231pd %zmm1,%zmm2,%zmm3
   6:\tvaddpd %zmm1,%zmm2,%zmm3{%k1}
/tree/solver/contact.cpp:40 (discriminator 3)
   c:\tvmulsd %xmm1,%xmm2,%xmm3
  10:\tvgatherdpd (%rax,%ymm1,8),%zmm2{%k2}
  17:\tvscatterdpd %zmm2,(%rax,%ymm1,8){%k2}
  1e:\tlock add %eax,(%rdx)
  20:\tvmovupd %zmm2,(%rax)
  26:\tret

0000000000000030 <scalar_only>:
  30:\tvsqrtsd %xmm1,%xmm1,%xmm1
  34:\tvfnmadd132ss %xmm1,%xmm2,%xmm3
  39:\tvmulps (%rax),%ymm1,%ymm2

0000000000000040 <nothing_to_count>:
  40:\txor %eax,%eax
  42:\tret
"""


class MachineCode(unittest.TestCase):
    def setUp(self):
        self.functions = machine_code.parse_objdump(OBJDUMP)

    def test_names_have_colons_and_brackets(self):
        self.assertEqual(list(self.functions), ["pinball::forces(double, std::vector<int>)::{lambda(long)#1}", "scalar_only",
                                                "nothing_to_count"])

    def test_counts_packed_masked_scalar_gathers_and_scatters(self):
        counts = self.functions["pinball::forces(double, std::vector<int>)::{lambda(long)#1}"]
        self.assertEqual(counts.as_dict(), {"instructions": 8, "packed_zmm": 2, "packed_ymm": 0, "packed_xmm": 0, "scalar": 1,
                                            "gathers": 1, "scatters": 1, "masked": 1, "operations": 16 + 8 + 1})
        self.assertAlmostEqual(counts.packed_fraction, 2 / 3)

    def test_lanes_depend_on_the_type(self):
        self.assertEqual(self.functions["scalar_only"].operations, 1 + 2 + 8)
        self.assertEqual(self.functions["scalar_only"].packed["ymm"], 1)

    def test_no_arithmetic_has_no_packed_part(self):
        self.assertIsNone(self.functions["nothing_to_count"].packed_fraction)

    def test_source_lines_of_packed_arithmetic(self):
        counts = self.functions["pinball::forces(double, std::vector<int>)::{lambda(long)#1}"]
        self.assertEqual(counts.packed_lines, {"/tree/kernels/simd.hpp": 2})
        self.assertEqual(counts.lines, {("/tree/kernels/simd.hpp", 12), ("/tree/solver/contact.cpp", 40)})

    def test_select_adds_up(self):
        names, whole = machine_code.select(self.functions, [r"forces\(.*lambda", "^scalar"])
        self.assertEqual((len(names), whole.instructions, whole.scalar), (2, 11, 3))
        self.assertEqual(machine_code.select(self.functions, ["absent"])[0], [])


GCC = """
/tree/kernels/a.hpp:10:5: missed: couldn't vectorize loop
/tree/kernels/a.hpp:10:5: missed: not vectorized: control flow in loop.
/tree/kernels/a.hpp:10:5: missed: not vectorized: another reason for another size
/tree/kernels/a.hpp:20:5: missed: couldn't vectorize loop
/tree/kernels/a.hpp:20:5: optimized: loop vectorized using 64 byte vectors
/tree/kernels/a.hpp:30:5: optimized: basic block part vectorized using 32 byte vectors
/tree/kernels/a.hpp:40:5: optimized: loop vectorized using 64 byte vectors
/tree/kernels/b.hpp:10:5: optimized: loop vectorized using 64 byte vectors
/usr/include/c++/12/bits/stl_algobase.h:50:5: optimized: loop vectorized using 64 byte vectors
/tree/kernels/exec.hpp:50:5: optimized: loop vectorized using 64 byte vectors
"""

CLANG = """--- !Missed
Pass:            loop-vectorize
Name:            MissedDetails
DebugLoc:        { File: '/tree/kernels/a.hpp', Line: 10, Column: 5 }
Function:        _ZN7pinball6forcesEv
Args:
  - String:          loop not vectorized
...
--- !Analysis
Pass:            loop-vectorize
Name:            CFGNotUnderstood
DebugLoc:        { File: '/tree/kernels/a.hpp', Line: 10,
                   Column: 5 }
Function:        _ZN7pinball6forcesEv
Args:
  - String:          'loop not vectorized: '
  - String:          loop control flow is not understood by vectorizer
...
--- !Passed
Pass:            loop-vectorize
Name:            Vectorized
DebugLoc:        { File: '/tree/kernels/a.hpp', Line: 20, Column: 5 }
Function:        _ZN7pinball6forcesEv
Args:
  - String:          'vectorized loop (vectorization width: '
  - VectorizationFactor: '8'
  - String:          ')'
...
--- !Passed
Pass:            loop-vectorize
Name:            Vectorized
DebugLoc:        { File: '/tree/kernels/a.hpp', Line: 99, Column: 5 }
Function:        _ZN7pinball5otherEv
Args:
  - String:          'vectorized loop'
...
"""


class CompilerRemarks(unittest.TestCase):
    def test_gcc_only_lines_of_the_kernel(self):
        lines = {("/tree/kernels/a.hpp", n) for n in (10, 20, 30)}
        found = remarks.parse_gcc(GCC, lines)
        self.assertEqual(found.refused, [("kernels/a.hpp:10", "not vectorized: control flow in loop.")])
        self.assertEqual([place for place, _ in found.loops], ["kernels/a.hpp:20"])
        self.assertEqual([place for place, _ in found.blocks], ["kernels/a.hpp:30"])
        self.assertEqual(found.verdict, "partly")

    def test_lines_that_all_kernels_share_say_nothing(self):
        shared = {("/usr/include/c++/12/bits/stl_algobase.h", 50), ("/tree/kernels/exec.hpp", 50)}
        self.assertEqual(remarks.parse_gcc(GCC, shared).verdict, "no")

    def test_gcc_verdicts(self):
        self.assertEqual(remarks.parse_gcc(GCC, {("/tree/kernels/a.hpp", 20)}).verdict, "yes")
        self.assertEqual(remarks.parse_gcc(GCC, {("/tree/kernels/a.hpp", 10)}).verdict, "no")
        self.assertEqual(remarks.parse_gcc(GCC, set()).verdict, "no")

    def test_clang_gives_the_reason(self):
        found = remarks.parse_clang(CLANG, ["6forcesE"])
        self.assertEqual(found.loops, [("kernels/a.hpp:20", "vectorized loop (vectorization width: 8)")])
        self.assertEqual(found.refused, [("kernels/a.hpp:10", "loop not vectorized: loop control flow is not understood by "
                                                              "vectorizer")])
        self.assertEqual(remarks.parse_clang(CLANG, ["absent"]).verdict, "no")

    def test_adding(self):
        whole = remarks.Remarks()
        for _ in range(2):
            whole.add(remarks.parse_clang(CLANG, ["6forcesE"]))
        self.assertEqual((len(whole.loops), len(whole.refused)), (1, 1))


class Verdict(unittest.TestCase):
    FACTS = {"packs": None, "packed": 0.5, "bandwidth": 0.1, "lanes": None, "arithmetic": 0.5, "speed_up": 1.0}

    def explain(self, *three, **facts):
        return verdict.explain(*three, {**self.FACTS, **facts})

    def test_agreement_needs_no_explanation(self):
        self.assertEqual(self.explain("yes", "yes", "yes"), ("yes", True, [], False))

    def test_explicit_packs(self):
        result, agree, reasons, unexplained = self.explain("no", "yes", "yes", packs=0.9)
        self.assertEqual((result, agree, unexplained), ("yes", False, False))
        self.assertIn("explicit SIMD packs", reasons[0])

    def test_contradiction_is_not_explained_away(self):
        self.assertTrue(self.explain("no", "yes", "yes", packs=0.1)[3])

    def test_vectors_that_do_not_pay(self):
        self.assertIn("memory", self.explain("yes", "yes", "no", bandwidth=0.8)[2][0])
        self.assertIn("lanes", self.explain("yes", "yes", "no", lanes=0.2)[2][0])
        self.assertIn("arithmetic", self.explain("yes", "yes", "no", arithmetic=0.1)[2][0])
        self.assertTrue(self.explain("yes", "yes", "no")[3])
        self.assertEqual(self.explain("yes", "yes", "no", bandwidth=0.8)[0], "partly")

    def test_the_packed_part_takes_the_time(self):
        result, _, reasons, unexplained = self.explain("partly", "partly", "yes", packed=0.4, speed_up=2.0)
        self.assertEqual((result, unexplained), ("partly", False))
        self.assertIn("40 %", reasons[0])

    def test_faster_without_vectors(self):
        self.assertFalse(self.explain("no", "no", "partly", speed_up=1.3)[3])
        self.assertTrue(self.explain("no", "no", "yes", speed_up=2.5)[3])
        self.assertEqual(self.explain("no", "no", "yes", speed_up=2.5)[0], "no")

    def test_grades(self):
        self.assertEqual([verdict.speed_verdict(s) for s in (3.0, 1.6, 1.5, 1.2, 1.1)], ["yes", "yes", "partly", "partly", "no"])

    def test_part_of_the_packs(self):
        lines = {"/tree/kernels/simd.hpp": 1, "/usr/include/c++/12/experimental/bits/simd_x86.h": 1,
                 "/usr/lib/gcc/x86_64-linux-gnu/12/include/avx512fintrin.h": 1, "/avx/solver/fma.cpp": 1}
        self.assertEqual(verdict.from_packs(machine_code.Counts(packed_lines=lines)), 0.75)
        self.assertIsNone(verdict.from_packs(machine_code.Counts()))


class Configured(unittest.TestCase):
    def test_with_what_is_asked_for(self):
        with tempfile.TemporaryDirectory() as root, mock.patch.object(builds, "ROOT", root):
            self.assertFalse(builds.knows("release", ["pinball"]))
            os.makedirs(builds.folder("release"))
            with open(os.path.join(builds.folder("release"), "build.ninja"), "w", encoding="utf-8") as file:
                file.write("rule PHONY\nbuild pinball: LINK main.o\nbuild lib/pinball_more: phony pinball\n")
            self.assertTrue(builds.knows("release", ["pinball"]))
            self.assertFalse(builds.knows("release", ["pinball", "bench_kernels"]))


class Order(unittest.TestCase):
    def test_every_build_is_first_equally_often(self):
        first = [measuring.in_turn(["a", "b", "c"], number)[0] for number in range(6)]
        self.assertEqual(sorted(first), ["a", "a", "b", "b", "c", "c"])


class Pointers(unittest.TestCase):
    RESULTS = {"a": [{"depth / size": 0.1234, "none": None}]}

    def test_pointer_and_lookup(self):
        pointer = pointers.pointer("a", 0, "depth / size")
        self.assertEqual(pointer, "/a/0/depth ~1 size")
        self.assertEqual(pointers.lookup(self.RESULTS, pointer), 0.1234)

    def test_shown_numbers(self):
        n = pointers.Numbers(self.RESULTS)
        self.assertIn(">0.123</data>", n.show("a", 0, "depth / size"))
        self.assertIn(">12</data> %", n.percent("a", 0, "depth / size"))
        self.assertEqual(n.percent("a", 0, "none"), "–")
        with self.assertRaises(KeyError):
            n.show("a", 0, "absent")


if __name__ == "__main__":
    unittest.main()
