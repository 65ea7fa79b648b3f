"""What a run leaves that must not change: all of it as one dictionary, and what two of them differ in."""

import csv
import json
import os
import re
import zlib

# Of summary.json: times, what depends on them, what a user called things, how much memory arrays take, and what exit
# status and message say, too.
NOT_KEPT = ("title", "status", "error", "started", "units", "version", "threads", "wall_seconds", "phase_seconds",
            "element_steps_per_second", "skipped_seconds", "bytes_per_element")
FEATURES = {  # what happened in a run
    "contact": lambda s: s["contact"]["pairs_max"] > 0,
    "contact_work": lambda s: s["energy"]["contact"] != 0,
    "searches": lambda s: s["contact"]["searches"] > 1,
    "searches_skipped": lambda s: s["contact"]["searches_skipped"] > 0,
    "erosion": lambda s: s["element_steps_eroded"] > 0 and any(body["eroded_elements"] for body in s["bodies"]),
    "plasticity": lambda s: any(body["max_plastic_strain"] for body in s["bodies"]),
    "hourglass": lambda s: s["energy"]["hourglass"] != 0,
    "bulk_viscosity": lambda s: s["energy"]["bulk_viscosity"] != 0,
    "resting": lambda s: s["element_steps_resting"] > 0,
    "subcycling": lambda s: s["element_steps_subcycled"] > 0,
    "external_work": lambda s: s["energy"]["external"] != 0,
    "wall": lambda s: any(wall["impulse"] for wall in s["rigid_walls"]),
}


def checksum(data):
    return f"{zlib.crc32(data):08x}"


def history(path):
    """{column: checksum of its numbers as they stand}."""
    with open(path, newline="", encoding="utf-8") as file:
        rows = list(csv.reader(line for line in file if not line.startswith("#")))
    return {name: checksum(",".join(column).encode()) for name, *column in zip(*rows)}


def fields(path):
    """{array: checksum} of a .vtu file: appended raw data, each with its length before it in 8 bytes."""
    with open(path, "rb") as file:
        content = file.read()
    mark = content.index(b'<AppendedData encoding="raw">')
    start = content.index(b"_", mark) + 1
    found = {}
    for tag in re.findall(r"<DataArray [^>]*>", content[:mark].decode()):
        attributes = dict(re.findall(r'(\w+)="([^"]*)"', tag))
        begin = start + int(attributes["offset"])
        end = begin + 8 + int.from_bytes(content[begin:begin + 8], "little")
        found[attributes.get("Name", "points")] = checksum(content[begin:end])
    return found


def message(text):
    """The first line, without the place of the last good state: how old that is depends on the time a copy takes."""
    return (text.splitlines() or [""])[0].partition("; the last good state")[0]


def of_run(status, said, folder):
    """said: what the run wrote to stderr."""
    found = {"status": status, "message": message(said) if status else ""}
    summary = os.path.join(folder, "summary.json")
    if not os.path.exists(summary):
        return found
    with open(summary, encoding="utf-8") as file:
        result = json.load(file)
    happened = {name: test(result) for name, test in FEATURES.items()}
    found.update((key, value) for key, value in result.items() if key not in NOT_KEPT)
    found["skipped"].pop("bytes_not_stored", None)
    found["history"] = history(os.path.join(folder, "history.csv"))
    # last_good.vtu is not among them: its time depends on the clock.
    written = sorted(name for name in os.listdir(folder) if re.fullmatch(r"fields_\d+\.vtu", name))
    found["fields"] = {name: fields(os.path.join(folder, name)) for name in written}
    found["happened"] = happened
    return found


def differences(recorded, found, path=""):
    """[(place, recorded, found)]; what only `found` has is none, what it lacks is one."""
    if isinstance(recorded, dict) and isinstance(found, dict):
        parts = [(f"{path}.{key}" if path else key, value, found[key] if key in found else "nothing") for key, value in recorded.items()]
    elif isinstance(recorded, list) and isinstance(found, list) and len(recorded) == len(found):
        parts = [(f"{path}[{k}]", *pair) for k, pair in enumerate(zip(recorded, found))]
    else:
        return [] if recorded == found and type(recorded) is type(found) else [(path, recorded, found)]
    return [difference for place, one, other in parts for difference in differences(one, other, place)]
