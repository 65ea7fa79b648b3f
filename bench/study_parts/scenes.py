"""The studies, in the order of the page."""

from . import cantilever, contact_patch, newtons_cradle, plate_impact, sliding_block, spheres, taylor_bar, two_bars

STUDIES = (two_bars.STUDY, contact_patch.STUDY, spheres.FLOOR, spheres.MIRROR, spheres.WALL, sliding_block.STUDY,
           sliding_block.WITH_FRICTION, newtons_cradle.STUDY, plate_impact.STUDY, taylor_bar.STUDY, cantilever.STUDY)
ENSEMBLE = "rod_oblique"
NAMES = [*(study.name for study in STUDIES), ENSEMBLE]
