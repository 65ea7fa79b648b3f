#pragma once

#include "radioss_common.hpp"

/// Input of the engine, between blanks, and what the starter has of controls.
namespace pinball::radioss {

inline constexpr CardLayout begin_name{word("run_name").columns(100)};
inline constexpr CardLayout begin_version{whole("Invers").always(), whole("Irun").reported("runs have no numbers")};
inline constexpr CardLayout begin_input{word("mass_in").columns(20), word("length_in").columns(20),
                                        word("time_in").columns(20)};
inline constexpr CardLayout begin_work{word("mass_work").columns(20), word("length_work").columns(20),
                                       word("time_work").columns(20)};
inline constexpr CardLayout unit_line{word("MUNIT").columns(20), word("LUNIT").columns(20), word("TUNIT").columns(20)};

inline constexpr CardLayout analysis{whole("N2D3D").rejected("plane and axisymmetric bodies"), blank(10),
                                     whole("IPARITH").reported("results are the same bits for any number of threads"),
                                     whole("ISUB").reported("of other programs"),
                                     whole("Icase").reported("of other programs")};
inline constexpr CardLayout random_noise{real("Xalea").rejected("nodes are where they are given"),
                                         real("Seed").reported("there is no noise")};

inline constexpr CardLayout run{real("Tstop").always()};
inline constexpr CardLayout anim_step{real("Tstart").reported("fields are from the start"), real("Tfreq")};
inline constexpr CardLayout th_step{real("DT_his")};
inline constexpr CardLayout step{real("Tsca", 0.9), real("Tmin").reported("no step is too small")};
inline constexpr CardLayout step_mass{real("Tsca", 0.9), real("Tmin")};
inline constexpr CardLayout first_step{real("Tini").reported("the first step is stable by itself"),
                                       real("Tmax").reported("steps are as long as is stable")};

inline constexpr std::string_view to_the_end =
    "a run goes to its end, and says how far its energy and its mass are off";
inline constexpr CardLayout limits{real("Emax").reported(to_the_end),   real("Mmax").reported(to_the_end),
                                   real("Nmax").reported(to_the_end),   whole("NTH").reported(to_the_end),
                                   whole("NANIM").reported(to_the_end), whole("NERR_POSIT").reported(to_the_end)};

}  // namespace pinball::radioss
