"""The quick tests of a build: which faults each of them comes by, and whether it fails with one of them on."""

import json
import os
import re
import signal
import subprocess
import time
from dataclasses import dataclass, field

from report_parts.builds import Failed, run

MOST = 4096  # as in switch.hpp
SHORTEST_LIMIT = 20  # seconds


@dataclass
class Test:
    name: str
    command: list
    room: str
    environment: dict
    folder: str
    seconds: float = 0
    seen: frozenset = field(default_factory=frozenset)

    @property
    def program(self):
        return self.command[0]

    @property
    def case(self):
        """Its name in a program of googletest; none: the program is one test."""
        found = [a.removeprefix("--gtest_filter=") for a in self.command if a.startswith("--gtest_filter=")]
        return found[0] if found else ""


def found_in(build, pattern):
    """All tests but slow ones whose program is there."""
    listed = json.loads(run(["ctest", "--test-dir", build, "--show-only=json-v1"]))["tests"]
    tests = []
    for test in listed:
        properties = {p["name"]: p["value"] for p in test.get("properties", [])}
        labels = properties.get("LABELS", [])
        command = test.get("command", [])
        if not command or "slow" in labels or not re.search(pattern, test["name"]) or not os.access(command[0], os.X_OK):
            continue
        environment = dict(e.split("=", 1) for e in properties.get("ENVIRONMENT", []))
        tests.append(Test(test["name"], command, labels[0] if labels else "", environment,
                          properties.get("WORKING_DIRECTORY", build)))
    if not tests:
        raise Failed(f"{build} has no quick tests that \"{pattern}\" names")
    return tests


def ended(command, folder, environment, limit, scratch):
    """Status of a command; None: it was still running after the limit, and was stopped with all that it had started."""
    os.makedirs(scratch, exist_ok=True)
    process = subprocess.Popen(command, cwd=folder, env={**os.environ, **environment, "TMPDIR": scratch}, stdout=subprocess.DEVNULL,
                               stderr=subprocess.DEVNULL, stdin=subprocess.DEVNULL, start_new_session=True)
    try:
        return process.wait(limit)
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        process.wait()
        return None


def traced(test, scratch, limit):
    """Runs the test without a fault. Whether it passes; what it comes by and how long it takes is in it from then on."""
    path = os.path.join(scratch, "seen")
    os.makedirs(scratch, exist_ok=True)
    with open(path, "wb") as file:
        file.write(bytes(MOST))
    start = time.monotonic()
    status = ended(test.command, test.folder, {**test.environment, "PINBALL_FAULTS_SEEN": path}, limit, scratch)
    test.seconds = time.monotonic() - start
    with open(path, "rb") as file:
        test.seen = frozenset(n for n, byte in enumerate(file.read()) if byte)
    return status == 0


def batches(number, fault_room, tests):
    """The tests that come by a fault, by programs: the shortest first, those of its room before others that take a fifth as
    long. [(command, tests)]"""
    programs = {}
    for test in tests:
        if number in test.seen:
            programs.setdefault(test.program if test.case else test.name, []).append(test)
    groups = sorted(programs.values(), key=lambda some: sum(t.seconds for t in some) * (1 if some[0].room == fault_room else 5))
    for some in groups:
        command = some[0].command
        if some[0].case:
            command = [c for c in command if not c.startswith("--gtest_filter=")] + ["--gtest_filter=" + ":".join(t.case for t in some)]
        yield command, some


def caught_by(number, fault, tests, scratch, budget):
    """(name of the program whose tests fail, how; seconds used, whether all tests that come by it were run)"""
    used, whole = 0.0, True
    environment = {"PINBALL_FAULT": str(number), "GTEST_FAIL_FAST": "1"}
    for command, some in batches(number, fault.room, tests):
        expected = sum(t.seconds for t in some)
        if used > 0 and used + expected > budget:
            whole = False
            continue
        start = time.monotonic()
        status = ended(command, some[0].folder, {**some[0].environment, **environment}, SHORTEST_LIMIT + 10 * expected, scratch)
        used += time.monotonic() - start
        if status != 0:
            name = os.path.basename(some[0].program) if some[0].case else some[0].name
            how = "does not end" if status is None else f"signal {-status}" if status < 0 else "fails"
            return name, how, used, whole
    return None, "", used, whole
