"""Installs one form of the package, archives or libraries, with headers and program into an empty folder:
    install.py CMAKE BUILD_FOLDER FORM PREFIX"""

import shutil
import subprocess
import sys

cmake, build, form, prefix = sys.argv[1:]
shutil.rmtree(prefix, ignore_errors=True)
for component in ["development", "program", form]:
    subprocess.run([cmake, "--install", build, "--prefix", prefix, "--component", component], check=True,
                   stdout=subprocess.DEVNULL)
