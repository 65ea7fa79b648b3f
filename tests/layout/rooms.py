"""The rooms of the source tree and which way their includes go: each room may include itself and the rooms before it.

    rooms.py [TREE]      prints every include that goes another way; exit status 1 if there is one
"""

import pathlib
import re
import sys

# Lowest first. A room is a folder, or the public headers named for it, which lie above their room's folder.
ROOMS = {
    "kernels": ["kernels/"],
    "exec": ["kernels/exec/", "kernels/exec.hpp"],
    "base": ["solver/base/"],
    "contact interface": ["solver/contact/contact.h", "solver/contact/embedded_contact.hpp",
                          "solver/contact/contact_settings.hpp"],
    "contact/surface": ["solver/contact/surface/"],
    "contact/tied": ["solver/contact/tied/"],
    "contact/search": ["solver/contact/search/"],
    "contact/impulses": ["solver/contact/impulses/"],
    "contact/algorithm": ["solver/contact/algorithm/"],
    "contact/segments": ["solver/contact/segments/"],
    "contact/spheres": ["solver/contact/spheres/"],
    "contact/pinball": ["solver/contact/pinball/"],
    "contact/faces": ["solver/contact/faces/"],
    "contact/slideline": ["solver/contact/slideline/"],
    "contact": ["solver/contact/make_contact.cpp"],
    "contact/host": ["solver/contact/host/"],
    "mesh": ["solver/mesh/", "solver/mesh.hpp", "solver/mesh_settings.hpp", "solver/array_view.hpp"],
    "scene": ["solver/scene/", "solver/scene.hpp", "solver/scene_boundary.hpp", "solver/scene_contact.hpp",
              "solver/scene_material.hpp", "solver/scene_rules.hpp"],
    "formats/deck": ["solver/formats/deck/"],
    "formats/abaqus": ["solver/formats/abaqus/"],
    "formats/exodus": ["solver/formats/exodus/"],
    "formats/gmsh": ["solver/formats/gmsh/"],
    "formats/lsdyna": ["solver/formats/lsdyna/"],
    "formats/vtk": ["solver/formats/vtk/"],
    "formats": ["solver/formats/"],
    "model": ["solver/model/"],
    "results": ["solver/results/", "solver/results.hpp", "solver/field_base.hpp"],
    "elements": ["solver/elements/"],
    "boundary": ["solver/boundary/"],
    "device": ["solver/device/"],
    "step": ["solver/step/"],
    "simulation": ["solver/simulation/", "solver/simulation.hpp"],
    "output": ["solver/output/", "solver/recorded_run.hpp", "solver/restart.hpp", "solver/run_page.hpp",
               "solver/summary.hpp"],
    "verification": ["solver/verification/"],
    "program": ["solver/program/"],
    "python": ["python/"],
    "bench": ["bench/micro/"],
    "tests": ["tests/"],
}
ORDER = {room: number for number, room in enumerate(ROOMS)}

# Side by side: neither includes the other, although one stands before the other above.
APART = [("contact/pinball", "contact/faces"), ("contact/pinball", "contact/slideline"),
         ("contact/faces", "contact/slideline"), ("elements", "boundary"), ("program", "python")]
FORMATS = [room for room in ROOMS if room.startswith("formats/") and room != "formats/deck"]
APART += [(one, other) for one in FORMATS for other in FORMATS if one < other]

# Hosts get these, and nothing else. They include by paths from where they lie, so that they hold wherever they are put.
PUBLIC = re.compile(r"kernels/((boundary|exec|material)/)?[a-z_]+\.hpp|solver/[a-z_]+\.hpp|solver/base/[a-z_]+\.hp*|solver/contact/[a-z_]+\.hp*|"
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


def room_of(path):
    """Room of a file, or None. The longest name counts."""
    fitting = [(len(place), room) for room, places in ROOMS.items() for place in places
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
    if ORDER[other] > ORDER[room]:
        return f"goes up from {room} to {other}"
    if (room, other) in APART or (other, room) in APART:
        return f"goes from {room} to {other}, which lie apart"
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


def main():
    tree = sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).resolve().parent.parent.parent
    found = problems(tree)
    print("\n".join(found) if found else f"{len(list(arrows(tree)))} includes, all downward")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
