"""A bare Debian 12 in a folder, in which commands run as in a machine of its own."""

import os
import pathlib
import shutil
import subprocess

MIRROR = os.environ.get("PINBALL_DEBIAN_MIRROR", "http://deb.debian.org/debian")


class NotHere(Exception):
    """What this machine lacks for it."""


def make(archive):
    """Leaves a bare system in an archive, unless that is there."""
    if archive.exists():
        return
    if os.geteuid() != 0:
        raise NotHere("only root can make a root file system")
    debootstrap = shutil.which("debootstrap", path="/usr/sbin:/usr/bin")
    if debootstrap is None:
        raise NotHere("there is no debootstrap")
    root = archive.with_suffix(".root")
    shutil.rmtree(root, ignore_errors=True)
    run = subprocess.run([debootstrap, "--variant=minbase", "bookworm", root, MIRROR], capture_output=True, text=True)
    if run.returncode != 0:
        raise NotHere(f"debootstrap has failed with {MIRROR}: {run.stdout[-500:]}{run.stderr[-500:]}")
    subprocess.run(["tar", "-C", root, "--numeric-owner", "-cf", archive, "."], check=True)
    shutil.rmtree(root)


class BareDebian:
    def __init__(self, archive, root):
        make(archive)
        self.root = pathlib.Path(root)
        shutil.rmtree(self.root, ignore_errors=True)
        self.root.mkdir(parents=True)
        subprocess.run(["tar", "-C", self.root, "--numeric-owner", "-xf", archive], check=True)
        for file in ["resolv.conf", "hosts"]:
            if pathlib.Path("/etc", file).exists():
                shutil.copy(f"/etc/{file}", self.root / "etc" / file)
        # Updates of security have the fixed versions alone that other packages may ask for.
        (self.root / "etc/apt/sources.list").write_text(f"deb {MIRROR} bookworm main\ndeb {MIRROR} bookworm-updates main\n")

    def run(self, command, check=True, **environment):
        """A command of the shell, by root; what it prints."""
        inside = ["unshare", "--mount", "sh", "-ec", 'for folder in proc dev; do mount --rbind "/$folder" "$0/$folder"; done; '
                  'exec chroot "$0" sh -ec "$1"', self.root, command]
        variables = {"PATH": "/usr/sbin:/usr/bin:/sbin:/bin", "LC_ALL": "C.UTF-8", "HOME": "/root",
                     "DEBIAN_FRONTEND": "noninteractive", "GOMP_SPINCOUNT": "1000", **environment}
        variables.update({name: value for name, value in os.environ.items() if name.lower().endswith("_proxy")})
        run = subprocess.run(inside, capture_output=True, text=True, env=variables, stdin=subprocess.DEVNULL)
        if check and run.returncode != 0:
            raise AssertionError(f"{command}\nended with {run.returncode}:\n{run.stdout[-3000:]}{run.stderr[-3000:]}")
        return run.stdout + run.stderr

    def can(self, command):
        try:
            self.run(command)
        except AssertionError as why:
            print(why)
            return False
        return True

    def install(self, *packages):
        return self.run("apt-get install -y --no-install-recommends " + " ".join(packages))

    def files(self):
        """Everything there is, but what package managers note of their own work."""
        notes = ("./var/lib/dpkg", "./var/lib/apt", "./var/cache", "./var/log", "./etc/ld.so.cache", "./tmp", "./proc", "./dev",
                 "./sys", "./run")
        listed = self.run("find . -xdev")
        return {name for name in listed.splitlines() if not name.startswith(notes)}
