"""The rows of docs/verification.md are those that the program gives.

    verification_rows_test.py PROGRAM FILE [SCENE]...     of these scenes, else of all; FILE: what the program writes
"""

import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent


def main():
    program, file, *scenes = sys.argv[1:]
    pathlib.Path(file).parent.mkdir(parents=True, exist_ok=True)
    subprocess.run([program, "verify", *scenes, "--json", file], check=True)
    complete = [] if scenes else ["--complete"]
    return subprocess.run([ROOT / "docs" / "verification", *complete, file], check=False).returncode


if __name__ == "__main__":
    sys.exit(main())
