"""An X server for VTK of Debian, which draws into nothing else: a virtual one, for as long as the pictures take."""

import os
import shutil
import subprocess

from view.fields import BadInput


class VirtualDisplay:
    """with VirtualDisplay(): DISPLAY is that of an Xvfb of our own, so that pictures are the same on every machine. Where
    Xvfb is missing, the display that is there is taken. Raises BadInput where there is neither."""

    def __enter__(self):
        self.server = None
        program = shutil.which("Xvfb")
        if program is None:
            if not os.environ.get("DISPLAY"):
                raise BadInput("pictures need the Debian package xvfb, or a display: apt-get install xvfb")
            return self
        reader, writer = os.pipe()
        # -noreset: it would begin anew when a window is closed, and refuse one that is opened then.
        self.server = subprocess.Popen(
            [program, "-displayfd", str(writer), "-screen", "0", "64x64x24", "-nolisten", "tcp", "-noreset"],
            pass_fds=[writer], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, start_new_session=True)
        os.close(writer)
        with os.fdopen(reader) as answer:
            number = answer.readline().strip()
        if not number:
            self.server.wait()
            raise BadInput("Xvfb does not start; `Xvfb :99` says why")
        self.before = os.environ.get("DISPLAY")
        os.environ["DISPLAY"] = f":{number}"
        return self

    def __exit__(self, *_):
        if self.server is None:
            return
        self.server.terminate()
        self.server.wait()
        if self.before is None:
            del os.environ["DISPLAY"]
        else:
            os.environ["DISPLAY"] = self.before
