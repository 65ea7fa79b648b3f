"""Prints where below PREFIX packages of this interpreter belong, relative to it: install_directory.py PREFIX"""

import pathlib
import site
import sys
import sysconfig

prefix = pathlib.PurePath(sys.argv[1])
searched = [pathlib.PurePath(folder) for folder in site.getsitepackages()]
own = [folder.relative_to(prefix) for folder in searched if folder.is_relative_to(prefix / "lib")] if sys.argv[1] else []
usual = sysconfig.get_path("platlib", "posix_prefix", {"platbase": "", "base": ""}).lstrip("/")
print(own[0] if own else usual)
