#pragma once

#include "radioss_common.hpp"

/// Materials, equations of state, failure, and properties of solids.
namespace pinball::radioss {

inline constexpr std::string_view not_smoothed = "rates are not smoothed",
                                  exact_return = "stresses are returned exactly",
                                  no_deletion =
                                      "solids go on without shear stress there, which is not done: leave it 0, "
                                      "or give /FAIL/JOHNSON";

inline constexpr CardLayout density{real("RHO_I").always(),
                                    real("RHO_0").rejected("leave it 0: bodies press on nothing at the start")};
inline constexpr CardLayout elasticity{real("E").always(), real("nu").always()};

inline constexpr CardLayout johnson_elasticity{real("E").always(), real("nu").always(), whole("Iflag").from(0, 1),
                                               whole("VP", 2).from(0, 3),
                                               real("Pmin").rejected("leave it 0, or give /MAT/HYD_JCOOK")};
/// With Iflag 1 the first three are SIG_Y, UTS and EUTS.
inline constexpr CardLayout johnson_hardening{real("a").always(), real("b"), real("n", 1),
                                              real("EPS_p_max").at_least(0), real("SIG_max0").at_least(0)};
inline constexpr CardLayout johnson_rate{real("c"),
                                         real("EPS_DOT_0"),
                                         whole("ICC", 1).from(0, 2),
                                         whole("Fsmooth").reported(not_smoothed),
                                         real("F_cut").reported(not_smoothed),
                                         real("Chard").from(0, 1)};
inline constexpr CardLayout johnson_heat{real("m", 1), real("T_melt").at_least(0), real("rhoC_p"), real("T_r", 300),
                                         real("T_max").rejected("leave it 0: there is no other exponent above it")};

inline constexpr CardLayout hydro_hardening{real("A").always(), real("B"), real("n", 1), real("eps_max").at_least(0),
                                            real("sig_max").at_least(0)};
inline constexpr CardLayout hydro_cutoff{real("Pmin").from(-1e30, 0)};
inline constexpr CardLayout hydro_rate{real("C"), real("EPS_DOT_0"), real("M", 1), real("Tmelt").at_least(0),
                                       real("Tmax").rejected("leave it 0: there is no other exponent above it")};
inline constexpr CardLayout hydro_heat{real("rhoC_p"), blank(40), real("T_r", 300)};

inline constexpr CardLayout brittle_modulus{real("G").always()};
inline constexpr CardLayout brittle_strength{real("a").always(), real("b"), real("m"), real("n")};
inline constexpr CardLayout brittle_rate{real("c"), real("EPS_DOT_0"), real("SIGMA_FMAX").at_least(0),
                                         real("Fcut").reported(not_smoothed)};
inline constexpr CardLayout brittle_limits{real("T").always().at_least(0), real("HEL").always(), real("PHEL").always()};
inline constexpr CardLayout brittle_damage{real("D1").at_least(0), real("D2").at_least(0), blank(10),
                                           whole("IDEL").from(0, 3), real("EPSMAX").at_least(0)};
inline constexpr CardLayout brittle_pressure{real("K1").always(), real("K2"), real("K3"), real("BETA").from(0, 1)};

inline constexpr CardLayout soil_strength{real("A0").at_least(0), real("A1").at_least(0), real("A2").at_least(0),
                                          real("Amax").at_least(0)};
inline constexpr CardLayout soil_function{whole("func_IDf").always(), blank(10), real("Kt").always(), real("FscaleP")};
inline constexpr CardLayout soil_limits{real("P_min").from(-1e30, 0),
                                        real("P_ext").rejected("leave it 0: bodies press on nothing at the start")};
inline constexpr CardLayout soil_unloading{real("B").at_least(0), real("Mu_max").at_least(0)};
inline constexpr CardLayout soil_polynomial{real("C0").rejected("leave it 0: bodies press on nothing at the start"),
                                            real("C1").at_least(0), real("C2"), real("C3")};

inline constexpr CardLayout foam_modulus{real("E").always(), whole("Ka").from(0, 2), whole("func_IDf"),
                                         real("Fscale_curv")};
inline constexpr CardLayout foam_air{real("P0").at_least(0), real("Phi").from(0, 1),
                                     real("Gamma_0").rejected("leave it 0: bodies have the volume of their density")};
inline constexpr CardLayout foam_yield{real("A"), real("B"), real("C"), real("SIG_COFF").at_least(0)};

inline constexpr CardLayout tabulated_elasticity{real("E").always(), real("nu").always(),
                                                 real("Eps_p_max").rejected(no_deletion),
                                                 real("Eps_t").rejected("leave it 0: there is no damage by tension"),
                                                 real("Eps_m").rejected("leave it 0: there is no damage by tension")};
inline constexpr CardLayout tabulated_rates{whole("N_funct").always(),
                                            whole("F_smooth").from(0, 2),
                                            real("C_hard"),
                                            real("F_cut").reported(not_smoothed),
                                            real("Eps_f").rejected("leave it 0: there is no damage by tension"),
                                            blank(10),
                                            whole("VP").from(0, 1)};
inline constexpr CardLayout tabulated_pressure{
    whole("fct_IDp").rejected("yield stresses do not depend on pressure"),
    real("Fscale", 1).reported("there is no fct_IDp"), whole("Fct_IDE").rejected("the modulus does not change"),
    real("EInf").rejected("the modulus does not change"), real("CE").rejected("the modulus does not change")};
inline constexpr CardLayout five_functions{whole("func_ID1"), whole("func_ID2"), whole("func_ID3"), whole("func_ID4"),
                                           whole("func_ID5")};
inline constexpr CardLayout five_scales{real("Fscale_1"), real("Fscale_2"), real("Fscale_3"), real("Fscale_4"),
                                        real("Fscale_5")};
inline constexpr CardLayout five_rates{real("Eps_dot_1"), real("Eps_dot_2"), real("Eps_dot_3"), real("Eps_dot_4"),
                                       real("Eps_dot_5")};

inline constexpr CardLayout cowper_elasticity{real("E").always(), real("nu").always(), whole("Iflag").from(0, 1)};
inline constexpr CardLayout cowper_hardening{real("A").always(), real("B"), real("n", 1),
                                             real("C_HARD").reported("solids of this law harden isotropically"),
                                             real("sigmax").at_least(0)};
inline constexpr CardLayout cowper_rate{real("C"),
                                        real("P", 1),
                                        whole("ICC", 1).from(0, 2),
                                        whole("ISMOOTH").reported(not_smoothed),
                                        real("F_CUT").reported(not_smoothed),
                                        blank(10),
                                        whole("VP", 2).from(0, 3)};
inline constexpr CardLayout cowper_failure{real("EPS_MAX").rejected(no_deletion),
                                           real("EPST1").rejected("leave it 0: there is no damage by tension"),
                                           real("EPST2").rejected("leave it 0: there is no damage by tension")};
inline constexpr CardLayout cowper_function{whole("fct_IDp").rejected("give A, B and n, or /MAT/PLAS_TAB"), blank(10),
                                            real("Fscale").reported("there is no fct_IDp")};

inline constexpr CardLayout ogden_volume{real("nu", 0.495),
                                         real("sigma_cut").rejected("there is no such limit: leave it 0"),
                                         blank(10),
                                         whole("funIDbulk").rejected("the bulk modulus does not change"),
                                         real("Fscale_bulk", 1).reported("there is no funIDbulk"),
                                         whole("M").rejected("there is no viscosity: leave it 0"),
                                         whole("Iform", 1).from(0, 2)};
inline constexpr CardLayout visc_hyp{
    real("nu").from(0, 1), whole("N").always().from(1, 10), whole("M").rejected("there is no viscosity: leave it 0"),
    real("mu_max").reported("there is no viscosity"), whole("Flag_Visc").reported("there is no viscosity")};
inline constexpr CardLayout ogden_moduli{real("Mu_1"), real("Mu_2"), real("Mu_3"), real("Mu_4"), real("Mu_5")};
inline constexpr CardLayout ogden_moduli_more{real("Mu_6"), real("Mu_7"), real("Mu_8"), real("Mu_9"), real("Mu_10")};
inline constexpr CardLayout ogden_exponents{real("alpha_1"), real("alpha_2"), real("alpha_3"), real("alpha_4"),
                                            real("alpha_5")};
inline constexpr CardLayout ogden_exponents_more{real("alpha_6"), real("alpha_7"), real("alpha_8"), real("alpha_9"),
                                                 real("alpha_10")};

inline constexpr std::string_view at_rest = "leave it 0: bodies press on nothing at the start";
inline constexpr CardLayout grueneisen{real("C").always(), real("S1"), real("S2"), real("S3"),
                                       real("P0").rejected(at_rest)};
inline constexpr CardLayout grueneisen_energy{real("GAMMA_0"), real("a"), real("E0").rejected(at_rest),
                                              real("RHO_0").rejected(at_rest), real("Psh").rejected(at_rest)};
inline constexpr CardLayout polynomial{real("C0"), real("C1").always(), real("C2"), real("C3")};
inline constexpr CardLayout polynomial_energy{real("C4"), real("C5"), real("E0").rejected(at_rest),
                                              real("Psh").rejected(at_rest), real("RHO_0").rejected(at_rest)};

inline constexpr CardLayout compaction{
    real("C0").rejected(at_rest), real("C1").always(), real("C2"), real("C3"), blank(10), whole("IFORM").from(0, 2)};
inline constexpr CardLayout compaction_unloading{real("Mue_min").at_least(0), real("Mue_max").at_least(0),
                                                 real("B").always()};
inline constexpr CardLayout compaction_function{blank(10), whole("P_fun_id").always(), real("Fscale"), real("Xscale"),
                                                blank(30), whole("IFORM").from(0, 2)};
inline constexpr CardLayout compaction_moduli{real("Mue_min").at_least(0), real("Mue_max").at_least(0),
                                              real("Bmin").always(), real("Bmax").always()};
inline constexpr CardLayout compaction_shift{real("PSH").rejected(at_rest), real("RHO_0").rejected(at_rest)};

inline constexpr CardLayout linear_state{real("P0").rejected(at_rest), real("B").always(),
                                         real("PSH").rejected(at_rest), real("RHO_0").rejected(at_rest)};

inline constexpr CardLayout fail_johnson{real("D1"), real("D2"), real("D3"), real("D4"), real("D5")};
inline constexpr CardLayout fail_johnson_rate{real("EPSILON_DOT_0"),
                                              whole("IFAIL_SH").reported(of_shells),
                                              whole("IFAIL_SO", 1).from(0, 2),
                                              real("EPSF_MIN").rejected("leave it 0"),
                                              real("DADV").reported("of cracks of shells"),
                                              blank(10),
                                              whole("IXFEM").reported("of cracks of shells")};
inline constexpr CardLayout fail_johnson_points{whole("FAILIP").reported("elements have one point")};

inline constexpr std::string_view large_strains = "strains are large ones", of_tetrahedra = "of tetrahedra";
inline constexpr CardLayout solid{whole("Isolid"),
                                  whole("Ismstr"),
                                  whole("Iale").rejected("the mesh goes with the material"),
                                  whole("Icpre").reported("elements have one point"),
                                  whole("Itetra10").reported(of_tetrahedra),
                                  whole("Inpts").reported("elements have one point"),
                                  whole("Itetra4").reported(of_tetrahedra),
                                  whole("Iframe").reported("stresses turn with the material"),
                                  real("dn").reported("assumed strains need no damping")};
inline constexpr CardLayout solid_viscosity{real("qa", 1.1).at_least(0), real("qb", 0.05).at_least(0),
                                            real("h", 0.1).at_least(0),
                                            real("Lambda").rejected("there is no such viscosity: leave it 0"),
                                            real("mu").rejected("there is no such viscosity: leave it 0")};
/// From version 2025 on limits of distortion stand behind the step, before it Istrain and Ihkt.
inline constexpr CardLayout solid_step{real("dt_min").reported("elements have no least step of their own"),
                                       whole("Istrain").reported("of output"),
                                       whole("Ihkt").reported("assumed strains have no such choice")};
inline constexpr CardLayout default_solid{whole("Isolid"),
                                          whole("Ismstr"),
                                          whole("Icpre").reported("elements have one point"),
                                          whole("Istrain").reported("of output"),
                                          whole("Itetra4").reported(of_tetrahedra),
                                          whole("Itetra10").reported(of_tetrahedra),
                                          whole("Imas").reported("masses are an eighth of each element"),
                                          whole("Iframe").reported("stresses turn with the material")};

inline constexpr std::string_view of_rigid_shells = "of shells that deform";
inline constexpr CardLayout shell_form{
    whole("Ishell").reported(of_rigid_shells),     whole("Ismstr").reported(of_rigid_shells),
    whole("Ish3n").reported(of_rigid_shells),      whole("Idrill").reported(of_rigid_shells),
    whole("Ipinch").reported(of_rigid_shells),     blank(10),
    real("P_thick_fail").reported(of_rigid_shells)};
inline constexpr CardLayout shell_damping{real("hm").reported(of_rigid_shells), real("hf").reported(of_rigid_shells),
                                          real("hr").reported(of_rigid_shells), real("dm").reported(of_rigid_shells),
                                          real("dn").reported(of_rigid_shells)};
inline constexpr CardLayout shell_thickness{whole("N").reported(of_rigid_shells),
                                            whole("Istrain").reported(of_rigid_shells),
                                            real("Thick").at_least(0),
                                            real("Ashear").reported(of_rigid_shells),
                                            blank(10),
                                            whole("Ithick").reported(of_rigid_shells),
                                            whole("Iplas").reported(of_rigid_shells)};

}  // namespace pinball::radioss
