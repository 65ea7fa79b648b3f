"""What tests of the viewer in pages have in common: a page with it, and the files that it shows."""

import base64
import io
import pathlib
import sys
import time

from browser import Pages, place

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "python"))

try:
    import numpy as np
    from PIL import Image
except ImportError:
    np = Image = None


def files_of(folder):
    """[(time, mesh)] of a run's field output."""
    from view.fields import read_pvd, read_vtu
    return [(at, read_vtu(path)) for at, path in read_pvd(str(place(folder) / "fields.pvd"))]


def surface_block(folder):
    text = (place(folder) / "index.html").read_text()
    return text.split('id="surface">')[1].split("</script>")[0]


class ViewerPages(Pages):
    def open_viewer(self, folder):
        self.open_page(f"{folder}/index.html")

    def open_page(self, path):
        """Of a page with a viewer, once its numbers are unpacked."""
        self.open(path)
        self.wait_for_viewer()

    def wait_for_viewer(self):
        for _ in range(200):
            if self.js("return viewer !== null"):
                return
            time.sleep(0.05)
        self.fail(f"no viewer: {self.texts('#viewer')}")

    def js(self, script, *arguments):
        return self.browser.execute_script(script, *arguments)

    def picture(self):
        """(height, width, 4) of what is drawn."""
        data = self.js("viewer.drawNow(); return viewer.canvas.toDataURL();")
        return np.asarray(Image.open(io.BytesIO(base64.b64decode(data.split(",")[1]))).convert("RGBA")).astype(float)

    def look(self, centre, height, azimuth, elevation, size):
        self.js("""const [centre, height, azimuth, elevation, [w, h]] = arguments;
            Object.assign(viewer.camera, {centre, height, azimuth, elevation});
            Object.assign(viewer.canvas.style, {width: `${w}px`, height: `${h}px`});""", centre, height, azimuth, elevation, list(size))

    def choose(self, field, frame):
        self.js("""viewer.chooseField(viewer.surface.fields.findIndex((f) => f.name === arguments[0]));
            viewer.showFrame(arguments[1]);""", field, frame)
