"""The reference of the Python package, which Sphinx makes from the package itself (target docs).

Pages are written beside this file, so it is copied into the build folder: a page for each group of names, and in it all that
the package has of that group. Nothing of the package is named here but what leads: whatever else there is falls into a group
by what it is.
"""

import inspect
import pathlib

import pinball

project = "Pinball"
release = version = pinball.version
copyright = author = ""
extensions = ["sphinx.ext.autodoc"]
html_theme = "alabaster"
html_theme_options = {"description": "Explicit dynamics of solids in contact and impact", "page_width": "75em", "sidebar_width": "15em"}
html_sidebars = {"**": ["about.html", "navigation.html", "searchbox.html"]}
html_show_copyright = html_show_sphinx = html_show_sourcelink = False
html_static_path = ["static"]
smartquotes = False
autodoc_member_order = "bysource"
autodoc_typehints_format = "short"
python_use_unqualified_type_names = True
default_role = "code"

LEADING = {
    "Commands": ["run", "converge", "compare", "view", "Convergence", "Comparison", "RunView"],
    "Results": ["read_history", "read_fields", "History", "Fields"],
    "Simulations": ["read_scene", "Simulation", "run_recorded", "restart_recorded", "InputError", "RunError"],
    "Contact in a host": ["Contact", "ContactResult"],
    "Scenes": ["Scene", "Body", "Material"],
}
TEXTS = {
    "Commands": "What `pinball run`, `converge`, `compare` and the viewer of pages do, with their results as arrays.",
    "Results": "What a run has left in its folder, as arrays, and with pandas and xarray where these are installed.",
    "Simulations": "A scene that is run step by step, or to its end with all files.",
    "Contact in a host": "Contact alone, in the time loop of another program.",
    "Scenes": "The tables of a scene file as classes: fields have the names of their keys, of which data/scenes/README.md says more.",
    "Choices": "Where a scene takes one of several words, both the word and these are taken.",
    "Lists": "Lists of the classes of a scene: any sequence may be assigned to them.",
}


def is_choice(value):
    return hasattr(value, "__members__")


def is_list(value):
    return (inspect.getdoc(value) or "").startswith("A list of ")


def public_names():
    return [name for name, value in vars(pinball).items()
            if not name.startswith("_") and not inspect.ismodule(value) and callable(value)]


def groups():
    """Names by the title of their page."""
    led = {name for names in LEADING.values() for name in names}
    found = {title: list(names) for title, names in LEADING.items()} | {"Choices": [], "Lists": []}
    for name in sorted(set(public_names()) - led):
        value = getattr(pinball, name)
        found["Choices" if is_choice(value) else "Lists" if is_list(value) else "Scenes"].append(name)
    return found


def directive(name):
    value = getattr(pinball, name)
    if not inspect.isclass(value):
        return f".. autofunction:: pinball.{name}\n"
    if issubclass(value, Exception):
        return f".. autoexception:: pinball.{name}\n"
    members = "" if is_list(value) else "   :members:\n   :undoc-members:\n"
    return f".. autoclass:: pinball.{name}\n{members}"


def titled(title, mark="="):
    return f"{title}\n{mark * len(title)}\n\n"


def write_pages(folder):
    pages = []
    for title, names in groups().items():
        file = title.lower().replace(" ", "_")
        pages.append(file)
        text = titled(title) + TEXTS[title] + "\n\n" + "\n".join(directive(name) for name in names)
        (folder / f"{file}.rst").write_text(text)
    toctree = ".. toctree::\n   :maxdepth: 2\n\n" + "".join(f"   {page}\n" for page in pages)
    (folder / "index.rst").write_text(titled("Pinball in Python") + inspect.getdoc(pinball) + "\n\n" + toctree)


def type_of(name):
    """Of pinball.CLASS.FIELD, as the class says it; empty: it does not."""
    of, _, field = name.removeprefix("pinball.").partition(".")
    return getattr(getattr(pinball, of, None), "__annotations__", {}).get(field, "")


def process_text(app, what, name, value, options, lines):
    """Texts are no reStructuredText: a star is a star. Those of fields begin with their type."""
    lines[:] = [line.replace("*", r"\*") for line in lines]
    if what in ("attribute", "property") and isinstance(type_of(name), str) and type_of(name):
        lines[:] = [f"``{type_of(name)}``  {lines[0] if lines else ''}", *lines[1:]]


def setup(app):
    app.connect("autodoc-process-docstring", process_text)
    app.add_css_file("reference.css")


write_pages(pathlib.Path(__file__).resolve().parent)
