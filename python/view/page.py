"""Pictures in the page of a run, OUT/index.html: between two marks, as data, so that the page stays one file."""

import base64
import html
import io
import json
import os
from concurrent.futures import ThreadPoolExecutor

from view.sheet import DARK, LIGHT

BEGIN, END = "<!-- pictures -->", "<!-- /pictures -->"
LARGEST_FRAME = 100_000  # bytes


def source(data, kind):
    return f"data:image/{kind};base64,{base64.b64encode(data).decode()}"


def image_tag(data, kind, text, more=""):
    return f'<img{more} alt="{html.escape(text)}" src="{source(data, kind)}">'


def png(image):
    stream = io.BytesIO()
    image.save(stream, "png", compress_level=4)
    return stream.getvalue()


def both(image_on, text, more=""):
    """The HTML of a picture with a variant for readers whose pages are dark. image_on: a PIL image for an Ink."""
    return (f'<picture><source media="(prefers-color-scheme: dark)" srcset="{source(png(image_on(DARK)), "png")}">'
            f'{image_tag(png(image_on(LIGHT)), "png", text, more)}</picture>')


def frame_data(frame):
    """A frame as WebP of at most LARGEST_FRAME bytes: of less quality where it must be."""
    for quality in (80, 60, 40, 20):
        stream = io.BytesIO()
        frame.save(stream, "webp", quality=quality, method=2)
        if stream.tell() <= LARGEST_FRAME:
            break
    return stream.getvalue()


class Film:
    """Frames for a page: drawings alone, each encoded beside the next one's drawing, which lie before one surround."""

    def __init__(self):
        self.encoders = ThreadPoolExecutor()
        self.frames, self.titles, self.sheet = [], [], None

    def add(self, sheet):
        """Takes a Sheet of one drawing."""
        self.sheet = sheet
        self.frames.append(self.encoders.submit(frame_data, sheet.drawings[0]))
        self.titles.append(sheet.titles[0])

    def html(self, what):
        layout = self.sheet.layout
        images = "".join(image_tag(frame.result(), "webp", f"{what} at {title}", ' loading="lazy"')
                         for frame, title in zip(self.frames, self.titles))
        place = f"--top:{100 * layout.title / layout.height:.4f}%;--width:{100 * layout.panel[0] / layout.width:.4f}%"
        surround = both(self.sheet.surround, "", ' class="surround"')
        return (f'<figure><div class="frames" data-titles="{html.escape(json.dumps(self.titles))}">'
                f'<div class="stage" style="{place}">{surround}{images}</div></div></figure>')


def pictures(sheet, film, what):
    """The HTML of a Sheet and of a Film, which may have no more than one frame."""
    picture = both(sheet.on, f"{what}; {', '.join(sheet.titles)}")
    parts = [f"<figure>{picture}<figcaption>{html.escape(what)}</figcaption></figure>"]
    if len(film.frames) > 1:
        parts.append(film.html(what))
    return "\n".join(parts)


def put_into_page(folder, content):
    """Puts the content between the marks of OUT/index.html, in place of what is there. Returns the file's path, or None where
    there is no page with such marks."""
    path = os.path.join(folder, "index.html")
    try:
        return put_into_file(path, content)
    except (FileNotFoundError, NoMarks):
        return None


class NoMarks(ValueError):
    """A page that has no place for pictures."""


def put_into_file(path, content):
    """The same with a page by its path, which is returned. Raises OSError, or NoMarks where there are no such marks."""
    with open(path, encoding="utf-8") as file:
        page = file.read()
    begin, end = page.find(BEGIN), page.find(END)
    if not 0 <= begin < end:
        raise NoMarks(f"{path}: expected a page with {BEGIN} and {END}, between which pictures go")
    with open(path + ".new", "w", encoding="utf-8") as file:
        file.write(page[: begin + len(BEGIN)] + "\n" + content + "\n" + page[end:])
    os.replace(path + ".new", path)
    return path
