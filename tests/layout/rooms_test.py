"""rooms.py: the tree's includes go down, and what goes another way is found."""

import pathlib
import shutil
import sys
import tempfile
import unittest

import rooms

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent


class Tree(unittest.TestCase):
    def test_has_downward_includes_only(self):
        self.assertEqual(rooms.problems(ROOT), [])

    def test_is_read_whole(self):
        found = list(rooms.arrows(ROOT))
        self.assertGreater(len(found), 1000)
        entered = {room for _, _, room, target, _ in found if target}
        # A room whose files include nothing of the tree, or that is gone, would be checked by nobody.
        self.assertEqual(set(rooms.ROOMS) - entered, set())

    def test_has_no_folder_with_more_than_thirty_files(self):
        counts = {}
        for folder in ["kernels", "solver", "bench", "tests", "python"]:
            for file in (ROOT / folder).rglob("*"):
                if file.suffix in {".h", ".hpp", ".cpp", ".c", ".cu", ".py", ".f90"}:
                    counts[file.parent] = counts.get(file.parent, 0) + 1
        self.assertEqual({str(folder): count for folder, count in counts.items() if count > 30}, {})


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

    def test_every_upward_arrow_between_two_rooms_is_found(self):
        files = {room: [place if not place.endswith("/") else self.a_header(place) for place in places][0]
                 for room, places in rooms.ROOMS.items()}
        files["contact"] = "solver/contact/make_contact.cpp"
        order = list(rooms.ROOMS)
        checked = 0
        for low in range(len(order)):
            for high in range(low + 1, len(order)):
                target = files[order[high]]
                with self.subTest(frm=order[low], to=order[high]):
                    problems = self.found(files[order[low]], f"<{target}>")
                    self.assertEqual(len(problems), 1, problems)
                    self.assertIn(files[order[low]], problems[0])
                    self.assertIn(target, problems[0])
                checked += 1
        self.assertEqual(checked, len(order) * (len(order) - 1) // 2)

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
