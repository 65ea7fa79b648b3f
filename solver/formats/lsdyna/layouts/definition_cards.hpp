#pragma once

#include "common_fields.hpp"

/// *DEFINE_... and *MAT_...
namespace pinball::layout {

inline constexpr std::string_view written_out = "write it out in the global system";

inline constexpr CardLayout curve{whole("LCID").always(),
                                  whole("SIDR").from(0, 2),
                                  number("SFA", 1),
                                  number("SFO", 1),
                                  number("OFFA"),
                                  number("OFFO"),
                                  whole("DATTYP").told("all curves are those of functions"),
                                  whole("LCINT").told(as_they_are)};
inline constexpr CardLayout curve_point{number("A1").columns(20), number("O1").columns(20)};
inline constexpr CardLayout table{whole("TBID").always(), number("SFA", 1), number("OFFA")};
inline constexpr CardLayout table_value{number("VALUE").columns(20), whole("LCID").columns(20)};
inline constexpr CardLayout vector{
    whole("VID").always(), number("XT"), number("YT"), number("ZT"),
    number("XH"),          number("YH"), number("ZH"), whole("CID").refused(written_out)};
inline constexpr CardLayout system{
    whole("CID").always(), number("XO"), number("YO"), number("ZO"),
    number("XL"),          number("YL"), number("ZL"), whole("CIDL").refused(written_out)};
inline constexpr CardLayout system_plane{number("XP"), number("YP"), number("ZP")};
inline constexpr CardLayout system_vectors{
    whole("CID").always(), number("XX"),
    number("YX"),          number("ZX"),
    number("XV"),          number("YV"),
    number("ZV"),          whole("NID").refused("systems do not turn with a node: leave it blank")};

constexpr CardField material_stress(std::string_view name) { return number(name).of(Dimension::stress); }
inline constexpr CardField material_id = whole("MID").always(), density = number("RO").always().of(Dimension::density),
                           young = material_stress("E").always(), poisson = number("PR").always();

inline constexpr CardLayout elastic{material_id,
                                    density,
                                    young,
                                    poisson,
                                    number("DA").told(of_beams),
                                    number("DB").told(of_beams),
                                    number("K").told("of fluids")};
inline constexpr CardLayout kinematic{material_id,
                                      density,
                                      young,
                                      poisson,
                                      material_stress("SIGY").always(),
                                      material_stress("ETAN"),
                                      number("BETA").from(0, 1)};
inline constexpr CardLayout kinematic_rate{number("SRC").of(Dimension::rate), number("SRP"), number("FS"),
                                           whole("VP").from(-1, 1)};
/// *MAT_ADD_EROSION: limits of any material.
inline constexpr std::string_view no_such_limit = "there is no such limit: leave it blank",
                                  no_damage_model = "damage is that of *MAT_JOHNSON_COOK: leave it blank";
inline constexpr CardLayout erosion{material_id,
                                    number("EXCL").refused("leave it 0, and what is no limit blank"),
                                    material_stress("MXPRES").at_least(0),
                                    number("MNEPS").refused(no_such_limit),
                                    number("EFFEPS").refused("give the material a failure strain, or leave it blank"),
                                    number("VOLEPS").refused(no_such_limit),
                                    number("NUMFIP", 1).told("elements have one point"),
                                    number("NCS", 1).refused("each limit counts by itself: leave it 1")};
inline constexpr CardLayout erosion_limits{material_stress("MNPRES").from(-std::numeric_limits<double>::infinity(), 0),
                                           material_stress("SIGP1").at_least(0),
                                           material_stress("SIGVM").at_least(0),
                                           number("MXEPS").at_least(0),
                                           number("EPSSH").at_least(0),
                                           number("SIGTH").refused(no_such_limit),
                                           number("IMPULSE").refused(no_such_limit),
                                           number("FAILTM").of(Dimension::time).at_least(0)};
inline constexpr CardLayout erosion_damage{whole("IDAM").refused(no_damage_model),  gap, gap, gap, gap, gap, gap,
                                           whole("LCREGD").refused(no_damage_model)};
inline constexpr CardLayout erosion_curves{
    whole("LCFLD").refused(no_such_limit),   whole("NSFF", 10).refused(no_such_limit),
    number("EPSTHIN").told(of_shells),       number("ENGCRT").refused(no_such_limit),
    number("RADCRT").refused(no_such_limit), whole("LCEPS12").refused(no_such_limit),
    whole("LCEPS13").refused(no_such_limit), whole("LCEPSMX").refused(no_such_limit)};
inline constexpr CardLayout erosion_more{
    number("DTEFLT").told("rates of strain have no limit that they could filter for"),
    number("VOLFRAC", 0.5).told("elements have one point"), number("MXTMP").refused(no_such_limit),
    number("DTMIN").of(Dimension::time).at_least(0)};

inline constexpr CardLayout piecewise{material_id,
                                      density,
                                      young,
                                      poisson,
                                      material_stress("SIGY"),
                                      material_stress("ETAN"),
                                      number("FAIL", 1e21),
                                      number("TDEL").told("solids do not fail by their time step")};
inline constexpr CardLayout piecewise_rate{number("C").of(Dimension::rate),
                                           number("P"),
                                           whole("LCSS"),
                                           whole("LCSR"),
                                           whole("VP").from(-1, 1),
                                           gap,
                                           number("RFILTF").told("rates are not smoothed")};
inline constexpr CardLayout piecewise_strains{number("EPS1"), number("EPS2"), number("EPS3"), number("EPS4"),
                                              number("EPS5"), number("EPS6"), number("EPS7"), number("EPS8")};
inline constexpr CardLayout piecewise_stresses{material_stress("ES1"), material_stress("ES2"), material_stress("ES3"),
                                               material_stress("ES4"), material_stress("ES5"), material_stress("ES6"),
                                               material_stress("ES7"), material_stress("ES8")};

inline constexpr std::string_view by_pressure = "the bulk modulus is that of the equation of state",
                                  of_other_rates = "of other forms of the rate";
inline constexpr CardLayout johnson_cook{
    material_id,
    density,
    material_stress("G").always(),
    number("E").told(by_pressure),
    number("PR").told(by_pressure),
    number("DTF").told("solids do not fail by their time step"),
    whole("VP").from(0, 1),
    number("RATEOP").refused("leave it blank: the rate is that of Johnson and Cook")};
inline constexpr CardLayout johnson_cook_strength{material_stress("A").always(),
                                                  material_stress("B"),
                                                  number("N"),
                                                  number("C"),
                                                  number("M"),
                                                  number("TM"),
                                                  number("TR"),
                                                  number("EPS0").of(Dimension::rate)};
inline constexpr CardLayout johnson_cook_failure{number("CP").of(Dimension::specific_heat),
                                                 material_stress("PC"),
                                                 number("SPALL", 2).from(0, 3),
                                                 number("IT").told("strains are returned exactly"),
                                                 number("D1"),
                                                 number("D2"),
                                                 number("D3"),
                                                 number("D4")};
inline constexpr CardLayout johnson_cook_more{number("D5"),
                                              number("C2/P").told(of_other_rates),
                                              number("EROD").refused("leave it blank: what fails is eroded"),
                                              number("EFMIN", 1e-6).refused("leave it blank: 1E-6"),
                                              number("NUMINT").told("elements have one point"),
                                              number("K").told(of_other_rates),
                                              number("D").told(of_other_rates)};

inline constexpr CardField state_equation_id = whole("EOSID").always();
inline constexpr std::string_view at_rest = "leave it blank: bodies press on nothing at the start";
inline constexpr CardLayout grueneisen{state_equation_id, number("C").always().of(Dimension::velocity),
                                       number("S1"),      number("S2"),
                                       number("S3"),      number("GAMAO"),
                                       number("A"),       number("E0").refused(at_rest)};
inline constexpr CardLayout grueneisen_volume{number("V0", 1).refused("leave it blank, or 1")};
inline constexpr CardLayout linear_polynomial{state_equation_id,     material_stress("C0"), material_stress("C1"),
                                              material_stress("C2"), material_stress("C3"), number("C4"),
                                              number("C5"),          number("C6")};
inline constexpr CardLayout linear_polynomial_state{number("E0").refused(at_rest),
                                                    number("V0", 1).refused("leave it blank, or 1")};

}  // namespace pinball::layout
