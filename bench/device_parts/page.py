"""The tables of bench/device: what is counted and what is measured apart."""


def rows(head, body):
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    return "\n".join(lines + ["| " + " | ".join(map(str, row)) + " |" for row in body])


def bound(result, what, precision):
    """Element steps per second that the bandwidth allows."""
    count = next(row["bytes"] for row in result["bytes"] if (row["what"], row["precision"]) == (what, precision))
    return 1e9 * result["bandwidth"] / count


def counted(result):
    registers = {(k["what"], k["precision"]): k for k in result["kernels"]}
    body = []
    for row in result["bytes"]:
        kernel = registers.get((row["what"], row["precision"]), {"registers": "?", "spilled": "?"})
        body.append((row["what"], row["precision"], kernel["registers"], kernel["spilled"], row["bytes"],
                     f"{bound(result, row['what'], row['precision']) / 1e9:.2f}"))
    steps = {(row["what"], row["precision"]) for row in result["bytes"]}
    body += [(*name, kernel["registers"], kernel["spilled"], "-", "-") for name, kernel in registers.items() if name not in steps]
    return rows(("kernel", "precision", "registers", "spilled [B]", "bytes of an element and step",
                 f"bound at {result['bandwidth']:.0f} GB/s [G element steps/s]"), body)


def measured(result):
    if not result["gpu"]:
        return "Nothing: there is no GPU here."
    text = f"{result['gpu']}; a copy in the same run: {result['copy']:.0f} GB/s.\n\n"
    text += rows(("step", "precision", "elements", "steps", "G element steps/s", "of the bound"),
                 [(row["what"], row["precision"], f"{row['n']}^3", row["steps"], f"{row['rate'] / 1e9:.3f}",
                   f"{100 * row['rate'] / bound(result, row['what'], row['precision']):.0f} %") for row in result["steps"]])
    for tool, said in result["sanitizer"].items():
        text += f"\n\ncompute-sanitizer, {tool}: {said}"
    if "lulesh" in result:
        best = max(row["rate"] for row in result["steps"] if row["precision"] == "double" and row["what"] == "viscous")
        text += f"\n\nLULESH: {result['lulesh']:.3e} zones/s; the step with viscous hourglass forces, double precision: " \
                f"{best / result['lulesh']:.1f} times as many elements."
    for name, same in result.get("hashes", {}).items():
        text += f"\n- {name}: {'the bits of the processor, twice' if same else 'OTHER BITS'}"
    return text


def text(result):
    return f"# Steps on a device\n\n## Counted\n\n{counted(result)}\n\n## Measured\n\n{measured(result)}\n"
