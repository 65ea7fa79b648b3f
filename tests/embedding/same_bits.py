"""Runs a scene with two programs and compares the hashes of their final states:
    same_bits.py PROGRAM OTHER_PROGRAM SCENE RESULTS_FOLDER"""

import json
import pathlib
import subprocess
import sys

*programs, scene, folder = sys.argv[1:]
hashes = []
for number, program in enumerate(programs):
    results = pathlib.Path(folder, str(number))
    subprocess.run([program, "run", scene, "--out", results, "--quiet"], check=True)
    hashes.append(json.loads((results / "summary.json").read_text())["state_hash"])
print(hashes)
sys.exit(0 if len(hashes) == 2 and hashes[0] == hashes[1] else 1)
