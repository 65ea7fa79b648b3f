"""The notebooks of docs/notebooks: each cell runs, in its order, and what a cell ends with can be shown. Nothing of Jupyter is
needed: notebooks_test.py FOLDER, with the package pinball on PYTHONPATH."""

import ast
import json
import pathlib
import re
import subprocess
import sys
import traceback
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
NOTEBOOKS = sorted((ROOT / "docs" / "notebooks").glob("*.ipynb"))
LONGEST_LINE = 140
SKIPPED = 77


def value_of(source, names):
    """Runs a cell. Returns what its last expression gives, as a notebook does; None: it ends with none, or with a semicolon."""
    tree = ast.parse(source)
    last = None
    if tree.body and isinstance(tree.body[-1], ast.Expr) and not source.rstrip().endswith(";"):
        last = ast.Expression(tree.body.pop().value)
    exec(compile(tree, "cell", "exec"), names)
    return None if last is None else eval(compile(last, "cell", "eval"), names)


def shown(value):
    """As a notebook shows it."""
    return value._repr_html_() if hasattr(value, "_repr_html_") else repr(value)


def run(notebook):
    """Runs all cells of a notebook. Returns 0, or 1 after the cell that failed was printed."""
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot

    names = {"__name__": "__main__"}
    for number, cell in enumerate(json.loads(notebook.read_text())["cells"], 1):
        if cell["cell_type"] != "code":
            continue
        try:
            value = value_of("".join(cell["source"]), names)
            if value is not None:
                shown(value)
            for figure in map(pyplot.figure, pyplot.get_fignums()):
                figure.canvas.draw()
            pyplot.close("all")
        except Exception:
            print(f"{notebook.name}, cell {number}:", "".join(cell["source"]), traceback.format_exc(), sep="\n", file=sys.stderr)
            return 1
    return 0


class Notebooks(unittest.TestCase):
    def test_run_from_the_first_cell_to_the_last(self):
        for notebook in NOTEBOOKS:
            with self.subTest(notebook.name):
                place = FOLDER / notebook.stem
                place.mkdir(parents=True, exist_ok=True)
                done = subprocess.run([sys.executable, __file__, "--run", notebook], cwd=place, capture_output=True, text=True)
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertNotIn("Warning", done.stderr)

    def test_are_what_jupyter_reads_without_results(self):
        self.assertEqual(len(NOTEBOOKS), 5)
        for notebook in NOTEBOOKS:
            with self.subTest(notebook.name):
                text = notebook.read_text()
                book = json.loads(text)
                self.assertEqual(text, json.dumps(book, indent=1, ensure_ascii=False, sort_keys=True) + "\n", "as Jupyter lays it out")
                self.assertEqual((book["nbformat"], book["nbformat_minor"]), (4, 5))
                self.assertEqual(book["metadata"]["kernelspec"]["name"], "python3")
                ids = [cell["id"] for cell in book["cells"]]
                self.assertEqual(len(set(ids)), len(ids))
                for cell in book["cells"]:
                    self.assertRegex(cell["id"], "^[a-zA-Z0-9-]{1,64}$")
                    keys = {"cell_type", "id", "metadata", "source"}
                    if cell["cell_type"] == "code":
                        keys |= {"execution_count", "outputs"}
                        self.assertEqual((cell["execution_count"], cell["outputs"]), (None, []))
                    self.assertEqual(set(cell), keys)
                    self.assertLessEqual(max(len(line.rstrip("\n")) for line in cell["source"]), LONGEST_LINE)
                self.assertTrue(book["cells"][0]["source"][0].startswith("# "))

    def test_are_listed_in_the_page(self):
        page = (ROOT / "docs" / "examples.md").read_text()
        listed = re.findall(r"\(notebooks/(\w+\.ipynb)\)", page)
        self.assertEqual(sorted(listed), [notebook.name for notebook in NOTEBOOKS])

    def test_name_files_that_are_there(self):
        for notebook in NOTEBOOKS:
            for cell in json.loads(notebook.read_text())["cells"]:
                if cell["cell_type"] == "markdown":
                    for link in re.findall(r"\]\(([^)#:]+)\)", "".join(cell["source"])):
                        self.assertTrue((notebook.parent / link).exists(), f"{notebook.name}: {link}")


class Runner(unittest.TestCase):
    def test_takes_the_value_that_a_cell_ends_with(self):
        names = {}
        self.assertEqual(value_of("a = 2\na + 3", names), 5)
        self.assertIsNone(value_of("a + 3;", names))
        self.assertIsNone(value_of("b = a", names))
        self.assertEqual(names["b"], 2)

    def test_finds_a_cell_that_fails(self):
        book = FOLDER / "fails.ipynb"
        book.parent.mkdir(parents=True, exist_ok=True)
        cells = [{"cell_type": "code", "source": [text]} for text in ("a = 1", "assert a == 2")]
        book.write_text(json.dumps({"cells": cells}))
        done = subprocess.run([sys.executable, __file__, "--run", book], capture_output=True, text=True)
        self.assertEqual(done.returncode, 1)
        self.assertIn("fails.ipynb, cell 2:\nassert a == 2", done.stderr)


if __name__ == "__main__":
    try:
        import matplotlib  # noqa: F401
        import pinball  # noqa: F401
    except ImportError as error:
        print(f"skipped: {error}")
        sys.exit(SKIPPED)
    if sys.argv[1] == "--run":
        sys.exit(run(pathlib.Path(sys.argv[2])))
    FOLDER = pathlib.Path(sys.argv.pop(1)).resolve()
    unittest.main()
