"""The program behind the functions of this package that are its commands."""

from __future__ import annotations

import json
import os
import pathlib
import shutil
import subprocess
import tempfile
from typing import Any

from ._core import InputError, RunError


def find_program(program: str | os.PathLike[str] | None, what: str) -> str:
    """What is given, else PINBALL_PROGRAM, that of the build tree, or the one on the path. Raises InputError, which names `what`."""
    beside = pathlib.Path(__file__).resolve().parents[2] / "pinball"
    for choice in (program, os.environ.get("PINBALL_PROGRAM"), beside if beside.is_file() else None, shutil.which("pinball")):
        if choice:
            return os.fspath(choice)
    raise InputError(f"{what}: the program pinball is not on the path; program=... or PINBALL_PROGRAM names it")


def options_of(**options: Any) -> list[str]:
    """Words of a command line: each keyword is its option, a sequence one for each of its members, True one without a value."""
    words = []
    for name, value in options.items():
        option = "--" + name.replace("_", "-")
        if value is None or value is False:
            continue
        if value is True:
            words.append(option)
            continue
        for one in [value] if isinstance(value, (str, int, float, os.PathLike)) else value:
            words += [option, os.fspath(one) if isinstance(one, os.PathLike) else str(one)]
    return words


def call(command: str, program: str | os.PathLike[str] | None, words: list[str]) -> tuple[int, str]:
    """Its status and the error that it named, if any. Raises InputError for bad input. Ctrl-C ends it after its step."""
    process = subprocess.Popen([find_program(program, command), command, *words], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    try:
        said = process.communicate()[1]
    except KeyboardInterrupt:  # the program got it, too
        process.wait()
        raise
    problem = said.strip().rpartition("pinball: error: ")[2]  # warnings come before it
    if process.returncode == 2:
        raise InputError(problem)
    return process.returncode, problem


def table_of(command: str, program: str | os.PathLike[str] | None, words: list[str]) -> Any:
    """What it writes with --json. Raises InputError, and RunError where it has written none."""
    with tempfile.TemporaryDirectory() as folder:
        file = os.path.join(folder, "table.json")
        status, problem = call(command, program, [*words, "--quiet", "--json", file])
        if not os.path.exists(file):
            raise RunError(problem or f"pinball {command} ended with status {status}")
        with open(file, encoding="utf-8") as table:
            return json.load(table)
