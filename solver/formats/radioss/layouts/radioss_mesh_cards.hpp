#pragma once

#include "radioss_common.hpp"

/// Nodes, elements, parts, and groups of them.
namespace pinball::radioss {

inline constexpr std::string_view no_axes_of_shells = "rigid shells have no axes";

inline constexpr CardLayout node{whole("node_ID").always(), real("Xc"), real("Yc"), real("Zc")};
inline constexpr CardLayout brick{whole("brick_ID").always(), whole("node_ID1"), whole("node_ID2"),
                                  whole("node_ID3"),          whole("node_ID4"), whole("node_ID5"),
                                  whole("node_ID6"),          whole("node_ID7"), whole("node_ID8")};
inline constexpr CardLayout penta6{whole("penta_ID").always(), whole("node_ID1"), whole("node_ID2"), whole("node_ID3"),
                                   whole("node_ID4"),          whole("node_ID5"), whole("node_ID6")};
inline constexpr CardLayout tetra4{whole("tetra_ID").always(), whole("node_ID1"), whole("node_ID2"), whole("node_ID3"),
                                   whole("node_ID4")};
inline constexpr CardLayout tetra10{whole("tetra_ID").always()};
inline constexpr CardLayout tetra10_nodes{whole("node_ID1"), whole("node_ID2"), whole("node_ID3"), whole("node_ID4"),
                                          whole("node_ID5"), whole("node_ID6"), whole("node_ID7"), whole("node_ID8"),
                                          whole("node_ID9"), whole("node_ID10")};
inline constexpr CardLayout bric20{whole("bric_ID").always(), whole("node_ID1"), whole("node_ID2"),
                                   whole("node_ID3"),         whole("node_ID4"), whole("node_ID5"),
                                   whole("node_ID6"),         whole("node_ID7"), whole("node_ID8")};
inline constexpr CardLayout bric20_edges{whole("node_ID9"),  whole("node_ID10"), whole("node_ID11"),
                                         whole("node_ID12"), whole("node_ID13"), whole("node_ID14"),
                                         whole("node_ID15"), whole("node_ID16")};
inline constexpr CardLayout bric20_more{whole("node_ID17"), whole("node_ID18"), whole("node_ID19"), whole("node_ID20")};
inline constexpr CardLayout shell{whole("shell_ID").always(),
                                  whole("node_ID1"),
                                  whole("node_ID2"),
                                  whole("node_ID3"),
                                  whole("node_ID4"),
                                  blank(10),
                                  real("Phi").reported(no_axes_of_shells),
                                  real("Thick").at_least(0)};
inline constexpr CardLayout sh3n{whole("sh3n_ID").always(), whole("node_ID1"), whole("node_ID2"),
                                 whole("node_ID3"),         blank(20),         real("Phi").reported(no_axes_of_shells),
                                 real("Thick").at_least(0)};
inline constexpr CardLayout part{whole("prop_ID").always(), whole("mat_ID").always(), whole("subset_ID").at_least(0),
                                 real("Thick").reported(of_shells),
                                 whole("Irigid").rejected("give an /RBODY of the nodes of the part")};
inline constexpr CardLayout ranges{whole("Ifirst"), whole("Ilast")};
inline constexpr CardLayout range_steps{whole("Ifirst"), whole("Ilast"), whole("Iincr", 1)};
inline constexpr CardLayout segment{whole("seg_ID").reported("segments need no numbers"), whole("node_ID1"),
                                    whole("node_ID2"), whole("node_ID3"), whole("node_ID4")};
inline constexpr CardLayout box_system{whole("N1").rejected("give the corners by their coordinates"),
                                       whole("N2").rejected("give the corners by their coordinates"),
                                       whole("Iskew").rejected("give a box along the axes")};
inline constexpr CardLayout box_low{real("Xp1"), real("Yp1"), real("Zp1")};
inline constexpr CardLayout box_high{real("Xp2"), real("Yp2"), real("Zp2")};
inline constexpr CardLayout axes_origin{real("Ox").reported("vectors have no place"),
                                        real("Oy").reported("vectors have no place"),
                                        real("Oz").reported("vectors have no place")};
inline constexpr CardLayout frame_origin{real("Ox"), real("Oy"), real("Oz")};
inline constexpr CardLayout axes_y{real("X1"), real("Y1"), real("Z1")};
inline constexpr CardLayout axes_z{real("X2"), real("Y2"), real("Z2")};
inline constexpr CardLayout function_point{real("X").always(), real("Y").always()};

}  // namespace pinball::radioss
