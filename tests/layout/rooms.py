"""The rooms of the source tree and which way their includes go: each room may include itself, the rooms it stands on, and
all that these stand on.

    rooms.py [TREE]      prints every include that goes another way; exit status 1 if there is one
    rooms.py --fix       writes the map into docs/architecture.md
"""

import pathlib
import re
import sys

import checked_tree

# Lowest first, each with its places and the rooms that it stands on. A place is a folder, or a public header named for the
# room, which lies above the room's folder. What others stand on is not said again: the arrows are those of the map in
# docs/architecture.md, and each is taken by an include.
ROOMS = {
    "kernels": (["kernels/"], []),
    "exec": (["kernels/exec/", "kernels/exec.hpp"], ["kernels"]),
    "base": (["solver/base/"], ["exec"]),
    "contact interface": (
        ["solver/contact/contact.h", "solver/contact/embedded_contact.hpp", "solver/contact/contact_settings.hpp"],
        ["base"]),
    "contact/surface": (["solver/contact/surface/"], ["base"]),
    "contact/tied": (["solver/contact/tied/"], ["base"]),
    "contact/search": (["solver/contact/search/"], ["contact interface"]),
    "contact/impulses": (["solver/contact/impulses/"], ["contact interface", "contact/surface", "contact/tied"]),
    "contact/algorithm": (["solver/contact/algorithm/"], ["contact/impulses"]),
    "contact/segments": (["solver/contact/segments/"], ["contact/surface"]),
    "contact/spheres": (["solver/contact/spheres/"], ["contact/search", "contact/segments"]),
    "contact/pinball": (["solver/contact/pinball/"], ["contact/algorithm", "contact/spheres"]),
    "contact/faces": (["solver/contact/faces/"], ["contact/algorithm", "contact/spheres"]),
    "contact/slideline": (["solver/contact/slideline/"], ["contact/search", "contact/algorithm", "contact/segments"]),
    "contact": (["solver/contact/make_contact.cpp"], ["contact/pinball", "contact/faces", "contact/slideline"]),
    "contact/host": (["solver/contact/host/"], ["contact/algorithm"]),
    "mesh": (["solver/mesh/", "solver/mesh.hpp", "solver/mesh_formats.hpp", "solver/mesh_settings.hpp",
              "solver/array_view.hpp"], ["base"]),
    "scene": (
        ["solver/scene/", "solver/scene.hpp", "solver/scene_boundary.hpp", "solver/scene_contact.hpp",
         "solver/scene_material.hpp", "solver/scene_rigid.hpp", "solver/scene_rules.hpp"],
        ["contact interface", "mesh"]),
    "formats/deck": (["solver/formats/deck/"], ["scene"]),
    "formats/abaqus": (["solver/formats/abaqus/"], ["formats/deck"]),
    "formats/exodus": (["solver/formats/exodus/"], ["mesh"]),
    "formats/gmsh": (["solver/formats/gmsh/"], ["mesh"]),
    "formats/lsdyna": (["solver/formats/lsdyna/"], ["formats/deck"]),
    "formats/radioss": (["solver/formats/radioss/"], ["formats/deck"]),
    "formats/vtk": (["solver/formats/vtk/"], ["mesh"]),
    "formats": (
        ["solver/formats/"],
        ["formats/abaqus", "formats/exodus", "formats/gmsh", "formats/lsdyna", "formats/radioss", "formats/vtk"]),
    "model": (["solver/model/"], ["contact/search", "contact/algorithm", "formats"]),
    "results": (["solver/results/", "solver/results.hpp", "solver/field_base.hpp"], ["model"]),
    "parallel": (["solver/parallel/"], ["model"]),
    "elements": (["solver/elements/"], ["parallel"]),
    "boundary": (["solver/boundary/"], ["results", "parallel"]),
    "rigid": (["solver/rigid/"], ["boundary"]),
    "device": (["solver/device/"], ["elements", "boundary"]),
    "step": (["solver/step/"], ["device", "rigid"]),
    "simulation": (["solver/simulation/", "solver/simulation.hpp"], ["step"]),
    "output": (
        ["solver/output/", "solver/recorded_run.hpp", "solver/restart.hpp", "solver/run_page.hpp", "solver/summary.hpp"],
        ["simulation"]),
    "verification": (["solver/verification/"], ["step"]),
    "program": (["solver/program/"], ["output", "verification"]),
    "parallel/mpi": (["solver/parallel/mpi/"], ["program"]),
    "python": (["python/"], ["output"]),
    "bench": (["bench/micro/"], ["contact/pinball", "contact/slideline", "step"]),
    "tests": (["tests/"], ["contact/pinball", "contact/faces", "contact/slideline", "program"]),
}
STANDS_ON = {room: below for room, (_, below) in ROOMS.items()}
REACHED = {}  # all rooms that a room may include beside itself
for room, all_below in STANDS_ON.items():
    REACHED[room] = set(all_below).union(*(REACHED[below] for below in all_below))

# Hosts get these, and nothing else. They include by paths from where they lie, so that they hold wherever they are put.
PUBLIC = re.compile(r"kernels/((boundary|element|exec|material)/)?[a-z_]+\.hpp|solver/[a-z_]+\.hpp|solver/base/[a-z_]+\.hp*|solver/contact/[a-z_]+\.hp*|"
                    r"solver/scene/schema/[a-z_]+\.hpp")
ONLY_PUBLIC = ["python"]

# Headers of the language, the system and other libraries. Kernels: formulas alone, no container, no stream. The execution
# layer: the language, threads and devices. Contact, which hosts embed: no other library, no file and no terminal.
CONTACT_ROOMS = [room for room in ROOMS if room == "base" or room.startswith("contact")]
LANGUAGE = re.compile(r"[a-z_]+|std(def|int)\.h|sys/mman\.h|unistd\.h")
FILES_AND_TERMINAL = re.compile(r"cstdio|iostream|fstream|filesystem|print")
OF_KERNELS = re.compile(r"cmath|cstdint|cstddef|experimental/simd|immintrin\.h|utility")
OF_EXEC = re.compile(OF_KERNELS.pattern + r"|atomic|charconv|cstdlib|cstring|exception|iterator|mutex|new|stdexcept|type_traits|sys/mman\.h"
                     r"|omp\.h|pthread\.h|cuda_runtime\.h|hip/hip_runtime\.h|Kokkos_Core\.hpp")

INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*([<"])([^>"]+)[>"]', re.M)
SOURCES = {".h", ".hpp", ".cpp", ".cu"}

MAP_BEGINS, MAP_ENDS = "<!-- the map, by tests/layout/rooms.py --fix -->\n", "\n<!-- end of the map -->"


def room_of(path):
    """Room of a file, or None. The longest name counts."""
    fitting = [(len(place), room) for room, (places, _) in ROOMS.items() for place in places
               if path == place or place.endswith("/") and path.startswith(place)]
    return max(fitting)[1] if fitting else None


def target_of(tree, path, bracket, name):
    """The file of the tree that an include means, or None for one from outside."""
    place = (tree / path).parent / name if bracket == '"' else tree / name
    return str(place.resolve().relative_to(tree)) if place.is_file() else None


def outside_problem(room, name):
    if room == "kernels":
        return None if OF_KERNELS.fullmatch(name) else "is not for kernels"
    if room == "exec":
        return None if OF_EXEC.fullmatch(name) else "is not for the execution layer"
    if room in CONTACT_ROOMS:
        return None if LANGUAGE.fullmatch(name) and not FILES_AND_TERMINAL.fullmatch(name) else "is not for contact"
    return None


def problem(path, room, bracket, target):
    """What is wrong with an include of a file of the tree, or None."""
    other = room_of(target)
    if other is None:
        return f"is in no room: {target}"
    if other != room and other not in REACHED[room]:
        return f"goes from {room} to {other}, on which it does not stand"
    if room in ONLY_PUBLIC and other != room and not PUBLIC.fullmatch(target):
        return "is not public"
    if PUBLIC.fullmatch(path):
        if bracket == "<":
            return "of a public header must be a path from where that lies"
        if not PUBLIC.fullmatch(target):
            return f"of a public header is not public: {target}"
    return None


def sources(tree):
    """All of the tree but hosts, which include what is installed."""
    for folder in ["kernels", "solver", "python", "bench/micro", "tests"]:
        for file in sorted((tree / folder).rglob("*")):
            path = str(file.relative_to(tree))
            if file.suffix in SOURCES and not path.startswith(("tests/embedding/", "tests/data/")):
                yield path


def arrows(tree, files=None):
    """(file, name, room, target or None, what is wrong or None) for each include of the tree, or of some files."""
    tree = pathlib.Path(tree).resolve()
    for path in sources(tree) if files is None else files:
        room = room_of(path)
        for bracket, name in INCLUDE.findall((tree / path).read_text()):
            target = target_of(tree, path, bracket, name)
            if room is None:
                wrong = "of a file that is in no room"
            elif target is None:
                wrong = outside_problem(room, name)
                if wrong is None and (bracket == '"' and name != "kernel_headers.hpp" or name.startswith("pinball/")):
                    wrong = "leads nowhere in the tree"
            else:
                wrong = problem(path, room, bracket, target)
            yield path, bracket + name, room, target, wrong


def problems(tree, files=None):
    return [f"{path}: {name} {wrong}" for path, name, _, _, wrong in arrows(tree, files) if wrong]


def unused_arrows(tree):
    """Arrows of the map that no include takes."""
    taken = {(room, room_of(target)) for _, _, room, target, _ in arrows(tree) if target}
    return [f"{room} includes nothing of {below}" for room, all_below in STANDS_ON.items() for below in all_below
            if (room, below) not in taken]


def level(room):
    """How many rooms lie below a room, one on the other."""
    return 1 + max((level(below) for below in STANDS_ON[room]), default=-1)


def map_text():
    """The map as docs/architecture.md has it: rooms that stand on the same number of others side by side."""
    width = max(map(len, ROOMS))
    levels = {room: level(room) for room in ROOMS}
    lines = []
    for height in sorted(set(levels.values()), reverse=True):
        for room in [room for room in ROOMS if levels[room] == height]:
            below = ", ".join(STANDS_ON[room])
            lines.append(f"{height:4}  {room:{width}}  {below}".rstrip())
    return "\n".join(["```text", f"level {'room':{width}}  stands on", *lines, "```"])


def map_in(page):
    """(from, to) of the map in the text of a page."""
    begin = page.index(MAP_BEGINS) + len(MAP_BEGINS)
    return begin, page.index(MAP_ENDS, begin)


def fix(path):
    page = path.read_text()
    begin, end = map_in(page)
    path.write_text(page[:begin] + map_text() + page[end:])


def main():
    if sys.argv[1:] == ["--fix"]:
        fix(checked_tree.ROOT / "docs" / "architecture.md")
        return 0
    tree = checked_tree.chosen()
    return checked_tree.print_problems(problems(tree) + unused_arrows(tree), f"{len(list(arrows(tree)))} includes, all downward")


if __name__ == "__main__":
    sys.exit(main())
