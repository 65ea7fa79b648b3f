"""`pinball verify` on the mock device: scenes pass there, with the values that the host has.

    verification_test.py PROGRAM FOLDER [SCENE]...     of these scenes, else of MOST
"""

import json
import pathlib
import subprocess
import sys

# Where erosion in contact is decided by round-off (rod_plate, rod_oblique, perforated_plate) values are others where
# compilers fuse others; taylor_plate and those of spheres on walls take minutes, and do what others here do.
MOST = ("patch_test uniaxial_strain cyclic_shear elastic_cycles material_laws spinning_block block plate_impact hugoniot "
        "coarse_impact crushed_block cantilever plastic_cantilever two_blocks taylor_bar taylor_johnson_cook taylor_tetrahedra two_bars "
        "sphere_sphere").split()
PROGRAM, FOLDER, SCENES = sys.argv[1], pathlib.Path(sys.argv[2]), sys.argv[3:] or MOST


def rows(name, *words):
    """What the program says of scenes: by scene and quantity."""
    file = FOLDER / f"{name}.json"
    subprocess.run([PROGRAM, "verify", *words, "--json", file], check=True, stdout=subprocess.DEVNULL)
    return {(row["scene"], row["quantity"]): row for row in json.loads(file.read_text())["rows"]}


def main():
    FOLDER.mkdir(parents=True, exist_ok=True)
    on_mock = rows("mock", *SCENES, "--device", "mock")
    on_host = rows("none", *dict.fromkeys(scene for scene, _ in on_mock))
    assert on_mock.keys() == on_host.keys(), on_mock.keys() ^ on_host.keys()
    assert {scene for scene, _ in on_mock} == set(SCENES), "not all of the scenes"
    # Nearly all have the same bits; sums of energies have another order, and compilers fuse what they like. What compares
    # with zero is a residual, of which the tolerance is the scale.
    def scale(row):
        return 1e-6 * abs(row["value"]) if row["reference"] else 1e-3 * row["tolerance"]

    apart = [(key, row["value"], on_host[key]["value"]) for key, row in on_mock.items()
             if abs(row["value"] - on_host[key]["value"]) > scale(row)]
    assert not apart, apart
    print(f"{len(on_mock)} rows, the same on both")


if __name__ == "__main__":
    main()
