"""The recipes for Spack and conda, and the presets, ask for options that CMakeLists.txt has and for all that it looks for. The
managers themselves are not needed: the recipe for Spack runs with a few lines in place of it, and what conda would run once
it has installed is run with an installed tree.

    recipes_test.py PREFIX FOLDER       FOLDER: to run in
"""

import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import types
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
CMAKE = "\n".join(path.read_text() for path in [ROOT / "CMakeLists.txt", *ROOT.glob("*/CMakeLists.txt"), *ROOT.glob("cmake/*.cmake")])
OPTIONS = set(re.findall(r"option\((\w+)", CMAKE)) | set(re.findall(r"set\((\w+)[^)]*?\sCACHE\s", CMAKE))
# Libraries that the solver is built with, in capitals and small letters as CMake has them.
SOUGHT = set(re.findall(r"find_package\((\w+) REQUIRED\)", (ROOT / "CMakeLists.txt").read_text())) - {"PkgConfig", "OpenMP"}
LIBRARIES = SOUGHT | set(re.findall(r"pkg_check_modules\((\w+) REQUIRED", CMAKE))
LEAST_CMAKE = re.search(r"cmake_minimum_required\(VERSION ([\d.]+)\)", CMAKE)[1]
PREFIX, FOLDER = None, None


def plain(name):
    return re.sub(r"[^a-z0-9]", "", name.lower())


def unknown(names):
    return {name for name in names if not name.startswith(("CMAKE_", "Python_"))} - OPTIONS


class Spec:
    """What a recipe asks of the package that is built."""

    def __init__(self, variants):
        self.variants = variants
        self.command = types.SimpleNamespace(path="/usr/bin/python3")

    def __contains__(self, text):
        return self.variants[text[1:]] == (text[0] == "+")

    def __getitem__(self, name):
        return self


def spack_recipe():
    """The class of the recipe, and its directives: name, arguments, keywords."""
    directives = []

    class CMakePackage:
        def define(self, name, value):
            return f"-D{name}={value}"

        def define_from_variant(self, name, variant):
            return self.define(name, self.spec.variants[variant])

    module = types.ModuleType("spack.package")
    module.CMakePackage = CMakePackage
    for name in ["license", "version", "variant", "depends_on", "extends", "conflicts"]:
        setattr(module, name, lambda *arguments, name=name, **words: directives.append((name, arguments, words)))
    sys.modules.update({"spack": types.ModuleType("spack"), "spack.package": module})
    names = {}
    exec(compile((ROOT / "packaging/spack/package.py").read_text(), "package.py", "exec"), names)
    return names["Pinball"], directives


class Spack(unittest.TestCase):
    recipe, directives = spack_recipe()

    def test_gives_options_that_there_are(self):
        variants = {arguments[0]: words["default"] for name, arguments, words in self.directives if name == "variant"}
        for python in [False, True]:
            package = self.recipe()
            package.spec = Spec({**variants, "python": python})
            given = {re.match(r"-D(\w+)=", argument)[1] for argument in package.cmake_args()}
            self.assertEqual(unknown(given), set())
            self.assertGreaterEqual(given, {"PINBALL_NATIVE", "PINBALL_PYTHON"})  # else they go by the machine

    def test_asks_variants_that_there_are(self):
        variants = {arguments[0] for name, arguments, _ in self.directives if name == "variant"}
        asked = {words["when"].lstrip("+~") for _, _, words in self.directives if "when" in words}
        self.assertLessEqual(asked, variants)

    def test_depends_on_what_cmake_looks_for(self):
        depends = [arguments[0] for name, arguments, _ in self.directives if name == "depends_on"]
        self.assertLessEqual({plain(name) for name in LIBRARIES}, {plain(name.split("@")[0]) for name in depends})
        self.assertIn(f"cmake@{LEAST_CMAKE}:", depends)


def conda_recipe():
    import jinja2
    import yaml
    text = jinja2.Template((ROOT / "packaging/conda/meta.yaml").read_text()).render(
        compiler=lambda language: f"{language}_compiler", pin_subpackage=lambda name, **_: name)
    return yaml.safe_load(text)


class Conda(unittest.TestCase):
    recipe = conda_recipe()

    def test_gives_options_that_there_are(self):
        given = set(re.findall(r"-D(\w+)=", self.recipe["build"]["script"]))
        self.assertEqual(unknown(given), set())
        self.assertGreaterEqual(given, {"PINBALL_NATIVE", "PINBALL_PYTHON", "CMAKE_INSTALL_PREFIX"})

    def test_depends_on_what_cmake_looks_for(self):
        requirements = {kind: {line.split()[0]: line for line in lines} for kind, lines in self.recipe["requirements"].items()}
        self.assertLessEqual({plain(name) for name in LIBRARIES}, {plain(name) for name in requirements["host"]})
        self.assertEqual(requirements["build"]["cmake"], f"cmake >={LEAST_CMAKE}")

    def test_its_tests_pass_with_what_is_installed(self):
        shutil.rmtree(FOLDER, ignore_errors=True)
        FOLDER.mkdir(parents=True)
        environment = {**os.environ, "PREFIX": str(PREFIX), "PATH": f"{PREFIX}/bin:/usr/bin:/bin", "GOMP_SPINCOUNT": "1000",
                       "PKG_CONFIG_PATH": str(next(PREFIX.glob("**/pinball-contact.pc")).parent)}
        for command in self.recipe["test"]["commands"]:
            with self.subTest(command):
                subprocess.run(["sh", "-ec", command], check=True, cwd=FOLDER, env=environment, stdout=subprocess.DEVNULL)


class Presets(unittest.TestCase):
    def test_set_options_that_there_are(self):
        presets = json.loads((ROOT / "CMakePresets.json").read_text())
        self.assertEqual({name for preset in presets["configurePresets"] for name in unknown(preset.get("cacheVariables", {}))}, set())


if __name__ == "__main__":
    PREFIX, FOLDER = (pathlib.Path(sys.argv.pop(1)).resolve() for _ in range(2))
    unittest.main()
