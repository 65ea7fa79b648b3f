"""How wrong a scene's numbers are: `pinball converge` from Python, with what it finds as arrays."""

from __future__ import annotations

import os
from dataclasses import dataclass, field
from typing import Any, Mapping, Sequence

import numpy as np
import numpy.typing as npt

from .program import options_of, table_of

NO_NUMBER = float("nan")


@dataclass(frozen=True)
class Convergence:
    """What a study of m meshes, q quantities and r runs says. What is not known is nan."""

    scene: str
    sentence: str
    factors: npt.NDArray[Any]  # (m,) of the numbers of elements in each direction, from coarse to fine
    elements: npt.NDArray[Any]  # (m,)
    seconds: npt.NDArray[Any]  # (m,) [s]
    names: list[str]  # of the quantities
    units: list[str]  # of the quantities
    values: npt.NDArray[Any]  # (q, m)
    scales: npt.NDArray[Any]  # (q,) what a quantity is measured by where it is small
    orders: npt.NDArray[Any]  # (q,) observed
    extrapolated: npt.NDArray[Any]  # (q,) to elements of no size
    bands: npt.NDArray[Any]  # (q, 2) in which the answer of such elements is expected
    verdicts: list[str]  # "converges", "oscillates", ...; empty: too few meshes
    moved_by: dict[str, npt.NDArray[Any]]  # (q,) by "mesh", "time step", "float", "chance", ...
    together: npt.NDArray[Any]  # (q,) what all sources together may move the value of their mesh by
    runs: list[str]  # "mesh 2", "mesh 1, float"
    run_seconds: npt.NDArray[Any]  # (r,) [s]
    run_bytes: npt.NDArray[Any]  # (r,)
    errors: npt.NDArray[Any]  # (q, r) against the extrapolated value, over it
    failures: list[str]  # of runs that did not come to their ends
    table: Mapping[str, Any] = field(repr=False)  # all that --json writes

    def value(self, name: str) -> npt.NDArray[Any]:
        """(m,) of one quantity. Raises KeyError."""
        if name not in self.names:
            raise KeyError(name)
        row: npt.NDArray[Any] = self.values[self.names.index(name)]
        return row


def numbers(values: Sequence[float | None]) -> npt.NDArray[Any]:
    return np.array([NO_NUMBER if value is None else value for value in values], dtype=float)


def factor(text: str) -> float:
    numerator, _, denominator = text.partition("/")
    return int(numerator) / int(denominator or 1)


def from_table(table: Mapping[str, Any]) -> Convergence:
    """What the program writes with --json, as arrays."""
    meshes, quantities, points = table["meshes"], table["quantities"], table["points"]
    sources = ["mesh", *(source["name"] for source in table["sources"])] if table["sources"] else []
    runs = [*meshes, *(run for source in table["sources"] for run in source["runs"])]
    return Convergence(
        scene=table["scene"], sentence=table["sentence"],
        factors=np.array([factor(mesh["factor"]) for mesh in meshes]),
        elements=numbers([mesh["elements"] for mesh in meshes]),
        seconds=numbers([mesh["wall_seconds"] for mesh in meshes]),
        names=[q["name"] for q in quantities], units=[q["unit"] for q in quantities],
        values=np.array([numbers(q["values"]) for q in quantities]).reshape(len(quantities), len(meshes)),
        scales=numbers([q["scale"] for q in quantities]),
        orders=numbers([q.get("observed_order") for q in quantities]),
        extrapolated=numbers([q.get("extrapolated") for q in quantities]),
        bands=np.array([numbers(q.get("band") or [None, None]) for q in quantities]).reshape(len(quantities), 2),
        verdicts=[q["verdict"] or "" for q in quantities],
        moved_by={name: numbers([q["moved_by"][name] for q in quantities]) for name in sources},
        together=numbers([q.get("together") for q in quantities]),
        runs=[point["settings"] for point in points],
        run_seconds=numbers([point["seconds"] for point in points]),
        run_bytes=numbers([point["bytes"] for point in points]),
        errors=np.array([numbers([point["errors"][i] for point in points])
                         for i in range(len(quantities))]).reshape(len(quantities), len(points)),
        failures=[run["failure"] for run in runs if run["failure"]], table=table)


def converge(scene: str | os.PathLike[str], of: Sequence[str] = (), *, meshes: str | None = None,
             error: str | float | None = None, budget: str | float | None = None, only: Sequence[str] = (),
             ensemble: int | None = None, refine: int | Sequence[str] | None = None, set: Sequence[str] = (),
             precision: str | None = None, threads: int | None = None, out: str | os.PathLike[str] | None = None,
             page: str | os.PathLike[str] | None = None, csv: str | os.PathLike[str] | None = None,
             program: str | os.PathLike[str] | None = None) -> Convergence:
    """Runs a scene on several meshes and says of each quantity how far it is from what finer ones would say.

    scene: a file, or the name of a scene that comes along. The other arguments are the options of `pinball converge`, which
    does the work: the program has to be installed, or named. Runs that are in `out` already are not made again; Ctrl-C
    leaves those that are done. Raises InputError for bad input, RunError where nothing could be written.
    """
    return from_table(table_of("converge", program, [os.fspath(scene), *options_of(
        of=of, meshes=meshes, error=error, budget=budget, only=only, ensemble=ensemble, refine=refine, set=set, precision=precision,
        threads=threads, out=out, page=page, csv=csv)]))
