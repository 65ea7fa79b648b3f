"""test_names.py: what test files that are one program have to have of their own."""

import sys
import unittest

import planted
import test_names
from checked_tree import ROOT


class Tests(unittest.TestCase):
    def test_have_names_of_their_own(self):
        self.assertEqual(test_names.problems(ROOT), [])


class Planted(unittest.TestCase):
    def found(self, files):
        return planted.found(test_names.problems, files)

    def test_namespace_of_all(self):
        found = self.found({"tests/mesh/a_test.cpp": "namespace pinball {\n", "tests/mesh/b_test.cpp": "namespace pinball::test::b_test {\n"})
        self.assertEqual(found, ["tests/mesh/a_test.cpp: namespace pinball::a_test expected, not pinball"])

    def test_test_of_the_same_name(self):
        found = self.found({"tests/mesh/a_test.cpp": "TEST(Mesh, IsRead) {\n}\nTEST_F(Mesh, HasNodes) {\n",
                            "tests/mesh/b_test.cpp": "TEST(Mesh,\n     IsRead) {\n}\nTEST_P(Mesh, HasElements) {\n",
                            "tests/scene/c_test.cpp": "TEST(Mesh, IsRead) {\n"})
        self.assertEqual(found, ["tests/mesh/b_test.cpp: Mesh.IsRead is in tests/mesh/a_test.cpp, too"])

    def test_folder_of_all(self):
        found = self.found({"tests/mesh/a_test.cpp": "const std::string path = testing::TempDir() + name;\n"})
        self.assertEqual(found, ["tests/mesh/a_test.cpp: TempDir() is the folder of all tests: FolderTest has one for each"])


if __name__ == "__main__":
    sys.exit(unittest.main())
