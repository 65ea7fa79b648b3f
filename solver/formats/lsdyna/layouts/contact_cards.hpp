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
inline constexpr CardLayout contact_sides{whole("SSID"),
                                          whole("MSID"),
                                          whole("SSTYP"),
                                          whole("MSTYP"),
                                          whole("SBOXID").refused(box_of_segments),
                                          whole("MBOXID").refused(box_of_segments),
                                          whole("SPR").told(of_output),
                                          whole("MPR").told(of_output)};
inline constexpr CardLayout contact_friction{number("FS"),
                                             number("FD"),
                                             number("DC"),
                                             number("VC"),
                                             number("VDC").told("impulses do not ring"),
                                             whole("PENCHK").told(all_checked),
                                             number("BT"),
                                             number("DT", 1e20)};
inline constexpr CardLayout contact_scales{number("SFS", 1).told(no_penalty),
                                           number("SFM", 1).told(no_penalty),
                                           number("SST"),
                                           number("MST"),
                                           number("SFST", 1).told(no_thickness),
                                           number("SFMT", 1).told(no_thickness),
                                           number("FSF", 1),
                                           number("VSF", 1).told("friction has no limit of stress")};
inline constexpr CardLayout contact_eroding{whole("ISYM").told(no_symmetry), whole("EROSOP").told(uncovered),
                                            whole("IADJ").told(uncovered)};
inline constexpr CardLayout contact_a{whole("SOFT").told(no_penalty),      number("SOFSCL", 0.1).told(no_penalty),
                                      whole("LCIDAB").told("of airbags"),  number("MAXPAR", 1.025).told(all_checked),
                                      whole("SBOPT", 2).told(all_checked), whole("DEPTH", 2).told(all_checked),
                                      whole("BSORT").told(all_checked),    whole("FRCFRQ", 1).told(all_checked)};
inline constexpr CardLayout contact_b{number("PENMAX").told(no_penalty),   whole("THKOPT").told(no_thickness),
                                      whole("SHLTHK").told(no_thickness),  whole("SNLOG").told(all_checked),
                                      whole("ISYM").told(no_symmetry),     whole("I2D3D").told(all_checked),
                                      number("SLDTHK").told(no_thickness), number("SLDSTF").told(no_penalty)};
inline constexpr CardLayout contact_c{
    whole("IGAP", 1).told(no_penalty),          whole("IGNORE").told(opened),     number("DPRFAC").told(opened),
    number("DTSTIF").told(no_penalty),          number("EDGEK").told(no_penalty), gap,
    number("FLANGL").told(of_shells_and_beams), whole("CID_RCF").told(of_output)};
inline constexpr CardLayout contact_d{
    whole("Q2TRI").told(of_shells_and_beams), number("DTPCHK").told(opened),
    number("SFNBR").told(no_penalty),         number("FNLSCL").told(no_penalty),
    number("DNLSCL").told(no_penalty),        whole("TCSO").told(of_shells_and_beams),
    whole("TIEDID").told(no_penalty),         whole("SHLEDG").told(of_shells_and_beams)};
inline constexpr CardLayout contact_e{whole("SHAREC").told(all_checked),
                                      whole("CPARM8").told(of_shells_and_beams),
                                      whole("IPBACK").told("tied nodes have no penalty beside"),
                                      whole("SRNDE").told(of_shells_and_beams),
                                      number("FRICSF", 1).told("scale FS and FD in its place, or by FSF"),
                                      whole("ICOR").told(opened),
                                      whole("FTORQ").told(no_penalty),
                                      whole("REGION").told(all_checked)};
inline constexpr CardLayout contact_f{
    whole("PSTIFF").told(no_penalty),    whole("IGNROFF").told(of_shells_and_beams), gap,
    number("FSTOL", 2).told(no_penalty), whole("2DBINR").told(all_checked),          whole("SSFTYP").told(no_penalty),
    whole("SWTPR").told(opened),         number("TETFAC").told(no_penalty)};
inline constexpr CardLayout contact_g{gap, number("SHLOFF").told(of_shells_and_beams)};
/// A to G
inline constexpr std::array<const CardLayout*, 7> contact_optional{&contact_a, &contact_b, &contact_c, &contact_d,
                                                                   &contact_e, &contact_f, &contact_g};

/// *CONTROL_CONTACT
inline constexpr std::string_view of_parts_friction = "give friction with *CONTACT_...",
                                  of_walls = "walls are exact, and have no stiffness";
inline constexpr CardLayout control_contact_1{number("SLSFAC", 0.1).told(no_penalty),
                                              number("RWPNAL").told(of_walls),
                                              whole("ISLCHK", 1).told(opened),
                                              whole("SHLTHK").told(no_thickness),
                                              whole("PENOPT", 1).told(no_penalty),
                                              whole("THKCHG").told(no_thickness),
                                              whole("ORIEN", 1).told("solids say where their outside is"),
                                              whole("ENMASS").told("there is one rule for nodes that erosion frees")};
inline constexpr CardLayout control_contact_2{whole("USRSTR").told(of_users),   whole("USRFRC").told(of_users),
                                              whole("NSBCS").told(all_checked), whole("INTERM").told(all_checked),
                                              number("XPENE", 4).told(opened),  whole("SSTHK").told(no_thickness),
                                              whole("ECDT").told(of_output),    whole("TIEDPRJ").told(put_on_faces)};
inline constexpr CardLayout control_contact_3{
    number("SFRIC").told(of_parts_friction), number("DFRIC").told(of_parts_friction),
    number("EDC").told(of_parts_friction),   number("VFC").told(of_parts_friction),
    number("TH").told(no_thickness),         number("TH_SF").told(no_thickness),
    number("PEN_SF").told(no_penalty),       number("PTSCL", 1).told(no_penalty)};
inline constexpr CardLayout control_contact_4{
    whole("IGNORE").told(opened),          whole("FRCENG").told(of_output),      whole("SKIPRWG").told(of_output),
    whole("OUTSEG").told(of_output),       whole("SPOTSTP").told(no_spot_welds), whole("SPOTDEL").told(no_spot_welds),
    number("SPOTHIN").told(no_spot_welds), whole("DIR_TIE").told(no_spot_welds)};
inline constexpr CardLayout control_contact_5{
    whole("ISYM").told(no_symmetry),      whole("NSEROD").told(uncovered),   whole("RWGAPS", 1).told(of_walls),
    number("RWGDTH").told(of_walls),      number("RWKSF", 1).told(of_walls), whole("ICOV").told(of_shells_and_beams),
    number("SWRADF").told(no_spot_welds), whole("ITHOFF").told(of_thermal)};
inline constexpr CardLayout control_contact_6{
    whole("SHLEDG").told(of_shells_and_beams),  whole("PSTIFF").told(no_penalty), whole("ITHCNT").told(of_thermal),
    whole("TDCNOF").told(of_thermal),           whole("FTALL").told(of_output),   gap,
    number("SHLTRW").told(of_shells_and_beams), whole("IGACTC").told(no_splines)};
inline constexpr CardLayout control_contact_7{whole("IREVSPT").told(no_spot_welds),
                                              gap,
                                              whole("COHTIEM").told("there are no cohesive elements"),
                                              whole("TIEOPT").told(put_on_faces),
                                              whole("STROBJ").told(no_penalty),
                                              number("BEFBLK").told(all_checked)};
inline constexpr std::array<const CardLayout*, 7> control_contact{
    &control_contact_1, &control_contact_2, &control_contact_3, &control_contact_4,
    &control_contact_5, &control_contact_6, &control_contact_7};

}  // namespace pinball::layout
