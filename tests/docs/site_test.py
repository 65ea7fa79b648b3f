"""Links and pictures of the site that doxygen has made lead somewhere.

    site_test.py FOLDER     of the site, with index.html
"""

import pathlib
import re
import sys

LINK = re.compile(r'(?:href|src)="([^"#?]+)')
OUTSIDE = re.compile(r"[a-z]+:")


def main():
    folder = pathlib.Path(sys.argv[1])
    pages = sorted(folder.glob("*.html"))
    assert any("architecture" in page.name for page in pages), f"{folder} is no site of the documents"
    dead = {(page.name, link) for page in pages for link in LINK.findall(page.read_text())
            if not OUTSIDE.match(link) and not (folder / link).exists()}
    for page, link in sorted(dead):
        print(f"{page}: {link}", file=sys.stderr)
    return 1 if dead else 0


if __name__ == "__main__":
    sys.exit(main())
