"""casts.py: product code has few casts, and all of them are counted."""

import sys
import unittest

import casts
import planted
from checked_tree import ROOT


class ProductCode(unittest.TestCase):
    def test_has_few_casts(self):
        found = casts.counts(ROOT)
        self.assertLessEqual(casts.per_100_lines(found), casts.MOST, casts.most_first(found))


class Planted(unittest.TestCase):
    def counted(self, files):
        return planted.found(casts.counts, files)

    def test_casts_of_both_folders_and_of_several_in_a_line(self):
        found = self.counted({"kernels/a.hpp": "int a = static_cast<int>(b) + static_cast<int>(c);\n",
                              "solver/base/b/c.cpp": "\n\n  static_cast <std::size_t>(\n d);\n", "tests/t.cpp": "static_cast<int>(e)\n"})
        self.assertEqual(found, {"kernels": (2, 1), "solver/base": (1, 4)})
        self.assertEqual(casts.per_100_lines(found), 60)

    def test_none_in_comments(self):
        found = self.counted({"kernels/a.hpp": "// static_cast<int>\n/* a\n static_cast<int> */\n", "solver/a.txt": "static_cast<int>"})
        self.assertEqual(found, {"kernels": (0, 3)})


if __name__ == "__main__":
    sys.exit(unittest.main())
