"""Contact search and contact forces alone, and the search of a library on the same balls."""

import statistics
from dataclasses import dataclass

from report_parts import measuring
from report_parts.builds import NATIVE

from .samples import Ratio


@dataclass
class Cloud:
    name: str  # in bench_contact
    title: str
    per_side: int


SMALL = Cloud("close_packed", "close-packed", 30)
LARGE = Cloud("close_packed", "close-packed", 100)
LAYERS = Cloud("facing_layers", "facing layers", 707)
OURS, LIBRARY = "list_from_nothing", "list_by_nanoflann"
FORCES = {"forces": "contact forces", "forces_of_tenth": "contact forces, a tenth in contact"}


def what_of(benchmark, cloud, leaf=None):
    if benchmark == LIBRARY:
        return f"pairs by nanoflann, leaf {leaf}, {cloud}"
    return {OURS: "list from nothing", **FORCES}[benchmark] + f", {cloud}"


def read(report, log):
    """The results of bench_contact (JSON)."""
    titles = {cloud.name: cloud.title for cloud in (SMALL, LAYERS)}
    for result in report["benchmarks"]:
        (benchmark, cloud), arguments = measuring.parts_of(result["name"])
        seconds, unit = ((result["per_pair"], "ns per listed pair") if benchmark in FORCES else
                         (result["per_pinball"], "ns per pinball"))
        log.add(what_of(benchmark, titles[cloud], arguments.get("leaf")), round(result["pinballs"]), "double",
                arguments["threads"], seconds * 1e9, unit)


def measure(cloud, log, options=(), library=True):
    searches = f"{OURS}|{LIBRARY}" if library else OURS
    wanted = f"^({searches}|{'|'.join(FORCES)})/{cloud.name}/per_side:{cloud.per_side}/"
    read(measuring.benchmarks(NATIVE, "bench_contact", wanted, options), log)


def of_library(sample):
    return sample.what.startswith("pairs by nanoflann")


def slower_leaves(samples):
    """The series of the library with other leaves than the best: for each cloud and number of threads by the median."""
    groups = {}
    for sample in filter(of_library, samples):
        cloud = sample.what.split(", ", 2)[2]
        groups.setdefault((cloud, sample.size, sample.threads), {}).setdefault(sample.series, []).append(sample.value)
    slower = set()
    for leaves in groups.values():
        best = min(leaves, key=lambda series: statistics.median(leaves[series]))
        slower.update(series for series in leaves if series != best)
    return slower


def ratios(samples):
    """samples: without slower_leaves."""
    found = []
    for cloud in (SMALL.title, LAYERS.title):
        ours = what_of(OURS, cloud)
        found.append(Ratio(f"{ours}: two threads over one", {"what": ours, "threads": 2}, {"what": ours, "threads": 1},
                           inverse=True))
        found += [Ratio(f"time of nanoflann over ours, {cloud}", {"what": what}, {"what": ours})
                  for what in sorted({s.what for s in samples if of_library(s) and s.what.endswith(", " + cloud)})]
    return found
