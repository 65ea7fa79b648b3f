"""Every link of every installed page leads to something that is installed:
    installed_links_test.py PREFIX"""

import pathlib
import re
import sys

LINK = re.compile(r"\]\(([^)#\s]+)")
CODE = re.compile(r"^```.*?^```$|`[^`\n]*`", re.M | re.S)


def main():
    prefix = pathlib.Path(sys.argv[1])
    pages = sorted(prefix.glob("share/doc/**/*.md"))
    names = {page.name for page in pages}
    assert {"README.md", "CHANGELOG.md", "embedding.md"} <= names, names
    links = [(page, link) for page in pages for link in LINK.findall(CODE.sub("", page.read_text()))
             if not re.match(r"[a-z]+:", link)]
    assert len(links) > 50, links
    dead = [f"{page.relative_to(prefix)}: {link}" for page, link in links if not (page.parent / link).exists()]
    print(f"{len(pages)} pages, {len(links)} links", *dead, sep="\n")
    return 1 if dead else 0


if __name__ == "__main__":
    sys.exit(main())
