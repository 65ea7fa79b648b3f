"""The block as a mesh in which nodes and elements are numbered at random: what does a step cost after the renumbering?"""

import os
import tempfile

import numpy as np

from report_parts import measuring
from report_parts.builds import NATIVE, Failed

from .samples import Ratio

STRUCTURED, SHUFFLED = "block, its own mesh: speed", "block, shuffled mesh: speed"


def block(per_side):
    """Nodes and elements of a cube of side 1, in order."""
    axis = np.arange(per_side + 1) / per_side
    z, y, x = np.meshgrid(axis, axis, axis, indexing="ij")
    number = np.arange((per_side + 1)**3).reshape(3 * [per_side + 1])  # by z, y, x
    low, high = slice(None, -1), slice(1, None)
    square = [(low, low), (low, high), (high, high), (high, low)]  # y, x: around the face
    corners = [number[(layer, *corner)].ravel() for layer in (low, high) for corner in square]
    return np.column_stack([x.ravel(), y.ravel(), z.ravel()]), np.column_stack(corners)


def shuffle(nodes, elements, seed=1):
    """The same mesh, its nodes and elements in an order drawn at random, the same in every run."""
    random = np.random.default_rng(seed)
    order = random.permutation(len(nodes))
    number = np.empty_like(order)
    number[order] = np.arange(len(nodes))
    return nodes[order], number[elements][random.permutation(len(elements))]


def write_gmsh(path, nodes, elements):
    """As text of format 2.2, with one volume of 8-node hexahedra (type 5)."""
    with open(path, "w", encoding="ascii") as file:
        file.write(f"$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n{len(nodes)}\n")
        file.writelines(f"{n} {x!r} {y!r} {z!r}\n" for n, (x, y, z) in enumerate(nodes.tolist(), 1))
        file.write(f"$EndNodes\n$Elements\n{len(elements)}\n")
        file.writelines(f"{n} 5 2 1 1 {' '.join(map(str, corners))}\n" for n, corners in enumerate((elements + 1).tolist(), 1))
        file.write("$EndElements\n")


def read(what, summary, log):
    """The summary of a run. Output goes by the numbers of the mesh and is no part of a step: it is left out."""
    seconds = summary["wall_seconds"] - summary["phase_seconds"]["output"]
    log.add(what, summary["elements"], summary["precision"], summary["threads"],
            summary["elements"] * summary["steps"] / seconds * 1e-6, "million element steps/s")


def measure(per_side, steps, log):
    with tempfile.TemporaryDirectory() as where:
        path = os.path.join(where, "shuffled.msh")
        write_gmsh(path, *shuffle(*block(per_side)))
        meshes = {STRUCTURED: f"body.block.mesh.elements=[{per_side},{per_side},{per_side}]",
                  SHUFFLED: f'body.block.mesh={{ type = "gmsh", file = "{path}" }}'}
        for threads in (1, 2):
            runs = {what: measuring.run_scene(NATIVE, "block", threads, [f"time.steps={steps}", mesh])
                    for what, mesh in meshes.items()}
            if any(runs[STRUCTURED][count] != runs[SHUFFLED][count] for count in ("elements", "nodes", "steps")):
                raise Failed("the shuffled mesh of the block is not that of data/scenes/block.toml")
            for what, summary in runs.items():
                read(what, summary, log)


def ratios(samples):
    return [Ratio("block: shuffled mesh over its own", {"what": SHUFFLED}, {"what": STRUCTURED})]
