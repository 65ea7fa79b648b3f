#pragma once

#include "common_fields.hpp"

/// *NODE, *ELEMENT_SOLID, *PART, *SECTION_SOLID, *HOURGLASS, *SET_... and what places an included file.
namespace pinball::layout {

inline constexpr CardLayout node{whole("NID").always().columns(8),
                                 number("X").of(Dimension::length).columns(16),
                                 number("Y").of(Dimension::length).columns(16),
                                 number("Z").of(Dimension::length).columns(16),
                                 whole("TC").from(0, 7).columns(8),
                                 whole("RC").columns(8)};

constexpr CardField solid_node(std::string_view name) { return whole(name).columns(8); }
inline constexpr CardLayout solid{whole("EID").always().columns(8),
                                  whole("PID").always().columns(8),
                                  solid_node("N1"),
                                  solid_node("N2"),
                                  solid_node("N3"),
                                  solid_node("N4"),
                                  solid_node("N5"),
                                  solid_node("N6"),
                                  solid_node("N7"),
                                  solid_node("N8")};
inline constexpr CardLayout solid_nodes{solid_node("N1"), solid_node("N2"), solid_node("N3"), solid_node("N4"),
                                        solid_node("N5"), solid_node("N6"), solid_node("N7"), solid_node("N8"),
                                        solid_node("N9"), solid_node("N10")};

inline constexpr CardLayout shell = solid;  ///< of four nodes, and of eight

inline constexpr CardField mass_of_node = number("MASS").of(Dimension::mass).at_least(0).columns(16),
                           part_of_mass = whole("PID").columns(8).reported("it only says in which sums a mass counts");
inline constexpr CardLayout node_mass{whole("EID").always().columns(8), whole("NID").always().columns(8), mass_of_node,
                                      part_of_mass};
inline constexpr CardLayout node_set_mass{whole("EID").always().columns(8), whole("NSID").always().columns(8),
                                          mass_of_node, part_of_mass};

inline constexpr CardLayout part{whole("PID").always(),
                                 whole("SECID"),
                                 whole("MID"),
                                 whole("EOSID"),
                                 whole("HGID"),
                                 whole("GRAV").reported("gravity acts on all parts that *LOAD_BODY_PARTS names"),
                                 whole("ADPOPT").reported("meshes stay as they are"),
                                 whole("TMID").reported(of_thermal)};
inline constexpr std::string_view of_parts = "friction and stiffness are those of *CONTACT_...: give them there";
inline constexpr CardLayout part_contact{number("FS").reported(of_parts),     number("FD").reported(of_parts),
                                         number("DC").reported(of_parts),     number("VC").reported(of_parts),
                                         number("OPTT").reported(of_parts),   number("SFT", 1).reported(of_parts),
                                         number("SSF", 1).reported(of_parts), number("CPARM8").reported(of_parts)};

inline constexpr CardLayout section_solid{whole("SECID").always(),
                                          whole("ELFORM", 1),
                                          whole("AET").reported("of materials that flow"),
                                          gap,
                                          gap,
                                          gap,
                                          number("COHOFF").reported("of cohesive elements"),
                                          number("GASKETT").reported("of gaskets")};

inline constexpr std::string_view of_rigid_shells = "shells are rigid: they have no stress";
inline constexpr CardLayout section_shell{whole("SECID").always(),
                                          whole("ELFORM").reported(of_rigid_shells),
                                          number("SHRF", 1).reported(of_rigid_shells),
                                          whole("NIP", 2).reported(of_rigid_shells),
                                          number("PROPT").reported(of_rigid_shells),
                                          number("QR/IRID").reported(of_rigid_shells),
                                          whole("ICOMP").reported(of_rigid_shells),
                                          whole("SETYP", 1).reported(of_rigid_shells)};
inline constexpr CardLayout shell_thickness{
    number("T1").of(Dimension::length),
    number("T2").of(Dimension::length),
    number("T3").of(Dimension::length),
    number("T4").of(Dimension::length),
    number("NLOC").rejected("nodes lie in the middle of a shell: move them there"),
    number("MAREA").rejected("mass that is no shell's: give it to the density"),
    number("IDOF").reported(of_rigid_shells),
    number("EDGSET").reported(of_rigid_shells)};

inline constexpr CardLayout hourglass{whole("HGID").always(),
                                      whole("IHQ"),
                                      number("QM").at_least(0),
                                      whole("IBQ").reported("the bulk viscosity is the standard one"),
                                      number("Q1").at_least(0),
                                      number("Q2").at_least(0),
                                      number("QB", 0.1).reported(of_shells),
                                      number("QW", 0.1).reported(of_shells)};

constexpr CardField attribute(std::string_view name) {
  return number(name).reported("attributes of sets are for keywords that are not read");
}
inline constexpr CardLayout set_head{whole("SID").always(),
                                     attribute("DA1"),
                                     attribute("DA2"),
                                     attribute("DA3"),
                                     attribute("DA4"),
                                     text("SOLVER", "MECH").reported("there is one solver"),
                                     text("ITS", "1").reported("there is one scale")};
inline constexpr CardLayout set_ranges{whole("B1BEG"), whole("B1END"), whole("B2BEG"), whole("B2END"),
                                       whole("B3BEG"), whole("B3END"), whole("B4BEG"), whole("B4END")};
inline constexpr CardLayout set_steps{whole("BBEG"), whole("BEND"), whole("INCR", 1).at_least(1)};
inline constexpr CardLayout set_column{whole("ID").always(), attribute("A1"), attribute("A2"), attribute("A3"),
                                       attribute("A4")};
inline constexpr CardLayout set_general{text("OPTION"), whole("E1"), whole("E2"), whole("E3"),
                                        whole("E4"),    whole("E5"), whole("E6"), whole("E7")};
inline constexpr CardLayout segment{whole("N1"),     whole("N2"),     whole("N3"),     whole("N4"),
                                    attribute("A1"), attribute("A2"), attribute("A3"), attribute("A4")};

inline constexpr CardLayout box{whole("BOXID").always(),
                                number("XMN").of(Dimension::length),
                                number("XMX").of(Dimension::length),
                                number("YMN").of(Dimension::length),
                                number("YMX").of(Dimension::length),
                                number("ZMN").of(Dimension::length),
                                number("ZMX").of(Dimension::length)};

inline constexpr CardLayout transformation{whole("TRANID").always()};
inline constexpr CardLayout transformation_step{text("OPTION"), number("A1"), number("A2"), number("A3"),
                                                number("A4"),   number("A5"), number("A6"), number("A7")};

inline constexpr CardLayout include_offsets{whole("IDNOFF"), whole("IDEOFF"), whole("IDPOFF"), whole("IDMOFF"),
                                            whole("IDSOFF"), whole("IDFOFF"), whole("IDDOFF")};
inline constexpr std::string_view by_number = "what has a title is found by its number, which stays";
inline constexpr CardLayout include_other{whole("IDROFF"), text("PREFIX").reported(by_number),
                                          text("SUFFIX").reported(by_number)};
inline constexpr CardLayout include_units{number("FCTMAS", 1), number("FCTTIM", 1), number("FCTLEN", 1), text("FCTTEM"),
                                          whole("INCOUT1").reported("nothing is written of it")};
inline constexpr CardLayout include_transformation{whole("TRANID")};
inline constexpr CardLayout case_head{whole("CASEID").always(), text("JOBID")};
inline constexpr CardLayout case_members{text("SCID1"), text("SCID2"), text("SCID3"), text("SCID4"),
                                         text("SCID5"), text("SCID6"), text("SCID7"), text("SCID8")};
inline constexpr CardLayout parameter_duplication{whole("DFLAG", 1)};
inline constexpr CardLayout parameters{text("PRMR1"), text("VAL1"), text("PRMR2"), text("VAL2"),
                                       text("PRMR3"), text("VAL3"), text("PRMR4"), text("VAL4")};

}  // namespace pinball::layout
