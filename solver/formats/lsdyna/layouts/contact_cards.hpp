#pragma once

#include "common_fields.hpp"

/// *CONTACT_..., in the form of R11 of the manual: after the card of _ID cards 1 to 3, that of _ERODING, and the
/// optional ones A to G.
namespace pinball::layout {

inline constexpr std::string_view no_penalty = "contact has no penalty stiffness",
                                  no_thickness = "faces lie where their nodes are",
                                  all_checked = "the search finds all pairs by itself",
                                  of_shells_and_beams = "of shells and beams", of_output = "of output",
                                  opened = "there is one rule for overlaps of the start",
                                  no_symmetry = "planes of symmetry do not change contact",
                                  uncovered = "faces that erosion uncovers always touch",
                                  put_on_faces = "nodes that are tied are put on their faces",
                                  no_spot_welds = "there are no spot welds", of_users = "of what users program",
                                  box_of_segments = "give the segments of the box as a set";

inline constexpr CardLayout contact_number{whole("CID"), text("HEADING").columns(70)};
/// Of _MPP: how processors share the search; the second line begins with &.
inline constexpr CardLayout contact_mpp{whole("IGNORE").reported(opened),
                                        whole("BCKT", 200).reported(all_checked),
                                        whole("LCBCKT").reported(all_checked),
                                        whole("NS2TRK", 3).reported(all_checked),
                                        whole("INITITR", 2).reported(opened),
                                        number("PARMAX", 1.0005).reported(all_checked),
                                        gap,
                                        whole("CPARM8").reported(of_shells_and_beams)};
inline constexpr CardLayout contact_mpp_more{text("&"), whole("CHKSEGS").reported(all_checked),
                                             number("PENSF", 1).reported(no_penalty),
                                             whole("GRPABLE").reported(all_checked)};
inline constexpr CardLayout contact_sides{whole("SSID"),
                                          whole("MSID"),
                                          whole("SSTYP"),
                                          whole("MSTYP"),
                                          whole("SBOXID").rejected(box_of_segments),
                                          whole("MBOXID").rejected(box_of_segments),
                                          whole("SPR").reported(of_output),
                                          whole("MPR").reported(of_output)};
inline constexpr CardLayout contact_friction{number("FS"),
                                             number("FD"),
                                             number("DC"),
                                             number("VC"),
                                             number("VDC").reported("impulses do not ring"),
                                             whole("PENCHK").reported(all_checked),
                                             number("BT"),
                                             number("DT", 1e20)};
inline constexpr CardLayout contact_scales{number("SFS", 1).reported(no_penalty),
                                           number("SFM", 1).reported(no_penalty),
                                           number("SST"),
                                           number("MST"),
                                           number("SFST", 1).reported(no_thickness),
                                           number("SFMT", 1).reported(no_thickness),
                                           number("FSF", 1),
                                           number("VSF", 1).reported("friction has no limit of stress")};
inline constexpr CardLayout contact_eroding{whole("ISYM").reported(no_symmetry), whole("EROSOP").reported(uncovered),
                                            whole("IADJ").reported(uncovered)};
inline constexpr CardLayout contact_a{
    whole("SOFT").reported(no_penalty),      number("SOFSCL", 0.1).reported(no_penalty),
    whole("LCIDAB").reported("of airbags"),  number("MAXPAR", 1.025).reported(all_checked),
    whole("SBOPT", 2).reported(all_checked), whole("DEPTH", 2).reported(all_checked),
    whole("BSORT").reported(all_checked),    whole("FRCFRQ", 1).reported(all_checked)};
inline constexpr CardLayout contact_b{number("PENMAX").reported(no_penalty),   whole("THKOPT").reported(no_thickness),
                                      whole("SHLTHK").reported(no_thickness),  whole("SNLOG").reported(all_checked),
                                      whole("ISYM").reported(no_symmetry),     whole("I2D3D").reported(all_checked),
                                      number("SLDTHK").reported(no_thickness), number("SLDSTF").reported(no_penalty)};
inline constexpr CardLayout contact_c{whole("IGAP", 1).reported(no_penalty),
                                      whole("IGNORE").reported(opened),
                                      number("DPRFAC").reported(opened),
                                      number("DTSTIF").reported(no_penalty),
                                      number("EDGEK").reported(no_penalty),
                                      gap,
                                      number("FLANGL").reported(of_shells_and_beams),
                                      whole("CID_RCF").reported(of_output)};
inline constexpr CardLayout contact_d{
    whole("Q2TRI").reported(of_shells_and_beams), number("DTPCHK").reported(opened),
    number("SFNBR").reported(no_penalty),         number("FNLSCL").reported(no_penalty),
    number("DNLSCL").reported(no_penalty),        whole("TCSO").reported(of_shells_and_beams),
    whole("TIEDID").reported(no_penalty),         whole("SHLEDG").reported(of_shells_and_beams)};
inline constexpr CardLayout contact_e{whole("SHAREC").reported(all_checked),
                                      whole("CPARM8").reported(of_shells_and_beams),
                                      whole("IPBACK").reported("tied nodes have no penalty beside"),
                                      whole("SRNDE").reported(of_shells_and_beams),
                                      number("FRICSF", 1).reported("scale FS and FD in its place, or by FSF"),
                                      whole("ICOR").reported(opened),
                                      whole("FTORQ").reported(no_penalty),
                                      whole("REGION").reported(all_checked)};
inline constexpr CardLayout contact_f{whole("PSTIFF").reported(no_penalty),
                                      whole("IGNROFF").reported(of_shells_and_beams),
                                      gap,
                                      number("FSTOL", 2).reported(no_penalty),
                                      whole("2DBINR").reported(all_checked),
                                      whole("SSFTYP").reported(no_penalty),
                                      whole("SWTPR").reported(opened),
                                      number("TETFAC").reported(no_penalty)};
inline constexpr CardLayout contact_g{gap, number("SHLOFF").reported(of_shells_and_beams)};
/// A to G
inline constexpr std::array<const CardLayout*, 7> contact_optional{&contact_a, &contact_b, &contact_c, &contact_d,
                                                                   &contact_e, &contact_f, &contact_g};

/// *CONTACT_INTERIOR
inline constexpr std::string_view resists_in_any_case =
    "corners that are about to turn over resist in any case "
    "(element.folding_resistance)";
inline constexpr CardLayout contact_interior{
    whole("PSID1").reported(resists_in_any_case), whole("PSID2").reported(resists_in_any_case),
    whole("PSID3").reported(resists_in_any_case), whole("PSID4").reported(resists_in_any_case),
    whole("PSID5").reported(resists_in_any_case), whole("PSID6").reported(resists_in_any_case),
    whole("PSID7").reported(resists_in_any_case), whole("PSID8").reported(resists_in_any_case)};

/// *CONTROL_CONTACT
inline constexpr std::string_view of_parts_friction = "give friction with *CONTACT_...",
                                  of_walls = "walls are exact, and have no stiffness";
inline constexpr CardLayout control_contact_1{
    number("SLSFAC", 0.1).reported(no_penalty),
    number("RWPNAL").reported(of_walls),
    whole("ISLCHK", 1).reported(opened),
    whole("SHLTHK").reported(no_thickness),
    whole("PENOPT", 1).reported(no_penalty),
    whole("THKCHG").reported(no_thickness),
    whole("ORIEN", 1).reported("solids say where their outside is"),
    whole("ENMASS").reported("there is one rule for nodes that erosion frees")};
inline constexpr CardLayout control_contact_2{
    whole("USRSTR").reported(of_users),   whole("USRFRC").reported(of_users),
    whole("NSBCS").reported(all_checked), whole("INTERM").reported(all_checked),
    number("XPENE", 4).reported(opened),  whole("SSTHK").reported(no_thickness),
    whole("ECDT").reported(of_output),    whole("TIEDPRJ").reported(put_on_faces)};
inline constexpr CardLayout control_contact_3{
    number("SFRIC").reported(of_parts_friction), number("DFRIC").reported(of_parts_friction),
    number("EDC").reported(of_parts_friction),   number("VFC").reported(of_parts_friction),
    number("TH").reported(no_thickness),         number("TH_SF").reported(no_thickness),
    number("PEN_SF").reported(no_penalty),       number("PTSCL", 1).reported(no_penalty)};
inline constexpr CardLayout control_contact_4{
    whole("IGNORE").reported(opened),          whole("FRCENG").reported(of_output),
    whole("SKIPRWG").reported(of_output),      whole("OUTSEG").reported(of_output),
    whole("SPOTSTP").reported(no_spot_welds),  whole("SPOTDEL").reported(no_spot_welds),
    number("SPOTHIN").reported(no_spot_welds), whole("DIR_TIE").reported(no_spot_welds)};
inline constexpr CardLayout control_contact_5{
    whole("ISYM").reported(no_symmetry),      whole("NSEROD").reported(uncovered),
    whole("RWGAPS", 1).reported(of_walls),    number("RWGDTH").reported(of_walls),
    number("RWKSF", 1).reported(of_walls),    whole("ICOV").reported(of_shells_and_beams),
    number("SWRADF").reported(no_spot_welds), whole("ITHOFF").reported(of_thermal)};
inline constexpr CardLayout control_contact_6{whole("SHLEDG").reported(of_shells_and_beams),
                                              whole("PSTIFF").reported(no_penalty),
                                              whole("ITHCNT").reported(of_thermal),
                                              whole("TDCNOF").reported(of_thermal),
                                              whole("FTALL").reported(of_output),
                                              gap,
                                              number("SHLTRW").reported(of_shells_and_beams),
                                              whole("IGACTC").reported(no_splines)};
inline constexpr CardLayout control_contact_7{whole("IREVSPT").reported(no_spot_welds),
                                              gap,
                                              whole("COHTIEM").reported("there are no cohesive elements"),
                                              whole("TIEOPT").reported(put_on_faces),
                                              whole("STROBJ").reported(no_penalty),
                                              number("BEFBLK").reported(all_checked)};
inline constexpr std::array<const CardLayout*, 7> control_contact{
    &control_contact_1, &control_contact_2, &control_contact_3, &control_contact_4,
    &control_contact_5, &control_contact_6, &control_contact_7};

}  // namespace pinball::layout
