"""standard_names.py: our headers include what they take of the standard library."""

import sys
import unittest

import planted
import standard_names
from checked_tree import ROOT


class Headers(unittest.TestCase):
    def test_include_what_they_name(self):
        self.assertEqual(standard_names.problems(ROOT), [])


class Planted(unittest.TestCase):
    def found(self, files):
        return planted.found(standard_names.problems, files)

    def test_a_name_without_its_header(self):
        self.assertEqual(self.found({"solver/a.hpp": "#include <string>\nstd::vector<std::string> a;\n"}),
                         ["solver/a.hpp: std::vector without <vector>"])

    def test_a_header_that_another_of_ours_includes(self):
        files = {"kernels/a.hpp": '#include <solver/b/b.hpp>\nstd::vector<int> a;\n', "solver/b/b.hpp": '#include "c.hpp"\n'}
        self.assertEqual(self.found(files | {"solver/b/c.hpp": '#include "b.hpp"\n#include <vector>\n'}), [])
        self.assertEqual(self.found(files | {"solver/b/c.hpp": '#include "b.hpp"\n'}), ["kernels/a.hpp: std::vector without <vector>"])

    def test_a_name_of_several_headers(self):
        self.assertEqual(self.found({"solver/a.hpp": "#include <string>\nstd::string_view a;\n"}), [])

    def test_a_name_that_nobody_knows(self):
        self.assertEqual(len(self.found({"solver/a.hpp": "#include <any>\nstd::any a;\n"})), 1)

    def test_none_in_comments_and_texts(self):
        self.assertEqual(self.found({"solver/a.hpp": '// std::vector\n/* std::\n std::map */ char a[] = "std::set";\n'}), [])


if __name__ == "__main__":
    sys.exit(unittest.main())
