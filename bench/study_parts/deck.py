"""A keyword deck (LS-DYNA) as a scene and a mesh file: solids with plasticity and erosion, held nodes, one velocity.

Reads *NODE (with tc: translations held), *ELEMENT_SOLID, *PART, *MAT_PLASTIC_KINEMATIC, *INITIAL_VELOCITY_GENERATION,
*CONTROL_TERMINATION and *INCLUDE; what stands in a *CASE is another run and is left out, all other keywords are named in
Deck.ignored. Units stay those of the deck.
"""

import os
import random
from dataclasses import dataclass, field

HELD = {"1": "x", "2": "y", "3": "z", "4": "xy", "5": "yz", "6": "zx", "7": "xyz"}  # by tc
CLOSE = 1e-5  # of the size of the mesh: nodes that far from a plane are on it


class Unreadable(Exception):
    """What the deck has and this does not do."""


@dataclass
class Deck:
    nodes: dict = field(default_factory=dict)  # number: [x, y, z]
    held: dict = field(default_factory=dict)  # number: directions
    elements: list = field(default_factory=list)  # (part, eight nodes)
    parts: dict = field(default_factory=dict)  # number: (title, material)
    materials: dict = field(default_factory=dict)  # number: fields
    velocities: list = field(default_factory=list)  # (part, vx, vy, vz)
    end: float = 0.0
    ignored: list = field(default_factory=list)


def numbers(line, width=10):
    cells = line.split(",") if "," in line else [line[i:i + width] for i in range(0, len(line), width)]
    return [float(c) if c.strip() else 0.0 for c in cells]


def keywords(path):
    """(keyword, its lines) of a deck and what it includes, outside of cases."""
    word, lines, inside = None, [], False
    with open(path, encoding="utf-8", errors="replace") as file:
        for line in file:
            line = line.rstrip("\n")
            if line.startswith("$"):
                continue
            if not line.startswith("*"):
                lines.append(line)
                continue
            if word and not inside:
                yield word, lines
            word, lines = line.split()[0].upper(), []
            inside = (inside or word.startswith("*CASE_BEGIN")) and not word.startswith("*CASE_END")
            if line.upper().startswith("*TITLE CID"):
                word = None
            if word == "*END":
                return
    if word and not inside:
        yield word, lines


def read(path, deck=None):
    deck = deck or Deck()
    for word, lines in keywords(path):
        if word == "*INCLUDE":
            read(os.path.join(os.path.dirname(path), lines[0].strip()), deck)
        elif word == "*NODE":
            for line in lines:
                number, held = int(line[:8]), line[56:64].strip()
                deck.nodes[number] = [float(line[8 + 16 * k:24 + 16 * k]) for k in range(3)]
                if held not in ("", "0"):
                    deck.held[number] = HELD[held]
        elif word == "*ELEMENT_SOLID":
            for line in lines:
                values = [int(line[8 * k:8 * k + 8]) for k in range(10)]
                deck.elements.append((values[1], values[2:]))
        elif word == "*PART":
            for title, line in zip(lines[::2], lines[1::2]):
                part, _, material = (int(v) for v in numbers(line)[:3])
                deck.parts[part] = (title.strip().lower(), material)
        elif word == "*MAT_PLASTIC_KINEMATIC":
            mid, density, young, poisson, yield_stress, tangent, beta = (numbers(lines[0]) + [0.0] * 7)[:7]
            rate_c, _, failure = (numbers(lines[1]) + [0.0] * 3)[:3]
            if rate_c or (tangent and beta != 1.0):
                raise Unreadable("a material that depends on rate or hardens kinematically")
            deck.materials[int(mid)] = {
                "density": density, "young_modulus": young, "poisson_ratio": poisson, "yield_stress": yield_stress,
                "plastic_modulus": young * tangent / (young - tangent), "erosion_strain": failure}
        elif word == "*INITIAL_VELOCITY_GENERATION":
            values = numbers(lines[0])
            deck.velocities.append((int(values[0]), *values[3:6]))  # of the part with the number of the set
        elif word == "*CONTROL_TERMINATION":
            deck.end = numbers(lines[0])[0]
        elif word not in ("*KEYWORD", "*TITLE"):
            deck.ignored.append(word)
    return deck


def bodies(deck):
    """(name, part number, numbers of its nodes) in the order of the parts."""
    for part, (title, _) in sorted(deck.parts.items()):
        own = sorted({n for p, corners in deck.elements if p == part for n in corners})
        yield title.split()[0], part, own


def planes(deck, own):
    """((axis, place), directions) of planes across an axis that together hold exactly the nodes of a body that are held;
    nodes that are nearly on a plane of symmetry are put on it. Raises Unreadable if there are none."""
    size = max(max(abs(c) for c in deck.nodes[n]) for n in own)
    found = []
    for directions in sorted({deck.held[n] for n in own if n in deck.held}):
        left = {n for n in own if deck.held.get(n) == directions}
        # A plane of symmetry also has nodes that others hold in more directions.
        enough = {n for n in own if set(directions) <= set(deck.held.get(n, ""))}
        for axis in ([ord(directions) - ord("x")] if len(directions) == 1 else range(3)):
            for place in sorted({round(deck.nodes[n][axis] / (CLOSE * size)) * CLOSE * size for n in left}):
                on_it = {n for n in own if abs(deck.nodes[n][axis] - place) < 3 * CLOSE * size}
                if on_it <= enough and on_it & left and len(on_it) > 2:
                    place = min((deck.nodes[n][axis] for n in on_it & left), key=lambda c: abs(c - place))
                    for n in on_it:
                        deck.nodes[n][axis] = place
                    found.append(((axis, place), directions))
                    left -= on_it
        if left:
            raise Unreadable(f"{len(left)} held nodes that are on no plane across an axis")
    return found


def write_mesh(deck, path, seed):
    """Gmsh 2.2, a physical volume per part; with a seed, nodes that nothing holds are moved by up to 1e-9."""
    rng = random.Random(seed)
    place = {n: i + 1 for i, n in enumerate(deck.nodes)}
    names = [(part, name) for name, part, _ in bodies(deck)]
    with open(path, "w", encoding="utf-8") as file:
        file.write(f"$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n{len(names)}\n")
        file.writelines(f'3 {part} "{name}"\n' for part, name in names)
        file.write(f"$EndPhysicalNames\n$Nodes\n{len(place)}\n")
        for n, x in deck.nodes.items():
            if seed is not None and n not in deck.held:
                x = [c + rng.uniform(-1e-9, 1e-9) for c in x]
            file.write(f"{place[n]} {x[0]!r} {x[1]!r} {x[2]!r}\n")
        file.write(f"$EndNodes\n$Elements\n{len(deck.elements)}\n")
        for i, (part, corners) in enumerate(deck.elements):
            file.write(f"{i + 1} 5 2 {part} {part} {' '.join(str(place[n]) for n in corners)}\n")
        file.write("$EndElements\n")


def write_scene(deck, folder, seed=None):
    """Writes scene.toml and mesh.msh; returns the path of the scene."""
    lines = [f"time.end = {deck.end!r}", 'contact.method = "pinball"', ""]
    held = {name: planes(deck, own) for name, _, own in bodies(deck)}
    write_mesh(deck, os.path.join(folder, "mesh.msh"), seed)
    for number, material in sorted(deck.materials.items()):
        lines += ["[[material]]", f'name = "m{number}"', 'model = "von_mises"']
        lines += [f"{key} = {value!r}" for key, value in material.items() if value] + [""]
    for name, part, _ in bodies(deck):
        lines += ["[[body]]", f'name = "{name}"', f'material = "m{deck.parts[part][1]}"',
                  f'mesh = {{ type = "gmsh", file = "mesh.msh", physical = "{name}" }}']
        lines += [f"velocity = [{vx!r}, {vy!r}, {vz!r}]" for p, vx, vy, vz in deck.velocities if p == part] + [""]
    for name, found in held.items():
        for (axis, place), directions in found:
            point, normal = [0.0] * 3, [0.0] * 3
            point[axis], normal[axis] = place, 1.0
            if directions == "xyz"[axis]:
                lines += ["[[constraint]]", 'type = "symmetry"', f'body = "{name}"', f"point = {point}", f"normal = {normal}", ""]
            else:
                lines += ["[[constraint]]", 'type = "fixed"', f'body = "{name}"', f"directions = {list(directions)}",
                          f"plane = {{ point = {point}, normal = {normal} }}", ""]
    path = os.path.join(folder, "scene.toml")
    with open(path, "w", encoding="utf-8") as file:
        file.write("\n".join(lines))
    return path
