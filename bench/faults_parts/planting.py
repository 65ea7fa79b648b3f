"""Which faults there are, and a copy of the tree with all of them in it, each behind a switch."""

import os
import random
import re
import shutil

from report_parts.builds import ROOT, Failed

from .named import all_named, text_of
from .rules import ARCHIVE, candidates

SWITCH = "bench/faults_parts/switch.hpp"  # below the root, as all of the tree includes
LEFT_OUT = ("build", "out", ".git", "__pycache__")
# Rooms whose results a user gets; devices, and what only measures, are not among them.
ROOMS = ("kernels", "boundary", "contact", "elements", "formats", "mesh", "model", "output", "parallel", "program", "results",
         "rigid", "scene", "simulation", "step")
MOST = 4000


def sources(rooms):
    """Files of the rooms, below ROOT; headers of kernels, and those that list what of a state is saved."""
    found = []
    for room in rooms:
        top = room if room == "kernels" else os.path.join("solver", room)
        for folder, folders, files in os.walk(os.path.join(ROOT, top)):
            folders[:] = sorted(f for f in folders if f not in LEFT_OUT and f not in ("exec", "device"))
            for path in (os.path.relpath(os.path.join(folder, f), ROOT) for f in sorted(files)):
                if path.endswith(".cpp") or (path.endswith(".hpp") and (room == "kernels" or ARCHIVE.search(text_of(path)))):
                    found.append(path)
    return found


def faults_of(file):
    """What the rules find in a file. Headers are read by much of the tree: of most only what of a state is saved."""
    found = candidates(file, text_of(file))
    return found if file.endswith(".cpp") or file.startswith("kernels/") else [f for f in found if f.rule == "unread"]


def overlaps(fault, others):
    return any(fault.file == o.file and fault.begin < o.begin + len(o.right) and o.begin < fault.begin + len(fault.right) for o in others)


def add_one_of(room, piles, chosen, chance):
    """The next of a room, of the rule that it has fewest of; where that is at the place of another, the one after it."""
    while room in piles:
        rule = min(piles[room], key=lambda r: (sum(f.rule == r and f.room == room for f in chosen), r))
        pile = piles[room][rule]
        fault = pile.pop(chance.randrange(len(pile)))
        if not pile:
            del piles[room][rule]
        if not piles[room]:
            del piles[room]
        if not overlaps(fault, chosen):
            chosen.append(fault)
            return


def by_rule(options, taken):
    """As many as are asked for, of all rooms and rules in turn, at places that no other has."""
    chance, count, rooms = random.Random(options.seed), options.count, options.rooms
    piles = {}
    for room in rooms:
        some = [file for file in sources([room]) if re.search(options.only, file)]
        chance.shuffle(some)
        for file in some[:options.files]:
            for fault in faults_of(file):
                piles.setdefault(room, {}).setdefault(fault.rule, []).append(fault)
    chosen = list(taken)
    while piles and len(chosen) < len(taken) + count:
        for room in [r for r in rooms if r in piles]:
            if len(chosen) < len(taken) + count:
                add_one_of(room, piles, chosen, chance)
    return chosen[len(taken):]


def choose(options):
    """{number: fault}, those that are named first. options: of the command."""
    first = [] if options.unnamed else [
        fault for fault in all_named()[0] if fault.room in options.rooms and re.search(options.only, fault.file)]
    faults = first + by_rule(options, first)
    if len(faults) > MOST:
        raise Failed(f"{len(faults)} faults are more than {MOST}")
    return dict(enumerate(faults))


def planted_text(text, faults):
    """faults: {number: fault} of this file."""
    for number, fault in sorted(faults.items(), key=lambda item: -item[1].begin):
        end = fault.begin + len(fault.right)
        if text[fault.begin:end] != fault.right:
            raise Failed(f"{fault.file}: `{fault.right}` is not at {fault.begin}")
        text = text[:fault.begin] + fault.planted(number) + text[end:]
    return f'#include <{SWITCH}>\n#line 1\n{text}'


def write_if_other(path, content):
    """So that only what has changed is compiled anew."""
    try:
        with open(path, "rb") as file:
            if file.read() == content:
                return
    except FileNotFoundError:
        pass
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "wb") as file:
        file.write(content)


def plant(tree, faults):
    """Makes the copy, or brings it up to date."""
    of_file = {}
    for number, fault in faults.items():
        of_file.setdefault(fault.file, {})[number] = fault
    kept = set()
    for folder, folders, files in os.walk(ROOT):
        folders[:] = [f for f in folders if f not in LEFT_OUT]
        for name in files:
            path = os.path.relpath(os.path.join(folder, name), ROOT)
            kept.add(path)
            with open(os.path.join(ROOT, path), "rb") as file:
                content = file.read()
            if path in of_file:
                content = planted_text(content.decode(), of_file[path]).encode()
            write_if_other(os.path.join(tree, path), content)
            shutil.copymode(os.path.join(ROOT, path), os.path.join(tree, path))
    for folder, folders, files in os.walk(tree):
        folders[:] = [f for f in folders if f not in LEFT_OUT]
        for name in files:
            if os.path.relpath(os.path.join(folder, name), tree) not in kept:
                os.remove(os.path.join(folder, name))
