"""Runs that mpirun starts on several ranks: the same bits and files as of one process, and what they do where something is
wrong.

    mpirun_test.py PROGRAM ALONE FOLDER         PROGRAM of ranks, ALONE without; exit status 77: there is no mpirun
    mpirun_test.py PROGRAM ALONE FOLDER DATA    every scene and deck of this folder
"""

import itertools
import json
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import time

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "python"))
from view.fields import read_pvd, read_vtu  # noqa: E402

PROGRAM, ALONE, FOLDER = sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3])
# Of this machine alone, whatever a batch system has left in the environment; root may, in a container.
MPIRUN = ["mpirun", "--oversubscribe", "--allow-run-as-root", "--host", "localhost"]
OTHERS = {"started", "threads", "wall_seconds", "phase_seconds", "element_steps_per_second", "skipped_seconds",
          "bytes_per_element", "parallel"}  # keys of times, and of how the run was shared
SCENES = {
    "block": ["block", "--set", "body.block.mesh.elements=[14,13,12]", "--set", "time.steps=20"],
    "taylor_bar": ["taylor_bar", "--set", "time.steps=60", "--set", "material.copper.erosion_strain=0.1",
                   "--set", "output.interval=2e-4"],
    "spinning_block": ["spinning_block", "--set", "time.steps=60", "--precision", "float"],
    "plate_impact": ["plate_impact", "--set", "time.steps=60"],
    "cantilever": ["cantilever", "--set", "time.steps=60"],
    "rod_plate": ["rod_plate", "--set", "time.steps=160"],
    "rod_plate_faces": ["rod_plate", "--set", "time.steps=160", "--set", "contact.enforcement=lagrange", "--set", "contact.gap=face"],
    "sliding_block": ["sliding_block", "--set", "time.steps=60"],
    "two_bars": ["two_bars"],
    # Lists of so many pairs that ranks share them.
    "wide_blocks": ["two_blocks", "--set", "time.steps=20", "--set", "contact.enforcement=lagrange", "--set", "contact.gap=face",
                    "--set", "body.lower.mesh.elements=[50,50,3]", "--set", "body.upper.mesh.elements=[50,50,3]",
                    "--set", "body.upper.position=[0.0,0.0,0.10001]"],
    "taylor_tetrahedra": ["taylor_tetrahedra", "--set", "body.bar.mesh.layers=20", "--set", "time.steps=60"],
    "refined_layer": ["refined_layer", "--set", "time.steps=160"],
}
IN_FULL = ("block", "taylor_bar", "rod_plate", "taylor_tetrahedra", "wide_blocks", "refined_layer")  # on one to four ranks


def start(ranks, *words, program=PROGRAM, **more):
    command = MPIRUN + ["-n", str(ranks), program, *map(str, words)]
    return subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, **more)


def mpirun(ranks, *words):
    process = start(ranks, *words)
    out, errors = process.communicate(timeout=60)
    return process.returncode, out, errors


def summary(folder):
    return json.loads((folder / "summary.json").read_text())


def results(folder):
    return {key: value for key, value in summary(folder).items() if key not in OTHERS}


def run_alone(folder, *words):
    subprocess.run([ALONE, "run", *map(str, words), "--out", folder, "--quiet"], check=True, stdout=subprocess.DEVNULL)


def run_on(ranks, folder, *words):
    status, out, errors = mpirun(ranks, "run", *words, "--out", folder, "--quiet")
    assert status == 0, (ranks, words, errors)
    assert errors == "" and len([line for line in out.splitlines() if line.startswith("  state ")]) == 1, (out, errors)


def expect_same(folder, alone):
    assert results(folder) == results(alone), folder
    assert (folder / "history.csv").read_bytes() == (alone / "history.csv").read_bytes(), folder


def same_results():
    for name, words in SCENES.items():
        run_alone(FOLDER / name / "alone", *words)
        partitions = [(1, "tiles"), (2, "tiles"), (3, "random:7"), (4, "tiles")]
        for ranks, partition in partitions if name in IN_FULL else partitions[2:3]:
            folder = FOLDER / name / str(ranks)
            run_on(ranks, folder, *words, "--partition", partition)
            expect_same(folder, FOLDER / name / "alone")
            shared = summary(folder)["parallel"]
            assert shared is None if ranks == 1 else shared["ranks"] == ranks and shared["bytes_per_step"] > 0, shared


def a_device_each():
    for name, ranks, partition in [("block", 2, "tiles"), ("taylor_bar", 3, "random:7"), ("spinning_block", 2, "tiles"),
                                   ("cantilever", 2, "random:1"), ("plate_impact", 4, "tiles"), ("rod_plate_faces", 1, "tiles"),
                                   ("rod_plate_faces", 2, "tiles"), ("rod_plate_faces", 3, "random:7"),
                                   ("rod_plate_faces", 4, "tiles"), ("rod_plate", 3, "random:5"), ("wide_blocks", 2, "tiles"), ("sliding_block", 3, "tiles"),
                                   ("taylor_tetrahedra", 2, "tiles"), ("taylor_tetrahedra", 4, "random:3")]:
        words = [*SCENES[name], "--device", "mock"]
        folder = FOLDER / "devices" / f"{name}_{ranks}"
        run_alone(folder / "alone", *words)
        run_on(ranks, folder / "ranks", *words, "--partition", partition)
        expect_same(folder / "ranks", folder / "alone")
        shared = summary(folder / "ranks")["parallel"]
        assert shared is None if ranks == 1 else shared["devices"] == ranks * ["mock"], folder
    words = ["--set", "time.steps=30", "--checkpoint-every", 30, "--device", "mock"]
    run_on(3, FOLDER / "devices" / "saved", *SCENES["taylor_bar"], *words)
    more = ["--restart", FOLDER / "devices" / "saved" / "checkpoint.pinball", "--set", "time.steps=60", "--device", "mock"]
    run_on(2, FOLDER / "devices" / "more", *more)
    run_alone(FOLDER / "devices" / "alone", *more)
    assert results(FOLDER / "devices" / "more") == results(FOLDER / "devices" / "alone")


def deck_of_tetrahedra(path):
    """A bar of 4 x 4 x 12 cubes of 1 mm along z, each six C3D4, of which the lower end is held and all else flies down."""
    counts = (4, 4, 12)
    number = lambda i, j, k: 1 + i + (counts[0] + 1) * (j + (counts[1] + 1) * k)
    places = itertools.product(*(range(count + 1) for count in counts))
    nodes = [f"{number(*place)}, {', '.join(map(str, place))}" for place in places]
    elements = []
    for cube in itertools.product(*map(range, counts)):
        for axes in itertools.permutations(range(3)):
            corners = [list(cube)]
            for axis in axes:
                corners.append(corners[-1][:])
                corners[-1][axis] += 1
            if (axes[1] - axes[0]) % 3 == 2:
                corners[1], corners[2] = corners[2], corners[1]
            elements.append(f"{len(elements) + 1}, {', '.join(str(number(*corner)) for corner in corners)}")
    last = number(*counts)
    path.write_text("\n".join([
        "*NODE", *nodes, "*ELEMENT, TYPE=C3D4, ELSET=bar", *elements, "*NSET, NSET=low, GENERATE",
        f"1, {number(counts[0], counts[1], 0)}, 1", "*NSET, NSET=high, GENERATE", f"{number(0, 0, 1)}, {last}, 1",
        "*SOLID SECTION, ELSET=bar, MATERIAL=steel", ",", "*MATERIAL, NAME=steel", "*DENSITY", "7.85E-9", "*ELASTIC",
        "210000., 0.3", "*PLASTIC", "300., 0.", "400., 1.", "*BOUNDARY", "low, 1, 3",
        "*INITIAL CONDITIONS, TYPE=VELOCITY", "high, 3, -1.E5", "*STEP", "*DYNAMIC, EXPLICIT", ", 1.E-5", "*END STEP", ""]))
    return path


def tetrahedra_of_a_deck():
    deck = deck_of_tetrahedra(FOLDER / "bar.inp")
    run_alone(FOLDER / "bar" / "alone", deck)
    assert summary(FOLDER / "bar" / "alone")["bodies"][0]["max_plastic_strain"] > 0.05
    for ranks in (1, 2, 3, 4, 7):
        run_on(ranks, FOLDER / "bar" / str(ranks), deck, "--partition", f"random:{ranks}")
        expect_same(FOLDER / "bar" / str(ranks), FOLDER / "bar" / "alone")


def partition_by_metis():
    status, _, errors = mpirun(2, "run", *SCENES["block"], "--partition", "metis", "--out", FOLDER / "metis", "--quiet")
    if status == 2 and "built without METIS" in errors:
        print("no METIS: its partition is not tested")
        return
    assert status == 0, errors
    assert results(FOLDER / "metis") == results(FOLDER / "block" / "alone")


def checkpoint_of_three_on_others():
    for scene, half, end, cycles in ("taylor_bar", 30, 60, 30), ("refined_layer", 81, 161, 6):
        folder = FOLDER / "restart" / scene
        run_alone(folder / "alone", *SCENES[scene], "--set", f"time.steps={end}")
        run_on(3, folder / "saved", *SCENES[scene], "--set", f"time.steps={half}", "--checkpoint-every", cycles)
        more = ["--restart", folder / "saved" / "checkpoint.pinball", "--set", f"time.steps={end}"]
        for ranks in (2, 4):
            run_on(ranks, folder / f"more{ranks}", *more)
        run_alone(folder / "more", *more)
        hashes = {summary(folder / name)["state_hash"] for name in ("more", "more2", "more4", "alone")}
        assert len(hashes) == 1, (scene, hashes)


def every_input(data):
    inputs = [*(data / "scenes").glob("*.toml"), *(data / "decks").glob("*.k"), *(data / "decks/abaqus").glob("*.inp"),
              *(data / "decks/radioss").glob("*_0000.rad")]
    for path in sorted(inputs):
        alone = FOLDER / path.name / "alone"
        words = [path, "--set", "time.steps=150"]
        run_alone(alone, *words)
        for ranks, partition in (2, "random:3"), (3, "random:5"), (4, "tiles"):
            folder = FOLDER / path.name / str(ranks)
            status, _, errors = mpirun(ranks, "run", *words, "--out", folder, "--quiet", "--partition", partition)
            assert status == 0, (path, ranks, errors)
            expect_same(folder, alone)
    print(len(inputs), "inputs as on one process", flush=True)
    assert len(inputs) >= 50, inputs


def message_of(status, ranks, *words):
    """The one message of the program; what mpirun says has another form."""
    found, _, errors = mpirun(ranks, "run", *words, "--out", FOLDER / f"failed{ranks}", "--quiet")
    assert found == status, (found, errors)
    messages = [line for line in errors.splitlines() if line.startswith("pinball: error: ")]
    assert len(messages) == 1, errors
    return messages[0]


def errors():
    ranks = 3
    assert "no device can do this scene yet: it has subcycling" in message_of(2, ranks, "refined_layer", "--device", "mock")
    assert "no such scene" in message_of(2, ranks, "nothing_of_this_name")
    assert "guard.energy_error" in message_of(1, ranks, "taylor_bar", "--set", "guard.energy_error=1e-9",
                                              "--set", "output.field_times=[]")
    assert summary(FOLDER / f"failed{ranks}")["status"] == "failed"
    assert (FOLDER / f"failed{ranks}" / "last_good.pinball").exists()


def commands_of_one():
    """What is no run rank 0 does alone, once."""
    (FOLDER / "new").mkdir()
    for words in ["info", "block"], ["schema", "--keys"], ["view", "--help"], ["new", "first", "--out", FOLDER / "new"]:
        status, out, errors = mpirun(3, *words)
        assert status == 0 and errors == "", (words, errors)
        if words[0] != "new":
            alone = subprocess.run([ALONE, *words], capture_output=True, text=True, check=True).stdout
            timeless = lambda text: [line for line in text.splitlines() if "run time about" not in line]
            assert timeless(out) == timeless(alone) != [], words
    assert (FOLDER / "new" / "first.toml").exists()
    for words, expected in (["info", "nothing_of_this_name"], "no such scene"), (["compare", "block"], "mpirun: expected pinball run"):
        status, _, errors = mpirun(3, *words)
        messages = [line for line in errors.splitlines() if line.startswith("pinball: error: ")]
        assert status == 2 and len(messages) == 1 and expected in messages[0], (words, errors)


def pieces_of_fields():
    """Each rank writes its own of the fields: the numbers of the files that one process writes, for every reader."""
    words = [*SCENES["rod_plate_faces"], "--set", "output.field_times=[0.0,2e-6,4e-6]"]
    run_alone(FOLDER / "pieces" / "alone", *words)
    whole = read_pvd(str(FOLDER / "pieces" / "alone" / "fields.pvd"))
    assert len(whole) >= 2, whole
    for ranks, more in (2, []), (3, ["--partition", "random:7"]), (3, ["--device", "mock"]):
        alone = FOLDER / "pieces" / "alone"
        if more[:1] == ["--device"]:
            alone = FOLDER / "pieces" / "on_device"
            run_alone(alone, *words, *more)
            whole = read_pvd(str(alone / "fields.pvd"))
        folder = FOLDER / "pieces" / f"{ranks}_{len(more) and more[0][2:]}"
        run_on(ranks, folder, *words, *more, "--pieces")
        expect_same(folder, alone)
        pieces = read_pvd(str(folder / "fields.pvd"))
        assert [time for time, _ in pieces] == [time for time, _ in whole]
        for (_, one), (_, other) in zip(whole, pieces):
            assert other.endswith(".pvtu"), other
            same_meshes(read_vtu(one), read_vtu(other))
            same_for_paraview(one, other)
        surface = lambda page: re.search(r'id="surface"[^>]*>([^<]*)<', page.read_text()).group(1)
        assert surface(folder / "index.html") == surface(alone / "index.html") != "", "the surface of the page"
    run_on(2, folder, *words, "--device", "mock")
    assert not list(folder.glob("*.pvtu")) and len(list(folder.glob("*.vtu"))) == len(whole), "pieces of the run before"


def same_meshes(one, other):
    assert other.names == one.names != [] and other.units == one.units and other.components == one.components
    for kind in "point_data", "cell_data":
        assert getattr(other, kind).keys() == getattr(one, kind).keys()
        for name, values in getattr(one, kind).items():
            assert np.array_equal(getattr(other, kind)[name], values), name
    assert np.array_equal(other.points, one.points) and np.array_equal(other.hexahedra, one.hexahedra)


def same_for_paraview(one, other):
    """Cells and values that VTK, and so ParaView, reads of both."""
    try:
        import vtkmodules.all as vtk
        from vtkmodules.util.numpy_support import vtk_to_numpy
    except ModuleNotFoundError:
        return
    grids = []
    for reader, path in (vtk.vtkXMLUnstructuredGridReader(), one), (vtk.vtkXMLPUnstructuredGridReader(), other):
        reader.SetFileName(path)
        reader.Update()
        grids.append(reader.GetOutput())
    whole, pieces = grids
    assert pieces.GetNumberOfCells() == whole.GetNumberOfCells() > 0
    for data in "GetPointData", "GetCellData":
        places = vtk_to_numpy(getattr(pieces, data)().GetGlobalIds())
        assert set(places) == set(range(max(places) + 1))
        for a in range(getattr(whole, data)().GetNumberOfArrays()):
            expected = getattr(whole, data)().GetArray(a)
            found = vtk_to_numpy(getattr(pieces, data)().GetArray(expected.GetName()))
            assert np.array_equal(found, vtk_to_numpy(expected)[places]), expected.GetName()
    places = vtk_to_numpy(pieces.GetPointData().GetGlobalIds())
    assert np.array_equal(vtk_to_numpy(pieces.GetPoints().GetData()), vtk_to_numpy(whole.GetPoints().GetData())[places])


def unlike_programs():
    other = FOLDER / "other"
    shutil.copy(PROGRAM, other)
    with other.open("ab") as file:
        file.write(b"another build")
    words = ["run", "block", "--out", str(FOLDER / "unlike")]
    both = subprocess.run(MPIRUN + ["-n", "1", PROGRAM, *words, ":", "-n", "1", other, *words], capture_output=True,
                          text=True, timeout=60)
    assert both.returncode == 2 and "rank 1 runs another program than rank 0" in both.stderr, both.stderr


def children(process):
    """The ranks of an mpirun."""
    found = pathlib.Path(f"/proc/{process.pid}/task/{process.pid}/children").read_text().split()
    return [int(pid) for pid in found]


def wait_for_rows(folder):
    for _ in range(300):
        if (folder / "history.csv").exists() and len((folder / "history.csv").read_text().splitlines()) > 2:
            return
        time.sleep(0.1)
    raise AssertionError(f"no rows in {folder}")


def killed_rank():
    long = ["run", "taylor_bar", "--set", "time.end=100", "--set", "output.interval=1e-4", "--quiet", "--out"]
    process = start(3, *long, FOLDER / "killed")
    wait_for_rows(FOLDER / "killed")
    os.kill(children(process)[-1], signal.SIGKILL)
    process.communicate(timeout=30)
    assert process.returncode != 0
    process = start(3, *long, FOLDER / "stopped")
    wait_for_rows(FOLDER / "stopped")
    os.kill(children(process)[0], signal.SIGUSR1)  # rank 0 decides
    process.communicate(timeout=30)
    assert process.returncode == 128 + signal.SIGUSR1, process.returncode
    assert summary(FOLDER / "stopped")["status"] == "stopped" and (FOLDER / "stopped" / "checkpoint.pinball").exists()


def main():
    if shutil.which("mpirun") is None:
        print("no mpirun: nothing is tested")
        return 77
    shutil.rmtree(FOLDER, ignore_errors=True)
    FOLDER.mkdir(parents=True)
    if len(sys.argv) > 4:
        every_input(pathlib.Path(sys.argv[4]))
        return 0
    for check in (same_results, a_device_each, tetrahedra_of_a_deck, partition_by_metis, checkpoint_of_three_on_others, errors,
                  commands_of_one, pieces_of_fields, unlike_programs, killed_rank):
        check()
        print(check.__name__, "as expected", flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
