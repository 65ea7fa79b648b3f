#pragma once

#include "radioss_common.hpp"

/// What holds, moves, loads and stops nodes, rigid bodies and what is watched.
namespace pinball::radioss {

inline constexpr CardLayout held{word("Trarot").columns(10), whole("skew_ID"), whole("grnod_ID")};
inline constexpr CardLayout motion{whole("fct_IDT").always(),
                                   word("Dir"),
                                   whole("skew_ID"),
                                   sensor("sens_ID"),
                                   whole("grnod_ID").always(),
                                   whole("frame_ID").rejected("give a /SKEW/FIX: frames that move are not there"),
                                   whole("Icoor").rejected("give directions that are straight")};
inline constexpr CardLayout motion_scales{real("Ascale_x", 1), real("Fscale_y", 1), real("Tstart"),
                                          real("Tstop", 1e30).at_least(0)};
inline constexpr CardLayout nodal_load{whole("fct_IDT").always(),  word("Dir"),
                                       whole("skew_ID"),           sensor("sens_ID"),
                                       whole("grnod_ID").always(), whole("Itypfun", 1).from(0, 1),
                                       real("Ascale_x", 1),        real("Fscale_y", 1)};
inline constexpr CardLayout pressure{whole("surf_ID").always(),
                                     whole("fct_IDT").always(),
                                     sensor("sens_ID"),
                                     whole("Ipinch").reported(of_shells),
                                     whole("Idel").reported("faces of eroded elements are free"),
                                     whole("Itypfun", 1).from(0, 1),
                                     real("Ascale_x", 1),
                                     real("Fscale_y", 1)};
inline constexpr CardLayout gravity{whole("fct_IDT"),  word("Dir"), whole("skew_ID"),    sensor("sens_ID"),
                                    whole("grnod_ID"), blank(10),   real("Ascale_x", 1), real("Fscale_y", 1)};
inline constexpr CardLayout velocity{real("Vx"), real("Vy"), real("Vz"), whole("grnod_ID"), whole("skew_ID")};
inline constexpr CardLayout velocity_of_turning{real("Vxr"), real("Vyr"), real("Vzr"), whole("grnod_ID").always(),
                                                whole("skew_ID")};
inline constexpr CardLayout velocity_axis{word("Dir"), whole("frame_ID"), whole("grnod_ID")};
inline constexpr CardLayout velocity_spin{real("Vxt"), real("Vyt"), real("Vzt"), real("Vr")};
inline constexpr CardLayout velocity_start{real("Tstart").rejected("velocities are those of the start"),
                                           sensor("sens_ID")};
inline constexpr CardLayout stress_normal{whole("brick_ID").always(), real("sigma_x"), real("sigma_y"),
                                          real("sigma_z")};
inline constexpr CardLayout stress_shear{real("sigma_xy"), real("sigma_yz"), real("sigma_zx")};
inline constexpr CardLayout stress_plastic{whole("brick_ID").always(), real("eps_p").at_least(0)};
inline constexpr std::string_view one_point = "there is one point", one_element = "give each element its own";
inline constexpr CardLayout stress_full{whole("brick_ID").always(),
                                        whole("Nb_integr").always(),
                                        whole("Isolnod").always(),
                                        whole("Isolid"),
                                        whole("nptr").reported(one_point),
                                        whole("npts").reported(one_point),
                                        whole("nptt").reported(one_point),
                                        whole("nlay").reported(one_point),
                                        whole("grbric_ID").rejected(one_element)};
inline constexpr CardLayout stress_full_energy{
    real("Eint").reported("the internal energy begins with that of the stress"),
    real("RHO").reported("masses are those of the undeformed material")};
inline constexpr CardLayout stress_full_normal{real("sigma_1"), real("sigma_2"), real("sigma_3")};
inline constexpr CardLayout stress_full_plastic{real("Epsilon_p").at_least(0)};
inline constexpr CardLayout wall_nodes{whole("node_ID"), whole("Slide").from(0, 2), whole("grnd_ID1"),
                                       whole("grnd_ID2"), whole("Iform").reported("walls are exact")};
inline constexpr CardLayout wall_friction{real("d"), real("fric"), real("Diameter").reported("of other walls"),
                                          real("ffac").reported("forces of walls are not smoothed"),
                                          whole("ifq").reported("forces of walls are not smoothed")};
inline constexpr CardLayout wall_point{real("XM"), real("YM"), real("ZM")};
inline constexpr CardLayout wall_mass{real("Mass"), real("VX0"), real("VY0"), real("VZ0")};
inline constexpr CardLayout wall_head{real("XM1"), real("YM1"), real("ZM1")};
inline constexpr CardLayout rigid_body{whole("node_ID").always(),
                                       sensor("sens_ID"),
                                       whole("Skew_ID"),
                                       whole("Ispher", 2).from(0, 2),
                                       real("Mass").at_least(0),
                                       whole("grnd_ID").always(),
                                       whole("Ikrem").reported("rigid walls know no rigid bodies"),
                                       whole("ICoG", 1).from(0, 4),
                                       whole("surf_ID").reported("of ellipsoids")};
inline constexpr CardLayout rigid_inertia{real("Jxx").at_least(0), real("Jyy").at_least(0), real("Jzz").at_least(0)};
inline constexpr CardLayout rigid_products{real("Jxy"), real("Jyz"), real("Jxz")};
inline constexpr CardLayout rigid_options{whole("Ioptoff").reported("rigid bodies stay rigid"),
                                          whole("Iexpams").reported("of advanced mass scaling"),
                                          whole("Ifail").rejected("rigid bodies hold their nodes for ever")};
inline constexpr std::string_view exact_joints = "joints are exact", no_axis = "this joint has no axis";
inline constexpr CardLayout joint{whole("Type").always(),
                                  real("Kn").reported(exact_joints),
                                  real("ScF").reported(exact_joints),
                                  real("Cr").reported(exact_joints),
                                  sensor("sens_ID"),
                                  whole("Skew_ID1").reported(no_axis),
                                  whole("Skew_ID2").reported(no_axis)};
inline constexpr std::string_view free_joints = "leave it 0: joints have no resistance in what they leave free";
inline constexpr CardLayout joint_stiffness{real("Kri").at_least(0), whole("fct_Kri").rejected(free_joints),
                                            real("SAi-").rejected(free_joints), real("SAi+").rejected(free_joints),
                                            whole("Icomb_ri").rejected(free_joints)};
inline constexpr CardLayout joint_damping{real("Cri").rejected(free_joints), whole("fct_Cri").rejected(free_joints)};
inline constexpr CardLayout joint_friction{real("Kfri").rejected(free_joints), real("FMi").rejected(free_joints),
                                           whole("fct_FMi").rejected(free_joints)};
inline constexpr CardLayout spring{whole("sprg_ID"), whole("node_ID1").always(), whole("node_ID2").always(),
                                   whole("node_ID3").reported(no_axis), whole("node_ID4").reported(no_axis)};
inline constexpr CardLayout damping{real("Alpha"),
                                    real("Beta").rejected("there is no damping in proportion to stiffness"),
                                    whole("grnod_ID"),
                                    whole("skew_ID").rejected("damping has no direction"),
                                    real("Tstart").rejected("damping is from the start to the end"),
                                    real("Tstop", 1e30).rejected("damping is from the start to the end")};
inline constexpr CardLayout damping_more{real("Alpha_more").rejected("damping has no direction"),
                                         real("Beta_more").rejected("damping has no direction")};
inline constexpr CardLayout variables{word("var1"), word("var2"), word("var3"), word("var4"), word("var5"),
                                      word("var6"), word("var7"), word("var8"), word("var9"), word("var10")};
inline constexpr CardLayout watched_node{whole("node_ID").always(), whole("skew_ID").reported("in the global system"),
                                         word("name").columns(80)};
inline constexpr CardLayout watched_brick{whole("brick_ID").always(), word("name").columns(90)};
inline constexpr CardLayout added_mass{real("MASS").always(), whole("grnd_ID").always()};

}  // namespace pinball::radioss
