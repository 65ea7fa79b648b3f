"""A tree of files that tests plant something into."""

import contextlib
import pathlib
import tempfile


@contextlib.contextmanager
def tree(files):
    """A folder with {path: text}, for a while."""
    with tempfile.TemporaryDirectory() as folder:
        for name, text in files.items():
            file = pathlib.Path(folder, name)
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text)
        yield folder


def found(check, files):
    """What a check of a tree finds in one with {path: text}."""
    with tree(files) as folder:
        return check(folder)
