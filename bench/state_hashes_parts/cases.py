"""What is run: scenes, settings, and what has to happen in a run so that its bits say something."""

import itertools
import os
from dataclasses import dataclass

from report_parts.builds import ROOT

SCENES = "data/scenes"  # below ROOT
# Steps of the scenes that take long; all others run to their end. Erosion begins in step 46 of rod_plate and 100 of
# rod_oblique, the spheres touch by step 300.
STEPS = {"block": 8, "cantilever": 1000, "refined_layer": 256, "rod_oblique": 240, "rod_plate": 240, "sliding_block": 400,
         "sphere_floor": 480, "sphere_sphere": 320, "sphere_wall": 1000, "sphere_wall_full": 120, "spinning_block": 2000,
         "taylor_bar": 240, "taylor_johnson_cook": 240, "taylor_plate": 240,
         "taylor_tetrahedra": 240}
CONTACT_SCENES = ("contact_patch", "newtons_cradle", "rod_oblique", "rod_plate", "sliding_block", "sphere_floor", "sphere_sphere",
                  "taylor_plate", "two_bars", "two_blocks")
ERODING = ("rod_oblique", "rod_plate")
QUICK_CONTACT = ("contact_patch", "newtons_cradle", "rod_plate", "two_bars", "two_blocks")
WITH_LEVELS = ("refined_layer", "rod_oblique", "sphere_floor", "sphere_sphere", "sphere_wall", "sphere_wall_full", "taylor_bar",
               "taylor_plate")  # of the scenes that subcycling divides into more than one level
SELF = {"contact_patch": False, "newtons_cradle": False, "sphere_floor": False, "sphere_sphere": False, "taylor_plate": False,
        "two_bars": False}  # what scenes say of contact.self; the default is true
STRETCHED = "body.block.velocity_gradient=[[0.0, 0.0, 0.0], [0.0, 0.0, 0.0], [0.0, 0.0, 2000.0]]"
SHEARED = tuple(f"body.{body}.velocity_gradient=[[900.0, 500.0, 0.0], [-500.0, -900.0, 0.0], [0.0, 0.0, 0.0]]"
                for body in ("isotropic", "mixed", "kinematic", "curve", "total_rate", "plastic_rate"))
WEDGE = ('body.sphere.mesh={ type = "gmsh", file = "../../tests/data/wedge_41.msh" }', "body.sphere.position=[0.0, 0.0, 0.0]",
         "constraint.1.normal=[-0.5, 0.8660254037844386, 0.0]")


@dataclass(frozen=True)
class Case:
    name: str
    scene: str
    settings: tuple = ()
    needs: tuple = ()  # what has to happen in the run: keys of fingerprint.FEATURES
    status: int = 0  # that it has to end with
    refine: int = 1
    precision: str = ""
    restart: bool = False  # also in two parts, with a checkpoint between
    quick: bool = False

    def arguments(self):
        """Of `pinball run`, without threads and folder. The path of the scene is relative: messages have it."""
        given = [f"{SCENES}/{self.scene}.toml", "--refine", str(self.refine)]
        if self.precision:
            given += ["--precision", self.precision]
        for setting in self.settings:
            given += ["--set", setting]
        return given


def limited(scene, settings=()):
    """The settings after the limit of steps of the scene, where it has one."""
    return ((f"time.steps={STEPS[scene]}",) if scene in STEPS else ()) + tuple(settings)


def erosion(scene):
    return ("erosion",) if scene in ERODING else ()


def whole_scenes(names):
    """Each scene as it is; in the full form also to its end."""
    for name in names:
        touched = ("contact", "searches", *erosion(name)) if name in CONTACT_SCENES else ()
        needs = touched + (("subcycling",) if name == "refined_layer" else ())
        yield Case(f"{name}: as it is", name, limited(name), needs, restart=True, quick=True)
        if name in STEPS and name != "block":
            yield Case(f"{name}: to its end", name, (), needs)


def element_settings(names):
    """Hourglass control, bulk viscosity, precision, subcycling, work that is skipped: each alone."""
    for name in names:
        for control in ("none", "viscous", "stiffness", "assumed_strain"):
            yield Case(f"{name}: element.hourglass={control}", name, limited(name, [f"element.hourglass={control}"]),
                       quick=name in ("rod_plate", "spinning_block", "two_blocks"))
        for viscosity in ("false", "true"):
            yield Case(f"{name}: element.bulk_viscosity={viscosity}", name, limited(name, [f"element.bulk_viscosity={viscosity}"]),
                       quick=name in ("plate_impact", "two_blocks"))
        yield Case(f"{name}: float", name, limited(name), precision="float", restart=True, quick=name in CONTACT_SCENES)
        subcycling = name in WITH_LEVELS
        yield Case(f"{name}: time.subcycling={str(name != 'refined_layer').lower()}", name,
                   limited(name, [f"time.subcycling={str(name != 'refined_layer').lower()}"]),
                   ("subcycling",) if subcycling and name != "refined_layer" else (), restart=subcycling,
                   quick=name in ("rod_oblique", "sphere_wall", "taylor_plate"))
        yield Case(f"{name}: skip.resting=false", name, limited(name, ["skip.resting=false"]), quick=name == "rod_plate")
        if name in CONTACT_SCENES:
            yield Case(f"{name}: skip.contact_search=false", name, limited(name, ["skip.contact_search=false"]), ("contact",),
                       quick=name in QUICK_CONTACT)


def combinations():
    """(method, enforcement, gap, friction) that the program takes. A slideline has one gap, whatever the key says."""
    for enforcement, gap, friction in itertools.product(("penalty", "projection", "lagrange"), ("pinball", "face"), ("0.0", "0.3")):
        if (gap == "pinball" and friction == "0.0") or (gap == "face" and enforcement != "penalty"):
            yield "pinball", enforcement, gap, friction
    for enforcement, friction in itertools.product(("penalty", "projection", "lagrange"), ("0.0", "0.3")):
        if (enforcement, friction) != ("penalty", "0.3"):
            yield "slideline", enforcement, None, friction


def contact_case(scene, method, enforcement, gap, friction, more=(), **options):
    """more: further settings, which the name shows."""
    settings = [f"contact.method={method}", f"contact.enforcement={enforcement}"]
    words = [method, enforcement]
    if gap:
        settings.append(f"contact.gap={gap}")
        words.append(f"gap {gap}")
    if friction != "0.0":
        settings.append(f"contact.friction={friction}")
        words.append(f"friction {friction}")
    words += [setting.removesuffix("=true") for setting in more] + ([options["precision"]] if "precision" in options else [])
    needs = ("contact", "searches") + options.pop("needs", ())
    return Case(f"{scene}: {', '.join(words)}", scene, limited(scene, [*settings, *more]), needs, **options)


def contact_settings():
    for scene in CONTACT_SCENES:
        quick = scene in QUICK_CONTACT
        yield Case(f"{scene}: contact.method=none", scene, limited(scene, ["contact.method=none"]))
        for method, enforcement, gap, friction in combinations():
            chosen = (scene, method, enforcement, gap, friction)
            yield contact_case(*chosen, needs=erosion(scene), quick=quick)
            if friction == "0.0" and gap != ("pinball" if enforcement != "penalty" else "face"):
                other = f"contact.self={str(not SELF.get(scene, True)).lower()}"
                yield contact_case(*chosen, [other])
                yield contact_case(*chosen, precision="float", quick=scene in ("rod_plate", "two_blocks"))
                if scene in WITH_LEVELS:
                    yield contact_case(*chosen, ["time.subcycling=true"], needs=("subcycling", *erosion(scene)),
                                       quick=scene == "taylor_plate")
            elif scene in ("rod_plate", "sliding_block", "taylor_plate"):
                yield contact_case(*chosen, restart=True, more=["contact.skin=0.2"])


def further_contact():
    """Keys that the scenes leave alone, one at a time."""
    face, springs = ("pinball", "lagrange", "face"), ("pinball", "penalty", "pinball")
    for scene in ("rod_plate", "sphere_floor", "two_blocks"):
        quick = scene == "two_blocks"
        yield contact_case(scene, *face, "0.2", ["contact.static_friction=0.5"], quick=quick, restart=True)
        for key in ("contact.radius=current", "contact.radius_factor=0.9", "contact.skin=0.0", "contact.skin=2.0"):
            yield contact_case(scene, *face, "0.0", [key])
            yield contact_case(scene, *springs, "0.0", [key], quick=quick)
        for key in ("contact.beta=0.3", "contact.beta=4.0", "contact.damping=0.0"):
            yield contact_case(scene, *springs, "0.0", [key])
        for key in ("contact.beta=0.05", "contact.beta=0.5", "contact.damping=0.0"):  # its springs are stiffer
            yield contact_case(scene, "slideline", "penalty", None, "0.0", [key])


def further():
    """Meshes of more than a tile of elements, other boundaries, files of Gmsh, what the program ends early or refuses."""
    for name, steps in (("rod_plate", 200), ("taylor_plate", 120), ("two_blocks", 320)):
        fine = 4 if name == "two_blocks" else 2
        for chosen in (("pinball", "lagrange", "face", "0.0"), ("pinball", "penalty", "pinball", "0.0"),
                       ("pinball", "projection", "face", "0.3"), ("slideline", "lagrange", None, "0.0"),
                       ("slideline", "penalty", None, "0.0")):
            one = contact_case(name, *chosen, [f"time.steps={steps}"], refine=fine, restart=chosen[1] == "lagrange")
            yield Case(**{**vars(one), "name": f"{one.name}, refine {fine}"})
    yield Case("rod_plate: variant as_printed", "rod_plate", limited("rod_plate", ["variant=as_printed"]), ("contact", "erosion"))
    yield Case("rod_plate: subcycling, coarse plate", "rod_plate",
               limited("rod_plate", ["time.subcycling=true", "body.plate.mesh.elements=[16, 8, 1]"]),
               ("contact", "erosion", "subcycling"), restart=True, quick=True)
    yield Case("taylor_bar: friction of the wall", "taylor_bar", limited("taylor_bar", ["rigid_wall.0.friction=0.3"]), quick=True)
    yield Case("taylor_bar: from rest to a step a row", "taylor_bar", ("time.steps=60", "output.interval=step", "time.cfl=0.5"))
    yield Case("uniaxial_strain: stretched", "uniaxial_strain", (STRETCHED,), ("plasticity",), restart=True, quick=True)
    yield Case("uniaxial_strain: stretched, float", "uniaxial_strain", (STRETCHED,), ("plasticity",), precision="float", quick=True)
    for precision in ("double", "float"):
        yield Case(f"cyclic_shear: stretched, {precision}", "cyclic_shear", ("time.steps=400", *SHEARED), ("plasticity",),
                   precision=precision, restart=True, quick=True)
    yield Case("sphere_wall: wedge of a Gmsh file", "sphere_wall", limited("sphere_wall", WEDGE), restart=True, quick=True)
    yield Case("two_blocks: noise", "two_blocks", ("body.lower.velocity_noise=1.0", "body.upper.angular_velocity=[50.0, 20.0, 0.0]"),
               ("contact",), quick=True)
    yield Case("two_blocks: fields", "two_blocks", ("output.field_interval=4e-5",), ("contact",), restart=True, quick=True)
    for setting in ("guard.energy_error=1e-5", "guard.time_step_collapse=0.5"):
        yield Case(f"rod_plate: {setting}", "rod_plate", (setting,), status=1, quick=True)
    for settings in (("contact.enforcement=penalty", "contact.gap=face"), ("contact.enforcement=penalty", "contact.friction=0.1"),
                     ("contact.enforcement=penalty", "contact.static_friction=0.1"), ("contact.friktion=0.1",), ("time.steps=0",),
                     ("contact.enforcement=projection", "contact.static_friction=0.1"), ("time.cfl=1.3",), ("body.road.velocity=1",),
                     ("contact.enforcement=lagrange", "contact.friction=0.2", "contact.static_friction=0.1")):
        yield Case(f"rod_plate: {', '.join(settings)}", "rod_plate", settings, status=2, quick=True)


def all_cases(quick):
    """In the order in which they run. Those of the quick form are some of those of the full form."""
    names = sorted(f.removesuffix(".toml") for f in os.listdir(os.path.join(ROOT, SCENES)) if f.endswith(".toml"))
    cases = [*whole_scenes(names), *element_settings(names), *contact_settings(), *further_contact(), *further()]
    repeated = {case.name for case in cases if [c.name for c in cases].count(case.name) > 1}
    assert not repeated, f"two cases have one name: {repeated}"
    return [case for case in cases if case.quick or not quick]
