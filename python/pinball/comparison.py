"""The same scene with other values of its keys: `pinball compare` from Python."""

from __future__ import annotations

import os
from dataclasses import dataclass, field
from typing import Any, Mapping, Sequence

import numpy as np
import numpy.typing as npt

from .program import options_of, table_of


@dataclass(frozen=True)
class Comparison:
    """What v variants of a scene took and gave, the first one being what the others are compared with."""

    scene: str
    settings: list[dict[str, str]]  # of each variant: values by their keys
    seconds: npt.NDArray[Any]  # (v,) median of the repeats [s]
    contact_seconds: npt.NDArray[Any]  # (v,) of these [s]
    all_seconds: npt.NDArray[Any]  # (v, repeats) [s]
    summaries: list[dict[str, Any]] = field(repr=False)  # of each variant what summary.json holds, without times
    failures: list[str]  # of each variant; empty: it came to its end
    table: Mapping[str, Any] = field(repr=False)  # all that --json writes


def from_table(table: Mapping[str, Any]) -> Comparison:
    """What the program writes with --json, as arrays."""
    variants = table["variants"]
    return Comparison(
        scene=table["scene"], settings=[variant["settings"] for variant in variants],
        seconds=np.array([variant["seconds"]["total"]["median"] for variant in variants]),
        contact_seconds=np.array([variant["seconds"]["contact"]["median"] for variant in variants]),
        all_seconds=np.array([[repeat["wall_seconds"] for repeat in variant["repeats"]] for variant in variants]),
        summaries=[variant["summary"] for variant in variants],
        failures=[variant["failure"] or "" for variant in variants], table=table)


def text_of(value: object) -> str:
    """As a command line has it."""
    return str(value).lower() if isinstance(value, bool) else str(value)


def compare(scene: str | os.PathLike[str], vary: Mapping[str, Sequence[object]] | None = None, *, repeat: int | None = None,
            set: Sequence[str] = (), refine: int | None = None, precision: str | None = None, threads: int | None = None,
            page: str | os.PathLike[str] | None = None, program: str | os.PathLike[str] | None = None) -> Comparison:
    """Runs a scene with several values of some keys, taking turns, and returns what each took and gave.

    vary: values by keys, {"contact.beta": [0.5, 1]}; of several keys all combinations; None: both methods of contact. page: an HTML file,
    which `pinball.view` takes. The other arguments are the options of `pinball compare`, which does the work: the program has to be
    installed, or named. Raises InputError for bad input, RunError where nothing could be written.
    """
    varied = [f"{key}={','.join(text_of(value) for value in values)}" for key, values in (vary or {}).items()]
    return from_table(table_of("compare", program, [os.fspath(scene), *options_of(
        vary=varied, repeat=repeat, set=set, refine=refine, precision=precision, threads=threads, page=page)]))
