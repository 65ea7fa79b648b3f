"""Builds the hosts that find an installed Pinball with find_package:
    build_with_find_package.py PREFIX archives|libraries FOLDER CMAKE CXX_COMPILER"""

import pathlib
import shutil
import subprocess
import sys

prefix, form, folder, cmake, compiler = sys.argv[1:]
hosts = pathlib.Path(__file__).resolve().parent / "installed_hosts"
shutil.rmtree(folder, ignore_errors=True)
subprocess.run([cmake, "-S", hosts, "-B", folder, "-G", "Ninja", f"-DCMAKE_CXX_COMPILER={compiler}",
                "-DCMAKE_BUILD_TYPE=Release", f"-DCMAKE_PREFIX_PATH={prefix}", f"-DFORM={form}"], check=True)
subprocess.run([cmake, "--build", folder], check=True)
