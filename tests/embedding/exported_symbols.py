"""The installed shared libraries export what their public headers declare with PINBALL_API, and nothing else:
    exported_symbols.py PREFIX"""

import pathlib
import re
import subprocess
import sys


def declared(headers):
    """Names of functions and classes that PINBALL_API stands before."""
    names = set()
    for header in headers:
        text = re.sub(r"/\*.*?\*/|//[^\n]*", "", header.read_text(), flags=re.S)
        text = re.sub(r"#\s*define[^\n]*", "", text)
        names |= set(re.findall(r"(?:class|struct) PINBALL_API (\w+)", text))
        names |= set(re.findall(r"(?<!class )(?<!struct )PINBALL_API [^;{(]*?(\w+)\(", text))
    return names


def exported(library):
    text = subprocess.run(["nm", "-DC", "--defined-only", library], check=True, capture_output=True, text=True).stdout
    return [line.split(maxsplit=2)[2] for line in text.splitlines()]


def is_of(symbol, names):
    """pinball_f, pinball::f(...), pinball::C::f(...), typeinfo for pinball::C, ..."""
    symbol = re.sub(r"\[abi:\w+\]", "", symbol)
    match = re.match(r"(?:(?:typeinfo|typeinfo name|vtable) for )?(?:pinball::)?~?(\w+)", symbol)
    return match is not None and match[1] in names


def main():
    prefix = pathlib.Path(sys.argv[1])
    names = declared(prefix.glob("include/pinball/**/*.h*"))
    bad = 0
    found = set()
    for library in sorted(prefix.glob("lib*/**/libpinball-*.so")):
        symbols = exported(library)
        print(f"{library.name}: {len(symbols)} symbols")
        found |= {name for name in names for symbol in symbols if is_of(symbol, {name})}
        for symbol in symbols:
            if not is_of(symbol, names):
                print(f"  is exported and nowhere declared: {symbol}")
                bad += 1
    missing = names - found
    print(f"{len(names)} names are declared")
    for name in sorted(missing):
        print(f"  is declared and not exported: {name}")
    return 1 if bad or missing or not names else 0


if __name__ == "__main__":
    sys.exit(main())
