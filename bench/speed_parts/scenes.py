"""Scenes as a user runs them."""

from dataclasses import dataclass, field

from report_parts import measuring
from report_parts.builds import NATIVE

from .samples import Ratio


@dataclass
class Case:
    title: str
    scene: str
    refine: int = 1
    settings: list = field(default_factory=list)
    steps: int = 0  # 0: to the end of the scene


# The bar of the scene with elements smaller by 4/7: 147 in the cross-section, 19,992 in all. Others work on the bar where
# it still flies freely; so does this, because what is compared is the rate.
FINE_BAR = [*(f"body.bar.mesh.{count}" for count in ("core=14", "ring=7", "layers=136")), "skip.resting=false"]
# Two blocks of 80 x 80 x 20 elements that meet face to face: 38,400 facets, as many as in a benchmark of NimbleSM. The gap
# is in proportion to the elements as in the scene; the faces meet after 20 steps.
FACETS = [*(f"body.{block}.mesh.{key}" for block in ("lower", "upper")
            for key in ("elements=[80, 80, 20]", "size=[0.1, 0.1, 0.025]")), "body.upper.position=[0.0, 0.0, 0.025325]"]
ONE_STEP = Case("refined_layer, one step for all", "refined_layer", settings=["time.subcycling=false"])
SUBCYCLED = Case("refined_layer, subcycling", "refined_layer")
CASES = [Case("rod_plate", "rod_plate"), Case("rod_plate, refine 2", "rod_plate", refine=2),
         Case("taylor_bar, 20,000 elements", "taylor_bar", settings=FINE_BAR),
         Case("two_blocks, 38,400 facets", "two_blocks", settings=FACETS, steps=150),
         ONE_STEP, SUBCYCLED]


def time_of(title):
    return f"{title}: time"


def speed_of(title):
    return f"{title}: speed"


def contact_time_of(title):
    return f"{title}: contact in a step"


def read(case, summary, log):
    """The summary of a run."""
    def add(what, value, unit):
        log.add(what, summary["elements"], summary["precision"], summary["threads"], value, unit)

    seconds = measuring.stage_seconds(summary)
    contact = sum(seconds[stage] for stage in measuring.CONTACT)
    if not case.steps:
        add(time_of(case.title), summary["wall_seconds"], "s")
    if contact > 0:
        add(f"{case.title}: share of contact", contact / sum(seconds.values()), "-")
        add(contact_time_of(case.title), contact / summary["steps"] * 1e3, "ms")
    add(speed_of(case.title), summary["element_steps_per_second"] * 1e-6, "million element steps/s")
    # That rate counts all elements, also those that are eroded or rest.
    add(f"{case.title}: part that is worked", summary["element_steps"] / (summary["elements"] * summary["steps"]), "-")


def measure(case, log):
    settings = [*case.settings, *([f"time.steps={case.steps}"] if case.steps else [])]
    for threads in (1, 2):
        read(case, measuring.run_scene(NATIVE, case.scene, threads, settings, case.refine), log)


def ratios(samples):
    return [*(Ratio(f"{case.title}: two threads over one", {"what": speed_of(case.title), "threads": 2},
                    {"what": speed_of(case.title), "threads": 1}) for case in CASES),
            Ratio("refined_layer: time of one step for all over subcycling", {"what": time_of(ONE_STEP.title)},
                  {"what": time_of(SUBCYCLED.title)})]
