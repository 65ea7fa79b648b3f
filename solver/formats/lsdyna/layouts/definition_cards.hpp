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

}  // namespace pinball::layout
