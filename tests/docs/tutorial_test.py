"""The commands of docs/tutorial.md run as they stand there, and print what stands there.

    tutorial_test.py PROGRAM FOLDER      FOLDER: to run in, emptied before

Every line of a block of text has to be the beginning of a line that the commands before it have printed: the same words, and
numbers that differ by a hundredth at most (those that chance moves, below 1e-5, are not compared).
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
BLOCK = re.compile(r"^```(sh|text)\n(.*?)^```$", re.S | re.M)
NUMBER = re.compile(r"[-+]?\d+(?:\.\d+)?(?:e[-+]?\d+)?")
CLOSE, CHANCE = 0.01, 1e-5


def same(said, printed):
    if len(printed) < len(said):
        return False
    for a, b in zip(said, printed):
        if NUMBER.sub("#", a) != NUMBER.sub("#", b):
            return False
        for x, y in zip(map(float, NUMBER.findall(a)), map(float, NUMBER.findall(b))):
            if abs(x - y) > CLOSE * max(abs(x), abs(y)) and max(abs(x), abs(y)) > CHANCE:
                return False
    return True


def main():
    program, folder = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2])
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    (folder / "data").symlink_to(ROOT / "data")
    environment = {**os.environ, "GOMP_SPINCOUNT": "1000", "PATH": f"{program.parent}:{os.environ['PATH']}"}
    printed, compared, wrong = [], 0, []
    for kind, text in BLOCK.findall((ROOT / "docs/tutorial.md").read_text()):
        if kind == "sh":
            done = subprocess.run(["sh", "-e", "-c", text], cwd=folder, env=environment, check=True, capture_output=True, text=True)
            printed = [line.split() for line in done.stdout.splitlines()]
            continue
        for line in text.splitlines():
            compared += 1
            if not any(same(line.split(), others) for others in printed):
                wrong.append(line)
    for line in wrong:
        print(f"not printed: {line}", file=sys.stderr)
    assert compared >= 8, f"{compared} lines were compared"
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
