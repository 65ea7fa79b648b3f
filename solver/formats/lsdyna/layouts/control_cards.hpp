#pragma once

#include "common_fields.hpp"

/// *CONTROL_..., *DAMPING_GLOBAL, *DATABASE_... but for contact and histories.
namespace pinball::layout {

inline constexpr CardLayout control_hourglass{whole("IHQ", 1), number("QH", 0.1)};
inline constexpr CardLayout termination{
    number("ENDTIM").always(),
    whole("ENDCYC"),
    number("DTMIN").at_least(0),
    number("ENDENG").told("the run goes on to ENDTIM, and tells how energy is kept"),
    number("ENDMAS", 1e8).told("the run goes on to ENDTIM; added mass is told"),
    whole("NOSOL").told("pinball info DECK checks a deck without running it")};
inline constexpr std::string_view of_selective = "of selective mass scaling (IMSCL), which is not there",
                                  by_dt2ms = "give DT2MS in its place";
inline constexpr CardLayout timestep{number("DTINIT").told("the first step is the stable one, too"),
                                     number("TSSFAC", 0.9),
                                     whole("ISDO").told(of_shells),
                                     number("TSLIMT").told(of_shells),
                                     number("DT2MS"),
                                     whole("LCTM").refused("leave it out: the step is TSSFAC times the stable one"),
                                     whole("ERODE").from(0, 1),
                                     whole("MS1ST")};
inline constexpr CardLayout timestep_scaling{number("DT2MSF").refused(by_dt2ms),
                                             whole("DT2MSLC").refused(by_dt2ms),
                                             whole("IMSCL"),
                                             gap,
                                             gap,
                                             number("RMSCL").told(of_selective),
                                             number("EMSCL").told("added mass feels gravity as all mass does"),
                                             whole("IHDO").told("the stable step is that of the element as it is")};
inline constexpr CardLayout timestep_more{number("RMAVG").told(of_selective), whole("IGADO").told(no_splines),
                                          number("DTUSR").told("there are no elements that users program"),
                                          whole("DTDYNV").told(no_splines)};
inline constexpr CardLayout bulk_viscosity{number("Q1", 1.5), number("Q2", 0.06), whole("TYPE", 1),
                                           whole("BTYPE").told(of_beams), whole("TSTYPE").told("of thick shells")};
inline constexpr std::string_view of_solvers = "of other ways to solve";
inline constexpr CardLayout solution{whole("SOLN").refused("heat is not computed: leave it 0"),
                                     whole("NLQ").told(of_solvers),
                                     whole("ISNAN").told("what is no number is always looked for"),
                                     whole("LCINT", 100).told(as_they_are),
                                     whole("LCACC").told(of_solvers),
                                     whole("NCDCF", 1).told(of_solvers),
                                     whole("NOCOPY").told(of_solvers),
                                     whole("CRVP").told(of_solvers)};

inline constexpr CardLayout damping{whole("LCID").refused("give VALDMP, a constant, in its place"),
                                    number("VALDMP"),
                                    number("STX"),
                                    number("STY"),
                                    number("STZ"),
                                    rotation("SRX"),
                                    rotation("SRY"),
                                    rotation("SRZ")};

inline constexpr std::string_view as_dt = "give the times of output as DT",
                                  other_form = "fields are written in the form of this program, all of them";
inline constexpr CardLayout plot{number("DT"), whole("LCDT").told(as_dt),
                                 whole("BEAM").told("there are no springs and beams"), whole("NPLTC").told(as_dt),
                                 whole("PSETID").told(other_form)};
inline constexpr CardLayout plot_more{whole("IOOPT").told(other_form),   number("RATE").told(other_form),
                                      number("CUTOFF").told(other_form), number("WINDOW").told(other_form),
                                      whole("TYPE").told(other_form),    whole("PSET").told(other_form)};
inline constexpr std::string_view rows = "rows are written in the form of history.csv, at intervals of DT";
inline constexpr CardLayout ascii{number("DT"),
                                  whole("BINARY").told(rows),
                                  whole("LCUR").told(rows),
                                  whole("IOOPT", 1).told(rows),
                                  number("OPTION1").told(rows),
                                  number("OPTION2").told(rows),
                                  number("OPTION3").told(rows),
                                  number("OPTION4").told(rows)};

}  // namespace pinball::layout
