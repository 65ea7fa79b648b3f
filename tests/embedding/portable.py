"""A host that takes Pinball in by add_subdirectory and gets shared libraries for several levels of x86-64: builds it, and
looks which of them the dynamic loader takes, on this processor and where features are hidden from it:
    portable.py FOLDER CMAKE CXX_COMPILER SOURCE"""

import os
import pathlib
import re
import subprocess
import sys

LOADER = "/lib64/ld-linux-x86-64.so.2"
# What the library says that it was compiled for, and what to hide so that the loader goes no higher.
LEVELS = [("x86-64-v4", "AVX-512 8", ""), ("x86-64-v3", "AVX2 4", "-AVX512F"), ("", "SSE2 2", "-AVX512F,-AVX2")]


def supported():
    """Levels of x86-64 that the processor has, as the loader sees it."""
    text = subprocess.run([LOADER, "--help"], check=True, capture_output=True, text=True).stdout
    return re.findall(r"(x86-64-v\d) \(supported, searched\)", text) + [""]


def loaded(program, hidden):
    """What the program prints, and the library that the loader says it has taken."""
    environment = {**os.environ, "GLIBC_TUNABLES": f"glibc.cpu.hwcaps={hidden}", "LD_DEBUG": "libs"}
    run = subprocess.run([program], check=True, capture_output=True, text=True, env=environment)
    libraries = re.findall(r"calling init: (\S*/libpinball-contact\.so\S*)", run.stderr)
    assert len(libraries) == 1, run.stderr
    return run.stdout.strip(), libraries[0]


def quantities(program, hidden):
    """What a host has computed: name and value per line."""
    environment = {**os.environ, "GLIBC_TUNABLES": f"glibc.cpu.hwcaps={hidden}"}
    text = subprocess.run([program], check=True, capture_output=True, text=True, env=environment).stdout
    return {name: float(value) for name, value in (line.split() for line in text.splitlines())}


def exported(library):
    text = subprocess.run(["nm", "-D", "--defined-only", library], check=True, capture_output=True, text=True).stdout
    return sorted(line.split()[-1] for line in text.splitlines())


def main():
    folder, cmake, compiler, source = sys.argv[1:]
    host = pathlib.Path(__file__).resolve().parent / "subdirectory_host"
    subprocess.run([cmake, "-S", host, "-B", folder, "-G", "Ninja", f"-DCMAKE_CXX_COMPILER={compiler}",
                    "-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_CXX_FLAGS_RELEASE=-O1",  # compiled three times, and soon done
                    f"-DPINBALL_SOURCE={source}"], check=True)
    subprocess.run([cmake, "--build", folder], check=True)

    base = pathlib.Path(folder, "pinball", "lib")
    known = supported()
    results = []
    for level, says, hidden in LEVELS:
        if level not in known:
            print(f"{level}: this processor has it not")
            continue
        text, library = loaded(pathlib.Path(folder, "instruction_set"), hidden)
        print(f"{level or 'every processor'}: {text}, {library}")
        assert text == says, f"expected {says}"
        assert pathlib.Path(library).parent == (base / "glibc-hwcaps" / level if level else base)
        results.append(quantities(pathlib.Path(folder, "two_bars"), hidden))
    assert results

    # What the libraries compute differs by round-off.
    for other in results[1:]:
        for name, value in results[0].items():
            assert abs(value - other[name]) <= 1e-9, f"{name}: {value} and {other[name]}"

    # The interface is the same whichever of them is loaded.
    interface = exported(base / "libpinball-contact.so")
    assert "pinball_version" in interface, interface
    for level, _, _ in LEVELS[:2]:
        assert exported(base / "glibc-hwcaps" / level / "libpinball-contact.so") == interface


if __name__ == "__main__":
    main()
