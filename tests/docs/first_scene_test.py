"""The first scene of README.md runs as it stands there, and its energies add up.

    first_scene_test.py PROGRAM FOLDER      FOLDER: to run in, emptied before
"""

import json
import os
import pathlib
import re
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
BLOCK = re.compile(r"<!-- run by tests/docs/first_scene_test\.py -->\n```sh\n(.*?)```\n", re.S)
PROGRAM = "build/release/pinball "


def main():
    program, folder = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2])
    blocks = BLOCK.findall((ROOT / "README.md").read_text())
    assert len(blocks) == 1, f"README.md has {len(blocks)} first scenes"
    assert blocks[0].count("\n") <= 12, "the first scene is longer than its heading promises"
    assert blocks[0].count(PROGRAM) == 1, f"the first scene does not run {PROGRAM}"
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    environment = {**os.environ, "GOMP_SPINCOUNT": "1000"}
    subprocess.run(["sh", "-e", "-c", blocks[0].replace(PROGRAM, f"'{program}' ")], cwd=folder, env=environment, check=True)

    summaries = list(folder.glob("out/*/summary.json"))
    assert len(summaries) == 1, f"the first scene has left {summaries}"
    summary = json.loads(summaries[0].read_text())
    energy = summary["energy"]
    assert energy["initial_total"] > 0
    assert energy["balance_error_max"] < 1e-3, f"the energy balance is off by {energy['balance_error_max']}"
    assert summary["contact"]["pairs_max"] > 0, "nothing has touched"
    assert not summary["warnings"], summary["warnings"]
    assert summary["contact"]["residual_share_max"] < 1e-6, summary["contact"]


if __name__ == "__main__":
    main()
