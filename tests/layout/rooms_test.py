"""rooms.py: the tree's includes go down, and what goes another way is found."""

import pathlib
import re
import shutil
import sys
import tempfile
import unittest

import rooms
from checked_tree import ROOT


class Tree(unittest.TestCase):
    def test_has_downward_includes_only(self):
        self.assertEqual(rooms.problems(ROOT), [])

    def test_is_read_whole(self):
        found = list(rooms.arrows(ROOT))
        self.assertGreater(len(found), 1000)
        entered = {room for _, _, room, target, _ in found if target}
        # A room whose files include nothing of the tree, or that is gone, would be checked by nobody.
        self.assertEqual(set(rooms.ROOMS) - entered, set())

    def test_is_the_map_that_architecture_shows(self):
        page = (ROOT / "docs" / "architecture.md").read_text()
        begin, end = rooms.map_in(page)
        self.assertEqual(page[begin:end], rooms.map_text())
        rows = re.findall(r"^\| ([a-z/ ]+) \| `", page, re.M)
        self.assertEqual(sorted(set(rooms.ROOMS) - set(rows)), [], "rooms that the table does not have")

    def test_takes_every_arrow_of_the_map(self):
        self.assertEqual(rooms.unused_arrows(ROOT), [])

    def test_stands_on_rooms_that_come_before(self):
        order = list(rooms.ROOMS)
        for room, all_below in rooms.STANDS_ON.items():
            for below in all_below:
                self.assertLess(order.index(below), order.index(room))
                others = [other for other in all_below if other != below]
                self.assertFalse(any(below in rooms.REACHED[other] for other in others), f"{room}: {below} is said twice")

    def test_has_all_its_rooms_in_the_readme(self):
        tree = (ROOT / "README.md").read_text().split("## The tree")[1].split("## ")[0]
        for folder in sorted(p.name for p in (ROOT / "solver").iterdir() if p.is_dir()):
            self.assertIn(f" {folder}/", tree)


class Planted(unittest.TestCase):
    """An include that is planted into a copy of the tree is named."""

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.tree = pathlib.Path(self.folder.name)
        for name in ["kernels", "solver", "python", "bench/micro", "tests"]:
            shutil.copytree(ROOT / name, self.tree / name)

    def found(self, path, include):
        file = self.tree / path
        text = file.read_text()
        file.write_text(f"#include {include}\n{text}")
        problems = rooms.problems(self.tree, [path])
        file.write_text(text)
        return problems

    def test_every_arrow_that_is_not_on_the_map_is_found(self):
        files = {room: [place if not place.endswith("/") else self.a_header(place) for place in places][0]
                 for room, (places, _) in rooms.ROOMS.items()}
        checked = 0
        for room, reached in rooms.REACHED.items():
            for other in set(rooms.ROOMS) - reached - {room}:
                with self.subTest(frm=room, to=other):
                    problems = self.found(files[room], f"<{files[other]}>")
                    self.assertEqual(len(problems), 1, problems)
                    self.assertIn(files[room], problems[0])
                    self.assertIn(files[other], problems[0])
                checked += 1
        self.assertGreater(checked, len(rooms.ROOMS) * (len(rooms.ROOMS) - 1) // 2)

    def a_header(self, folder):
        """Of a room: one that is not public, where there is one."""
        room = rooms.room_of(folder + "any.hpp")
        for ending in ["*.hpp", "*.cpp"]:
            files = sorted(str(f.relative_to(self.tree)) for f in (self.tree / folder).rglob(ending))
            for file in files:
                if rooms.room_of(file) == room:  # a room may lie in the folder of another one
                    return file

    def test_rooms_that_lie_apart(self):
        self.assertTrue(self.found("solver/boundary/rigid_walls.cpp", "<solver/elements/subcycling.hpp>"))

    def test_what_kernels_and_contact_may_not_use(self):
        self.assertTrue(self.found("kernels/simd.hpp", "<vector>"))
        self.assertTrue(self.found("kernels/simd.hpp", "<pthread.h>"))
        self.assertTrue(self.found("kernels/exec/mock.hpp", "<fstream>"))
        self.assertTrue(self.found("kernels/exec/mock.hpp", "<map>"))
        self.assertTrue(self.found("kernels/exec/mock.hpp", "<string>"))
        self.assertEqual(self.found("kernels/exec/mock.hpp", "<atomic>"), [])
        self.assertTrue(self.found("solver/contact/surface/surface.cpp", "<fmt/format.h>"))
        self.assertTrue(self.found("solver/contact/surface/surface.cpp", "<fstream>"))
        self.assertEqual(self.found("solver/contact/surface/surface.cpp", "<vector>"), [])

    def test_public_headers_stand_by_themselves(self):
        self.assertTrue(self.found("solver/scene.hpp", "<solver/base/point.hpp>"))
        self.assertTrue(self.found("solver/scene.hpp", '"scene/table.hpp"'))
        self.assertTrue(self.found("python/module.cpp", "<solver/model/model.hpp>"))

    def test_what_leads_nowhere(self):
        self.assertTrue(self.found("solver/model/model.cpp", '"no_such_file.hpp"'))
        self.assertTrue(self.found("solver/model/model.cpp", "<pinball/solver/scene.hpp>"))
        (self.tree / "solver/elsewhere").mkdir()
        (self.tree / "solver/elsewhere/a.cpp").write_text("#include <solver/scene.hpp>\n")
        self.assertTrue(rooms.problems(self.tree))


if __name__ == "__main__":
    sys.exit(unittest.main())
