"""function_lengths.py: no function of the kernels is long, and all of them are found."""

import re
import sys
import unittest

import function_lengths
from checked_tree import ROOT
from function_lengths import functions


def found(text):
    return [(name, lines) for name, _, lines in functions(text)]


class Kernels(unittest.TestCase):
    def test_have_no_function_of_more_than_80_lines(self):
        self.assertEqual(function_lengths.too_long(ROOT), [])

    def test_are_read_whole(self):
        """Every function that is marked for a device, and has a body, is one that is found."""
        for file in sorted((ROOT / "kernels").rglob("*.hpp")):
            text = function_lengths.blanked(file.read_text())
            marked = set(re.findall(r"PINBALL_(?:FUNCTION|OUTLINED)[^;{}()]*?([\w~]+)\s*\([^;{}]*\)[^;{}()]*\{", text))
            names = {name for name, _ in found(file.read_text())}
            self.assertEqual(marked - names, set(), file)


class Planted(unittest.TestCase):
    BODY = "\n".join(f"  sum += {i};" for i in range(90))

    def test_a_long_function(self):
        text = "namespace a {\ntemplate <class T>\nvoid add(T& sum) {\n" + self.BODY + "\n}\n}\n"
        self.assertEqual(found(text), [("add", 93)])

    def test_a_long_member_and_a_lambda_in_it(self):
        text = "struct A {\n  int x{3};\n  void add(int& sum) const {\n  const auto f = [&] {\n" + self.BODY + "\n  };\n  f();\n}\n};\n"
        self.assertEqual(found(text), [("add", 95)])

    def test_a_constructor_with_initializers(self):
        text = "class A {\n A(int b)\n  : a_{b}, c_(b) {\n" + self.BODY + "\n }\n A() : a_{1} {}\n int a_, c_;\n};\n"
        self.assertEqual(found(text), [("A", 93), ("A", 1)])

    def test_what_is_restricted(self):
        text = "template <class T>\nrequires requires(T t) { t.f(); }\nauto add(T t) -> int {\n" + self.BODY + "\n}\n"
        self.assertEqual(found(text), [("add", 94)])

    def test_braces_in_comments_texts_and_macros(self):
        text = '// { \nvoid a() {\n  b("{", \'{\');  /* { */\n}\n#define X \\\n  {\nvoid c() {}\n'
        self.assertEqual(found(text), [("a", 3), ("c", 1)])


if __name__ == "__main__":
    sys.exit(unittest.main())
