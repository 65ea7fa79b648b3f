"""What is measured on a GPU."""

import json
import pathlib
import re
import shlex
import shutil
import subprocess
import tempfile

SCENES = ("block", "spinning_block", "taylor_bar", "cantilever", "plastic_cantilever", "cyclic_shear", "sphere_wall")


def name_of_gpu():
    """Of the first one; None: there is none, or no driver of it."""
    if not shutil.which("nvidia-smi"):
        return None
    done = subprocess.run(["nvidia-smi", "--query-gpu=name,driver_version", "--format=csv,noheader"], capture_output=True,
                          text=True)
    return done.stdout.splitlines()[0].strip() if done.returncode == 0 and done.stdout.strip() else None


def parse_steps(text):
    """Of what bench_device prints: {copy, steps}; rates in 1/s, the copy's in GB/s."""
    copy = re.search(r"^copy: (\d+) GB/s", text, re.MULTILINE)
    row = re.compile(r"^(\w+) +(\w+) +(\d+) +(\d+) +([\d.]+) s +([\d.]+) G/s +(\d+) B", re.MULTILINE)
    if not copy or not row.search(text):
        raise ValueError(f"bench_device did not print what it measured:\n{text}")
    return {"copy": float(copy.group(1)),
            "steps": [{"precision": r[1], "what": r[2], "n": int(r[3]), "steps": int(r[4]), "seconds": float(r[5]),
                       "rate": 1e9 * float(r[6]), "bytes": int(r[7])} for r in row.finditer(text)]}


def steps(binary, sizes):
    return parse_steps(subprocess.run([str(binary), *sizes], capture_output=True, text=True, check=True).stdout)


def sanitizer(binary):
    """What compute-sanitizer says of a few steps of a small block, per tool; empty where it is not installed."""
    if not shutil.which("compute-sanitizer"):
        return {}
    said = {}
    for tool in ("memcheck", "racecheck", "initcheck"):
        done = subprocess.run(["compute-sanitizer", "--tool", tool, "--error-exitcode", "9", str(binary), "--steps", "3", "16"],
                              capture_output=True, text=True)
        said[tool] = "clean" if done.returncode == 0 else (done.stdout + done.stderr)[-2000:]
    return said


def figure_of_merit(command):
    """Zones per second that LULESH gives itself."""
    text = subprocess.run(shlex.split(command), capture_output=True, text=True, check=True).stdout
    found = re.search(r"FOM\s*=\s*([0-9.eE+-]+)", text)
    if not found:
        raise ValueError(f"{command}: expected a line FOM = NUMBER")
    return float(found.group(1))


def hashes(program):
    """Whether a scene has the processor's state after 200 steps on the GPU, twice, per scene and precision."""
    same = {}
    with tempfile.TemporaryDirectory() as folder:
        for scene in SCENES:
            for precision in ("double", "float"):
                states = []
                for device in ("none", "cuda", "cuda"):
                    out = pathlib.Path(folder) / "out"
                    subprocess.run([str(program), "run", scene, "--device", device, "--quiet", "--out", str(out), "--set",
                                    "time.steps=200", "--set", f"precision={precision}"], capture_output=True, text=True,
                                   check=True)
                    states.append(json.loads((out / "summary.json").read_text())["state_hash"])
                same[f"{scene}, {precision}"] = len(set(states)) == 1
    return same
