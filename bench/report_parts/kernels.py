"""The kernels of a step: where they are in the program, which timer shows them, and what they work on."""

from dataclasses import dataclass
from typing import Callable, Optional


@dataclass
class Kernel:
    key: str
    title: str
    item: str  # what times and operations are given for
    method: str  # which benchmark has it
    stage: str  # names the counters of bench_kernels: seconds_STAGE, items_STAGE, bytes_STAGE, lanes_STAGE
    symbols: list  # patterns for demangled names of gcc's functions
    mangled: list  # the same for clang's
    contact: bool = False  # a contact kernel of pinball: the aim of the speed-up is for these
    # Operations of an item by hand, where loops of unknown length keep them from being counted in the machine code
    by_hand: Optional[Callable] = None
    by_hand_text: str = ""


def pair_operations(work):
    return 13 + 170 * work["pairs_in_contact"] / work["items"]


def meeting_operations(work):
    return 30.0 * work["entries"] / work["items"]


MEETING_TEXT = ("at least the 30 of the test against each ball that ends in a list (kernels/ball_tree.hpp); balls that fail "
                "the test, and boxes, are not counted")
KERNELS = [
    Kernel("element_update", "element update", "element", "pinball", "internal_forces",
           [r"update_tile<double, double, pinball::ElementFeatures\{true, true, true, \(pinball::HourglassKind\)2, "
            r"\(pinball::YieldLaw\)0, true\}>"],
           [r"update_tileIddXtlNS_15ElementFeaturesELb1ELb1ELb1ELNS_13HourglassKindE2ELNS_8YieldLawE0ELb1EE"]),
    Kernel("pinball_geometry", "pinball centres and normals", "listed pinball", "pinball", "pinballs",
           [r"UpdatePinballs<.*\bdouble\b.*, false>.*::work\("], [r"14UpdatePinballsI(NSt.*4simdId|d).*Lb0E"], contact=True),
    Kernel("list_check", "do the lists still hold", "surface node", "pinball", "list_check",
           [r"NodesStray<.*\bdouble\b.*::work\("], [r"10NodesStrayI(NSt.*4simdId|d)"], contact=True,
           by_hand=lambda work: 14.0,
           by_hand_text="14: distance of a node from where it is expected (kernels/straying.hpp)"),
    Kernel("list_building", "pair list, when built", "pinball", "pinball", "list_building",
           [r"PairList<double>::(build|collect_references|find|leave_out|leave_out_neighbours|append|mark|number|remember|"
            r"recall)\(", r"(BallTree|MovingBalls|NearBalls)<double>::",
            r"SurfaceMotion<double>::(adapt|start)\(", r"PinballAlgorithm<double>::(build_list|collect_listed)\("],
           [r"PairListIdE(5build|18collect_references|4find|9leave_out|20leave_out_neighbours|6append|4mark|6number|8remember|"
            r"6recall)E", r"(BallTree|MovingBalls|NearBalls)IdE",
            r"SurfaceMotionIdE(5adapt|5start)E", r"PinballAlgorithmIdE(10build_list|14collect_listed)E"], contact=True,
           by_hand=meeting_operations, by_hand_text=MEETING_TEXT),
    Kernel("pair_forces", "contact pair forces", "listed pair", "pinball", "contact_forces",
           [r"PairForces<double>::(compute|compute_piece|compute_pack)\("],
           [r"PairForcesIdE(7compute|13compute_piece|12compute_pack)E"], contact=True,
           by_hand=pair_operations,
           by_hand_text="13 for the test of a listed pair (distance, reach), about 170 for a pair in contact"),
    Kernel("contact_scatter", "contact scatter", "listed pinball", "pinball", "contact_scatter",
           [r"HostPinballs<double>::add_forces.*(omp_fn|operator\(\)|::work\()"], [r"HostPinballsIdE10add_forces"], contact=True,
           by_hand=lambda work: 72.0 * min(1.0, work["touching"] / work["items"]),
           by_hand_text="8 nodes x (4 products and sums of the force, 1 product of the bound on the frequency), 72, of each "
                        "pinball in contact"),
    Kernel("node_update", "node update", "node", "pinball", "integration",
           [r"integrate_nodes<double>.*(omp_fn|operator\(\)|::work\()"], [r"15integrate_nodesIdE"]),
    Kernel("segment_update", "slideline: segments", "segment", "slideline", "pinballs",
           [r"SegmentSurface<double>::update\(pinball::SurfaceSource<double> const&\)::\{lambda"],
           [r"SegmentSurfaceIdE6update"]),
    Kernel("slideline_search", "slideline: lists, when built", "slave node", "slideline", "list_building",
           [r"SlidelineSearch<double>::(build|find|may_touch|move_segments|move_slaves)\(",
            r"(BallTree|MovingBalls|NearBalls)<double>::", r"SurfaceMotion<double>::(adapt|start)\("],
           [r"SlidelineSearchIdE(5build|4find|9may_touch|13move_segments|11move_slaves)E",
            r"(BallTree|MovingBalls|NearBalls)IdE", r"SurfaceMotionIdE(5adapt|5start)E"],
           by_hand=meeting_operations, by_hand_text=MEETING_TEXT),
    Kernel("narrow_phase", "slideline: projection and forces", "candidate", "slideline", "contact_forces",
           [r"find_touches<pinball::SlidelineAlgorithm<double>::spring_forces", r"SlidelineAlgorithm<double>::(find_segment|"
            r"penalty_force)\("],
           [r"SlidelineAlgorithmIdE(12find_touches|12find_segment|13penalty_force)"],
           by_hand=lambda work: 9.0 + 550.0 * work["pairs_in_contact"] / work["items"],
           by_hand_text="9 for the sphere of every candidate, about 550 for a node in contact (three Newton iterations of "
                        "120, foot, normal and weights 120, spring 70)"),
]
# Packs of W items go through the whole machine code of a kernel once, where nothing was derived by hand; the node update
# has one node in each pass of its loop.
ONE_ITEM_A_PASS = {"node_update"}
