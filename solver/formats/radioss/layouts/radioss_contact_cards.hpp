#pragma once

#include "radioss_common.hpp"

/// /INTER/TYPE..., in the forms of version 2023 on, which those before have without what is newer.
namespace pinball::radioss {

inline constexpr std::string_view no_ringing = "impulses do not ring",
                                  opened = "there is one rule for overlaps of the start",
                                  erosion_seen = "erosion is always seen to",
                                  constant_friction = "friction is Fric alone",
                                  no_friction_law = "friction is Fric alone: leave it 0",
                                  walls_and_ties = "of other constraints";
constexpr CardField stiffness(std::string_view name, double otherwise = 0) {
  return real(name, otherwise).reported(no_penalty);
}
constexpr CardField flag(std::string_view name, std::string_view why) { return whole(name).reported(why); }

inline constexpr CardLayout inter_scales{stiffness("Stfac", 1), real("Fric"), real("GAPmin").reported(no_gap),
                                         real("Tstart"), real("Tstop", 1e30).at_least(0)};
inline constexpr CardLayout inter_start{blank(7),
                                        whole("IBC").columns(3).rejected("contact acts in all directions"),
                                        blank(20),
                                        flag("Inacti", opened),
                                        real("VIS_S").reported(no_ringing),
                                        real("VIS_F").reported(no_ringing),
                                        real("Bumult").reported(all_checked)};

inline constexpr CardLayout type7_sides{whole("grnod_ID").always(),  whole("surf_ID").always(),
                                        flag("Istf", no_penalty),    flag("Ithe", of_heat),
                                        flag("Igap", no_gap),        blank(10),
                                        flag("Ibag", "of airbags"),  flag("Idel", erosion_seen),
                                        whole("Icurv").rejected(""), flag("Iadm", no_gap)};
inline constexpr CardLayout type7_gap{real("Fscale_gap", 1).reported(no_gap),
                                      real("Gap_max").reported(no_gap),
                                      real("Fpenmax").reported(no_gap),
                                      blank(20),
                                      whole("Itied").rejected("give /INTER/TYPE2"),
                                      flag("Ists", no_gap)};
inline constexpr CardLayout type7_stiffness{stiffness("Stmin"),
                                            stiffness("Stmax"),
                                            real("mesh_size").reported(no_gap),
                                            real("dtmin").reported(no_penalty),
                                            flag("Irem_gap", no_gap),
                                            flag("Irem_i2", walls_and_ties)};
inline constexpr CardLayout type7_friction{whole("Ifric").rejected(no_friction_law),
                                           flag("Ifiltr", constant_friction),
                                           real("Xfreq").reported(constant_friction),
                                           flag("Iform", "friction is by impulses, too"),
                                           sensor("sens_ID"),
                                           whole("fct_IDF").rejected(no_friction_law),
                                           real("AscaleF").reported(constant_friction),
                                           whole("fric_ID").rejected(no_friction_law)};

inline constexpr CardLayout type11_sides{whole("line_IDs").always(), whole("line_IDm").always(),
                                         flag("Istf", no_penalty),   flag("Ithe", of_heat),
                                         flag("Igap", no_gap),       blank(10),
                                         flag("Irem_gap", no_gap),   flag("Idel", erosion_seen)};
inline constexpr CardLayout type11_stiffness{stiffness("Stmin"),
                                             stiffness("Stmax"),
                                             real("mesh_size").reported(no_gap),
                                             real("dtmin").reported(no_penalty),
                                             flag("Iform", "friction is by impulses, too"),
                                             sensor("sens_ID")};
inline constexpr CardLayout type11_friction{blank(90), whole("fric_ID").rejected(no_friction_law)};

inline constexpr CardLayout type24_sides{whole("surf_ID1"),
                                         whole("surf_ID2"),
                                         flag("Istf", no_penalty),
                                         flag("Ithe", of_heat),
                                         flag("Igap", no_gap),
                                         flag("Irem_i2", walls_and_ties),
                                         blank(10),
                                         flag("Idel", erosion_seen),
                                         flag("Iedge", "edges touch always"),
                                         flag("IPSTIF", no_penalty)};
inline constexpr CardLayout type24_gap{whole("grnd_IDs"),
                                       blank(10),
                                       real("gap_or_edge").reported(no_gap),
                                       real("mesh_size").reported(no_gap),
                                       real("Gap_max_s").reported(no_gap),
                                       real("Gap_max_m").reported(no_gap)};
inline constexpr CardLayout type24_stiffness{stiffness("Stmin"),
                                             stiffness("Stmax"),
                                             flag("Igap0", no_gap),
                                             flag("Ipen0", opened),
                                             real("Ipen_max").reported(opened),
                                             stiffness("STFAC_MDT")};
inline constexpr CardLayout type24_scales{stiffness("Stfac", 1), real("Fric"), real("Tpressfit").reported(opened),
                                          real("Tstart"), real("Tstop", 1e30).at_least(0)};
inline constexpr CardLayout type24_start{blank(7),
                                         whole("IBC").columns(3).rejected("contact acts in all directions"),
                                         blank(10),
                                         flag("IVIS2", no_ringing),
                                         flag("Inacti", opened),
                                         real("VISs").reported(no_ringing),
                                         flag("Ithick", no_gap),
                                         blank(10),
                                         real("Pmax").reported(opened)};
inline constexpr CardLayout type24_friction{whole("Ifric").rejected(no_friction_law),
                                            flag("Ifiltr", constant_friction),
                                            real("Xfreq").reported(constant_friction),
                                            blank(10),
                                            sensor("sens_ID"),
                                            real("DTSTIF").reported(no_penalty),
                                            blank(10),
                                            whole("fric_ID").rejected(no_friction_law)};

inline constexpr CardLayout tie{whole("grnd_IDs").always(),
                                whole("surf_IDm").always(),
                                flag("Ignore", "nodes without a face are left free"),
                                flag("Spotflag", "nodes that are tied are put on their faces"),
                                flag("Level", walls_and_ties),
                                flag("Isearch", all_checked),
                                flag("Idel2", erosion_seen),
                                whole("surf_IDs").rejected("give the nodes by grnd_IDs"),
                                real("dsearch").at_least(0)};

}  // namespace pinball::radioss
