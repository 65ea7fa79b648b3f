"""Frames to a film: GIF and WebP by Pillow, MP4 (H.264) and WebM (VP9) by ffmpeg where that is installed."""

import os
import shutil
import subprocess

import numpy as np

from view.fields import BadInput

CODECS = {
    ".mp4": ["-c:v", "libx264", "-crf", "20", "-pix_fmt", "yuv420p", "-movflags", "+faststart"],
    ".webm": ["-c:v", "libvpx-vp9", "-crf", "30", "-b:v", "0", "-pix_fmt", "yuv420p"],
}
BY_PILLOW = [".gif", ".webp"]


def check_animation(path):
    """Raises BadInput for a kind of file that cannot be written here."""
    kind = os.path.splitext(path)[1].lower()
    if kind not in CODECS and kind not in BY_PILLOW:
        raise BadInput(f"--animation: expected a file that ends in {', '.join([*BY_PILLOW, *CODECS])}, got {path}")
    if kind in CODECS and shutil.which("ffmpeg") is None:
        raise BadInput(f"--animation: {kind} needs ffmpeg: apt-get install ffmpeg; .webp and .gif do without")


def write_animation(path, frames, frames_per_second):
    """Writes the frames (PIL images of one size) as a film that begins anew at its end."""
    kind = os.path.splitext(path)[1].lower()
    if kind in CODECS:
        write_film(path, frames, frames_per_second, CODECS[kind])
        return
    # The last state stays for a second.
    durations = [round(1000.0 / frames_per_second)] * (len(frames) - 1) + [1000]
    if kind == ".gif":
        palette = frames[-1].quantize(255)
        frames = [frame.quantize(palette=palette, dither=0) for frame in frames]
        frames[0].save(path, save_all=True, append_images=frames[1:], duration=durations, loop=0, optimize=False)
    else:
        frames[0].save(path, save_all=True, append_images=frames[1:], duration=durations, loop=0, quality=80, method=2)


def write_film(path, frames, frames_per_second, codec):
    first = frames[0]
    command = ["ffmpeg", "-y", "-loglevel", "error", "-f", "rawvideo", "-pix_fmt", "rgb24", "-s",
               f"{first.width}x{first.height}", "-r", str(frames_per_second), "-i", "-", *codec, path]
    with subprocess.Popen(command, stdin=subprocess.PIPE, stderr=subprocess.PIPE) as process:
        try:
            for frame in frames:
                process.stdin.write(np.asarray(frame).tobytes())
            process.stdin.close()
        except BrokenPipeError:
            pass  # ffmpeg has said why
        said = process.stderr.read().decode(errors="replace").strip()
    if process.returncode != 0:
        raise OSError(f"ffmpeg cannot write {path}: {said}")
