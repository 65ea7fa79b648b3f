#pragma once

#include "common_fields.hpp"

/// *CONTROL_..., *DAMPING_GLOBAL, *DATABASE_... but for contact and histories.
namespace pinball::layout {

inline constexpr CardLayout control_hourglass{whole("IHQ", 1), number("QH", 0.1).at_least(0)};
inline constexpr CardLayout termination{
    number("ENDTIM").always(),
    whole("ENDCYC").at_least(0),
    number("DTMIN").at_least(0),
    number("ENDENG").reported("the run goes on to ENDTIM, and tells how energy is kept"),
    number("ENDMAS", 1e8).reported("the run goes on to ENDTIM; added mass is reported"),
    whole("NOSOL").reported("pinball info DECK checks a deck without running it")};
inline constexpr std::string_view of_selective = "of selective mass scaling (IMSCL), which is not there",
                                  by_dt2ms = "give DT2MS in its place";
inline constexpr CardLayout timestep{number("DTINIT").reported("the first step is the stable one, too"),
                                     number("TSSFAC", 0.9),
                                     whole("ISDO").reported(of_shells),
                                     number("TSLIMT").reported(of_shells),
                                     number("DT2MS"),
                                     whole("LCTM").rejected("leave it out: the step is TSSFAC times the stable one"),
                                     whole("ERODE").from(0, 1),
                                     whole("MS1ST")};
inline constexpr CardLayout timestep_scaling{number("DT2MSF").rejected(by_dt2ms),
                                             whole("DT2MSLC").rejected(by_dt2ms),
                                             whole("IMSCL"),
                                             gap,
                                             gap,
                                             number("RMSCL").reported(of_selective),
                                             number("EMSCL").reported("added mass feels gravity as all mass does"),
                                             whole("IHDO").reported("the stable step is that of the element as it is")};
inline constexpr CardLayout timestep_more{number("RMAVG").reported(of_selective), whole("IGADO").reported(no_splines),
                                          number("DTUSR").reported("there are no elements that users program"),
                                          whole("DTDYNV").reported(no_splines)};
inline constexpr CardLayout bulk_viscosity{number("Q1", 1.5).at_least(0), number("Q2", 0.06).at_least(0),
                                           whole("TYPE", 1), whole("BTYPE").reported(of_beams),
                                           whole("TSTYPE").reported("of thick shells")};
inline constexpr std::string_view of_solvers = "of other ways to solve";
inline constexpr CardLayout solution{whole("SOLN").rejected("heat is not computed: leave it 0"),
                                     whole("NLQ").reported(of_solvers),
                                     whole("ISNAN").reported("what is no number is always looked for"),
                                     whole("LCINT", 100).reported(as_they_are),
                                     whole("LCACC").reported(of_solvers),
                                     whole("NCDCF", 1).reported(of_solvers),
                                     whole("NOCOPY").reported(of_solvers),
                                     whole("CRVP").reported(of_solvers)};

/// *CONTROL_DYNAMIC_RELAXATION, which is there as often as not for its defaults.
inline constexpr std::string_view nothing_relaxes = "nothing relaxes before the run";
inline constexpr CardLayout relaxation{
    number("NRCYCK", 250).reported(nothing_relaxes),   number("DRTOL", 1e-3).reported(nothing_relaxes),
    number("DRFCTR", 0.995).reported(nothing_relaxes), number("DRTERM").reported(nothing_relaxes),
    number("TSSFDR").reported(nothing_relaxes),        whole("IRELAL").reported(nothing_relaxes),
    number("EDTTL", 0.04).reported(nothing_relaxes),   whole("IDRFLG")};

inline constexpr CardLayout damping{whole("LCID").rejected("give VALDMP, a constant, in its place"),
                                    number("VALDMP"),
                                    number("STX"),
                                    number("STY"),
                                    number("STZ"),
                                    rotation("SRX"),
                                    rotation("SRY"),
                                    rotation("SRZ")};

inline constexpr std::string_view as_dt = "give the times of output as DT",
                                  other_form = "fields are written in the form of this program, all of them";
inline constexpr CardLayout plot{number("DT"), whole("LCDT").reported(as_dt),
                                 whole("BEAM").reported("there are no springs and beams"),
                                 whole("NPLTC").reported(as_dt), whole("PSETID").reported(other_form)};
inline constexpr CardLayout plot_more{whole("IOOPT").reported(other_form),   number("RATE").reported(other_form),
                                      number("CUTOFF").reported(other_form), number("WINDOW").reported(other_form),
                                      whole("TYPE").reported(other_form),    whole("PSET").reported(other_form)};
inline constexpr std::string_view rows = "rows are written in the form of history.csv, at intervals of DT";
inline constexpr CardLayout ascii{number("DT"),
                                  whole("BINARY").reported(rows),
                                  whole("LCUR").reported(rows),
                                  whole("IOOPT", 1).reported(rows),
                                  number("OPTION1").reported(rows),
                                  number("OPTION2").reported(rows),
                                  number("OPTION3").reported(rows),
                                  number("OPTION4").reported(rows)};

}  // namespace pinball::layout
