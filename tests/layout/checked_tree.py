"""The tree that the checks of the layout look at."""

import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent


def chosen():
    """The tree that the command line names, or this one."""
    return pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ROOT).resolve()


def print_problems(problems, none=""):
    """The exit status: 1 if there are any."""
    print("\n".join(problems) or none)
    return 1 if problems else 0
