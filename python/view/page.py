"""Pictures in the page of a run, OUT/index.html: between two marks, as data, so that the page stays one file."""

import base64
import html
import io
import json
import os

BEGIN, END = "<!-- pictures -->", "<!-- /pictures -->"
LARGEST_FRAME = 100_000  # bytes


def image_tag(data, kind, text, more=""):
    return f'<img{more} alt="{html.escape(text)}" src="data:image/{kind};base64,{base64.b64encode(data).decode()}">'


def frame_data(frame):
    """A frame as WebP of at most LARGEST_FRAME bytes: of less quality where it must be."""
    for quality in (80, 60, 40, 20):
        stream = io.BytesIO()
        frame.save(stream, "webp", quality=quality)
        if stream.tell() <= LARGEST_FRAME:
            break
    return stream.getvalue()


def pictures(sheet, frames, times, unit, what):
    """The HTML of a picture (bytes of a PNG file) and of a film's frames (PIL images)."""
    parts = [f"<figure>{image_tag(sheet, 'png', what)}<figcaption>{html.escape(what)}</figcaption></figure>"]
    if len(frames) > 1:
        images = "".join(image_tag(frame_data(frame), "webp", f"{what} at {time:.6g} {unit}".strip(), ' loading="lazy"')
                         for frame, time in zip(frames, times))
        parts.append(f'<figure><div class="frames" data-times="{html.escape(json.dumps(times))}" '
                     f'data-unit="{html.escape(unit)}">{images}</div></figure>')
    return "\n".join(parts)


def put_into_page(folder, content):
    """Puts the content between the marks of OUT/index.html, in place of what is there. Returns the file's path, or None where
    there is no page with such marks."""
    path = os.path.join(folder, "index.html")
    try:
        with open(path, encoding="utf-8") as file:
            page = file.read()
    except FileNotFoundError:
        return None
    begin, end = page.find(BEGIN), page.find(END)
    if not 0 <= begin < end:
        return None
    with open(path + ".new", "w", encoding="utf-8") as file:
        file.write(page[: begin + len(BEGIN)] + "\n" + content + "\n" + page[end:])
    os.replace(path + ".new", path)
    return path
