# Made by python/stubs from the module itself: see there before you change it.
from collections.abc import Callable, Iterable, MutableSequence, Sequence
from typing import Any, Generic, Optional, TypeVar, Union, overload

import numpy as np
import numpy.typing as npt

Shown = TypeVar("Shown")
Given = TypeVar("Given")

class Field(Generic[Shown, Given]):
    """Of a class of data: it shows one type, and takes more: a text for a choice, any sequence for a list."""
    @overload
    def __get__(self, instance: None, owner: type[Any]) -> property: ...
    @overload
    def __get__(self, instance: object, owner: type[Any]) -> Shown: ...
    def __set__(self, instance: Any, value: Given) -> None: ...

version: str

class InputError(ValueError): ...

class RunError(RuntimeError): ...

class Precision:
    double: Precision
    float: Precision
    mixed: Precision
    @property
    def name(self) -> str: ...
    @property
    def value(self) -> int: ...
    def __init__(self, value: Union[int, str]) -> None: ...
    def __int__(self) -> int: ...

class Device:
    none: Device
    mock: Device
    cuda: Device
    hip: Device
    @property
    def name(self) -> str: ...
    @property
    def value(self) -> int: ...
    def __init__(self, value: Union[int, str]) -> None: ...
    def __int__(self) -> int: ...

class HourglassControl:
    none: HourglassControl
    viscous: HourglassControl
    stiffness: HourglassControl
    assumed_strain: HourglassControl
    @property
    def name(self) -> str: ...
    @property
    def value(self) -> int: ...
    def __init__(self, value: Union[int, str]) -> None: ...
    def __int__(self) -> int: ...

class ContactMethod:
    none: ContactMethod
    pinball: ContactMethod
    slideline: ContactMethod
    not_set: ContactMethod
    @property
    def name(self) -> str: ...
    @property
    def value(self) -> int: ...
    def __init__(self, value: Union[int, str]) -> None: ...
    def __int__(self) -> int: ...

class Enforcement:
    penalty: Enforcement
    projection: Enforcement
    lagrange: Enforcement
    @property
    def name(self) -> str: ...
    @property
    def value(self) -> int: ...
    def __init__(self, value: Union[int, str]) -> None: ...
    def __int__(self) -> int: ...

class ContactGap:
    pinball: ContactGap
    face: ContactGap
    not_set: ContactGap
    @property
    def name(self) -> str: ...
    @property
    def value(self) -> int: ...
    def __init__(self, value: Union[int, str]) -> None: ...
    def __int__(self) -> int: ...

class ContactRadius:
    initial: ContactRadius
    current: ContactRadius
    @property
    def name(self) -> str: ...
    @property
    def value(self) -> int: ...
    def __init__(self, value: Union[int, str]) -> None: ...
    def __int__(self) -> int: ...

class ContactSearch:
    tree: ContactSearch
    hash: ContactSearch
    automatic: ContactSearch
    @property
    def name(self) -> str: ...
    @property
    def value(self) -> int: ...
    def __init__(self, value: Union[int, str]) -> None: ...
    def __int__(self) -> int: ...

class ContactOverlap:
    keep: ContactOverlap
    adjust: ContactOverlap
    @property
    def name(self) -> str: ...
    @property
    def value(self) -> int: ...
    def __init__(self, value: Union[int, str]) -> None: ...
    def __int__(self) -> int: ...

class ElementShape:
    hexahedra: ElementShape
    tetrahedra: ElementShape
    @property
    def name(self) -> str: ...
    @property
    def value(self) -> int: ...
    def __init__(self, value: Union[int, str]) -> None: ...
    def __int__(self) -> int: ...

class NegativeVolume:
    stop: NegativeVolume
    erode: NegativeVolume
    @property
    def name(self) -> str: ...
    @property
    def value(self) -> int: ...
    def __init__(self, value: Union[int, str]) -> None: ...
    def __int__(self) -> int: ...

class InsideOut:
    warn: InsideOut
    erode: InsideOut
    stop: InsideOut
    @property
    def name(self) -> str: ...
    @property
    def value(self) -> int: ...
    def __init__(self, value: Union[int, str]) -> None: ...
    def __int__(self) -> int: ...

class StrainRate:
    total: StrainRate
    deviatoric: StrainRate
    plastic: StrainRate
    @property
    def name(self) -> str: ...
    @property
    def value(self) -> int: ...
    def __init__(self, value: Union[int, str]) -> None: ...
    def __int__(self) -> int: ...

class RateInterpolation:
    linear: RateInterpolation
    logarithmic: RateInterpolation
    @property
    def name(self) -> str: ...
    @property
    def value(self) -> int: ...
    def __init__(self, value: Union[int, str]) -> None: ...
    def __int__(self) -> int: ...

class EquationOfStateForm:
    mie_grueneisen: EquationOfStateForm
    polynomial: EquationOfStateForm
    tabulated: EquationOfStateForm
    @property
    def name(self) -> str: ...
    @property
    def value(self) -> int: ...
    def __init__(self, value: Union[int, str]) -> None: ...
    def __int__(self) -> int: ...

class VolumeMeasure:
    logarithmic: VolumeMeasure
    density: VolumeMeasure
    @property
    def name(self) -> str: ...
    @property
    def value(self) -> int: ...
    def __init__(self, value: Union[int, str]) -> None: ...
    def __int__(self) -> int: ...

class MassScaling:
    small: MassScaling
    all: MassScaling
    @property
    def name(self) -> str: ...
    @property
    def value(self) -> int: ...
    def __init__(self, value: Union[int, str]) -> None: ...
    def __int__(self) -> int: ...

class TimeSettings:
    """[time] of a scene"""
    def __init__(self, *, end: float = ..., cfl: float = ..., steps: int = ..., smallest_step: float = ..., mass_scaling: Union[MassScaling, str] = ..., subcycling: bool = ...) -> None: ...
    end: float
    """when the run stops; less than 2^52 steps, unless steps ends the run [time]"""
    cfl: float
    """fraction of the stable time step [-]"""
    steps: int
    """stop after so many steps, at least 1; -1: no limit; negative: -1 (no limit)"""
    smallest_step: float
    """elements that would need a smaller step get so much mass that this one is stable (below); 0: none [time]"""
    mass_scaling: Field[MassScaling, Union[MassScaling, str]]
    """whose mass smallest_step changes: "small": of elements that need it; "all": mass is added to all, and taken from all, so that the step is that of each"""
    subcycling: bool
    """elements that are stable with a larger step make one, 2, 4 ... 64 times the smallest (below)"""

class ElementSettings:
    """[element] of a scene"""
    def __init__(self, *, hourglass: Union[HourglassControl, str] = ..., hourglass_coefficient: float = ..., bulk_viscosity: bool = ..., linear_viscosity: float = ..., quadratic_viscosity: float = ..., negative_volume: Optional[Union[NegativeVolume, str]] = ..., inside_out: Union[InsideOut, str] = ..., folding_resistance: float = ...) -> None: ...
    hourglass: Field[HourglassControl, Union[HourglassControl, str]]
    """hourglass control; "assumed_strain" resists as the material does in bending and twisting"""
    hourglass_coefficient: float
    """its strength; only beside hourglass. Viscous: QH/4 of other codes, whose QH = 0.1 is 0.025 here; a cube is stable up to 0.047 (cfl 0.9, Poisson ratio 0.3), and a warning at the start says where a scene is not; negative: 0.05 stiffness, 0.025 viscous, 1 assumed strains [-]"""
    bulk_viscosity: bool
    """artificial pressure that spreads shocks over a few elements"""
    linear_viscosity: float
    """b1 of the bulk viscosity [-]"""
    quadratic_viscosity: float
    """b2 of the bulk viscosity [-]"""
    negative_volume: Field[Optional[NegativeVolume], Optional[Union[NegativeVolume, str]]]
    """what happens to an element whose volume is not positive; None: "erode" where a material erodes, else "stop\""""
    inside_out: Field[InsideOut, Union[InsideOut, str]]
    """what happens to an element with a corner that has turned over, whatever its volume: "warn": it is counted, and reported at the end; "erode"; "stop" ends the run"""
    folding_resistance: float
    """modulus with which corners resist that are about to turn over, over the bulk modulus; 0: none does. It acts in materials that yield, where a corner has less than 0.3 of the mean of its element, and nowhere else [-]"""

class ContactSettings:
    """[contact] of a scene"""
    def __init__(__self, *, method: Union[ContactMethod, str] = ..., enforcement: Union[Enforcement, str] = ..., gap: Union[ContactGap, str] = ..., beta: float = ..., damping: float = ..., friction: float = ..., static_friction: float = ..., friction_decay: float = ..., radius: Union[ContactRadius, str] = ..., radius_factor: float = ..., self: bool = ..., search: Union[ContactSearch, str] = ..., overlap: Union[ContactOverlap, str] = ..., skin: float = ...) -> None: ...
    method: Field[ContactMethod, Union[ContactMethod, str]]
    """"none"; "pinball"; or "slideline", which pinballs replaced: nodes of the surface against faces, in both directions"""
    enforcement: Field[Enforcement, Union[Enforcement, str]]
    """"penalty": springs between pinballs, as in the report; "lagrange": the impulses that let no gap close within the step, from the coupled system of all pairs; "projection": one step towards the same. The last two leave the time step alone and have no parameters but friction"""
    gap: Field[ContactGap, Union[ContactGap, str]]
    """what the gap is measured between: "pinball": the balls, which reach 0.12 h out of flat faces; "face": nodes against faces in both directions and edges against edges, where they are; not for penalty in this version. A slideline measures from node to face whatever stands here. Balls see what near-cubes of one size do: for others a warning at the start says what to choose"""
    beta: float
    """penalty factor of the report's equation (3.11); above 2 the contact can limit the time step. Of a slideline: factor of K A^2/V, half in each direction; limits the time step from 0.1 on [-]"""
    damping: float
    """fraction xi of critical damping, p1 = 2 xi sqrt(p2 m) [-]"""
    friction: float
    """Coulomb coefficient while sliding; not with penalty, and not between balls, which touch elsewhere than elements do. What friction takes is part of the contact energy [-]"""
    static_friction: float
    """the same at rest, >= friction; another value than friction only with lagrange; negative: as friction [-]"""
    friction_decay: float
    """> 0: the coefficient is friction + (static_friction - friction) exp(-friction_decay v) of the sliding velocity v of the step before; 0: that at rest or that of sliding. FS, FD and DC of LS-DYNA are static_friction, friction and this [time/length]"""
    radius: Field[ContactRadius, Union[ContactRadius, str]]
    """pinballs: radius from the "initial" or the "current" volume of the element"""
    radius_factor: float
    """on that radius; 0.806 = (pi/6)^(1/3): the ball of a cube just reaches its faces [-]"""
    self: bool
    """a body may touch itself"""
    search: Field[ContactSearch, Union[ContactSearch, str]]
    """how what may touch is found, with the same results: "tree", boxes over boxes of elements with near numbers; "hash", cells of grids for each size. What suits is measured when lists are made. A slideline always takes a tree"""
    overlap: Field[ContactOverlap, Union[ContactOverlap, str]]
    """what becomes of nodes that lie in another body at the start, which are reported with their depth: "keep": they come no deeper, without stress, and what is deeper than about a quarter of an element passes; "adjust": they are put on the surface of the other body, without stress, half of the way done by each of two bodies where nodes of both lie inside; nodes that are held or tied stay"""
    skin: float
    """how far a node may stray from its straight way before what may touch is searched anew: scale over the radius of its pinballs or the size of its faces [-]"""

class SkipSettings:
    """[skip] of a scene"""
    def __init__(self, *, contact_search: bool = ..., resting: bool = ...) -> None: ...
    contact_search: bool
    """lists of what may touch last while contact.skin allows it; false: search at every step"""
    resting: bool
    """tiles of up to 2,048 elements without stress whose nodes all have one velocity are not updated until something changes that; false: they are, with the same bits"""

class GuardSettings:
    """[guard] of a scene"""
    def __init__(self, *, energy_error: float = ..., time_step_collapse: float = ...) -> None: ...
    energy_error: float
    """the run stops when the error of the energy balance, over the energy in motion in the frame of the scene's own centre of mass, exceeds this [-]"""
    time_step_collapse: float
    """the run stops when the stable step is below this times its largest [-]"""

class OutputSettings:
    """[output] of a scene, for run_recorded()"""
    def __init__(self, *, interval: float = ..., every_step: bool = ..., field_interval: float = ..., field_times: Sequence[float] = ..., fields: Sequence[str] = ..., body_energies: bool = ...) -> None: ...
    interval: float
    """between rows of history.csv; 0: 200 rows over the run; "step", and less than a step: a row per step [time]"""
    every_step: bool
    """interval = "step\""""
    field_interval: float
    """between field outputs; 0: none; less than a step: in every step [time]"""
    field_times: Field[list[float], Sequence[float]]
    """field output at these times, in any order; later than time.end: none [time]"""
    fields: Field[list[str], Sequence[str]]
    """which of them"""
    body_energies: bool
    """energies, momentum and mass of each body in history.csv, after all other columns"""

class Section:
    full: Section
    half: Section
    quarter: Section
    wedge: Section
    @property
    def name(self) -> str: ...
    @property
    def value(self) -> int: ...
    def __init__(self, value: Union[int, str]) -> None: ...
    def __int__(self) -> int: ...

class BlockSection:
    """Layers of elements of one thickness across a block."""
    def __init__(self, *, length: float = ..., elements: int = ...) -> None: ...
    length: float
    """[length]"""
    elements: int
    """layers"""

class BlockMesh:
    """A regular block with a corner at the origin."""
    def __init__(self, *, size: Sequence[float] = ..., elements: Sequence[int] = ..., sections: Sequence[Sequence[BlockSection]] = ...) -> None: ...
    size: Field[list[float], Sequence[float]]
    """[length]"""
    elements: Field[list[int], Sequence[int]]
    """along each direction"""
    sections: Field[list[list[BlockSection]], Sequence[Sequence[BlockSection]]]
    """per direction, whose sums are size and elements; empty: elements of one size"""

class RoundNosedRodMesh:
    """A rod along -z with a hemispherical nose at the origin."""
    def __init__(self, *, length: float = ..., radius: float = ..., half: bool = ..., core: Sequence[int] = ..., ring: int = ..., layers: int = ...) -> None: ...
    length: float
    """over all, > radius [length]"""
    radius: float
    """of the rod and of the nose [length]"""
    half: bool
    """only y >= 0, with the flat cut in y = 0"""
    core: Field[list[int], Sequence[int]]
    """elements of the core along x and y (of the half section) [-]"""
    ring: int
    """layers of elements between the core and the surface [-]"""
    layers: int
    """layers of elements along the axis [-]"""

class CylinderMesh:
    """A cylinder along z from 0 to length, or a part of it."""
    def __init__(self, *, radius: float = ..., length: float = ..., section: Union[Section, str] = ..., core: int = ..., ring: int = ..., angle: float = ..., radial: int = ..., layers: int = ...) -> None: ...
    radius: float
    """of the cylinder [length]"""
    length: float
    """along its axis [length]"""
    section: Field[Section, Union[Section, str]]
    """"half" (y >= 0), "quarter" (x >= 0 and y >= 0) or "wedge" (from y = 0 by angle)"""
    core: int
    """elements along each side of the full core, even in half and quarter; not in a wedge [-]"""
    ring: int
    """layers of elements between the core and the surface; not in a wedge [-]"""
    angle: float
    """of the wedge, and only there [degree]"""
    radial: int
    """elements of the wedge along the radius, and only there [-]"""
    layers: int
    """layers of elements along the axis [-]"""

class SphereMesh:
    """A sphere around the origin, or a part of it."""
    def __init__(self, *, radius: float = ..., section: Union[Section, str] = ..., angle: float = ..., core: Sequence[int] = ..., ring: int = ..., grading: float = ...) -> None: ...
    radius: float
    """of the sphere [length]"""
    section: Field[Section, Union[Section, str]]
    """as of the cylinder; a wedge is about the body's z axis"""
    angle: float
    """of the wedge, and only there [degree]"""
    core: Field[list[int], Sequence[int]]
    """elements along the sides of the core"""
    ring: int
    """layers of elements between the core and the surface [-]"""
    grading: float
    """elements at the pole z = -radius are smaller by this factor, those at the other one larger [-]"""

class MeshFormat:
    gmsh: MeshFormat
    keyword: MeshFormat
    exodus: MeshFormat
    vtk: MeshFormat
    abaqus: MeshFormat
    radioss: MeshFormat
    @property
    def name(self) -> str: ...
    @property
    def value(self) -> int: ...
    def __init__(self, value: Union[int, str]) -> None: ...
    def __int__(self) -> int: ...

class FileMesh:
    """A mesh from a file."""
    def __init__(self, *, format: Union[MeshFormat, str] = ..., file: str = ..., part: str = ..., chosen_case: Optional[int] = ..., array: str = ..., splits: int = ..., scale: float = ...) -> None: ...
    format: Field[MeshFormat, Union[MeshFormat, str]]
    """of the file"""
    file: str
    """relative to the folder of the scene file"""
    part: str
    """name or number of the physical volume that is the body; part with type = "file"; empty: all volumes"""
    chosen_case: Optional[int]
    """number of a *CASE: its nodes, elements and sets are read, too"""
    array: str
    """name of the integers of the cells that number the parts; empty: the first of known names"""
    splits: int
    """so often each hexahedron is split in eight"""
    scale: float
    """multiplies the coordinates [-]"""

class ArrayMesh:
    """The mesh of a body in NumPy arrays, read when the simulation is made."""
    def __init__(self, coordinates: npt.NDArray[Any], hexahedra: npt.NDArray[Any], first_index: int = ...) -> None:
        """coordinates: (nodes, 3), float32 or float64 [length]; hexahedra: (elements, 8), int32 or int64, places in coordinates, the first node being first_index."""
    @property
    def coordinates(self) -> npt.NDArray[Any]:
        """(nodes, 3) [length]"""
    @property
    def hexahedra(self) -> npt.NDArray[Any]:
        """(elements, 8)"""
    @property
    def first_index(self) -> int:
        """what hexahedra calls the first node"""

class YieldCurve:
    """Yield stress over plastic strain, at a strain rate."""
    def __init__(self, *, rate: float = ..., plastic_strain: Sequence[float] = ..., stress: Sequence[float] = ...) -> None: ...
    rate: float
    """at which it holds [1/time]"""
    plastic_strain: Field[list[float], Sequence[float]]
    """from 0, ascending [-]"""
    stress: Field[list[float], Sequence[float]]
    """one for each of them [stress]"""

class YieldCurves(MutableSequence[YieldCurve]):
    """A list of YieldCurve."""
    def __init__(self, items: Iterable[YieldCurve] = ...) -> None: ...
    def __len__(self) -> int: ...
    @overload
    def __getitem__(self, place: int) -> YieldCurve: ...
    @overload
    def __getitem__(self, place: slice) -> list[YieldCurve]: ...
    @overload
    def __setitem__(self, place: int, value: YieldCurve) -> None: ...
    @overload
    def __setitem__(self, place: slice, value: Iterable[YieldCurve]) -> None: ...
    def __delitem__(self, place: Union[int, slice]) -> None: ...
    def insert(self, index: int, value: YieldCurve) -> None: ...

class PowerHardening:
    """Yield stress as a power of the plastic strain."""
    def __init__(self, *, coefficient: float = ..., exponent: float = ...) -> None: ...
    coefficient: float
    """K [stress]"""
    exponent: float
    """n [-]"""

class JohnsonCook:
    """Strength and failure after Johnson and Cook."""
    def __init__(self, *, hardening_coefficient: float = ..., hardening_exponent: float = ..., rate_coefficient: float = ..., reference_rate: float = ..., softening_exponent: float = ..., melting_temperature: float = ..., room_temperature: float = ..., specific_heat: float = ..., heat_share: float = ..., failure: Sequence[float] = ..., damage_weakening: float = ...) -> None: ...
    hardening_coefficient: float
    """B [stress]"""
    hardening_exponent: float
    """n [-]"""
    rate_coefficient: float
    """C [-]"""
    reference_rate: float
    """at which r = 1; > 0 beside rate_coefficient and D4 [1/time]"""
    softening_exponent: float
    """m [-]"""
    melting_temperature: float
    """> room_temperature; 0: heat does not soften [K]"""
    room_temperature: float
    """of the undeformed material [K]"""
    specific_heat: float
    """per mass; > 0 beside melting_temperature [L^2/(T^2 K)]"""
    heat_share: float
    """part of the plastic work that heats [-]"""
    failure: Field[list[float], Sequence[float]]
    """[D1, D2, D3, D4, D5]: an element whose damage reaches 1 is eroded; empty: none [-]"""
    damage_weakening: float
    """w: part of the strength that is lost by then, in proportion to the damage [-]"""

class JohnsonHolmquist:
    """Brittle material after Johnson and Holmquist."""
    def __init__(self, *, intact_strength: float = ..., intact_exponent: float = ..., fractured_strength: float = ..., fractured_exponent: float = ..., most_fractured: float = ..., rate_coefficient: float = ..., reference_rate: float = ..., tensile_strength: float = ..., elastic_limit: float = ..., elastic_limit_pressure: float = ..., damage_coefficient: float = ..., damage_exponent: float = ..., quadratic_modulus: float = ..., cubic_modulus: float = ..., bulking: float = ..., erodes: bool = ...) -> None: ...
    intact_strength: float
    """A [-]"""
    intact_exponent: float
    """N [-]"""
    fractured_strength: float
    """B [-]"""
    fractured_exponent: float
    """M [-]"""
    most_fractured: float
    """F, of the strength of fragments; 0: no such limit [-]"""
    rate_coefficient: float
    """C [-]"""
    reference_rate: float
    """above which strength grows with the rate; > 0 beside rate_coefficient [1/time]"""
    tensile_strength: float
    """of the mean stress [stress]"""
    elastic_limit: float
    """HEL, Hugoniot elastic limit: stress along a shock [stress]"""
    elastic_limit_pressure: float
    """p_H, the pressure there, < elastic_limit [stress]"""
    damage_coefficient: float
    """D_1; 0: it breaks where it yields [-]"""
    damage_exponent: float
    """D_2 [-]"""
    quadratic_modulus: float
    """K_2, of the pressure [stress]"""
    cubic_modulus: float
    """K_3 [stress]"""
    bulking: float
    """beta: part of the elastic energy set free by damage that presses fragments apart [-]"""
    erodes: bool
    """whether an element whose damage reaches 1 is eroded"""

class DruckerPrager:
    """Strength that grows with the pressure."""
    def __init__(self, *, constant: float = ..., linear: float = ..., quadratic: float = ..., largest: float = ..., tension_limit: float = ...) -> None: ...
    constant: float
    """a0 [M^2/(L^2 T^4)]"""
    linear: float
    """a1 [stress]"""
    quadratic: float
    """a2; one of the three > 0 [-]"""
    largest: float
    """which s:s/2 never exceeds [M^2/(L^2 T^4)]"""
    tension_limit: float
    """where the mean stress reaches this there is no strength [stress]"""

class CrushableFoam:
    """Foam whose principal stresses yield each by itself."""
    def __init__(self, *, compaction: Sequence[float] = ..., yield_stress: Sequence[float] = ..., tension_cutoff: float = ..., damping: float = ..., air_pressure: float = ..., solid_share: float = ...) -> None: ...
    compaction: Field[list[float], Sequence[float]]
    """1 - V/V_0 of the points of a curve, ascending, as many as one likes; before the first the stress is as there, behind the last as between the last two, or as there where it falls [-]"""
    yield_stress: Field[list[float], Sequence[float]]
    """one for each of them, of each principal stress [stress]"""
    tension_cutoff: float
    """which no principal stress exceeds [stress]"""
    damping: float
    """zeta: a rate of deformation adds zeta L/c of what the strain would add; L: of an element, c: the speed of waves along one axis [-]"""
    air_pressure: float
    """P_0 at rest of the air in closed cells, whose pressure over that adds to the stress; 0: none [stress]"""
    solid_share: float
    """phi: part of the volume at rest that is not air [-]"""

class MooneyRivlin:
    """Rubber after Mooney and Rivlin."""
    def __init__(self, *, a: float = ..., b: float = ..., poisson_ratio: float = ...) -> None: ...
    a: float
    """A [stress]"""
    b: float
    """B; A + B > 0 [stress]"""
    poisson_ratio: float
    """of small strains, whose shear modulus is 2 (A + B) [-]"""

class Ogden:
    """Rubber and foam after Ogden."""
    def __init__(self, *, moduli: Sequence[float] = ..., exponents: Sequence[float] = ..., poisson_ratio: float = ..., whole: bool = ...) -> None: ...
    moduli: Field[list[float], Sequence[float]]
    """m_p, one per term, 10 at most [stress]"""
    exponents: Field[list[float], Sequence[float]]
    """a_p, as many, none 0; half the sum of m_p a_p is the shear modulus of small strains [-]"""
    poisson_ratio: float
    """of small strains [-]"""
    whole: bool
    """what the powers are of: "shape", without the change of volume, which has an energy of its own, of rubber; "whole", of foam"""

class Orthotropic:
    """Elastic moduli that differ with the direction."""
    def __init__(self, *, young_moduli: Sequence[float] = ..., poisson_ratios: Sequence[float] = ..., shear_moduli: Sequence[float] = ..., first_axis: Sequence[float] = ..., second_axis: Sequence[float] = ...) -> None: ...
    young_moduli: Field[list[float], Sequence[float]]
    """[E_a, E_b, E_c] [stress]"""
    poisson_ratios: Field[list[float], Sequence[float]]
    """[nu_ab, nu_ac, nu_bc]: the first of two letters is the direction of the tension, the other that of the contraction; nu_ba = nu_ab E_b/E_a [-]"""
    shear_moduli: Field[list[float], Sequence[float]]
    """[G_ab, G_ac, G_bc] [stress]"""
    first_axis: Field[list[float], Sequence[float]]
    """a, in the scene at the start, of any length [-]"""
    second_axis: Field[list[float], Sequence[float]]
    """in the plane of a and b, on the side of b; not along a [-]"""

class Fluid:
    """No strength, and the viscosity of Newton."""
    def __init__(self, *, viscosity: float = ...) -> None: ...
    viscosity: float
    """eta: the deviator is 2 eta times that of the rate of deformation [M/(L T)]"""

class EquationOfState:
    """Pressure over compression and energy."""
    def __init__(self, *, form: Union[EquationOfStateForm, str] = ..., sound_speed: float = ..., slopes: Sequence[float] = ..., gamma: float = ..., gamma_slope: float = ..., coefficients: Sequence[float] = ..., volume_strain: Sequence[float] = ..., pressure: Sequence[float] = ..., energy_factor: Sequence[float] = ..., tension_limit: float = ..., bears_tension: bool = ..., volume_measure: Union[VolumeMeasure, str] = ..., unloading_modulus: Sequence[float] = ..., full_compaction: float = ..., elastic_compaction: float = ..., tears: bool = ...) -> None: ...
    form: Field[EquationOfStateForm, Union[EquationOfStateForm, str]]
    """of A and B in p = A + B e"""
    sound_speed: float
    """c, of the bulk: of a shock u_s = c + s1 u_p [length/time]"""
    slopes: Field[list[float], Sequence[float]]
    """[s1, s2, s3] [-]"""
    gamma: float
    """Gamma_0 of Grueneisen [-]"""
    gamma_slope: float
    """a, of its change with the density [-]"""
    coefficients: Field[list[float], Sequence[float]]
    """[c0, c1, c2, c3, c4, c5, c6], the last three without a unit [stress]"""
    volume_strain: Field[list[float], Sequence[float]]
    """of 2 to 16 points, rising or falling, below 0 in compression; beyond the ends the last pieces go on [-]"""
    pressure: Field[list[float], Sequence[float]]
    """A at these points, 0 where the volume is that at rest [stress]"""
    energy_factor: Field[list[float], Sequence[float]]
    """B at these points; none: 0 [-]"""
    tension_limit: float
    """the pressure is never below minus this; 0: no limit [stress]"""
    bears_tension: bool
    """false: the pressure is never below 0"""
    volume_measure: Field[VolumeMeasure, Union[VolumeMeasure, str]]
    """what volume_strain is: "logarithmic", ln(V/V_0); "density", 1 - rho/rho_0"""
    unloading_modulus: Field[list[float], Sequence[float]]
    """[K] of what crushes, in tension, too, or one for each point, or two of a polynomial, without compaction and at full_compaction: K is straight between them; none: it goes back as it came; empty: none [stress]"""
    full_compaction: float
    """beyond it what crushes goes back as it came: a volume_strain without its sign, or mu of a polynomial [-]"""
    elastic_compaction: float
    """up to it what crushes goes back as it came, in tension, too; as full_compaction; negative: none: K is that of tension from the start [-]"""
    tears: bool
    """whether what has come to tension_limit once bears no tension any more"""

class Erosion:
    """Limits beyond which elements are eroded."""
    def __init__(self, *, tension: float = ..., compression: float = ..., principal_stress: float = ..., effective_stress: float = ..., principal_strain: float = ..., shear_strain: float = ..., time: float = ..., smallest_step: float = ..., step_share: float = ...) -> None: ...
    tension: float
    """of the mean stress, which is minus the pressure; 0: no such limit, here and below [stress]"""
    compression: float
    """of the pressure [stress]"""
    principal_stress: float
    """of the largest principal stress [stress]"""
    effective_stress: float
    """of von Mises' effective stress [stress]"""
    principal_strain: float
    """of the largest principal strain, logarithmic where its axes stay in the material [-]"""
    shear_strain: float
    """of half the difference of the largest and the smallest principal strain [-]"""
    time: float
    """after it all elements of the material are eroded [time]"""
    smallest_step: float
    """an element whose stable step is smaller is eroded [time]"""
    step_share: float
    """the same, as a part of the smallest stable step at the start [-]"""

class Material:
    """[[material]] of a scene, with bulk and shear modulus."""
    def __init__(self, *, name: str = ..., plastic: bool = ..., density: float = ..., bulk_modulus: float = ..., shear_modulus: float = ..., yield_stress: float = ..., plastic_modulus: float = ..., ultimate_stress: float = ..., erosion_strain: float = ..., isotropic_share: float = ..., yield_curves: Union[YieldCurves, list[YieldCurve]] = ..., power_hardening: Optional[PowerHardening] = ..., rate_interpolation: Union[RateInterpolation, str] = ..., strain_rate: Union[StrainRate, str] = ..., rate_constant: float = ..., rate_exponent: float = ..., rate_stress: float = ..., johnson_cook: Optional[JohnsonCook] = ..., johnson_holmquist: Optional[JohnsonHolmquist] = ..., drucker_prager: Optional[DruckerPrager] = ..., crushable_foam: Optional[CrushableFoam] = ..., mooney_rivlin: Optional[MooneyRivlin] = ..., ogden: Optional[Ogden] = ..., orthotropic: Optional[Orthotropic] = ..., fluid: Optional[Fluid] = ..., equation_of_state: Optional[EquationOfState] = ..., erosion: Optional[Erosion] = ...) -> None: ...
    name: str
    """unique"""
    plastic: bool
    """neo-Hookean, for large strains, too; or von Mises plasticity"""
    density: float
    """mass per volume [mass/length^3]"""
    bulk_modulus: float
    """K, beside shear_modulus [stress]"""
    shear_modulus: float
    """G, beside bulk_modulus [stress]"""
    yield_stress: float
    """where plastic strain begins [stress]"""
    plastic_modulus: float
    """H, slope of the yield stress over the effective plastic strain [stress]"""
    ultimate_stress: float
    """hardening ends at this yield stress, >= yield_stress [stress]"""
    erosion_strain: float
    """effective plastic strain at which an element is eroded; 0: never [-]"""
    isotropic_share: float
    """beta: the yield surface grows by this part of H, and moves by the rest, as back stress: 1 isotropic, 0 kinematic hardening [-]"""
    yield_curves: Field[YieldCurves, Union[YieldCurves, list[YieldCurve]]]
    """in the place of yield_stress, of ascending rates"""
    power_hardening: Optional[PowerHardening]
    """table (below), in the place of plastic_modulus and ultimate_stress: a power of the plastic strain; None: none"""
    rate_interpolation: Field[RateInterpolation, Union[RateInterpolation, str]]
    """between yield_curves: in the rate, or in its logarithm"""
    strain_rate: Field[StrainRate, Union[StrainRate, str]]
    """of which the yield stress depends: "total", sqrt(D:D) of the rate of deformation D; "deviatoric", sqrt(2/3 D':D') of its deviator; "plastic", rate of the effective plastic strain"""
    rate_constant: float
    """C of Cowper and Symonds: the yield stress is (1 + (rate/C)^(1/p)) times as large; 0: no such law [1/time]"""
    rate_exponent: float
    """p, > 0 beside rate_constant [-]"""
    rate_stress: float
    """the law adds this stress times (rate/C)^(1/p) instead; 0: none [stress]"""
    johnson_cook: Optional[JohnsonCook]
    """table (below), in the place of the laws of hardening and rate above; yield_stress is its A; None: none"""
    johnson_holmquist: Optional[JohnsonHolmquist]
    """table (below), in the place of yield_stress and the laws above: ceramics, glass and rock, whose strength grows with the pressure; bulk_modulus is its K_1; None: none"""
    drucker_prager: Optional[DruckerPrager]
    """table (below), in the place of yield_stress and the laws above: soils, foams and concrete, whose strength grows with the pressure; None: none"""
    crushable_foam: Optional[CrushableFoam]
    """table (below), in the place of yield_stress and the laws above: foams whose principal stresses yield each by itself, at a stress of the volume; None: none"""
    mooney_rivlin: Optional[MooneyRivlin]
    """table (below): rubber, in the place of the moduli; None: none"""
    ogden: Optional[Ogden]
    """table (below): rubber and foam, in the place of the moduli; None: none"""
    orthotropic: Optional[Orthotropic]
    """table (below): moduli that differ with the direction, for small strains and any rotation, in the place of the moduli; None: none"""
    fluid: Optional[Fluid]
    """table (below), in the place of all strength, shear_modulus and yield_stress, beside an equation_of_state; of "von_mises", with elements of viscous hourglass control, or none; None: none"""
    equation_of_state: Optional[EquationOfState]
    """table (below), in the place of the bulk modulus, beside shear_modulus or fluid; of "von_mises"; None: none"""
    erosion: Optional[Erosion]
    """table (below) of limits: an element beyond one of them is eroded; of elastic materials, too; None: none"""

class Body:
    """[[body]] of a scene"""
    def __init__(self, *, name: str = ..., material: str = ..., mesh: Union[BlockMesh, RoundNosedRodMesh, CylinderMesh, SphereMesh, FileMesh, ArrayMesh] = ..., elements: Union[ElementShape, str] = ..., position: Sequence[float] = ..., axis: Optional[Sequence[float]] = ..., velocity: Sequence[float] = ..., angular_velocity: Sequence[float] = ..., velocity_gradient: Sequence[Sequence[float]] = ..., velocity_noise: float = ..., element: Optional[ElementSettings] = ...) -> None: ...
    name: str
    """unique"""
    material: str
    """name of a [[material]]"""
    mesh: Union[BlockMesh, RoundNosedRodMesh, CylinderMesh, SphereMesh, FileMesh, ArrayMesh]
    """by a generator, from a file or of arrays"""
    elements: Field[ElementShape, Union[ElementShape, str]]
    """"tetrahedra": each hexahedron of a generated mesh is cut into six, as those of meshes that have them"""
    position: Field[list[float], Sequence[float]]
    """translation, after the rotation [length]"""
    axis: Field[Optional[list[float]], Optional[Sequence[float]]]
    """the body's z axis is turned onto this direction by the shortest rotation; None: not turned [-]"""
    velocity: Field[list[float], Sequence[float]]
    """initial, uniform [length/time]"""
    angular_velocity: Field[list[float], Sequence[float]]
    """initial rigid spin about the body's centroid [1/time]"""
    velocity_gradient: Field[list[list[float]], Sequence[Sequence[float]]]
    """3 rows of 3: adds G (x - centroid) to the initial velocity [1/time]"""
    velocity_noise: float
    """adds a pseudo-random velocity of this amplitude, the same in every run [length/time]"""
    element: Optional[ElementSettings]
    """table with keys of [element] that this body has in their place: element = { hourglass = "viscous", linear_viscosity = 0.1 }; None: that of the scene"""

class Materials(MutableSequence[Material]):
    """A list of Material."""
    def __init__(self, items: Iterable[Material] = ...) -> None: ...
    def __len__(self) -> int: ...
    @overload
    def __getitem__(self, place: int) -> Material: ...
    @overload
    def __getitem__(self, place: slice) -> list[Material]: ...
    @overload
    def __setitem__(self, place: int, value: Material) -> None: ...
    @overload
    def __setitem__(self, place: slice, value: Iterable[Material]) -> None: ...
    def __delitem__(self, place: Union[int, slice]) -> None: ...
    def insert(self, index: int, value: Material) -> None: ...

class Bodies(MutableSequence[Body]):
    """A list of Body."""
    def __init__(self, items: Iterable[Body] = ...) -> None: ...
    def __len__(self) -> int: ...
    @overload
    def __getitem__(self, place: int) -> Body: ...
    @overload
    def __getitem__(self, place: slice) -> list[Body]: ...
    @overload
    def __setitem__(self, place: int, value: Body) -> None: ...
    @overload
    def __setitem__(self, place: slice, value: Iterable[Body]) -> None: ...
    def __delitem__(self, place: Union[int, slice]) -> None: ...
    def insert(self, index: int, value: Body) -> None: ...

class MeshSetName:
    """A set of a mesh file."""
    def __init__(self, *, set: str = ..., file: str = ...) -> None: ...
    set: str
    """its name or number"""
    file: str
    """the mesh file that has it; empty: the only one"""

class MeshSetNames(MutableSequence[MeshSetName]):
    """A list of MeshSetName."""
    def __init__(self, items: Iterable[MeshSetName] = ...) -> None: ...
    def __len__(self) -> int: ...
    @overload
    def __getitem__(self, place: int) -> MeshSetName: ...
    @overload
    def __getitem__(self, place: slice) -> list[MeshSetName]: ...
    @overload
    def __setitem__(self, place: int, value: MeshSetName) -> None: ...
    @overload
    def __setitem__(self, place: slice, value: Iterable[MeshSetName]) -> None: ...
    def __delitem__(self, place: Union[int, slice]) -> None: ...
    def insert(self, index: int, value: MeshSetName) -> None: ...

class ContactSide:
    """Bodies and sets on one side of a contact."""
    def __init__(self, *, bodies: Sequence[str] = ..., elements: Union[MeshSetNames, list[MeshSetName]] = ..., faces: Union[MeshSetNames, list[MeshSetName]] = ..., nodes: Union[MeshSetNames, list[MeshSetName]] = ...) -> None: ...
    bodies: Field[list[str], Sequence[str]]
    """names"""
    elements: Field[MeshSetNames, Union[MeshSetNames, list[MeshSetName]]]
    """sets of elements"""
    faces: Field[MeshSetNames, Union[MeshSetNames, list[MeshSetName]]]
    """sets of faces"""
    nodes: Field[MeshSetNames, Union[MeshSetNames, list[MeshSetName]]]
    """sets of nodes"""

class ContactPair:
    """[[contact.pair]] of a scene"""
    def __init__(self, *, name: str = ..., first: ContactSide = ..., second: ContactSide = ..., friction: float = ..., static_friction: float = ..., friction_decay: float = ..., start: float = ..., end: float = ..., where: str = ...) -> None: ...
    name: str
    """unique; of the columns in history.csv, counted from 0; empty: pair_NUMBER"""
    first: ContactSide
    """a body, a set, or an array of these (below): all of them together"""
    second: ContactSide
    """the same; without it the members of first touch each other, and themselves; empty: first"""
    friction: float
    """as in [contact]; where one of these three is given, none is taken from [contact]; negative: of `[contact]` [-]"""
    static_friction: float
    """as in [contact]; negative: as friction [-]"""
    friction_decay: float
    """as in [contact]; negative: 0 [time/length]"""
    start: float
    """they may touch from the steps of start on [time]"""
    end: float
    """and before it [time]"""
    where: str
    """for messages"""

class TiedContact:
    """[[contact.tied]] of a scene"""
    def __init__(self, *, name: str = ..., first: ContactSide = ..., second: ContactSide = ..., tolerance: float = ..., start: float = ..., end: float = ..., where: str = ...) -> None: ...
    name: str
    """unique; empty: tied_NUMBER"""
    first: ContactSide
    """as in [[contact.pair]]: whose nodes are tied; should have the finer mesh"""
    second: ContactSide
    """whose faces they are tied to; no sets of nodes"""
    tolerance: float
    """how far from a face a node may lie; negative: 0.05 of a face's shorter diagonal [length]"""
    start: float
    """they are tied from the steps of start on [time]"""
    end: float
    """and before it [time]"""
    where: str
    """for messages"""

class ContactPairs(MutableSequence[ContactPair]):
    """A list of ContactPair."""
    def __init__(self, items: Iterable[ContactPair] = ...) -> None: ...
    def __len__(self) -> int: ...
    @overload
    def __getitem__(self, place: int) -> ContactPair: ...
    @overload
    def __getitem__(self, place: slice) -> list[ContactPair]: ...
    @overload
    def __setitem__(self, place: int, value: ContactPair) -> None: ...
    @overload
    def __setitem__(self, place: slice, value: Iterable[ContactPair]) -> None: ...
    def __delitem__(self, place: Union[int, slice]) -> None: ...
    def insert(self, index: int, value: ContactPair) -> None: ...

class TiedContacts(MutableSequence[TiedContact]):
    """A list of TiedContact."""
    def __init__(self, items: Iterable[TiedContact] = ...) -> None: ...
    def __len__(self) -> int: ...
    @overload
    def __getitem__(self, place: int) -> TiedContact: ...
    @overload
    def __getitem__(self, place: slice) -> list[TiedContact]: ...
    @overload
    def __setitem__(self, place: int, value: TiedContact) -> None: ...
    @overload
    def __setitem__(self, place: slice, value: Iterable[TiedContact]) -> None: ...
    def __delitem__(self, place: Union[int, slice]) -> None: ...
    def insert(self, index: int, value: TiedContact) -> None: ...

class Frame:
    cylindrical: Frame
    @property
    def name(self) -> str: ...
    @property
    def value(self) -> int: ...
    def __init__(self, value: Union[int, str]) -> None: ...
    def __int__(self) -> int: ...

class MotionQuantity:
    velocity: MotionQuantity
    displacement: MotionQuantity
    acceleration: MotionQuantity
    @property
    def name(self) -> str: ...
    @property
    def value(self) -> int: ...
    def __init__(self, value: Union[int, str]) -> None: ...
    def __int__(self) -> int: ...

class JointKind:
    spherical: JointKind
    revolute: JointKind
    cylindrical: JointKind
    translational: JointKind
    universal: JointKind
    locking: JointKind
    @property
    def name(self) -> str: ...
    @property
    def value(self) -> int: ...
    def __init__(self, value: Union[int, str]) -> None: ...
    def __int__(self) -> int: ...

class ProbeKind:
    node: ProbeKind
    element: ProbeKind
    @property
    def name(self) -> str: ...
    @property
    def value(self) -> int: ...
    def __init__(self, value: Union[int, str]) -> None: ...
    def __int__(self) -> int: ...

class Plane:
    """plane = { point, normal }"""
    def __init__(self, *, point: Sequence[float] = ..., normal: Sequence[float] = ...) -> None: ...
    point: Field[list[float], Sequence[float]]
    """a point of it [length]"""
    normal: Field[list[float], Sequence[float]]
    """across it [-]"""

class Line:
    """line = { point, direction }"""
    def __init__(self, *, point: Sequence[float] = ..., direction: Sequence[float] = ...) -> None: ...
    point: Field[list[float], Sequence[float]]
    """a point of it [length]"""
    direction: Field[list[float], Sequence[float]]
    """along it [-]"""

class Box:
    """box = { low, high }"""
    def __init__(self, *, low: Sequence[float] = ..., high: Sequence[float] = ...) -> None: ...
    low: Field[list[float], Sequence[float]]
    """a corner [length]"""
    high: Field[list[float], Sequence[float]]
    """the opposite corner, no component < that of low [length]"""

class NodeSelection:
    """Nodes that fulfil everything given."""
    def __init__(self, *, body: str = ..., plane: Optional[Plane] = ..., line: Optional[Line] = ..., box: Optional[Box] = ..., nearest: Optional[Sequence[float]] = ..., set: str = ..., nodes: Sequence[int] = ..., file: str = ..., without: str = ..., tolerance: float = ..., where: str = ...) -> None: ...
    body: str
    """nodes of this body; empty: all"""
    plane: Optional[Plane]
    """{ point = [...], normal = [...] }: nodes on the plane [L, -]"""
    line: Optional[Line]
    """{ point = [...], direction = [...] }: nodes on the line [L, -]"""
    box: Optional[Box]
    """{ low = [...], high = [...] }: nodes in the box, its faces included [length]"""
    nearest: Field[Optional[list[float]], Optional[Sequence[float]]]
    """of these nodes the one nearest to the point [length]"""
    set: str
    """name or number of a set in the mesh file of the bodies; of faces, elements or a part: their nodes"""
    nodes: Field[list[int], Sequence[int]]
    """[11, 12, ...]: the numbers that the mesh file gives its nodes"""
    file: str
    """the mesh file of sets and numbers, where bodies are from several"""
    without: str
    """a set whose nodes are left out"""
    tolerance: float
    """how far from plane, line and box a node may lie; 0: by the mesh [length]"""
    where: str
    """for messages"""

class TimeSpan:
    """When something acts."""
    def __init__(self, *, start: float = ..., end: float = ...) -> None: ...
    start: float
    """when it begins to act; not above 0: from the beginning [time]"""
    end: float
    """when it ends to act [time]"""

class TimeTable:
    """Factor over time, piecewise linear."""
    def __init__(self, *, times: Sequence[float] = ..., factors: Sequence[float] = ...) -> None: ...
    times: Field[list[float], Sequence[float]]
    """increasing [time]"""
    factors: Field[list[float], Sequence[float]]
    """one per time, linear between them; empty: 1 at all times [-]"""

class SymmetryPlane:
    """[[constraint]] type = "symmetry\""""
    def __init__(self, *, name: str = ..., point: Sequence[float] = ..., normal: Sequence[float] = ..., body: str = ..., set: str = ..., tolerance: float = ..., where: str = ...) -> None: ...
    name: str
    """of its force, see above; empty: none"""
    point: Field[list[float], Sequence[float]]
    """a point of the plane, which with set goes through its nodes [length]"""
    normal: Field[list[float], Sequence[float]]
    """nodes on the plane may not move along it [-]"""
    body: str
    """only nodes of this body; empty: all"""
    set: str
    """these nodes of the mesh file in the place of those on the plane"""
    tolerance: float
    """how far from the plane a node may lie; 0: by the mesh [length]"""
    where: str
    """for messages"""

class Fixed:
    """[[constraint]] type = "fixed", with directions along x, y, z"""
    def __init__(self, *, name: str = ..., frame: Union[Frame, str] = ..., directions: Sequence[Sequence[float]] = ..., axis: Line = ..., when: TimeSpan = ..., nodes: NodeSelection = ...) -> None: ...
    name: str
    """of its force, see above; empty: none"""
    frame: Field[Frame, Union[Frame, str]]
    """"cylindrical": the directions are "radial", "circumferential", "axial", or 3 numbers along these, at the place that each node has at the start"""
    directions: Field[list[list[float]], Sequence[Sequence[float]]]
    """"all", or an array of directions: "x", "y", "z" or 3 numbers of any non-zero length [-]"""
    axis: Line
    """{ point = [...], direction = [...] } [L, -]"""
    when: TimeSpan
    """start, end"""
    nodes: NodeSelection
    """which nodes"""

class EquationTerm:
    """[[equation]]: a term of an equation among displacements"""
    def __init__(self, *, name: str = ..., direction: Sequence[float] = ..., factor: float = ..., nodes: NodeSelection = ...) -> None: ...
    name: str
    """of the equation that this is a term of; those of one name add up to zero"""
    direction: Field[list[float], Sequence[float]]
    """of the displacement that is a term [-]"""
    factor: float
    """of the displacement along it, not 0 [-]"""
    nodes: NodeSelection
    """which nodes; several: an equation for each of them"""

class RigidWall:
    """[[rigid_wall]]"""
    def __init__(self, *, name: str = ..., plane: Plane = ..., friction: float = ..., sliding: bool = ..., edge: Optional[Sequence[float]] = ..., size: Sequence[float] = ..., mass: float = ..., speed: float = ..., table: TimeTable = ..., when: TimeSpan = ..., body: str = ..., nodes: NodeSelection = ..., where: str = ...) -> None: ...
    name: str
    """of the columns NAME_force and NAME_impulse in history.csv, counted from 0; empty: wall_NUMBER"""
    plane: Plane
    """the normal points to the free side"""
    friction: float
    """Coulomb coefficient [-]"""
    sliding: bool
    """false: nodes do not move along the wall while they touch it; then no friction"""
    edge: Field[Optional[list[float]], Optional[Sequence[float]]]
    """of a rectangle with a corner in point: direction of its first side; None: none [-]"""
    size: Field[list[float], Sequence[float]]
    """of that rectangle: lengths along edge and along normal x edge; 0: without end both ways [length]"""
    mass: float
    """> 0: the nodes push it along its normal; it begins with speed [mass]"""
    speed: float
    """at which it moves along the normal [length/time]"""
    table: TimeTable
    """of the speed"""
    when: TimeSpan
    """when it acts"""
    body: str
    """only nodes of this body; empty: all"""
    nodes: NodeSelection
    """only these nodes; nothing given: all"""
    where: str
    """for messages"""

class PrescribedVelocity:
    """[[prescribed_velocity]]"""
    def __init__(self, *, name: str = ..., velocity: Sequence[float] = ..., direction: Optional[Sequence[float]] = ..., quantity: Union[MotionQuantity, str] = ..., table: TimeTable = ..., when: TimeSpan = ..., nodes: NodeSelection = ...) -> None: ...
    name: str
    """of its force, see above; empty: none"""
    velocity: Field[list[float], Sequence[float]]
    """all three components [length/time]"""
    direction: Field[Optional[list[float]], Optional[Sequence[float]]]
    """only the component along it; the others are free; None: all three [-]"""
    quantity: Field[MotionQuantity, Union[MotionQuantity, str]]
    """what the factors make of it: with "displacement" and "acceleration" velocity and speed are lengths and accelerations"""
    table: TimeTable
    """factors"""
    when: TimeSpan
    """nodes are free before and after; factors are of the time of the run"""
    nodes: NodeSelection
    """which nodes"""

class Load:
    """[[load]]"""
    def __init__(self, *, force: Sequence[float] = ..., each: bool = ..., table: TimeTable = ..., nodes: NodeSelection = ...) -> None: ...
    force: Field[list[float], Sequence[float]]
    """on all the nodes together [force]"""
    each: bool
    """true: on each of the nodes"""
    table: TimeTable
    """factors"""
    nodes: NodeSelection
    """which nodes"""

class Pressure:
    """[[pressure]]"""
    def __init__(self, *, name: str = ..., pressure: float = ..., start: float = ..., table: TimeTable = ..., corners: Sequence[Sequence[int]] = ..., faces: NodeSelection = ...) -> None: ...
    name: str
    """of the columns NAME_force_x, _y, _z and NAME_work in history.csv, counted from 0; empty: pressure_NUMBER"""
    pressure: float
    """positive: it presses on the faces [stress]"""
    start: float
    """before it there is none; times count from it [time]"""
    table: TimeTable
    """factors"""
    corners: Field[list[list[int]], Sequence[Sequence[int]]]
    """[[1, 2, 6, 5], ...]: their nodes by the numbers of the mesh file; of a triangle the last one twice"""
    faces: NodeSelection
    """which faces: those of a set, or the exposed ones with all corners here"""

class Gravity:
    """[[gravity]]"""
    def __init__(self, *, name: str = ..., acceleration: Sequence[float] = ..., bodies: Sequence[str] = ..., table: TimeTable = ...) -> None: ...
    name: str
    """of its force, see above; empty: none"""
    acceleration: Field[list[float], Sequence[float]]
    """force over mass on every node [length/time^2]"""
    bodies: Field[list[str], Sequence[str]]
    """names of those that feel it; empty: all"""
    table: TimeTable
    """factors"""

class PointMass:
    """[[point_mass]]"""
    def __init__(self, *, mass: float = ..., each: bool = ..., nodes: NodeSelection = ...) -> None: ...
    mass: float
    """of all the nodes together, shared in proportion to the masses of their elements [mass]"""
    each: bool
    """true: of each of the nodes"""
    nodes: NodeSelection
    """which nodes; of a node that several tables have the masses add up"""

class InitialVelocity:
    """[[initial_velocity]]"""
    def __init__(self, *, velocity: Sequence[float] = ..., angular_velocity: Sequence[float] = ..., centre: Sequence[float] = ..., components: Sequence[bool] = ..., nodes: NodeSelection = ...) -> None: ...
    velocity: Field[list[float], Sequence[float]]
    """required, or the next one; the last table that selects a node counts [length/time]"""
    angular_velocity: Field[list[float], Sequence[float]]
    """adds a spin about an axis through centre [1/time]"""
    centre: Field[list[float], Sequence[float]]
    """a point of that axis [length]"""
    components: Field[list[bool], Sequence[bool]]
    """those that are set"""
    nodes: NodeSelection
    """which nodes"""

class InitialStress:
    """[[initial_stress]]"""
    def __init__(self, *, stress: Sequence[float] = ..., shear_stress: Sequence[float] = ..., plastic_strain: float = ..., elements: Sequence[int] = ..., nodes: NodeSelection = ...) -> None: ...
    stress: Field[list[float], Sequence[float]]
    """xx, yy, zz of Cauchy's stress, along x, y, z as the mesh lies; the last table that selects an element counts [stress]"""
    shear_stress: Field[list[float], Sequence[float]]
    """xy, yz, zx [stress]"""
    plastic_strain: float
    """effective, of what yields [-]"""
    elements: Field[list[int], Sequence[int]]
    """[11, 12, ...]: the numbers that the mesh file gives its elements"""
    nodes: NodeSelection
    """which elements: those of a set or a part, or those with all corners here"""

class Probe:
    """[[probe]]: a node or an element, by a point at the start or by its number"""
    def __init__(self, *, name: str = ..., kind: Union[ProbeKind, str] = ..., point: Sequence[float] = ..., number: Optional[int] = ..., body: str = ..., quantities: Sequence[str] = ..., where: str = ...) -> None: ...
    name: str
    """unique, also among the bodies"""
    kind: Field[ProbeKind, Union[ProbeKind, str]]
    """what is watched"""
    point: Field[list[float], Sequence[float]]
    """the node, or the element whose centre, is nearest to this point at the start is watched [length]"""
    number: Optional[int]
    """of the node or the element in the mesh file of its body"""
    body: str
    """only of this body; empty: all"""
    quantities: Field[list[str], Sequence[str]]
    """of nodes the first three, of elements the others; empty: all of the kind"""
    where: str
    """for messages"""

class RigidBody:
    """[[rigid_body]]"""
    def __init__(self, *, name: str = ..., bodies: Sequence[str] = ..., held: Sequence[Sequence[float]] = ..., held_rotations: Sequence[Sequence[float]] = ..., mass: float = ..., inertia: Sequence[Sequence[float]] = ..., centre: Optional[Sequence[float]] = ..., velocity: Optional[Sequence[float]] = ..., angular_velocity: Optional[Sequence[float]] = ..., where: str = ...) -> None: ...
    name: str
    """of its columns in history.csv; empty: that of the first of its bodies"""
    bodies: Field[list[str], Sequence[str]]
    """names of the bodies that move as one and do not deform; empty: none: nodes of `[[rigid_nodes]]` alone"""
    held: Field[list[list[float]], Sequence[Sequence[float]]]
    """"all", or directions at right angles along which its centre does not move: "x", "y", "z" or 3 numbers; empty: none [-]"""
    held_rotations: Field[list[list[float]], Sequence[Sequence[float]]]
    """"all", or directions at right angles about which it does not turn; empty: none [-]"""
    mass: float
    """in the place of that of its materials, whose densities follow [mass]"""
    inertia: Field[list[list[float]], Sequence[Sequence[float]]]
    """3 rows of 3, at the start, about its centre along x, y, z; all 0: that of the masses of its nodes [M L^2]"""
    centre: Field[Optional[list[float]], Optional[Sequence[float]]]
    """of its mass, at the start; required beside it is inertia; None: that of the masses of its nodes [length]"""
    velocity: Field[Optional[list[float]], Optional[Sequence[float]]]
    """of its centre at the start, whatever velocities its bodies and nodes have; 0 beside angular_velocity; None: as its nodes move [length/time]"""
    angular_velocity: Field[Optional[list[float]], Optional[Sequence[float]]]
    """at the start, the same; 0 beside velocity; None: as its nodes turn [1/time]"""
    where: str
    """for messages"""

class AttachedNodes:
    """[[rigid_nodes]]"""
    def __init__(self, *, rigid_body: str = ..., nodes: NodeSelection = ...) -> None: ...
    rigid_body: str
    """name of a [[rigid_body]]"""
    nodes: NodeSelection
    """which nodes"""

class RigidMotion:
    """[[rigid_motion]]"""
    def __init__(self, *, rigid_body: str = ..., direction: Optional[Sequence[float]] = ..., speed: float = ..., axis: Optional[Sequence[float]] = ..., angular_speed: float = ..., quantity: Union[MotionQuantity, str] = ..., table: TimeTable = ..., when: TimeSpan = ..., where: str = ...) -> None: ...
    rigid_body: str
    """name of a [[rigid_body]]"""
    direction: Field[Optional[list[float]], Optional[Sequence[float]]]
    """in which its centre moves [-]"""
    speed: float
    """along the direction [length/time]"""
    axis: Field[Optional[list[float]], Optional[Sequence[float]]]
    """about which it turns [-]"""
    angular_speed: float
    """about the axis [1/time]"""
    quantity: Field[MotionQuantity, Union[MotionQuantity, str]]
    """what the factors make of it: with "displacement" and "acceleration" speeds are ways, angles and accelerations"""
    table: TimeTable
    """factors"""
    when: TimeSpan
    """the body is free before and after; factors are of the time of the run"""
    where: str
    """for messages"""

class Joint:
    """[[joint]]"""
    def __init__(self, *, name: str = ..., kind: Union[JointKind, str] = ..., bodies: Sequence[str] = ..., point: Optional[Sequence[float]] = ..., axis: Optional[Sequence[float]] = ..., second_axis: Optional[Sequence[float]] = ..., where: str = ...) -> None: ...
    name: str
    """of its columns in history.csv; empty: `joint_0`, `joint_1`, ..."""
    kind: Field[JointKind, Union[JointKind, str]]
    """what the bodies still do with each other (below)"""
    bodies: Field[list[str], Sequence[str]]
    """names of two [[rigid_body]]; in the place of one of them "ground", which does not move"""
    point: Field[Optional[list[float]], Optional[Sequence[float]]]
    """where it is at the start, of both bodies [length]"""
    axis: Field[Optional[list[float]], Optional[Sequence[float]]]
    """that it turns about or slides along; of a "universal" one that of the first body; None: required but for `"spherical"` and `"locking"` [-]"""
    second_axis: Field[Optional[list[float]], Optional[Sequence[float]]]
    """of a "universal" one: that of the second body, at right angles to the first; None: required of a `"universal"` one [-]"""
    where: str
    """for messages"""

class RigidBodies(MutableSequence[RigidBody]):
    """A list of RigidBody."""
    def __init__(self, items: Iterable[RigidBody] = ...) -> None: ...
    def __len__(self) -> int: ...
    @overload
    def __getitem__(self, place: int) -> RigidBody: ...
    @overload
    def __getitem__(self, place: slice) -> list[RigidBody]: ...
    @overload
    def __setitem__(self, place: int, value: RigidBody) -> None: ...
    @overload
    def __setitem__(self, place: slice, value: Iterable[RigidBody]) -> None: ...
    def __delitem__(self, place: Union[int, slice]) -> None: ...
    def insert(self, index: int, value: RigidBody) -> None: ...

class AttachedNodesList(MutableSequence[AttachedNodes]):
    """A list of AttachedNodes."""
    def __init__(self, items: Iterable[AttachedNodes] = ...) -> None: ...
    def __len__(self) -> int: ...
    @overload
    def __getitem__(self, place: int) -> AttachedNodes: ...
    @overload
    def __getitem__(self, place: slice) -> list[AttachedNodes]: ...
    @overload
    def __setitem__(self, place: int, value: AttachedNodes) -> None: ...
    @overload
    def __setitem__(self, place: slice, value: Iterable[AttachedNodes]) -> None: ...
    def __delitem__(self, place: Union[int, slice]) -> None: ...
    def insert(self, index: int, value: AttachedNodes) -> None: ...

class RigidMotions(MutableSequence[RigidMotion]):
    """A list of RigidMotion."""
    def __init__(self, items: Iterable[RigidMotion] = ...) -> None: ...
    def __len__(self) -> int: ...
    @overload
    def __getitem__(self, place: int) -> RigidMotion: ...
    @overload
    def __getitem__(self, place: slice) -> list[RigidMotion]: ...
    @overload
    def __setitem__(self, place: int, value: RigidMotion) -> None: ...
    @overload
    def __setitem__(self, place: slice, value: Iterable[RigidMotion]) -> None: ...
    def __delitem__(self, place: Union[int, slice]) -> None: ...
    def insert(self, index: int, value: RigidMotion) -> None: ...

class Joints(MutableSequence[Joint]):
    """A list of Joint."""
    def __init__(self, items: Iterable[Joint] = ...) -> None: ...
    def __len__(self) -> int: ...
    @overload
    def __getitem__(self, place: int) -> Joint: ...
    @overload
    def __getitem__(self, place: slice) -> list[Joint]: ...
    @overload
    def __setitem__(self, place: int, value: Joint) -> None: ...
    @overload
    def __setitem__(self, place: slice, value: Iterable[Joint]) -> None: ...
    def __delitem__(self, place: Union[int, slice]) -> None: ...
    def insert(self, index: int, value: Joint) -> None: ...

class SymmetryPlanes(MutableSequence[SymmetryPlane]):
    """A list of SymmetryPlane."""
    def __init__(self, items: Iterable[SymmetryPlane] = ...) -> None: ...
    def __len__(self) -> int: ...
    @overload
    def __getitem__(self, place: int) -> SymmetryPlane: ...
    @overload
    def __getitem__(self, place: slice) -> list[SymmetryPlane]: ...
    @overload
    def __setitem__(self, place: int, value: SymmetryPlane) -> None: ...
    @overload
    def __setitem__(self, place: slice, value: Iterable[SymmetryPlane]) -> None: ...
    def __delitem__(self, place: Union[int, slice]) -> None: ...
    def insert(self, index: int, value: SymmetryPlane) -> None: ...

class FixedConstraints(MutableSequence[Fixed]):
    """A list of Fixed."""
    def __init__(self, items: Iterable[Fixed] = ...) -> None: ...
    def __len__(self) -> int: ...
    @overload
    def __getitem__(self, place: int) -> Fixed: ...
    @overload
    def __getitem__(self, place: slice) -> list[Fixed]: ...
    @overload
    def __setitem__(self, place: int, value: Fixed) -> None: ...
    @overload
    def __setitem__(self, place: slice, value: Iterable[Fixed]) -> None: ...
    def __delitem__(self, place: Union[int, slice]) -> None: ...
    def insert(self, index: int, value: Fixed) -> None: ...

class EquationTerms(MutableSequence[EquationTerm]):
    """A list of EquationTerm."""
    def __init__(self, items: Iterable[EquationTerm] = ...) -> None: ...
    def __len__(self) -> int: ...
    @overload
    def __getitem__(self, place: int) -> EquationTerm: ...
    @overload
    def __getitem__(self, place: slice) -> list[EquationTerm]: ...
    @overload
    def __setitem__(self, place: int, value: EquationTerm) -> None: ...
    @overload
    def __setitem__(self, place: slice, value: Iterable[EquationTerm]) -> None: ...
    def __delitem__(self, place: Union[int, slice]) -> None: ...
    def insert(self, index: int, value: EquationTerm) -> None: ...

class RigidWalls(MutableSequence[RigidWall]):
    """A list of RigidWall."""
    def __init__(self, items: Iterable[RigidWall] = ...) -> None: ...
    def __len__(self) -> int: ...
    @overload
    def __getitem__(self, place: int) -> RigidWall: ...
    @overload
    def __getitem__(self, place: slice) -> list[RigidWall]: ...
    @overload
    def __setitem__(self, place: int, value: RigidWall) -> None: ...
    @overload
    def __setitem__(self, place: slice, value: Iterable[RigidWall]) -> None: ...
    def __delitem__(self, place: Union[int, slice]) -> None: ...
    def insert(self, index: int, value: RigidWall) -> None: ...

class PrescribedVelocities(MutableSequence[PrescribedVelocity]):
    """A list of PrescribedVelocity."""
    def __init__(self, items: Iterable[PrescribedVelocity] = ...) -> None: ...
    def __len__(self) -> int: ...
    @overload
    def __getitem__(self, place: int) -> PrescribedVelocity: ...
    @overload
    def __getitem__(self, place: slice) -> list[PrescribedVelocity]: ...
    @overload
    def __setitem__(self, place: int, value: PrescribedVelocity) -> None: ...
    @overload
    def __setitem__(self, place: slice, value: Iterable[PrescribedVelocity]) -> None: ...
    def __delitem__(self, place: Union[int, slice]) -> None: ...
    def insert(self, index: int, value: PrescribedVelocity) -> None: ...

class Loads(MutableSequence[Load]):
    """A list of Load."""
    def __init__(self, items: Iterable[Load] = ...) -> None: ...
    def __len__(self) -> int: ...
    @overload
    def __getitem__(self, place: int) -> Load: ...
    @overload
    def __getitem__(self, place: slice) -> list[Load]: ...
    @overload
    def __setitem__(self, place: int, value: Load) -> None: ...
    @overload
    def __setitem__(self, place: slice, value: Iterable[Load]) -> None: ...
    def __delitem__(self, place: Union[int, slice]) -> None: ...
    def insert(self, index: int, value: Load) -> None: ...

class Pressures(MutableSequence[Pressure]):
    """A list of Pressure."""
    def __init__(self, items: Iterable[Pressure] = ...) -> None: ...
    def __len__(self) -> int: ...
    @overload
    def __getitem__(self, place: int) -> Pressure: ...
    @overload
    def __getitem__(self, place: slice) -> list[Pressure]: ...
    @overload
    def __setitem__(self, place: int, value: Pressure) -> None: ...
    @overload
    def __setitem__(self, place: slice, value: Iterable[Pressure]) -> None: ...
    def __delitem__(self, place: Union[int, slice]) -> None: ...
    def insert(self, index: int, value: Pressure) -> None: ...

class Gravities(MutableSequence[Gravity]):
    """A list of Gravity."""
    def __init__(self, items: Iterable[Gravity] = ...) -> None: ...
    def __len__(self) -> int: ...
    @overload
    def __getitem__(self, place: int) -> Gravity: ...
    @overload
    def __getitem__(self, place: slice) -> list[Gravity]: ...
    @overload
    def __setitem__(self, place: int, value: Gravity) -> None: ...
    @overload
    def __setitem__(self, place: slice, value: Iterable[Gravity]) -> None: ...
    def __delitem__(self, place: Union[int, slice]) -> None: ...
    def insert(self, index: int, value: Gravity) -> None: ...

class PointMasses(MutableSequence[PointMass]):
    """A list of PointMass."""
    def __init__(self, items: Iterable[PointMass] = ...) -> None: ...
    def __len__(self) -> int: ...
    @overload
    def __getitem__(self, place: int) -> PointMass: ...
    @overload
    def __getitem__(self, place: slice) -> list[PointMass]: ...
    @overload
    def __setitem__(self, place: int, value: PointMass) -> None: ...
    @overload
    def __setitem__(self, place: slice, value: Iterable[PointMass]) -> None: ...
    def __delitem__(self, place: Union[int, slice]) -> None: ...
    def insert(self, index: int, value: PointMass) -> None: ...

class InitialVelocities(MutableSequence[InitialVelocity]):
    """A list of InitialVelocity."""
    def __init__(self, items: Iterable[InitialVelocity] = ...) -> None: ...
    def __len__(self) -> int: ...
    @overload
    def __getitem__(self, place: int) -> InitialVelocity: ...
    @overload
    def __getitem__(self, place: slice) -> list[InitialVelocity]: ...
    @overload
    def __setitem__(self, place: int, value: InitialVelocity) -> None: ...
    @overload
    def __setitem__(self, place: slice, value: Iterable[InitialVelocity]) -> None: ...
    def __delitem__(self, place: Union[int, slice]) -> None: ...
    def insert(self, index: int, value: InitialVelocity) -> None: ...

class InitialStresses(MutableSequence[InitialStress]):
    """A list of InitialStress."""
    def __init__(self, items: Iterable[InitialStress] = ...) -> None: ...
    def __len__(self) -> int: ...
    @overload
    def __getitem__(self, place: int) -> InitialStress: ...
    @overload
    def __getitem__(self, place: slice) -> list[InitialStress]: ...
    @overload
    def __setitem__(self, place: int, value: InitialStress) -> None: ...
    @overload
    def __setitem__(self, place: slice, value: Iterable[InitialStress]) -> None: ...
    def __delitem__(self, place: Union[int, slice]) -> None: ...
    def insert(self, index: int, value: InitialStress) -> None: ...

class Probes(MutableSequence[Probe]):
    """A list of Probe."""
    def __init__(self, items: Iterable[Probe] = ...) -> None: ...
    def __len__(self) -> int: ...
    @overload
    def __getitem__(self, place: int) -> Probe: ...
    @overload
    def __getitem__(self, place: slice) -> list[Probe]: ...
    @overload
    def __setitem__(self, place: int, value: Probe) -> None: ...
    @overload
    def __setitem__(self, place: slice, value: Iterable[Probe]) -> None: ...
    def __delitem__(self, place: Union[int, slice]) -> None: ...
    def insert(self, index: int, value: Probe) -> None: ...

class SceneOverrides:
    """What the command line adds to a scene file."""
    def __init__(self, *, set: Sequence[str] = ..., refine: int = ..., precision: Optional[Union[Precision, str]] = ..., vary: Sequence[str] = ...) -> None: ...
    set: Field[list[str], Sequence[str]]
    """"KEY=VALUE", in order"""
    refine: int
    """times as many elements along each direction"""
    precision: Field[Optional[Precision], Optional[Union[Precision, str]]]
    """in place of the scene's; None: that"""
    vary: Field[list[str], Sequence[str]]
    """as set, and after it"""

class SceneSource:
    """What a scene was read from."""
    def __init__(self, *, path: str = ..., text: str = ..., overrides: SceneOverrides = ...) -> None: ...
    path: str
    """of the file"""
    text: str
    """of the file when it was read"""
    overrides: SceneOverrides
    """what was added to it"""

class Scene:
    """What is to be run: the fields are those of a scene file."""
    def __init__(self, *, name: str = ..., path: str = ..., title: str = ..., units: str = ..., precision: Union[Precision, str] = ..., device: Union[Device, str] = ..., refine: int = ..., of_deck: bool = ..., time: TimeSettings = ..., element: ElementSettings = ..., contact: ContactSettings = ..., contact_pairs: Union[ContactPairs, list[ContactPair]] = ..., tied_contacts: Union[TiedContacts, list[TiedContact]] = ..., skip: SkipSettings = ..., guard: GuardSettings = ..., output: OutputSettings = ..., materials: Union[Materials, list[Material]] = ..., bodies: Union[Bodies, list[Body]] = ..., rigid_bodies: Union[RigidBodies, list[RigidBody]] = ..., attached_nodes: Union[AttachedNodesList, list[AttachedNodes]] = ..., rigid_motions: Union[RigidMotions, list[RigidMotion]] = ..., joints: Union[Joints, list[Joint]] = ..., symmetry_planes: Union[SymmetryPlanes, list[SymmetryPlane]] = ..., fixed: Union[FixedConstraints, list[Fixed]] = ..., equation_terms: Union[EquationTerms, list[EquationTerm]] = ..., rigid_walls: Union[RigidWalls, list[RigidWall]] = ..., prescribed_velocities: Union[PrescribedVelocities, list[PrescribedVelocity]] = ..., loads: Union[Loads, list[Load]] = ..., pressures: Union[Pressures, list[Pressure]] = ..., gravities: Union[Gravities, list[Gravity]] = ..., point_masses: Union[PointMasses, list[PointMass]] = ..., initial_velocities: Union[InitialVelocities, list[InitialVelocity]] = ..., initial_stresses: Union[InitialStresses, list[InitialStress]] = ..., damping: float = ..., probes: Union[Probes, list[Probe]] = ..., source: Optional[SceneSource] = ...) -> None: ...
    name: str
    """of the file, without folder and ending"""
    path: str
    """the file it was read from"""
    title: str
    """one line for people"""
    units: str
    """name of the consistent set of units, such as "in-lbf-s" (above)"""
    precision: Field[Precision, Union[Precision, str]]
    """of numbers; "mixed": of elements single, of all else double precision; --precision overrides it"""
    device: Field[Device, Union[Device, str]]
    """where steps are made: of no file"""
    refine: int
    """already in the numbers of elements"""
    of_deck: bool
    """of a deck that says nothing of contact"""
    time: TimeSettings
    """how long, and in which steps"""
    element: ElementSettings
    """what elements do beside their material"""
    contact: ContactSettings
    """what happens where bodies meet"""
    contact_pairs: Field[ContactPairs, Union[ContactPairs, list[ContactPair]]]
    """contact.pair: what may touch what; none: all touches all"""
    tied_contacts: Field[TiedContacts, Union[TiedContacts, list[TiedContact]]]
    """contact.tied: nodes that move with faces"""
    skip: SkipSettings
    """work that may be left out"""
    guard: GuardSettings
    """when a run stops because something is wrong"""
    output: OutputSettings
    """what a run leaves"""
    materials: Field[Materials, Union[Materials, list[Material]]]
    """what bodies are of"""
    bodies: Field[Bodies, Union[Bodies, list[Body]]]
    """what moves"""
    rigid_bodies: Field[RigidBodies, Union[RigidBodies, list[RigidBody]]]
    """bodies that do not deform"""
    attached_nodes: Field[AttachedNodesList, Union[AttachedNodesList, list[AttachedNodes]]]
    """nodes that move with a rigid body"""
    rigid_motions: Field[RigidMotions, Union[RigidMotions, list[RigidMotion]]]
    """rigid bodies that move as given"""
    joints: Field[Joints, Union[Joints, list[Joint]]]
    """how rigid bodies move with each other"""
    symmetry_planes: Field[SymmetryPlanes, Union[SymmetryPlanes, list[SymmetryPlane]]]
    """nodes on a plane do not move across it"""
    fixed: Field[FixedConstraints, Union[FixedConstraints, list[Fixed]]]
    """nodes do not move along some directions"""
    equation_terms: Field[EquationTerms, Union[EquationTerms, list[EquationTerm]]]
    """displacements that add up to zero"""
    rigid_walls: Field[RigidWalls, Union[RigidWalls, list[RigidWall]]]
    """planes that nodes do not cross"""
    prescribed_velocities: Field[PrescribedVelocities, Union[PrescribedVelocities, list[PrescribedVelocity]]]
    """nodes that move as given"""
    loads: Field[Loads, Union[Loads, list[Load]]]
    """forces on nodes"""
    pressures: Field[Pressures, Union[Pressures, list[Pressure]]]
    """on faces of elements"""
    gravities: Field[Gravities, Union[Gravities, list[Gravity]]]
    """accelerations of bodies"""
    point_masses: Field[PointMasses, Union[PointMasses, list[PointMass]]]
    """at nodes, beside those of elements"""
    initial_velocities: Field[InitialVelocities, Union[InitialVelocities, list[InitialVelocity]]]
    """of nodes, in place of their body's"""
    initial_stresses: Field[InitialStresses, Union[InitialStresses, list[InitialStress]]]
    """of elements at the start"""
    damping: float
    """damping.mass [1/time]"""
    probes: Field[Probes, Union[Probes, list[Probe]]]
    """history of a node or an element"""
    source: Optional[SceneSource]
    """of a scene that was read, None of one that was made"""

class Energies:
    """Energies of the whole model [energy]."""
    @property
    def kinetic(self) -> float:
        """of the masses of nodes"""
    @property
    def kinetic_below_zero(self) -> float:
        """of the kinetic energy, reported apart"""
    @property
    def internal(self) -> float:
        """elastic and plastic, of elements that are there"""
    @property
    def hourglass(self) -> float:
        """of the forces against hourglass modes"""
    @property
    def hourglass_plastic(self) -> float:
        """part of internal"""
    @property
    def bulk_viscosity(self) -> float:
        """dissipated"""
    @property
    def folding(self) -> float:
        """stored by corners that are about to turn over"""
    @property
    def contact_stored(self) -> float:
        """elastic, in the springs"""
    @property
    def contact_damped(self) -> float:
        """dissipated"""
    @property
    def eroded(self) -> float:
        """of elements that are no longer there"""
    @property
    def external(self) -> float:
        """work done on the model"""
    @property
    def contact(self) -> float:
        """stored and damped"""
    @property
    def total(self) -> float:
        """of all these, less the work done on the model"""

class ProbeValue:
    """What one quantity of a probe is."""
    @property
    def quantity(self) -> str:
        """"velocity_x\""""
    @property
    def value(self) -> float:
        """in the units of the scene"""

class ProbeResult:
    """What a probe watches, and what it sees."""
    @property
    def name(self) -> str:
        """as in the scene"""
    @property
    def body(self) -> str:
        """the name of the body that is watched"""
    @property
    def number(self) -> int:
        """of the node or element, in the order of the scene"""
    @property
    def element(self) -> bool:
        """whether it is an element"""
    @property
    def point(self) -> list[float]:
        """where that was at the start [length]"""
    @property
    def values(self) -> list[ProbeValue]:
        """a ProbeValue for each quantity"""
    def __getitem__(self, quantity: str) -> float:
        """A value by its quantity: probe["velocity_x"]."""

class BodyResult:
    """What has become of a body."""
    @property
    def name(self) -> str:
        """as in the scene"""
    @property
    def elements(self) -> int:
        """how many it began with"""
    @property
    def eroded_elements(self) -> int:
        """how many of these are no longer there"""
    @property
    def mass_initial(self) -> float:
        """[mass]"""
    @property
    def mass_remaining(self) -> float:
        """without eroded elements [mass]"""
    @property
    def mass_added(self) -> float:
        """of mass_initial, for the step [mass]"""
    @property
    def velocity(self) -> list[float]:
        """mean [length/time]"""
    @property
    def max_plastic_strain(self) -> float:
        """[-]"""

class HistoryRow:
    """One row of history.csv."""
    @property
    def step(self) -> int:
        """steps made before it"""
    @property
    def time(self) -> float:
        """[time]"""
    @property
    def dt(self) -> float:
        """[time]"""
    @property
    def energy(self) -> Energies:
        """of all elements and nodes"""
    @property
    def inside_out(self) -> int:
        """elements with a corner that has turned over"""
    @property
    def balance_error(self) -> float:
        """of the energies, relative [-]"""
    @property
    def momentum(self) -> list[float]:
        """[mass length/time]"""
    @property
    def bodies(self) -> list[BodyResult]:
        """a BodyResult for each body"""
    @property
    def more(self) -> list[float]:
        """of walls and probes: Simulation.history_columns()"""

class Simulation:
    """A scene being run. Writes no files but save_checkpoint(). Pickles and copies go on with the same bits; callbacks are no part of them."""
    def __init__(self, scene: Scene, threads: int = ...) -> None:
        """threads: results are the same bits for any number; 0: OMP_NUM_THREADS, else what the size earns."""
    def step(self) -> bool:
        """One step. Returns whether there is more to do."""
    def run_until(self, time: float) -> bool:
        """Steps until the time is reached; no step is cut for it. Returns whether there is more to do."""
    def run(self) -> bool:
        """Steps to the end. Returns False where a callback has stopped the run."""
    def on_step(self, callback: Callable[..., object]) -> None:
        """callback(simulation) after each step and once at the end; what returns False stops the run."""
    @property
    def complete(self) -> bool:
        """whether all is at one time, at the end"""
    @property
    def time(self) -> float:
        """of the positions [time]"""
    @property
    def state_time(self) -> float:
        """of stresses and energies [time]"""
    @property
    def dt(self) -> float:
        """the last step [time]"""
    @property
    def steps(self) -> int:
        """made so far"""
    @property
    def threads(self) -> int:
        """as given"""
    @property
    def scene(self) -> Scene:
        """A copy of the scene as it is run, with every default."""
    @property
    def energies(self) -> Energies:
        """at state_time"""
    @property
    def balance_error(self) -> float:
        """of the energies, relative [-]"""
    @property
    def bodies(self) -> list[BodyResult]:
        """a BodyResult for each body"""
    @property
    def probes(self) -> list[ProbeResult]:
        """a ProbeResult for each probe, at state_time"""
    @property
    def state_hash(self) -> int:
        """of positions, velocities and stresses"""
    def history_row(self) -> HistoryRow:
        """The present state as a row of history.csv."""
    def history_columns(self) -> list[str]:
        """names of HistoryRow.more"""
    def summary(self) -> Any:
        """What summary.json holds, as a dictionary."""
    @property
    def nodes(self) -> int:
        """number of nodes of all bodies"""
    @property
    def elements(self) -> int:
        """number of elements of all bodies"""
    def nodes_of(self, body: str) -> slice:
        """The numbers of a body's nodes, as a slice, but for those that it shares with an earlier body of its file."""
    def elements_of(self, body: str) -> slice:
        """The numbers of a body's elements, as a slice."""
    @property
    def positions(self) -> npt.NDArray[Any]:
        """(nodes, 3), the solver's own, in its order: node n of the scene is positions[place_of_node[n]] [length]."""
    @property
    def velocities(self) -> npt.NDArray[Any]:
        """(nodes, 3), the solver's own, in its order [length/time]."""
    @property
    def masses(self) -> npt.NDArray[Any]:
        """(nodes,), the solver's own, in its order [mass]."""
    @property
    def plastic_strains(self) -> npt.NDArray[Any]:
        """(places,), the solver's own: element e of the scene is plastic_strains[place_of_element[e]] [-]."""
    @property
    def place_of_node(self) -> npt.NDArray[Any]:
        """(nodes,), places in the solver's arrays of nodes, in the order of the scene."""
    @property
    def place_of_element(self) -> npt.NDArray[Any]:
        """(elements,), places in the solver's arrays of elements, in the order of the scene."""
    def velocities_to_change(self) -> npt.NDArray[Any]:
        """The velocities, (nodes, 3), to be written before the next step; to be asked for again before each change."""
    def external_forces(self) -> npt.NDArray[Any]:
        """Forces on the nodes, (nodes, 3), that are added in every step, zero until they are written [force]."""
    def position(self, out: Optional[npt.NDArray[Any]] = ...) -> npt.NDArray[Any]:
        """Copy of the positions, (nodes, 3) in the order of the scene [length]."""
    def velocity(self, out: Optional[npt.NDArray[Any]] = ...) -> npt.NDArray[Any]:
        """Copy of the velocities, (nodes, 3) in the order of the scene [length/time]."""
    def mass(self, out: Optional[npt.NDArray[Any]] = ...) -> npt.NDArray[Any]:
        """Copy of the masses, (nodes,) in the order of the scene [mass]."""
    def initial_position(self, out: Optional[npt.NDArray[Any]] = ...) -> npt.NDArray[Any]:
        """Copy of where the nodes began, (nodes, 3) in the order of the scene [length]."""
    def stress(self, out: Optional[npt.NDArray[Any]] = ...) -> npt.NDArray[Any]:
        """Copy of the stresses, (elements, 6): xx yy zz xy yz zx, in the order of the scene [stress]."""
    def plastic_strain(self, out: Optional[npt.NDArray[Any]] = ...) -> npt.NDArray[Any]:
        """Copy of the effective plastic strains, (elements,) in the order of the scene [-]."""
    def element_mass(self, out: Optional[npt.NDArray[Any]] = ...) -> npt.NDArray[Any]:
        """Copy of the masses, (elements,) in the order of the scene, 0 once eroded [mass]."""
    def save_checkpoint(self, path: str) -> None:
        """Writes a file from which `pinball run --restart` and Simulation.from_checkpoint go on with the same bits; of scenes that were read and not changed."""
    @staticmethod
    def from_checkpoint(path: str, threads: int = ..., set: Sequence[str] = ..., device: Union[Device, str] = ...) -> Simulation:
        """The simulation of a checkpoint, also of one that `pinball run` has written; set: "KEY=VALUE" of time.end, time.steps, time.cfl, output.* or guard.*"""

class ContactResult:
    """What contact has done in a step."""
    @property
    def stored(self) -> float:
        """energy in the penalty springs now [energy]"""
    @property
    def dissipated(self) -> float:
        """since creation [energy]"""
    @property
    def eroded(self) -> float:
        """of springs that went with elements, since creation [energy]"""
    @property
    def damped_power(self) -> float:
        """of the damping now [power]"""
    @property
    def penetration_ratio(self) -> float:
        """largest, over the size of its pair [-]"""
    @property
    def pairs(self) -> int:
        """that push"""
    @property
    def listed_pairs(self) -> int:
        """that are looked at in each step"""
    @property
    def surface_elements(self) -> int:
        """elements and spheres with an exposed face"""
    @property
    def searches(self) -> int:
        """since creation"""
    @property
    def searches_skipped(self) -> int:
        """steps whose lists still held"""
    @property
    def frequency2(self) -> float:
        """bound on the square of the contact frequency [1/time^2]"""
    @property
    def stable_step(self) -> float:
        """2 / sqrt(frequency2) [time]"""

class Contact:
    """Pinball contact in a time loop of the caller's (contact.h, docs/embedding.md): each step one update() and one add_forces(). Numbers are all float64 or all float32."""
    def __init__(self, position: npt.NDArray[Any], mass: object, corners: Optional[object] = ..., body: Optional[object] = ..., bulk_modulus: Optional[object] = ..., part: Optional[object] = ..., element_mass: Optional[object] = ..., element_volume: Optional[object] = ..., hidden_faces: Optional[object] = ..., sphere_node: Optional[object] = ..., sphere_radius: Optional[object] = ..., sphere_bulk_modulus: Optional[object] = ..., sphere_body: Optional[object] = ..., held_node: Optional[object] = ..., held_direction: Optional[object] = ..., **kwargs: Any) -> None:
        """position: (nodes, 3), undeformed [length]; mass: (nodes,) [mass]; corners: (elements, 8), int32 or int64; body, part: (elements,); bulk_modulus: (elements,) or (parts,) [stress]; sphere_*: (spheres,); held_node: (held,), held_direction: (held, 3). Spheres meet the faces of elements, whatever their radius; with gap = 'pinball' the balls of elements, between which small ones fall. Options by name: method, enforcement, gap, radius (texts), beta, damping, friction, static_friction, radius_factor, skin, self, keep_lists, threads, first_index. Arrays of the right type without gaps are used where they lie and have to stay unchanged; others are copied."""
    def update(self, position: npt.NDArray[Any], velocity: npt.NDArray[Any], dt_before: float, alive: Optional[object] = ..., sphere_alive: Optional[object] = ...) -> None:
        """position: (nodes, 3) at t_n [length]; velocity: (nodes, 3) in the middle of the last step [length/time]; dt_before: its length, 0 in the first [time]; alive: (elements,), 0 once eroded. Nothing is copied."""
    def add_forces(self, force: npt.NDArray[Any], dt_after: float) -> ContactResult:
        """Adds to force: (nodes, 3) [force]; dt_after: length of the coming step, 0 in the last [time]. Returns a ContactResult."""

def read_scene(scene: str, set: Sequence[str] = ..., refine: int = ...) -> Scene:
    """Reads a scene file, or a scene of data/scenes by name; set: "KEY=VALUE" as on the command line."""

def run_recorded(scene: Scene, out: str, checkpoint_every: int = ..., threads: int = ...) -> Any:
    """Runs a scene as `pinball run` does, with history.csv, fields, summary.json and the page in the folder out. checkpoint_every: steps between checkpoints, 0: none; of scenes that were read and not changed. threads: as of Simulation. Ctrl-C leaves all files of the run so far. Returns what summary.json holds."""

def restart_recorded(checkpoint: str, out: str = ..., set: Sequence[str] = ..., checkpoint_every: int = ..., device: Union[Device, str] = ..., threads: int = ...) -> Any:
    """Goes on as `pinball run --restart` does; out: empty: the folder of the checkpoint."""
