"""What can be known without a GPU: what the compiler makes of the kernels, and what a step has to move."""

import re
import subprocess


def build(nvcc, root, binary, architecture):
    """Builds bench/bench_device.cu; what the assembler says of its kernels."""
    done = subprocess.run([nvcc, "-std=c++20", "-O3", f"-arch={architecture}", "-Xptxas", "-v", f"-I{root}",
                           str(root / "bench" / "bench_device.cu"), "-o", str(binary)],
                          capture_output=True, text=True, check=True)
    return subprocess.run(["c++filt"], input=done.stderr + done.stdout, capture_output=True, text=True, check=True).stdout


def kernel_name(function):
    """(what, precision) of a kernel of the element step or of the nodes; None: of something else. That of rare cases has
    the elements of a sweep that another has left."""
    precision = "float" if re.search(r"<float|float>", function) else "double"
    elements = re.search(r"UpdatesElements<\w+, pinball::ElementFeatures\{(\w+), \w+, \w+, \(pinball::HourglassKind\)(\d), "
                         r"\(pinball::YieldLaw\)\d, (\w+), false\}", function)
    if elements:
        plastic, hourglass, rare_cases = elements.groups()
        what = "elastic" if plastic == "false" else "viscous" if hourglass == "1" else "everything"
        return what + (", rare cases" if rare_cases == "true" else ""), precision
    if "SumsAndIntegrates<" in function:
        return "sums of corners and integration", precision
    return None


def kernels(said):
    """Of what `ptxas -v` says: {what, precision, registers, spilled} of each kernel [bytes of stores and loads]."""
    found = []
    for part in said.split("Compiling entry function '")[1:]:
        name = kernel_name(part.split("\n")[0])
        registers = re.search(r"Used (\d+) registers", part)
        spills = re.search(r"(\d+) bytes spill stores, (\d+) bytes spill loads", part)
        if name and registers and spills:
            found.append({"what": name[0], "precision": name[1], "registers": int(registers.group(1)),
                          "spilled": sum(map(int, spills.groups()))})
    return sorted(found, key=lambda kernel: (kernel["what"], kernel["precision"]))


def bytes_of_steps(binary):
    """Of an element and step, each array once: [{what, precision, bytes}]."""
    done = subprocess.run([str(binary), "--bytes"], capture_output=True, text=True, check=True)
    rows = [line.split() for line in done.stdout.splitlines()]
    return [{"precision": precision, "what": what, "bytes": int(count)} for precision, what, count in rows]
