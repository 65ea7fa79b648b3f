"""The pages say what is there: paths, rooms and names of functions exist, and pages are as short as they are meant to be."""

import importlib.machinery
import importlib.util
import pathlib
import re
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "tests" / "layout"))
import rooms  # noqa: E402

PAGES = [ROOT / page for page in ["README.md", "CONTRIBUTING.md", "CHANGELOG.md", "bench/README.md", "data/scenes/README.md",
                                  "data/decks/README.md", "data/reference/README.md"]] + sorted((ROOT / "docs").glob("*.md"))
TOP = {entry.name for entry in ROOT.iterdir()} - {"build", "out", ".git"}
LONGEST_LINE = 125
LONGEST_PAGE = {"README.md": 150, "CONTRIBUTING.md": 90, "docs/architecture.md": 300}

PLACEHOLDER = re.compile(r"[A-Z][A-Z_]+|<[a-z]+>")
TOKEN = re.compile(r"(?<![\w./<-])(?:<pinball/)?[\w.*-]+(?:/[\w.*-]+)+/?")
LINK = re.compile(r"\]\(([^)#\s]+)")
TABLE_OF_ROOMS = re.compile(r"^\| room \| files \| what it holds \|\n\|.*\n((?:\|.*\n)+)", re.M)
FUNCTION = re.compile(r"`((?:[A-Za-z_]+::)?[a-z_]+(?:\(\))?|[A-Z][A-Za-z]+(?:::[a-z_]+)?)`")
SOURCES = ["kernels", "solver", "python"]


def without_samples(text):
    return re.sub(r"^```(?!text).*?^```$", "", text, flags=re.M | re.S)  # they are checked elsewhere


def paths(text):
    """What a page names as a path of the tree: what begins with one of its folders, with `*` for placeholders."""
    for token in TOKEN.findall(re.sub(r"\]\([^)]*\)", "", without_samples(text))):
        if token.startswith("<pinball/"):
            token = token.removeprefix("<pinball/")
            token = re.sub("^contact/", "solver/contact/", token)
        token = re.sub(r"\.\.\.$", "", PLACEHOLDER.sub("*", token)).rstrip(".")
        if token.split("/")[0] in TOP:
            yield token


def missing_paths(page, text):
    found = [path for path in paths(text) if not any(ROOT.glob(path.rstrip("/")))]
    links = [link for link in LINK.findall(without_samples(text)) if not re.match(r"[a-z]+:", link)]
    return found + [link for link in links if not (page.parent / link).exists()]


def too_long(text):
    """Lines, but those of tables and of code."""
    text = re.sub(r"^```.*?^```$", lambda block: "\n" * block[0].count("\n"), text, flags=re.M | re.S)
    return [number for number, line in enumerate(text.splitlines(), 1) if len(line) > LONGEST_LINE and line[0] != "|"]


class Pages(unittest.TestCase):
    def test_name_what_exists(self):
        for page in PAGES:
            with self.subTest(page.name):
                self.assertEqual(missing_paths(page, page.read_text()), [])

    def test_have_lines_that_can_be_read(self):
        for page in PAGES:
            with self.subTest(page.name):
                self.assertEqual(too_long(page.read_text()), [])

    def test_show_the_same_commands_of_the_program(self):
        synopsis = re.compile(r"^    pinball run SCENE .*?(?=\n\n)", re.M | re.S)
        shown = {synopsis.search((ROOT / page).read_text())[0] for page in ["README.md", "docs/program.md"]}
        self.assertEqual(len(shown), 1)

    def test_list_every_scene(self):
        listed = re.findall(r"^\| `([a-z_]+)` \|", (ROOT / "data/scenes/README.md").read_text(), re.M)
        scenes = {scene.stem for scene in (ROOT / "data" / "scenes").glob("*.toml")}
        self.assertEqual(scenes - set(listed), set())

    def test_are_short(self):
        for page, lines in LONGEST_PAGE.items():
            with self.subTest(page):
                self.assertLessEqual((ROOT / page).read_text().count("\n"), lines)


class Architecture(unittest.TestCase):
    text = (ROOT / "docs" / "architecture.md").read_text()

    def test_lists_the_rooms(self):
        rows = [[cell.strip() for cell in row.strip("|\n").split("|")]
                for row in TABLE_OF_ROOMS.search(self.text)[1].splitlines()]
        self.assertEqual([row[0] for row in rows], list(rooms.ROOMS))
        for name, files, _ in rows:
            with self.subTest(name):
                self.assertIn(files.strip("`"), rooms.ROOMS[name][0])

    def test_names_classes_and_functions_of_the_sources(self):
        code = "\n".join(file.read_text() for folder in SOURCES for file in sorted((ROOT / folder).rglob("*"))
                         if file.suffix in {".h", ".hpp", ".cpp"})
        words = set(re.findall(r"\w+", code))
        for name in FUNCTION.findall(self.text):
            with self.subTest(name):
                self.assertEqual(set(re.findall(r"\w+", name)) - words, set())


class Check(unittest.TestCase):
    def test_finds_a_path_that_is_gone(self):
        page = ROOT / "docs" / "page.md"
        self.assertEqual(missing_paths(page, "`solver/gone.cpp`, `solver/step/solver.cpp`, `out/gone`, `K A^2/V`"),
                         ["solver/gone.cpp"])
        self.assertEqual(missing_paths(page, "[a](gone.md) [b](../README.md) [c](https://example.org)"), ["gone.md"])
        self.assertEqual(missing_paths(page, "`<pinball/contact/gone.h>` `<pinball/contact/contact.h>`"),
                         ["solver/contact/gone.h"])
        self.assertEqual(missing_paths(page, "text\n\n    tests/gone/ what it was\n"), ["tests/gone/"])

    def test_takes_placeholders(self):
        page = ROOT / "README.md"
        self.assertEqual(missing_paths(page, "`data/scenes/NAME.toml` `tests/ROOM/NAME_test.cpp`"), [])

    def test_finds_a_long_line(self):
        self.assertEqual(too_long("a\n" + "b" * 126 + "\n| " + "c" * 126 + "\n"), [2])


if __name__ == "__main__":
    unittest.main()
