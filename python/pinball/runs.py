"""`pinball run` from Python, which takes decks, too."""

from __future__ import annotations

import json
import os
import pathlib
from typing import Any, Sequence

from ._core import RunError
from .program import call, options_of


def run(scene: str | os.PathLike[str], out: str | os.PathLike[str], *, set: Sequence[str] = (), refine: int | None = None,
        precision: str | None = None, threads: int | None = None, device: str | None = None, case: int | None = None,
        lenient: bool = False, checkpoint_every: int | None = None, program: str | os.PathLike[str] | None = None) -> dict[str, Any]:
    """Runs a scene or a deck of another program to its end, with all files of the run in the folder `out`, and returns what
    summary.json holds.

    scene: a file, or the name of a scene that comes along. The other arguments are the options of `pinball run`, which does the work:
    the program has to be installed, or named. A scene that is made in Python runs by `run_recorded`. Raises InputError for bad
    input, RunError for a run that fails. Ctrl-C leaves the files of the run so far.
    """
    words = [os.fspath(scene), "--quiet", *options_of(out=out, set=set, refine=refine, precision=precision, threads=threads, device=device,
                                                      case=case, lenient=lenient, checkpoint_every=checkpoint_every)]
    status, problem = call("run", program, words)
    if status != 0:
        raise RunError(problem or f"pinball run ended with status {status}")
    summary: dict[str, Any] = json.loads((pathlib.Path(out) / "summary.json").read_text(encoding="utf-8"))
    return summary
