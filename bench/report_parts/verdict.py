"""Is a kernel vectorized? Three sources, their verdicts, and why they differ where they do."""

import re

PACKED_YES, PACKED_PARTLY = 0.6, 0.2  # packed part of the floating-point arithmetic
SPEED_YES, SPEED_PARTLY = 1.6, 1.2  # times over one lane
OF_BANDWIDTH = 0.5  # of the triad: from here on memory is what a kernel waits for
FEW_LANES = 0.5
OWN_PACKS = re.compile(r"kernels/simd\.hpp$|experimental/bits/simd[^/]*$|/[a-z0-9]*intrin\.h$")


def grade(value, yes, partly):
    if value is None:
        return "no"
    return "yes" if value >= yes else "partly" if value >= partly else "no"


def machine_verdict(counts):
    return grade(counts.packed_fraction, PACKED_YES, PACKED_PARTLY)


def speed_verdict(speed_up):
    return grade(speed_up, SPEED_YES, SPEED_PARTLY)


def from_packs(counts):
    """Part of the packed arithmetic that the lines of SIMD packs and intrinsics account for; None if unknown."""
    whole = sum(counts.packed_lines.values())
    if whole == 0:
        return None
    return sum(n for path, n in counts.packed_lines.items() if OWN_PACKS.search(path)) / whole


def explain(compiler, machine, speed, facts):
    """(verdict, agree, explanations, unexplained) from three verdicts.

    facts: packs (part of the packed arithmetic from explicit packs, or None), packed (part of the arithmetic, or None),
    bandwidth (part of the triad reached), lanes (part of the lanes that hold something, or None), arithmetic
    (floating-point part of the instructions), speed_up.
    """
    answers = {compiler, machine, speed}
    if len(answers) == 1:
        return compiler, True, [], False
    reasons, unexplained = [], False
    if compiler != machine:
        if machine != "no" and facts.get("packs") and facts["packs"] >= 0.5:
            reasons.append(f"{100 * facts['packs']:.0f} % of the packed arithmetic comes from explicit SIMD packs: the loop "
                           "over packs is not for the compiler's vectorizer, which is right to leave it alone")
        elif machine == "no" and compiler != "no":
            reasons.append("what the compiler vectorized holds little of the arithmetic: copies, fills and sums beside it")
        elif machine == "partly" and compiler == "no":
            reasons.append("packed instructions on the components of one vector or record, not across items")
        elif compiler == "partly" and machine == "yes":
            reasons.append("the arithmetic is packed; what the compiler refused are loops beside it")
        else:
            reasons.append("remark and machine code contradict each other")
            unexplained = True
    if speed != machine:
        order = {"no": 0, "partly": 1, "yes": 2}
        if order[speed] < order[machine]:
            if facts["bandwidth"] >= OF_BANDWIDTH:
                reasons.append(f"it moves {100 * facts['bandwidth']:.0f} % of what memory gives: lanes cannot make it faster")
            elif facts.get("lanes") is not None and facts["lanes"] < FEW_LANES:
                reasons.append(f"only {100 * facts['lanes']:.0f} % of its lanes hold something")
            elif facts["arithmetic"] < 0.25:
                reasons.append(f"only {100 * facts['arithmetic']:.0f} % of its instructions are floating-point arithmetic: "
                               "loads, shuffles, indices and branches take the time, and they do not get fewer")
            else:
                reasons.append("its vectors do not pay, and neither memory nor empty lanes explain it")
                unexplained = True
        elif machine == "partly":
            reasons.append(f"{100 * facts['packed']:.0f} % of the arithmetic in its functions is packed; each instruction is "
                           "counted once, however often it runs, and the loops that take the time are the packed ones")
        else:
            reasons.append(f"{facts['speed_up']:.2f} times as fast without packed arithmetic to show for it: integer and "
                           "memory instructions of the wider set, or noise")
            unexplained = facts["speed_up"] > SPEED_YES
    # What runs decides: the machine code, and whether it pays.
    verdict = "yes" if machine == "yes" and speed == "yes" else "no" if machine == "no" else "partly"
    return verdict, False, reasons, unexplained
