"""`pinball view`: reads a run's folder, draws, and says what it wrote. Exit status: 0 done, 1 a file cannot be written,
2 bad input or a package that is missing."""

import os
import sys

PACKAGES = {"vtkmodules": "python3-vtk9", "matplotlib": "python3-matplotlib", "numpy": "python3-numpy", "PIL": "python3-pil"}
PANELS, MOST_FRAMES = 4, 200
WIDTH, FILM_WIDTH = 1600, 900
MOST_HEIGHT, FILM_MOST_HEIGHT = 1.1, 0.75  # of the width: a film has to fit into a window


def report(message, status):
    print(f"pinball: error: {message}", file=sys.stderr)
    return status


def entries_of(folder):
    from view.fields import BadInput, read_pvd

    path = os.path.join(folder, "fields.pvd")
    if not os.path.exists(path):
        raise BadInput(f"{folder}: no fields.pvd; run the scene with --set output.field_interval=T, about a thirtieth of its "
                       "time")
    entries = read_pvd(path)
    if not entries:
        raise BadInput(f"{path} lists no files")
    return entries


def check_picture(path):
    """Before minutes of drawing; the folder of the file is looked at when it is written."""
    from PIL import Image

    from view.fields import BadInput

    kinds = [kind for kind, name in Image.registered_extensions().items() if name in Image.SAVE]
    if os.path.splitext(path)[1].lower() not in kinds:
        raise BadInput(f"--out: expected a file that ends in .png, or another kind of picture, got {path}")


class Wanted:
    """Which files an invocation makes: all in OUT, or those that it names."""

    def __init__(self, options):
        folder = options.folder
        named = options.out or options.animation or options.history or options.page
        self.sheet = options.out or (None if named else os.path.join(folder, "fields.png"))
        self.into = options.page
        self.film = options.animation or (None if named else os.path.join(folder, "animation.webp"))
        self.page = not named
        self.state = None if named else os.path.join(folder, "fields_paraview.py")
        self.history = os.path.join(folder, "history.png") if options.history or not named else None


def draw_fields(options, wanted):
    from view.animation import check_animation, write_animation
    from view.display import VirtualDisplay
    from view.drawing import Drawing
    from view.page import Film, pictures, put_into_file, put_into_page
    from view.paraview import state_text
    from view.selection import choose_entries

    entries = entries_of(options.folder)
    if options.beside:
        entries = [entries_of(folder)[-1] for folder in [options.folder, *options.beside]]
    panels = [] if not (wanted.sheet or wanted.into) else entries if options.beside else choose_entries(entries, options.times, PANELS)
    frames = choose_entries(entries, None, MOST_FRAMES) if wanted.film else []
    if wanted.film:
        check_animation(wanted.film)
    drawing = Drawing(panels if options.beside else sorted({*panels, *frames}), options)
    sheet, film, on_paper = None, Film(), []
    with VirtualDisplay(), drawing:
        if panels:
            (sheet,) = drawing.sheets([panels], options.size or WIDTH, MOST_HEIGHT)
        if wanted.sheet:
            sheet.on_paper().save(wanted.sheet)
            yield wanted.sheet
        if wanted.film and (len(frames) > 1 or options.animation):
            width = options.size or FILM_WIDTH
            for frame in drawing.sheets([[entry] for entry in frames], width, FILM_MOST_HEIGHT, shadow_pixel=3):
                on_paper.append(frame.on_paper())
                if wanted.page:
                    film.add(frame)
    if on_paper:
        write_animation(wanted.film, on_paper, options.fps)
        yield wanted.film
    if wanted.state:
        with open(wanted.state, "w", encoding="utf-8") as file:
            file.write(state_text(drawing))
        yield wanted.state
    if wanted.into:
        put_into_file(wanted.into, pictures(sheet, film, drawing.colours.label or "bodies"))
        yield wanted.into
    if wanted.page and put_into_page(options.folder, pictures(sheet, film, drawing.colours.label or "bodies")):
        yield os.path.join(options.folder, "index.html")


def draw(options):
    """Makes what is wanted; yields the path of each file."""
    from view.fields import BadInput

    if not os.path.isdir(options.folder):
        raise BadInput(f"{options.folder}: no such folder")
    wanted = Wanted(options)
    has_history = os.path.exists(os.path.join(options.folder, "history.csv"))
    if options.beside and not (options.out or options.page):
        raise BadInput("--beside: expected --out FILE.png or --page FILE.html as well, where the picture goes")
    if options.out:
        check_picture(options.out)
    if wanted.sheet or wanted.film or wanted.into:
        yield from draw_fields(options, wanted)
    if options.history or (wanted.history and has_history):
        from view.history_plot import plot_history

        plot_history(options.folder, wanted.history)
        yield wanted.history


def main(arguments):
    from view.options import parser

    options = parser().parse_args(arguments)
    try:
        from view.fields import BadInput
    except ModuleNotFoundError as error:
        return missing(error)
    try:
        for path in draw(options):
            print(path, flush=True)
    except ModuleNotFoundError as error:
        return missing(error)
    except BadInput as error:
        return report(error, 2)
    except (OSError, ValueError) as error:  # a file cannot be written, or its ending is of no known format
        return report(error, 1)
    return 0


def missing(error):
    package = PACKAGES.get((error.name or "").partition(".")[0])
    if package is None:
        raise error
    return report(f"pictures need the Debian package {package}: apt-get install {package}", 2)
