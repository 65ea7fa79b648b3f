"""The command line of `pinball view`."""

import argparse
import math

from view.camera import VIEWS

DESCRIPTION = """Pictures of a run: the bodies at several times side by side (fields.png), an animation (animation.webp), what
happened over time (history.png). The first two are also put into the page of the run (index.html)."""
EXAMPLES = """examples:
  pinball view out/rod_plate
  pinball view out/rod_plate --view side --times 0 25e-6 54e-6 --field von_mises --out three.png
  pinball view out/rod_plate --hide rod --cut "y>0.5" --animation plate.mp4"""


def positive(text):
    value = float(text)
    if not (math.isfinite(value) and value > 0.0):
        raise argparse.ArgumentTypeError(f"expected a number above 0, got {text}")
    return value


def pixels(text):
    value = int(text)
    if not 100 <= value <= 8000:
        raise argparse.ArgumentTypeError(f"expected 100 to 8000 pixels, got {text}")
    return value


def value_range(text):
    low, high = (float(part) for part in text.split(","))
    if not (math.isfinite(low) and math.isfinite(high) and low < high):
        raise argparse.ArgumentTypeError(f"expected LOW,HIGH with LOW < HIGH, got {text}")
    return low, high


def parser():
    p = argparse.ArgumentParser(prog="pinball view", description=DESCRIPTION, epilog=EXAMPLES,
                                formatter_class=argparse.RawDescriptionHelpFormatter)
    p.add_argument("folder", metavar="OUT", help="the output folder of a run")
    p.add_argument("--field", help="plastic_strain, von_mises, pressure, displacement, velocity, contact_force, pinball_radius, "
                   "corner_share, body, or a component (stress_xx, velocity_z); default: plastic strain where there is any, else von Mises stress")
    p.add_argument("--times", nargs="+", type=float, metavar="T", help="the outputs nearest to these times, in the scene's "
                   "unit; default: four, evenly spaced")
    p.add_argument("--view", default="iso", help=f"{', '.join(VIEWS)}, or AZIMUTH,ELEVATION in degrees from the side "
                   "(--view=-30,20)")
    p.add_argument("--only", action="append", metavar="BODY", help="draw this body only; may be repeated")
    p.add_argument("--hide", action="append", metavar="BODY", help="leave this body out; may be repeated")
    p.add_argument("--cut", metavar="PLANE", help='x=0.5: what lies at smaller x is cut away; "x<0.5": at larger x')
    p.add_argument("--mirror", default="", metavar="AXES", help="y completes a body cut at y = 0; xy a quarter")
    p.add_argument("--no-edges", dest="edges", action="store_false", help="no mesh lines; they are left out, too, where "
                   "elements are a few pixels")
    p.add_argument("--range", type=value_range, metavar="LOW,HIGH", help="of the colours; default: of all times drawn")
    p.add_argument("--colours", metavar="NAME", help="a colour map of Matplotlib; default: from grey to dark, or RdBu_r where "
                   "values have a sign")
    p.add_argument("--size", type=pixels, metavar="PIXELS", help="width, default 1600, of an animation 900")
    p.add_argument("--out", metavar="FILE.png", help="this picture alone, in place of all in OUT")
    p.add_argument("--beside", action="append", metavar="OUT", help="the last output of OUT and of this run, side by side with "
                   "one camera and one scale of colours, named by their folders; may be repeated; needs --out or --page")
    p.add_argument("--page", metavar="FILE.html", help="puts the picture between the marks of this page, in place of all in OUT")
    p.add_argument("--animation", metavar="FILE", help="this animation (.webp, .gif; .mp4, .webm with ffmpeg), in place of "
                   "animation.webp in OUT")
    p.add_argument("--fps", type=positive, default=10.0, metavar="N", help="frames a second, default 10")
    p.add_argument("--history", action="store_true", help="history.png alone")
    return p
