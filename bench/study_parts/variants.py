"""The table of variants: a setting that is new becomes a curve of every study of its group by one line here.

Each is a change of the plain algorithm of the report (PLAIN). What the program does not know it refuses; the page names
it as not in this program.
"""

from .study import Variant

PLAIN = ("contact.enforcement=penalty", "contact.gap=pinball", "element.hourglass=stiffness")
PLAIN_TITLE = "plain"  # penalty between balls, beta = 1, hourglass stiffness, 0.9 of the stable step, double precision

VARIANTS = (
    Variant("plain", PLAIN_TITLE),
    Variant("contact", "balls to the face, penalty", ("contact.radius_factor=0.8059959770082347",)),
    Variant("contact", "balls, penalty, no damping", ("contact.damping=0",)),
    Variant("contact", "balls, projection", ("contact.enforcement=projection",)),
    Variant("contact", "balls, lagrange", ("contact.enforcement=lagrange",)),
    Variant("contact", "faces, penalty", ("contact.gap=face",)),
    Variant("contact", "faces, projection", ("contact.enforcement=projection", "contact.gap=face")),
    Variant("contact", "faces, lagrange", ("contact.enforcement=lagrange", "contact.gap=face")),
    Variant("contact", "faces, lagrange, assumed strain",
            ("contact.enforcement=lagrange", "contact.gap=face", "element.hourglass=assumed_strain")),
    Variant("contact", "slideline, penalty", ("contact.method=slideline",)),
    Variant("contact", "slideline, projection", ("contact.method=slideline", "contact.enforcement=projection")),
    Variant("contact", "slideline, lagrange", ("contact.method=slideline", "contact.enforcement=lagrange")),
    Variant("hourglass", "hourglass stiffness 0.01", ("element.hourglass_coefficient=0.01",)),
    Variant("hourglass", "hourglass stiffness 0.25", ("element.hourglass_coefficient=0.25",)),
    Variant("hourglass", "hourglass viscous", ("element.hourglass=viscous", "element.hourglass_coefficient=0.025")),
    Variant("hourglass", "assumed strain", ("element.hourglass=assumed_strain",)),
    Variant("viscosity off", "no bulk viscosity", ("element.bulk_viscosity=false",)),
    Variant("viscosity on", "bulk viscosity", ("element.bulk_viscosity=true",)),
    Variant("step", "half the time step", step=0.45),
    Variant("step", "a quarter of the time step", step=0.225),
    Variant("subcycling", "subcycling", ("time.subcycling=true",)),
    Variant("precision", "float", precision="float"),
)


def of(study):
    """The variants of a study, the plain one first."""
    return [v for v in VARIANTS if v.group in ("plain", *study.groups) and v.title not in study.without]
