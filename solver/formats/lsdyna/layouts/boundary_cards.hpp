#pragma once

#include "common_fields.hpp"

/// *BOUNDARY_..., *INITIAL_VELOCITY..., *INITIAL_STRESS_SOLID..., *RIGIDWALL_PLANAR..., *LOAD_...,
/// *DATABASE_HISTORY_...
namespace pinball::layout {

constexpr CardLayout held(std::string_view target) {
  return {whole(target).always(),
          whole("CID"),
          whole("DOFX").from(0, 1),
          whole("DOFY").from(0, 1),
          whole("DOFZ").from(0, 1),
          whole("DOFRX").reported(no_rotations),
          whole("DOFRY").reported(no_rotations),
          whole("DOFRZ").reported(no_rotations)};
}
inline constexpr CardLayout held_node = held("NID"), held_set = held("NSID");
inline constexpr CardLayout held_span{number("BIRTH"), number("DEATH", 1e20).at_least(0)};

constexpr CardLayout motion(std::string_view target) {
  return {whole(target).always(),
          whole("DOF").always(),
          whole("VAD"),
          whole("LCID").always(),
          number("SF", 1),
          whole("VID"),
          number("DEATH", 1e28).at_least(0),
          number("BIRTH")};
}
inline constexpr CardLayout motion_node = motion("NID"), motion_set = motion("NSID"), motion_part = motion("PID");

inline constexpr CardLayout velocity_nodes{whole("NSID"), whole("NSIDEX"), whole("BOXID"), whole("IRIGID"),
                                           whole("ICID")};
inline constexpr CardLayout velocity{number("VX"),    number("VY"),    number("VZ"),
                                     rotation("VXR"), rotation("VYR"), rotation("VZR")};
inline constexpr CardLayout velocity_exempt{number("VXE"),    number("VYE"),    number("VZE"),
                                            rotation("VXRE"), rotation("VYRE"), rotation("VZRE")};
inline constexpr CardLayout velocity_node{whole("NID").always(), number("VX"),    number("VY"),    number("VZ"),
                                          rotation("VXR"),       rotation("VYR"), rotation("VZR"), whole("ICID")};
inline constexpr CardLayout velocity_generation{whole("ID"),  whole("STYP"), number("OMEGA"),           number("VX"),
                                                number("VY"), number("VZ"),  whole("IVATN").from(0, 1), whole("ICID")};
inline constexpr CardLayout velocity_axis{number("XC"),
                                          number("YC"),
                                          number("ZC"),
                                          number("NX"),
                                          number("NY"),
                                          number("NZ"),
                                          whole("PHASE").rejected("velocities are those of the start"),
                                          whole("IRIGID")};
inline constexpr CardLayout velocity_rigid{whole("PID").always(), number("VX"),  number("VY"),  number("VZ"),
                                           number("VXR"),         number("VYR"), number("VZR"), whole("ICID")};

constexpr CardLayout stress_of(std::string_view target) {
  return {whole(target).always(),
          whole("NINT", 1).from(1, 27),
          whole("NHISV").at_least(0),
          whole("LARGE").from(0, 1),
          whole("IVEFLG").from(0, 1),
          whole("IALEGP").reported("of ALE"),
          whole("NTHINT").rejected(of_thermal),
          whole("NTHHSV").reported(of_thermal)};
}
inline constexpr CardLayout stress_element = stress_of("EID"), stress_set = stress_of("SID");
inline constexpr CardLayout stress_point{number("SIGXX"), number("SIGYY"), number("SIGZZ"),          number("SIGXY"),
                                         number("SIGYZ"), number("SIGZX"), number("EPS").at_least(0)};
constexpr CardField long_number(std::string_view name) { return number(name).columns(16); }
inline constexpr std::string_view of_law = "history variables are their law's own";
inline constexpr CardLayout stress_long{long_number("SIGXX"), long_number("SIGYY"), long_number("SIGZZ"),
                                        long_number("SIGXY"), long_number("SIGYZ")};
inline constexpr CardLayout stress_long_more{
    long_number("SIGZX"), long_number("EPS").at_least(0), long_number("HISV1").reported(of_law),
    long_number("HISV2").reported(of_law), long_number("HISV3").reported(of_law)};

inline constexpr CardLayout wall_nodes{whole("NSID"),
                                       whole("NSIDEX"),
                                       whole("BOXID"),
                                       number("OFFSET").reported("nodes further from the wall are looked at, too"),
                                       number("BIRTH"),
                                       number("DEATH", 1e20).at_least(0),
                                       number("RWKSF", 1).reported("walls have no penalty stiffness")};
inline constexpr CardLayout wall_plane{
    number("XT"), number("YT"), number("ZT"),   number("XH"),
    number("YH"), number("ZH"), number("FRIC"), number("WVEL").reported("of nodes that stick (FRIC 2 and 3)")};
inline constexpr CardLayout wall_rectangle{number("XHEV"), number("YHEV"), number("ZHEV"), number("LENL"),
                                           number("LENM")};
inline constexpr CardLayout wall_mass{number("MASS"), number("V0")};

inline constexpr std::string_view follower = "of forces that turn with their nodes, which are not there";
constexpr CardLayout node_load(std::string_view target) {
  return {whole(target).always(),
          whole("DOF").always(),
          whole("LCID").always(),
          number("SF", 1),
          whole("CID"),
          whole("M1").reported(follower),
          whole("M2").reported(follower),
          whole("M3").reported(follower)};
}
inline constexpr CardLayout load_node = node_load("NID"), load_node_set = node_load("NSID");
inline constexpr CardLayout load_segment{whole("LCID").always(),
                                         number("SF", 1),
                                         number("AT").at_least(0),
                                         whole("N1"),
                                         whole("N2"),
                                         whole("N3"),
                                         whole("N4"),
                                         whole("N5").rejected("faces have four corners: leave N5 to N8 out")};
inline constexpr CardLayout load_segment_set{whole("SSID").always(), whole("LCID").always(), number("SF", 1),
                                             number("AT").at_least(0)};
inline constexpr std::string_view no_spin = "of loads by a spin, which are not there";
inline constexpr CardLayout body_load{whole("LCID").always(),
                                      number("SF", 1),
                                      whole("LCIDDR").reported("there is no dynamic relaxation"),
                                      number("XC").reported(no_spin),
                                      number("YC").reported(no_spin),
                                      number("ZC").reported(no_spin),
                                      whole("CID")};
inline constexpr CardLayout body_load_vector{number("V1"), number("V2"), number("V3")};
inline constexpr CardLayout body_load_parts{whole("PSID").always()};

inline constexpr CardLayout history_named{whole("ID").always(), text("HEADING").columns(70)};

}  // namespace pinball::layout
