"""Runs a host and the installed program on the same problem, and compares them:
    compare.py PROGRAM SCENE IMPACTS RESULTS_FOLDER HOST [--set KEY=VALUE]...

The host prints one line per quantity, name and value:
    momentum_initial, momentum_final    along x
    energy_initial, energy_final        of the host's bodies and of the contact, with what contact has dissipated
    contact_dissipated
    velocity_BODY                       mean velocity along x at the end
"""

import json
import pathlib
import subprocess
import sys


def quantities(text):
    lines = (line.split() for line in text.splitlines())
    return {name: float(value) for name, value in lines}


def main():
    program, scene, impacts, folder, host, *settings = sys.argv[1:]
    subprocess.run([program, "run", scene, "--out", folder, "--quiet", *settings], check=True)
    solver = json.loads(pathlib.Path(folder, "summary.json").read_text())
    run = subprocess.run([host], check=True, capture_output=True, text=True)
    host_has = quantities(run.stdout)
    print(run.stdout)

    momentum = host_has["momentum_initial"]
    energy = host_has["energy_initial"]
    speed = max(abs(value) for value in solver["momentum"]["initial"]) / solver["bodies"][0]["mass_initial"]
    # Each impact takes a few per cent of the energy. How much depends on where in a step it falls, and the solver's steps
    # are others than the host's, as its strain is (logarithmic).
    spread = 5e-3 * int(impacts)
    balance = max(2 * solver["energy"]["balance_error_max"], 1e-12)
    checks = [
        ("momentum at the beginning", momentum, solver["momentum"]["initial"][0], 1e-12 * abs(momentum)),
        ("momentum at the end", host_has["momentum_final"], momentum, 1e-12 * abs(momentum)),
        ("energy at the beginning", energy, solver["energy"]["initial_total"], 1e-12 * energy),
        # Springs of contact keep the solver's balance to 0.3 % here, impulses to round-off.
        ("energy at the end", host_has["energy_final"], energy, balance * energy),
        ("energy lost in contact", host_has["contact_dissipated"], solver["energy"]["contact"], spread * energy),
    ]
    checks += [(f"velocity of {body['name']}", host_has["velocity_" + body["name"]], body["velocity"][0], spread * speed)
               for body in solver["bodies"]]

    failed = 0
    for name, value, expected, tolerance in checks:
        good = abs(value - expected) <= tolerance
        failed += not good
        print(f"{'ok  ' if good else 'BAD '} {name}: {value:.12g}, expected {expected:.12g} +- {tolerance:.2g}")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
