"""Runs of the program, and what they leave."""

import json
import os
import subprocess
import tempfile
from dataclasses import dataclass

from run_files import read_history
from report_parts.builds import NATIVE, ROOT, Failed, program
from run_files import read_pvd, read_vtu

from .variants import PLAIN


class Refused(Exception):
    """The program does not know a setting: what it said."""


class Broken(Exception):
    """A run that failed: what it said."""


@dataclass
class Run:
    folder: str
    summary: dict
    settings: tuple = ()

    @property
    def history(self):
        return read_history(os.path.join(self.folder, "history.csv"))[0]

    @property
    def seconds(self):
        """Of the solver: what the histories that a measurement asks for take to write is not part of a method."""
        return self.summary["wall_seconds"] - self.summary["phase_seconds"].get("output", 0.0)

    def fields(self):
        """(time, mesh) of each field output."""
        for time, path in read_pvd(os.path.join(self.folder, "fields.pvd")):
            yield time, read_vtu(path)


def command(verb, setup, variant, where):
    """The command line; writes the scene, where it is not one of data/scenes as it stands."""
    scene = setup.scene
    if setup.more or setup.replace:
        with open(os.path.join(ROOT, "data", "scenes", scene + ".toml"), encoding="utf-8") as file:
            text = file.read()
        for old, new in setup.replace:
            if old not in text:
                raise Failed(f"data/scenes/{scene}.toml does not hold what the study changes in it: {old!r}")
            text = text.replace(old, new)
        scene = os.path.join(where, scene + ".toml")
        with open(scene, "w", encoding="utf-8") as file:
            file.write(text + "\n" + setup.more)
    line = [program(NATIVE), verb, scene, "--threads", "1", "--precision", variant.precision, "--refine", str(setup.refine)]
    for setting in (*PLAIN, *setup.settings, *variant.settings):
        line += ["--set", setting]
    return line


def call(line):
    done = subprocess.run(line, capture_output=True, text=True, errors="replace")
    said = (done.stderr.strip().splitlines() or ["nothing"])[-1].removeprefix("pinball: ").removeprefix("error: ")
    said = said.partition("; the last good state")[0]  # which is removed with the folder of the run
    if done.returncode == 2:
        raise Refused(said)
    if done.returncode != 0:
        raise Broken(said)


def check(setup, variant):
    """Raises Refused if the program does not know a setting."""
    with tempfile.TemporaryDirectory() as where:
        call(command("info", setup, variant, where))


def run(setup, variant, measure):
    """(seconds, summary, what `measure` makes of the Run). Raises Refused or Broken."""
    with tempfile.TemporaryDirectory() as where:
        out = os.path.join(where, "out")
        call([*command("run", setup, variant, where), "--quiet", "--out", out])
        with open(os.path.join(out, "summary.json"), encoding="utf-8") as file:
            done = Run(out, json.load(file), tuple(setup.settings))
        return done.seconds, done.summary, measure(done)
