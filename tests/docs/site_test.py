"""Links and pictures of the site that doxygen has made lead somewhere.

    site_test.py FOLDER     of the site, with index.html
"""

import pathlib
import re
import sys

LINK = re.compile(r'(?:href|src)="([^"#?]+)')
OUTSIDE = re.compile(r"[a-z]+:")


def dead_links(folder):
    """(page, link) of those that lead nowhere."""
    return sorted({(page.name, link) for page in folder.glob("*.html") for link in LINK.findall(page.read_text())
                   if not OUTSIDE.match(link) and not (folder / link).exists()})


def main():
    folder = pathlib.Path(sys.argv[1])
    assert any("architecture" in page.name for page in folder.glob("*.html")), f"{folder} is no site of the documents"
    dead = dead_links(folder)
    for page, link in dead:
        print(f"{page}: {link}", file=sys.stderr)
    return 1 if dead else 0


if __name__ == "__main__":
    sys.exit(main())
