"""Runs a scene with the program and with a host, and compares the hashes of their final states:
    same_bits.py PROGRAM HOST SCENE RESULTS_FOLDER"""

import json
import os
import pathlib
import subprocess
import sys

program, host, scene, folder = sys.argv[1:]
# A host looks for scenes beside itself, where there are none: it is told where the program's are.
data = pathlib.Path(program).resolve().parent.parent / "share" / "pinball" / "data"
hashes = []
for name, command in {"program": [program, "run", scene, "--quiet", "--out"], "host": [host, scene]}.items():
    results = pathlib.Path(folder, name)
    subprocess.run([*command, results], check=True, env={**os.environ, "PINBALL_DATA": str(data)})
    hashes.append(json.loads((results / "summary.json").read_text())["state_hash"])
print(hashes)
sys.exit(0 if hashes[0] == hashes[1] else 1)
