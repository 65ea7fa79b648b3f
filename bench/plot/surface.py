"""The surface of a hexahedral mesh and its projection onto a picture."""

import numpy as np

# The six faces of a hexahedron, node order such that the right-hand normal points outward (see solver/mesh.hpp).
FACES = np.array([[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [3, 7, 6, 2], [0, 4, 7, 3]])

# Where the viewer stands, seen from the model; z is up, except in views along z, where y is.
VIEWS = {
    "side": (0.0, -1.0, 0.0),
    "back": (0.0, 1.0, 0.0),
    "top": (0.0, 0.0, 1.0),
    "bottom": (0.0, 0.0, -1.0),
    "iso": (0.45, -1.0, 0.6),
}


def exposed_quads(hexahedra):
    """Faces that belong to one element only.

    hexahedra: (m, 8) node indices; where some are collapsed, their triangles are quads with a node twice, and faces of
    fewer than three nodes are none. Returns quads (q, 4) with outward normals and the element of each (q,).
    """
    quads = hexahedra[:, FACES].reshape(-1, 4)
    owners = np.repeat(np.arange(len(hexahedra)), len(FACES))
    if len(quads) == 0:
        return quads, owners
    nodes = np.sort(quads, axis=1)
    with_area = (np.diff(nodes, axis=1) != 0).sum(axis=1) >= 2
    quads, owners, nodes = quads[with_area], owners[with_area], nodes[with_area]
    # The sorted nodes of a triangle are aabc, abbc or abcc; all become abcc.
    nodes[:, 1] = np.where(nodes[:, 1] == nodes[:, 0], nodes[:, 2], nodes[:, 1])
    nodes[:, 2] = np.where(nodes[:, 2] == nodes[:, 1], nodes[:, 3], nodes[:, 2])
    order = np.lexsort(nodes.T)
    same = (nodes[order][1:] == nodes[order][:-1]).all(axis=1)  # as the face before
    single = np.ones(len(quads), dtype=bool)
    single[1:] &= ~same
    single[:-1] &= ~same
    kept = np.sort(order[single])
    return quads[kept], owners[kept]


def mirror_quads(corners, tolerance):
    """The other half of a body cut at y = 0.

    corners: (q, 4, 3). Returns which quads to keep (those in the cut become interior) and the mirror images of the kept.
    """
    kept = (np.abs(corners[:, :, 1]) > tolerance).any(axis=1)
    images = corners[kept][:, ::-1] * np.array([1.0, -1.0, 1.0])  # reversed: the normal stays outward
    return kept, images


def camera(view):
    """Unit vectors (right, up, toward the viewer) of a view."""
    toward = np.array(VIEWS[view])
    toward = toward / np.linalg.norm(toward)
    vertical = np.array([0.0, 0.0, 1.0]) if abs(toward[2]) < 0.99 else np.array([0.0, 1.0, 0.0])
    right = np.cross(vertical, toward)
    right /= np.linalg.norm(right)
    return right, np.cross(toward, right), toward


def project(corners, view):
    """Painter's picture of quads: those that face the viewer, farthest first.

    corners: (q, 4, 3). Returns (indices, outlines (v, 4, 2), brightness (v,) in 0..1): flat shading with light from
    above the viewer's left shoulder, 1 where a quad faces the viewer, so that its colour is that of the colour bar.
    """
    right, up, toward = camera(view)
    normals = np.cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1])
    length = np.linalg.norm(normals, axis=1)
    normals /= np.where(length > 0.0, length, 1.0)[:, None]
    visible = np.flatnonzero(normals @ toward > 1e-6)
    order = visible[np.argsort((corners[visible] @ toward).mean(axis=1), kind="stable")]
    light = toward + 0.45 * up - 0.35 * right
    brightness = np.clip(normals[order] @ light / (toward @ light), 0.0, 1.0)
    outlines = np.stack([corners[order] @ right, corners[order] @ up], axis=-1)
    return order, outlines, brightness
