"""What the numbers say, in sentences: the conclusion, what was missed, and why."""

import html

from . import measuring
from .builds import BASE, NATIVE
from .pointers import two_digits


def text_list(items):
    return items[0] if len(items) == 1 else ", ".join(items[:-1]) + " and " + items[-1]


def of_comparison(n):
    """Ratios and shares on all meshes."""
    columns = n.value("comparison", "columns")
    each = [f"{html.escape(c['title'])} ({n.count('comparison', 'columns', i, 'elements')} elements): contact "
            f"{n.show('comparison', 'columns', i, 'ratio', 'contact')} times, the whole run "
            f"{n.show('comparison', 'columns', i, 'ratio', 'total')} times cheaper, "
            f"{n.percent('comparison', 'columns', i, 'methods', 'pinball', 'share')} of it contact (slideline: "
            f"{n.percent('comparison', 'columns', i, 'methods', 'slideline', 'share')})"
            for i, c in enumerate(columns)]
    return "Pinball against the slideline, one thread, vectorized: " + "; ".join(each) + "."


def of_vectorization(n):
    gain, kernels = n.value("vectorization", "aims"), n.value("vectorization", "kernels")
    element = next(i for i, k in enumerate(kernels) if k["key"] == "element_update")
    each = [f"{html.escape(k['title'])} {n.show('vectorization', 'kernels', i, 'vectorized', 'speed_up', form=two_digits)}"
            for i, k in enumerate(kernels) if k["contact"]]
    return (f"Vectors of {n.show('vectorization', 'ceilings', NATIVE, 'simd_width')} lanes against one lane, "
            f"{n.count('vectorization', 'listed')} pinballs with neighbours: "
            f"{n.show('vectorization', 'aims', 'met_by')} of {n.show('vectorization', 'aims', 'of')} contact kernels gain "
            f"{n.show('vectorization', 'aims', 'gain')} times or more ({text_list(each)}), all contact stages of a step together "
            f"{n.show('vectorization', 'aims', 'together', form=two_digits)}, the element update "
            f"{n.show('vectorization', 'kernels', element, 'vectorized', 'speed_up', form=two_digits)}.")


def of_builds(n):
    """Share of contact with vectorization off and on, and what vectorization gives to a whole run."""
    sentences = []
    for i, series in enumerate(n.value("stages")):
        def share(method, build):
            return n.percent("stages", i, "builds", build, method, "contact_share")

        def gain(method):
            return n.show("stages", i, "speed_up", method)

        sentences.append(
            f"On {series['scene']} with {n.count('stages', i, 'elements')} elements vectorization makes whole "
            f"runs {gain('slideline')} times (slideline) and {gain('pinball')} times (pinball) as fast; the share of contact goes from "
            f"{share('slideline', BASE)} (slideline) and {share('pinball', BASE)} (pinball) without to "
            f"{share('slideline', NATIVE)} and {share('pinball', NATIVE)} with it.")
    return " ".join(sentences)


def of_differences(n):
    return ("The known weakness of pinballs, smoothness: a block that slides over a flat floor goes up and down by "
            f"{n.show('sliding', 'methods', 'pinball', 'bumps', form=two_digits)} elements, with the slideline by "
            f"{n.show('sliding', 'methods', 'slideline', 'bumps', form=two_digits)}.")


def largest_contact_stage(method):
    return max(measuring.CONTACT, key=lambda stage: method["stages"][stage]["seconds"])


def why_share(n, i, column):
    pinball = column["methods"]["pinball"]
    stage = largest_contact_stage(pinball)
    at = ("comparison", "columns", i, "methods", "pinball")
    return (f"{n.count(*at, 'surface_elements')} of "
            f"{n.count('comparison', 'columns', i, 'elements')} elements are at a surface and take part in contact; "
            f"its largest stage is {stage.removeprefix('contact: ')} with {n.percent(*at, 'stages', stage, 'share')} of the run "
            f"({n.count(*at, 'searches')} searches in {n.count(*at, 'results', 'steps')} steps)")


def why_contact(n, i, column):
    pinball, slideline = column["methods"]["pinball"], column["methods"]["slideline"]
    slowest = largest_contact_stage(pinball)
    at = ("comparison", "columns", i, "methods")
    return (f"pinball's largest stage is {slowest.removeprefix('contact: ')}, "
            f"{n.show(*at, 'pinball', 'stages', slowest, 'seconds')} s, where the slideline needs "
            f"{n.show(*at, 'slideline', 'stages', slowest, 'seconds')} s; the slideline has the same broad phase "
            f"({n.count(*at, 'slideline', 'searches')} searches, pinball "
            f"{n.count(*at, 'pinball', 'searches')})")


def why_total(n, i, column):
    at = ("comparison", "columns", i, "methods", "slideline")
    return (f"contact is {n.percent(*at, 'share')} of the slideline's run, so that no cheaper contact could make the whole more "
            f"than {n.show('comparison', 'columns', i, 'total_ratio_limit')} times cheaper")


WHY = {"contact": why_contact, "total": why_total, "share": why_share}


def missed_in_comparison(n):
    """A sentence for each aim and column that missed it."""
    sentences = []
    for i, column in enumerate(n.value("comparison", "columns")):
        for aim, result in column["aims"].items():
            if result["met"]:
                continue
            at = ("comparison", "columns", i, "aims", aim, "value")
            value = n.percent(*at) if aim == "share" else n.show(*at)
            sentences.append(f"{html.escape(n.value('comparison', 'aims', aim, 'text'))}: {value} in "
                             f"{html.escape(column['title'])}, because {WHY[aim](n, i, column)}.")
    return sentences


def why_kernel(n, i):
    at = ("vectorization", "kernels", i, "builds", NATIVE)
    reasons = [f"it moves {n.percent(*at, 'of_bandwidth')} of what memory gives",
               f"{n.percent('vectorization', 'kernels', i, 'vectorized', 'facts', 'arithmetic')} of its instructions are "
               "floating-point arithmetic"]
    if n.value(*at, "packed_fraction") is not None:
        reasons.append(f"{n.percent(*at, 'packed_fraction')} of that is packed")
    if n.value(*at, "lanes_used") is not None:
        reasons.append(f"{n.percent(*at, 'lanes_used')} of the lanes hold something")
    return "; ".join(reasons)


def missed_by_kernels(n):
    sentences = []
    for i, kernel in enumerate(n.value("vectorization", "kernels")):
        if kernel["contact"] and kernel["vectorized"]["speed_up"] < n.value("vectorization", "aims", "gain"):
            gain = n.show("vectorization", "kernels", i, "vectorized", "speed_up", form=two_digits)
            sentences.append(f"{html.escape(kernel['title'])}: {gain} times as fast with vectors; {why_kernel(n, i)}.")
    return sentences


def summary_of_aims(n):
    missed = []
    for aim, result in n.value("comparison", "aims").items():
        if not result["met"]:
            missed.append(f"{html.escape(result['text'])} (reached in {n.show('comparison', 'aims', aim, 'met_in')} of "
                          f"{n.show('comparison', 'aims', aim, 'of')} columns)")
    if not n.value("vectorization", "aims", "met"):
        missed.append(f"every contact kernel at least {n.show('vectorization', 'aims', 'gain')} times as fast with vectors (reached "
                      f"by {n.show('vectorization', 'aims', 'met_by')} of {n.show('vectorization', 'aims', 'of')})")
    return "All aims are reached." if not missed else "Missed: " + "; ".join(missed) + "."


def paragraph(n):
    return " ".join([of_comparison(n), of_vectorization(n), of_builds(n), of_differences(n), summary_of_aims(n)])
