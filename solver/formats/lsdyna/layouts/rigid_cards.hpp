#pragma once

#include "definition_cards.hpp"
#include "mesh_cards.hpp"

/// *MAT_RIGID, *CONSTRAINED_RIGID_BODIES, and what *PART_INERTIA has behind the card of *PART.
namespace pinball::layout {

inline constexpr std::string_view not_coupled = "no other program moves bodies: leave it blank",
                                  own_system = "rigid bodies are written in the global system";
inline constexpr CardLayout rigid{material_id,
                                  density,
                                  young,
                                  poisson,
                                  number("N").rejected(not_coupled),
                                  number("COUPLE").rejected(not_coupled),
                                  number("M").rejected(not_coupled),
                                  text("ALIAS").rejected("bodies have the faces of their solids: leave it blank")};
inline constexpr CardLayout rigid_held{number("CMO").from(-1, 1), whole("CON1"), whole("CON2")};
inline constexpr CardLayout rigid_system{number("LCO").reported(own_system), number("A2").reported(own_system),
                                         number("A3").reported(own_system),  number("V1").reported(own_system),
                                         number("V2").reported(own_system),  number("V3").reported(own_system)};

inline constexpr CardLayout merged_parts{whole("PIDM").always(), whole("PIDS").always(), whole("IFLAG").from(0, 1)};

inline constexpr std::string_view of_inertia = "it counts beside *PART_INERTIA alone";
inline constexpr CardLayout attached_node{whole("PID").always(), whole("NID").always(),
                                          whole("IFLAG").reported(of_inertia)};
inline constexpr CardLayout attached_set{whole("PID").always(), whole("NSID").always(),
                                         whole("IFLAG").reported(of_inertia)};

inline constexpr std::string_view of_bodies_output = "of output", no_release = "leave it 0: all of it moves as one";
inline constexpr CardLayout nodal_rigid{whole("PID").always(),
                                        whole("CID").reported(of_bodies_output),
                                        whole("NSID"),
                                        whole("PNODE").reported(of_bodies_output),
                                        whole("IPRT").reported(of_bodies_output),
                                        whole("DRFLAG").rejected(no_release),
                                        whole("RRFLAG").rejected(no_release)};

inline constexpr std::string_view kept_exactly = "joints are kept without penalty and damping";
inline constexpr CardLayout joint_number{whole("JID"), text("HEADING").columns(70)};
inline constexpr std::string_view from_start = "what the joint keeps of directions it keeps from the start";
inline constexpr CardLayout joint_pair{whole("N1").always(),
                                       whole("N2").always(),
                                       whole("N3").reported(from_start),
                                       whole("N4").reported(from_start),
                                       whole("N5").reported(from_start),
                                       whole("N6").reported(from_start),
                                       number("RPS", 1.0).reported(kept_exactly),
                                       number("DAMP", 1.0).reported(kept_exactly)};
inline constexpr CardLayout joint_pairs{whole("N1").always(),
                                        whole("N2").always(),
                                        whole("N3").always(),
                                        whole("N4").always(),
                                        whole("N5").reported(from_start),
                                        whole("N6").reported(from_start),
                                        number("RPS", 1.0).reported(kept_exactly),
                                        number("DAMP", 1.0).reported(kept_exactly)};

inline constexpr CardLayout part_inertia{
    number("XC"), number("YC"), number("ZC"), number("TM").always(), whole("IRCS").from(0, 1), whole("NODEID")};
inline constexpr CardLayout part_moments{number("IXX"), number("IXY"), number("IXZ"),
                                         number("IYY"), number("IYZ"), number("IZZ")};
inline constexpr CardLayout part_velocity{number("VTX"), number("VTY"), number("VTZ"),
                                          number("VRX"), number("VRY"), number("VRZ")};
inline constexpr CardLayout part_system{number("XL"),   number("YL"),   number("ZL"), number("XLIP"),
                                        number("YLIP"), number("ZLIP"), whole("CID")};

}  // namespace pinball::layout
