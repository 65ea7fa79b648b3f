"""bench/report finds the functions of its kernels in the object files of build/release, by each of its patterns."""

import os
import re
import sys
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "bench"))

from report_parts import builds
from report_parts.kernels import KERNELS


class Patterns(unittest.TestCase):
    def check(self, patterns_of, *options):
        names = builds.function_names(*options, *builds.compile_commands(builds.NATIVE))
        for kernel in KERNELS:
            for pattern in patterns_of(kernel):
                with self.subTest(kernel=kernel.key, pattern=pattern):
                    self.assertTrue(any(re.search(pattern, name) for name in names))

    def test_demangled_names(self):
        self.check(lambda kernel: kernel.symbols, "-C")

    def test_mangled_names(self):
        self.check(lambda kernel: kernel.mangled)


if __name__ == "__main__":
    unittest.main()
