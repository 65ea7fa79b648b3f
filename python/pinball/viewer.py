"""The bodies of runs in a notebook: the viewer of the pages that `pinball` writes."""

from __future__ import annotations

import html
import os
import pathlib
import re
from dataclasses import dataclass, field

from ._core import InputError

BLOCK = re.compile(r'(<script type="application/json" id="(\w+)">)[^<]*(</script>)')
PICTURES = re.compile(r"<!-- pictures -->.*?<!-- /pictures -->", re.S)
# What the viewer does not read, as far as the scripts of a page ask for it when they begin; all others stay.
LEFT_OUT = {"history": '{"columns":[],"data":[]}', "curves": "[]", "summary": "null", "scene": "null", "checks": "null",
            "converged": "null", "other_histories": "null"}


@dataclass(frozen=True)
class RunView:
    """Bodies that can be turned, cut and played, in a notebook as the last value of a cell."""

    path: str  # of the page
    page: str = field(repr=False)  # HTML that needs nothing beside it
    height: int = 720  # [pixels] on the screen

    def _repr_html_(self) -> str:
        """An element that holds the whole page, so that it is there wherever the notebook goes."""
        source = self.page.replace("&", "&amp;").replace('"', "&quot;")
        return (f'<iframe title="{html.escape(self.path)}" srcdoc="{source}" sandbox="allow-scripts" '
                f'style="width:100%;height:{self.height}px;border:0"></iframe>')


def alone(page: str) -> str:
    """A page of a run, of `compare` or `converge` as one of its viewer, without numbers and pictures that this has no use for.
    A page of a program that had no such viewer stays as it is."""
    if "viewer_alone" not in page:
        return page
    page = PICTURES.sub("", page)
    page = BLOCK.sub(lambda block: block[1] + LEFT_OUT[block[2]] + block[3] if block[2] in LEFT_OUT else block[0], page)
    return page.replace("<html ", '<html class="viewer_alone" ', 1)


def view(run: str | os.PathLike[str], *, height: int = 720) -> RunView:
    """The bodies of a run for a notebook, to be turned, zoomed, cut, hidden, played and picked.

    run: the folder of a run (`run_recorded(scene, out)`, `pinball run --out`), or a page of `pinball compare --page` or
    `pinball converge --page`, with runs beside each other. What it shows stays with it when a later run takes the folder.
    height: of the widget [pixels]. Raises InputError where there is no page.
    """
    path = pathlib.Path(run)
    if path.is_dir():
        path /= "index.html"
    try:
        page = path.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        reason = error.strerror if isinstance(error, OSError) else "no text"
        raise InputError(f"view: {path} ({reason}): expected the folder of a run, or a page of compare or converge") from None
    if '<section id="viewer">' not in page:
        raise InputError(f"view: {path}: expected a page with bodies, of run, compare or converge")
    return RunView(os.fspath(path), alone(page), height)
