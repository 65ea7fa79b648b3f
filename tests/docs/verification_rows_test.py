"""The rows of docs/verification.md are those that the program gives.

    verification_rows_test.py PROGRAM FILE      runs all scenes; FILE: what the program writes
    verification_rows_test.py FOLDER            as tests of the scenes have left them there (tests/verification), of all but one
"""

import json
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
LONGEST = "rod_oblique"  # runs once, with all scenes


def left_in(folder):
    """One file of the rows in the files of the scenes that the page has."""
    page = (ROOT / "docs" / "verification.md").read_text()
    rows = []
    for scene in re.findall(r"<!-- rows: (\S+) -->", page):
        if scene != LONGEST:
            rows += json.loads((folder / f"{scene}.json").read_text())["rows"]
    file = folder / "all" / "rows.json"
    file.parent.mkdir(exist_ok=True)
    file.write_text(json.dumps({"rows": rows}))
    return file


def main():
    if not sys.argv[2:]:
        return subprocess.run([ROOT / "docs" / "verification", left_in(pathlib.Path(sys.argv[1]))], check=False).returncode
    program, file = sys.argv[1:]
    pathlib.Path(file).parent.mkdir(parents=True, exist_ok=True)
    subprocess.run([program, "verify", "--json", file], check=True)
    return subprocess.run([ROOT / "docs" / "verification", "--complete", file], check=False).returncode


if __name__ == "__main__":
    sys.exit(main())
