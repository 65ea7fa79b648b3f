#pragma once

#include "common_fields.hpp"

/// *DEFINE_... and *MAT_...
namespace pinball::layout {

inline constexpr std::string_view written_out = "write it out in the global system";

inline constexpr CardLayout curve{
    whole("LCID").always(), whole("SIDR").from(0, 2), number("SFA", 1), number("SFO", 1),
    number("OFFA"),         number("OFFO"),           whole("DATTYP"),  whole("LCINT").reported(as_they_are)};
inline constexpr CardLayout curve_point{number("A1").columns(20), number("O1").columns(20)};
inline constexpr CardLayout table{whole("TBID").always(), number("SFA", 1), number("OFFA")};
inline constexpr CardLayout table_value{number("VALUE").columns(20), whole("LCID").columns(20)};
inline constexpr CardLayout vector{
    whole("VID").always(), number("XT"), number("YT"), number("ZT"),
    number("XH"),          number("YH"), number("ZH"), whole("CID").rejected(written_out)};
inline constexpr CardLayout system{
    whole("CID").always(), number("XO"), number("YO"), number("ZO"),
    number("XL"),          number("YL"), number("ZL"), whole("CIDL").rejected(written_out)};
inline constexpr CardLayout system_plane{number("XP"), number("YP"), number("ZP")};
inline constexpr CardLayout system_vectors{
    whole("CID").always(), number("XX"),
    number("YX"),          number("ZX"),
    number("XV"),          number("YV"),
    number("ZV"),          whole("NID").rejected("systems do not turn with a node: leave it blank")};

constexpr CardField material_stress(std::string_view name) { return number(name).of(Dimension::stress); }
inline constexpr CardField material_id = whole("MID").always(), density = number("RO").always().of(Dimension::density),
                           young = material_stress("E").always(), poisson = number("PR").always();

inline constexpr CardLayout elastic{material_id,
                                    density,
                                    young,
                                    poisson,
                                    number("DA").reported(of_beams),
                                    number("DB").reported(of_beams),
                                    number("K").reported("of fluids")};
inline constexpr CardLayout kinematic{material_id,
                                      density,
                                      young,
                                      poisson,
                                      material_stress("SIGY").always(),
                                      material_stress("ETAN"),
                                      number("BETA").from(0, 1)};
inline constexpr CardLayout kinematic_rate{number("SRC").of(Dimension::rate), number("SRP"), number("FS"),
                                           whole("VP").from(-1, 1)};
inline constexpr CardLayout power_law{material_id,
                                      density,
                                      young,
                                      poisson,
                                      material_stress("K").always(),
                                      number("N").always(),
                                      number("SRC").of(Dimension::rate),
                                      number("SRP")};
/// SIGY: a stress, or below 0.02 a strain: it has no dimension.
inline constexpr CardLayout power_law_more{number("SIGY").at_least(0), whole("VP").from(0, 1), number("EPSF")};
/// *MAT_ADD_EROSION: limits of any material.
inline constexpr std::string_view no_such_limit = "there is no such limit: leave it blank",
                                  no_damage_model = "damage is that of *MAT_JOHNSON_COOK: leave it blank";
inline constexpr CardLayout erosion{material_id,
                                    number("EXCL").rejected("leave it 0, and what is no limit blank"),
                                    material_stress("MXPRES").at_least(0),
                                    number("MNEPS").rejected(no_such_limit),
                                    number("EFFEPS").rejected("give the material a failure strain, or leave it blank"),
                                    number("VOLEPS").rejected(no_such_limit),
                                    number("NUMFIP", 1).reported("elements have one point"),
                                    number("NCS", 1).rejected("each limit counts by itself: leave it 1")};
inline constexpr CardLayout erosion_limits{material_stress("MNPRES").from(-std::numeric_limits<double>::infinity(), 0),
                                           material_stress("SIGP1").at_least(0),
                                           material_stress("SIGVM").at_least(0),
                                           number("MXEPS").at_least(0),
                                           number("EPSSH").at_least(0),
                                           number("SIGTH").rejected(no_such_limit),
                                           number("IMPULSE").rejected(no_such_limit),
                                           number("FAILTM").of(Dimension::time).at_least(0)};
inline constexpr CardLayout erosion_damage{whole("IDAM").rejected(no_damage_model),  gap, gap, gap, gap, gap, gap,
                                           whole("LCREGD").rejected(no_damage_model)};
inline constexpr CardLayout erosion_curves{
    whole("LCFLD").rejected(no_such_limit),   whole("NSFF", 10).rejected(no_such_limit),
    number("EPSTHIN").reported(of_shells),    number("ENGCRT").rejected(no_such_limit),
    number("RADCRT").rejected(no_such_limit), whole("LCEPS12").rejected(no_such_limit),
    whole("LCEPS13").rejected(no_such_limit), whole("LCEPSMX").rejected(no_such_limit)};
inline constexpr CardLayout erosion_more{
    number("DTEFLT").reported("rates of strain have no limit that they could filter for"),
    number("VOLFRAC", 0.5).reported("elements have one point"), number("MXTMP").rejected(no_such_limit),
    number("DTMIN").of(Dimension::time).at_least(0)};

inline constexpr CardLayout piecewise{material_id,
                                      density,
                                      young,
                                      poisson,
                                      material_stress("SIGY"),
                                      material_stress("ETAN"),
                                      number("FAIL", 1e21),
                                      number("TDEL").reported("solids do not fail by their time step")};
inline constexpr CardLayout piecewise_rate{number("C").of(Dimension::rate),
                                           number("P"),
                                           whole("LCSS"),
                                           whole("LCSR"),
                                           whole("VP").from(-1, 1),
                                           gap,
                                           number("RFILTF").reported("rates are not smoothed")};
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
    number("E").reported(by_pressure),
    number("PR").reported(by_pressure),
    number("DTF").reported("solids do not fail by their time step"),
    whole("VP").from(0, 1),
    number("RATEOP").rejected("leave it blank: the rate is that of Johnson and Cook")};
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
                                                 number("IT").reported("strains are returned exactly"),
                                                 number("D1"),
                                                 number("D2"),
                                                 number("D3"),
                                                 number("D4")};
inline constexpr CardLayout johnson_cook_more{number("D5"),
                                              number("C2/P").reported(of_other_rates),
                                              number("EROD").rejected("leave it blank: what fails is eroded"),
                                              number("EFMIN", 1e-6).rejected("leave it blank: 1E-6"),
                                              number("NUMINT").reported("elements have one point"),
                                              number("K").reported(of_other_rates),
                                              number("D").reported(of_other_rates)};

/// *MAT_110
inline constexpr CardLayout johnson_holmquist{material_id,          density,     material_stress("G").always(),
                                              number("A").always(), number("B"), number("C"),
                                              number("M"),          number("N")};
inline constexpr CardLayout johnson_holmquist_limits{
    number("EPS0").of(Dimension::rate), material_stress("T").at_least(0), number("SFMAX").at_least(0),
    material_stress("HEL").always(),    material_stress("PHEL").always(), number("BETA").from(0, 1)};
inline constexpr CardLayout johnson_holmquist_damage{number("D1").at_least(0),       number("D2").at_least(0),
                                                     material_stress("K1").always(), material_stress("K2"),
                                                     material_stress("K3"),          number("FS")};

/// *MAT_098; what limits its stress is not there.
inline constexpr std::string_view no_largest_stress = "there is no such limit: leave it blank";
inline constexpr CardLayout simplified_johnson_cook{material_id, density, young, poisson, whole("VP").from(0, 1)};
inline constexpr CardLayout simplified_johnson_cook_strength{material_stress("A").always(),
                                                             material_stress("B"),
                                                             number("N"),
                                                             number("C"),
                                                             number("PSFAIL", 1e17),
                                                             number("SIGMAX", 1e28).rejected(no_largest_stress),
                                                             number("SIGSAT", 1e28).rejected(no_largest_stress),
                                                             number("EPS0", 1).of(Dimension::rate)};
inline constexpr CardLayout isotropic_plastic{material_id,
                                              density,
                                              material_stress("G").always(),
                                              material_stress("SIGY").always(),
                                              material_stress("ETAN"),
                                              material_stress("BULK").always()};

inline constexpr CardLayout null{material_id,
                                 density,
                                 material_stress("PC").from(-std::numeric_limits<double>::infinity(), 0),
                                 number("MU").at_least(0),
                                 number("TEROD").rejected("elements are not eroded by their volume: leave it blank"),
                                 number("CEROD").rejected("elements are not eroded by their volume: leave it blank"),
                                 number("YM").reported("of beams and shells"),
                                 number("PR").reported("of beams and shells")};

/// *MAT_005
inline constexpr CardLayout soil{
    material_id,  density,      number("G").always(), number("KUN").always().at_least(0),
    number("A0"), number("A1"), number("A2"),         number("PC").from(-std::numeric_limits<double>::infinity(), 0)};
inline constexpr CardLayout soil_options{number("VCR").from(0, 1),
                                         number("REF").rejected("leave it 0: the mesh has no stress"), whole("LCID")};
inline constexpr CardLayout soil_strains{number("EPS1"), number("EPS2"), number("EPS3"), number("EPS4"),
                                         number("EPS5"), number("EPS6"), number("EPS7"), number("EPS8")};
inline constexpr CardLayout soil_strains_more{number("EPS9"), number("EPS10")};
inline constexpr CardLayout soil_pressures{number("P1"), number("P2"), number("P3"), number("P4"),
                                           number("P5"), number("P6"), number("P7"), number("P8")};
inline constexpr CardLayout soil_pressures_more{number("P9"), number("P10")};

/// *MAT_063
inline constexpr CardLayout crushable_foam{
    material_id,
    density,
    young,
    number("PR"),
    whole("LCID").always(),
    number("TSC").at_least(0),
    number("DAMP").at_least(0),
    whole("MODEL").rejected("leave it 0: principal stresses yield each by itself")};

inline constexpr std::string_view of_a_test = "leave it blank, and give A and B: they are not fitted to a test";
inline constexpr CardLayout mooney_rivlin{material_id,
                                          density,
                                          poisson,
                                          material_stress("A"),
                                          material_stress("B"),
                                          number("REF").rejected("leave it 0: the mesh has no stress")};
inline constexpr CardLayout mooney_rivlin_test{number("SGL").rejected(of_a_test), number("SW").rejected(of_a_test),
                                               number("ST").rejected(of_a_test), whole("LCID").rejected(of_a_test)};

inline constexpr std::string_view not_viscous = "leave it 0: there is no viscosity";
/// Of rubber by an energy of stretches or invariants. not_fitted: what to do instead of a test (N).
constexpr CardLayout energy_of_rubber(std::string_view not_fitted) {
  return {material_id,
          density,
          poisson,
          whole("N").rejected(not_fitted),
          whole("NV").reported("there is no test"),
          number("G").rejected(not_viscous),
          number("SIGF").rejected(not_viscous),
          number("REF").rejected("leave it 0: the mesh has no stress")};
}
inline constexpr CardLayout ogden = energy_of_rubber("leave it 0, and give MU and ALPHA: they are not fitted");
inline constexpr CardLayout ogden_moduli{material_stress("MU1"), material_stress("MU2"), material_stress("MU3"),
                                         material_stress("MU4"), material_stress("MU5"), material_stress("MU6"),
                                         material_stress("MU7"), material_stress("MU8")};
inline constexpr CardLayout ogden_exponents{number("ALPHA1"), number("ALPHA2"), number("ALPHA3"), number("ALPHA4"),
                                            number("ALPHA5"), number("ALPHA6"), number("ALPHA7"), number("ALPHA8")};

inline constexpr CardLayout hyperelastic = energy_of_rubber("leave it 0, and give C10 to C02: they are not fitted");
inline constexpr std::string_view no_mixed_power = "leave it 0: it is no sum of powers of stretches";
inline constexpr CardLayout hyperelastic_constants{
    material_stress("C10"),
    material_stress("C01"),
    number("C11").rejected(no_mixed_power),
    material_stress("C20"),
    material_stress("C02"),
    number("C30").rejected(no_mixed_power),
    whole("THERML").rejected("leave it 0: its constants do not depend on temperature")};
inline constexpr CardLayout blatz_ko{material_id, density, material_stress("G").always().at_least(0),
                                     number("REF").rejected("leave it 0: the mesh has no stress")};
inline constexpr CardLayout hill_foam{material_id,
                                      density,
                                      number("K").reported("of steps and contact stiffnesses"),
                                      number("N").at_least(0),
                                      number("MU").rejected("leave it 0: there is no damping"),
                                      whole("LCID").rejected("leave it 0, and give C and B: they are not fitted"),
                                      whole("FITTYPE").reported("there is no test"),
                                      whole("LCSR").reported("there is no test")};
inline constexpr CardLayout hill_moduli{material_stress("C1"), material_stress("C2"), material_stress("C3"),
                                        material_stress("C4"), material_stress("C5"), material_stress("C6"),
                                        material_stress("C7"), material_stress("C8")};
inline constexpr CardLayout hill_exponents{number("B1"), number("B2"), number("B3"), number("B4"),
                                           number("B5"), number("B6"), number("B7"), number("B8")};
inline constexpr CardLayout hill_unloading{number("R").rejected("leave it 0: it unloads as it is loaded"),
                                           number("M").reported("there is no R")};

inline constexpr std::string_view of_other_axes = "of another AOPT than 2";
inline constexpr CardLayout orthotropic{material_id,
                                        density,
                                        material_stress("EA").always(),
                                        material_stress("EB").always(),
                                        material_stress("EC").always(),
                                        number("PRBA"),
                                        number("PRCA"),
                                        number("PRCB")};
inline constexpr CardLayout orthotropic_shear{material_stress("GAB").always(),
                                              material_stress("GBC").always(),
                                              material_stress("GCA").always(),
                                              number("AOPT"),
                                              number("G").reported("of damping that depends on the frequency"),
                                              number("SIGF").reported("of damping that depends on the frequency")};
inline constexpr CardLayout orthotropic_first{
    number("XP").reported(of_other_axes),
    number("YP").reported(of_other_axes),
    number("ZP").reported(of_other_axes),
    number("A1"),
    number("A2"),
    number("A3"),
    whole("MACF", 1).rejected("leave it 1: the axes are a, b and c"),
    whole("IHIS").rejected("leave it 0: axes and moduli are those of the card")};
inline constexpr CardLayout orthotropic_second{number("V1").reported(of_other_axes),
                                               number("V2").reported(of_other_axes),
                                               number("V3").reported(of_other_axes),
                                               number("D1"),
                                               number("D2"),
                                               number("D3"),
                                               number("BETA").reported(of_other_axes),
                                               number("REF").rejected("leave it 0: the mesh has no stress")};

inline constexpr CardField state_equation_id = whole("EOSID").always();
inline constexpr std::string_view at_rest = "leave it blank: bodies press on nothing at the start";
inline constexpr CardLayout grueneisen{state_equation_id, number("C").always().of(Dimension::velocity),
                                       number("S1"),      number("S2"),
                                       number("S3"),      number("GAMAO"),
                                       number("A"),       number("E0").rejected(at_rest)};
inline constexpr CardLayout grueneisen_volume{number("V0", 1).rejected("leave it blank, or 1")};
inline constexpr CardLayout linear_polynomial{state_equation_id,     material_stress("C0"), material_stress("C1"),
                                              material_stress("C2"), material_stress("C3"), number("C4"),
                                              number("C5"),          number("C6")};
inline constexpr CardLayout linear_polynomial_state{number("E0").rejected(at_rest),
                                                    number("V0", 1).rejected("leave it blank, or 1")};
inline constexpr std::string_view points_of_table = "give the points EV, C and T";
inline constexpr CardLayout tabulated_state{state_equation_id,
                                            number("GAMA"),
                                            number("E0").rejected(at_rest),
                                            number("V0", 1).rejected("leave it blank, or 1"),
                                            whole("LCC").rejected(points_of_table),
                                            whole("LCT").rejected(points_of_table)};
constexpr CardField of_table(std::string_view name) { return number(name).columns(16); }
constexpr CardField stress_of_table(std::string_view name) { return of_table(name).of(Dimension::stress); }
inline constexpr CardLayout table_strains{of_table("EV1"), of_table("EV2"), of_table("EV3"), of_table("EV4"),
                                          of_table("EV5")};
inline constexpr CardLayout table_strains_more{of_table("EV6"), of_table("EV7"), of_table("EV8"), of_table("EV9"),
                                               of_table("EV10")};
inline constexpr CardLayout table_pressures{stress_of_table("C1"), stress_of_table("C2"), stress_of_table("C3"),
                                            stress_of_table("C4"), stress_of_table("C5")};
inline constexpr CardLayout table_pressures_more{stress_of_table("C6"), stress_of_table("C7"), stress_of_table("C8"),
                                                 stress_of_table("C9"), stress_of_table("C10")};
inline constexpr CardLayout table_factors{of_table("T1"), of_table("T2"), of_table("T3"), of_table("T4"),
                                          of_table("T5")};
inline constexpr CardLayout table_factors_more{of_table("T6"), of_table("T7"), of_table("T8"), of_table("T9"),
                                               of_table("T10")};
inline constexpr CardLayout table_moduli{stress_of_table("K1"), stress_of_table("K2"), stress_of_table("K3"),
                                         stress_of_table("K4"), stress_of_table("K5")};
inline constexpr CardLayout table_moduli_more{stress_of_table("K6"), stress_of_table("K7"), stress_of_table("K8"),
                                              stress_of_table("K9"), stress_of_table("K10")};

}  // namespace pinball::layout
