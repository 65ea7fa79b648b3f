"""The package installs on a bare Debian 12, works there, and is removed without a trace.

    debian_test.py PACKAGE LEVELS FOLDER     FOLDER keeps the bare system; status 77: what this machine lacks for it
"""

import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import unittest

from bare_debian import BareDebian, NotHere

HOSTS = pathlib.Path(__file__).resolve().parent.parent / "embedding"
PACKAGE, LEVELS, FOLDER = (pathlib.Path(argument).resolve() for argument in sys.argv[1:])
NAME = "pinball-solver"
# How Debian hides what the processor has, so that the loader takes the first libraries.
NO_AVX = "glibc.cpu.hwcaps=-AVX512F,-AVX2"


def field(name):
    text = subprocess.run(["dpkg-deb", "--field", PACKAGE, name], check=True, capture_output=True, text=True)
    return text.stdout.strip()


class Package(unittest.TestCase):
    """In the order of the names."""

    @classmethod
    def setUpClass(cls):
        cls.system = BareDebian(FOLDER / "bookworm.tar", FOLDER / "root")
        cls.system.run("apt-get update")
        shutil.copy(PACKAGE, cls.system.root / "pinball.deb")
        # What it depends on comes first, so that what is new afterwards is the package's own.
        cls.system.run(f"apt-get satisfy -y --no-install-recommends '{field('Depends')}'")
        cls.before = cls.system.files()
        cls.system.run("dpkg -i /pinball.deb")

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(FOLDER / "root")

    def test_1_program_runs_a_scene(self):
        self.assertEqual(self.system.run("pinball --version"), f"pinball {field('Version')}\n")
        self.assertIn("what will run", self.system.run("pinball info rod_plate"))
        self.assertRegex(self.system.run("pinball info --device"), "mock: not there: .*PINBALL_MOCK=ON")  # it is for tests
        self.system.run("cd /tmp && pinball run two_blocks --quiet")
        summary = json.loads((self.system.root / "tmp/out/two_blocks/summary.json").read_text())
        self.assertGreater(summary["contact"]["pairs_max"], 0)

    def test_1_loader_takes_the_widest_libraries(self):
        flags = pathlib.Path("/proc/cpuinfo").read_text()
        level = LEVELS.read_text() if " avx2 " in flags and " fma " in flags else ""
        for tunables, folder in {"": f"glibc-hwcaps/{level}/" if level else "", NO_AVX: ""}.items():
            said = self.system.run(f"GLIBC_TUNABLES={tunables} LD_DEBUG=libs pinball info two_blocks")
            loaded = set(re.findall(r"calling init: \S*x86_64-linux-gnu/(\S*libpinball-\w+)", said))
            self.assertEqual(loaded, {f"{folder}libpinball-program"})

    def test_1_python_module_works(self):
        said = self.system.run("python3 -c 'import pinball; print(pinball.__version__, pinball.__file__)'")
        self.assertRegex(said, rf"^{re.escape(field('Version'))} /usr/lib/python3/dist-packages/pinball")
        self.system.run("cd /tmp && python3 -c 'import pinball; pinball.Simulation(pinball.read_scene(\"two_blocks\")).run()'")

    def test_1_manual_page_completions_and_documents_are_there(self):
        self.system.run("gzip -t /usr/share/man/man1/pinball.1.gz; test -s /usr/share/zsh/vendor-completions/_pinball")
        said = self.system.run("bash -c 'source /usr/share/bash-completion/completions/pinball; COMP_WORDS=(pinball ver); "
                               "COMP_CWORD=1; _pinball; echo $COMPREPLY'")
        self.assertEqual(said, "verify\n")
        self.system.run(f"test -s /usr/share/doc/{NAME}/copyright -a -s /usr/share/doc/{NAME}/docs/program.md")

    def test_2_is_removed_without_a_trace(self):
        self.assertTrue(self.system.files() - self.before)
        said = self.system.run(f"dpkg --purge {NAME}")
        self.assertNotIn("not empty", said)
        self.assertEqual(self.system.files() ^ self.before, set())
        self.assertNotIn("pinball", self.system.run("ldconfig -p"))

    def test_3_installs_again_for_hosts(self):
        self.system.install("gcc", "libc6-dev", "pkg-config", "/pinball.deb")
        shutil.copy(HOSTS / "two_bars.c", self.system.root / "tmp")
        self.system.run("cd /tmp && cc -O2 -Wall -Werror two_bars.c -o two_bars $(pkg-config --cflags --libs pinball-contact)")
        values = dict(line.split() for line in self.system.run("/tmp/two_bars").splitlines())
        self.assertAlmostEqual(float(values["momentum_final"]), float(values["momentum_initial"]), 9)

    @unittest.skipUnless("PINBALL_TEST_VIEW" in os.environ, "what draws takes 1.6 GB: with PINBALL_TEST_VIEW=1")
    def test_3_draws_with_what_it_recommends(self):
        self.system.run("apt-get install -y /pinball.deb")
        self.system.run("cd /tmp && pinball run two_blocks --quiet --set output.field_interval=1e-4 && pinball view out/two_blocks")
        self.assertGreater((self.system.root / "tmp/out/two_blocks/fields.png").stat().st_size, 10000)

    @unittest.skipUnless(shutil.which("lintian"), "there is no lintian")
    def test_4_lintian_finds_no_error(self):
        # Not for Debian's own archive: no bug there asks for it, and its maintainers have an address of their own.
        suppressed = "bogus-mail-host,initial-upload-closes-no-bugs,mail-address-loops-or-bounces"
        run = subprocess.run(["lintian", "--allow-root", "--fail-on", "error", "--suppress-tags", suppressed, PACKAGE],
                             capture_output=True, text=True)
        print(run.stdout)
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)


if __name__ == "__main__":
    sys.argv[1:] = []
    FOLDER.mkdir(parents=True, exist_ok=True)
    try:
        system = BareDebian(FOLDER / "bookworm.tar", FOLDER / "root")
        if not system.can("apt-get update -o APT::Update::Error-Mode=any"):
            raise NotHere("Debian's packages are out of reach, or this machine lets nobody change the root")
    except NotHere as why:
        print(f"Skipped: {why}")
        sys.exit(77)
    unittest.main(verbosity=2)
