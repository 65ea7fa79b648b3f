#include "radioss_cards.hpp"

#include <solver/formats/radioss/scan/radioss_names.hpp>

#include "radioss_boundary_cards.hpp"
#include "radioss_contact_cards.hpp"
#include "radioss_control_cards.hpp"
#include "radioss_material_cards.hpp"
#include "radioss_mesh_cards.hpp"

namespace pinball {

namespace {

using Table = std::vector<RadiossCards>;
using Lines = std::vector<const CardLayout*>;

void add(Table& table, const char* keyword, const Lines& lines) {
  table.push_back({keyword, radioss_has_title(keyword), lines});
}

void add_mesh(Table& table) {
  namespace r = radioss;
  add(table, "BEGIN", {&r::begin_name, &r::begin_version, &r::begin_input, &r::begin_work});
  add(table, "UNIT", {&r::unit_line});
  add(table, "NODE", {&r::node});
  add(table, "BRICK", {&r::brick});
  add(table, "PENTA6", {&r::penta6});
  add(table, "TETRA4", {&r::tetra4});
  add(table, "TETRA10", {&r::tetra10, &r::tetra10_nodes});
  add(table, "BRIC20", {&r::bric20, &r::bric20_edges, &r::bric20_more});
  add(table, "SHELL", {&r::shell});
  add(table, "SH3N", {&r::sh3n});
  add(table, "PART", {&r::part});
  for (const char* keyword : {"SUBSET",          "GRNOD/NODE",    "GRNOD/GRNOD",   "GRNOD/GRBRIC",    "GRNOD/PART",
                              "GRNOD/SUBSET",    "GRNOD/MAT",     "GRNOD/PROP",    "GRNOD/SURF",      "GRNOD/BOX",
                              "GRBRIC/BRIC",     "GRBRIC/GRBRIC", "GRBRIC/PART",   "GRBRIC/SUBSET",   "GRBRIC/MAT",
                              "GRBRIC/PROP",     "GRBRIC/BOX",    "SURF/SURF",     "SURF/PART/EXT",   "SURF/PART/ALL",
                              "SURF/SUBSET/EXT", "SURF/MAT/EXT",  "SURF/PROP/EXT", "SURF/GRBRIC/EXT", "LINE/SURF"})
    add(table, keyword, {&r::members});
  for (const char* keyword : {"GRNOD/GENE", "GRBRIC/GENE"}) add(table, keyword, {&r::ranges});
  for (const char* keyword : {"GRNOD/GEN_INCR", "GRBRIC/GEN_INCR"}) add(table, keyword, {&r::range_steps});
  add(table, "SURF/SEG", {&r::segment});
  add(table, "BOX/RECTA", {&r::box_system, &r::box_low, &r::box_high});
  add(table, "SKEW/FIX", {&r::axes_origin, &r::axes_y, &r::axes_z});
  add(table, "FRAME/FIX", {&r::frame_origin, &r::axes_y, &r::axes_z});
  add(table, "FUNCT", {&r::function_point});
}

void add_materials(Table& table) {
  namespace r = radioss;
  add(table, "PROP/SOLID", {&r::solid, &r::solid_viscosity, &r::solid_step});
  add(table, "PROP/SHELL", {&r::shell_form, &r::shell_damping, &r::shell_thickness});
  add(table, "DEF_SOLID", {&r::default_solid});
  add(table, "MAT/ELAST", {&r::density, &r::elasticity});
  add(table, "MAT/RIGID", {&r::density, &r::elasticity});
  add(table, "MAT/PLAS_JOHNS",
      {&r::density, &r::johnson_elasticity, &r::johnson_hardening, &r::johnson_rate, &r::johnson_heat});
  add(table, "MAT/HYDPLA", {&r::density, &r::elasticity, &r::hydro_hardening, &r::hydro_cutoff});
  add(table, "MAT/HYD_JCOOK",
      {&r::density, &r::elasticity, &r::hydro_hardening, &r::hydro_cutoff, &r::hydro_rate, &r::hydro_heat});
  add(table, "MAT/PLAS_TAB",
      {&r::density, &r::tabulated_elasticity, &r::tabulated_rates, &r::tabulated_pressure, &r::five_functions,
       &r::five_scales, &r::five_rates});
  add(table, "MAT/COWPER",
      {&r::density, &r::cowper_elasticity, &r::cowper_hardening, &r::cowper_rate, &r::cowper_failure,
       &r::cowper_function});
  add(table, "MAT/VISC_HYP",
      {&r::density, &r::visc_hyp, &r::ogden_moduli, &r::ogden_moduli_more, &r::ogden_exponents,
       &r::ogden_exponents_more});
  add(table, "MAT/OGDEN",
      {&r::density, &r::ogden_volume, &r::ogden_moduli, &r::ogden_moduli_more, &r::ogden_exponents,
       &r::ogden_exponents_more});
  add(table, "MAT/JOHN_HOLM",
      {&r::density, &r::brittle_modulus, &r::brittle_strength, &r::brittle_rate, &r::brittle_limits, &r::brittle_damage,
       &r::brittle_pressure});
  add(table, "MAT/DPRAG",
      {&r::density, &r::elasticity, &r::soil_strength, &r::soil_function, &r::soil_limits, &r::soil_unloading});
  add(table, "MAT/DPRAG1",
      {&r::density, &r::elasticity, &r::soil_strength, &r::soil_polynomial, &r::soil_limits, &r::soil_unloading});
  add(table, "MAT/FOAM_PLAS", {&r::density, &r::foam_modulus, &r::foam_air, &r::foam_yield});
  add(table, "EOS/COMPACTION", {&r::compaction, &r::compaction_unloading, &r::compaction_shift});
  add(table, "EOS/COMPACTION2", {&r::compaction_function, &r::compaction_moduli, &r::compaction_shift});
  add(table, "EOS/LINEAR", {&r::linear_state});
  add(table, "EOS/GRUNEISEN", {&r::grueneisen, &r::grueneisen_energy});
  add(table, "EOS/POLYNOMIAL", {&r::polynomial, &r::polynomial_energy});
  add(table, "FAIL/JOHNSON", {&r::fail_johnson, &r::fail_johnson_rate, &r::fail_johnson_points});
}

void add_boundaries(Table& table) {
  namespace r = radioss;
  add(table, "BCS", {&r::held});
  for (const char* keyword : {"IMPVEL", "IMPDISP", "IMPACC"}) add(table, keyword, {&r::motion, &r::motion_scales});
  add(table, "INIVEL/TRA", {&r::velocity, &r::velocity_start});
  add(table, "INIVEL/ROT", {&r::velocity_of_turning, &r::velocity_start});
  add(table, "INIVEL/AXIS", {&r::velocity_axis, &r::velocity_spin, &r::velocity_start});
  add(table, "INIBRI/STRESS", {&r::stress_normal, &r::stress_shear});
  add(table, "INIBRI/EPSP", {&r::stress_plastic});
  add(table, "INIBRI/STRS_FGLO",
      {&r::stress_full, &r::stress_full_energy, &r::stress_full_normal, &r::stress_shear, &r::stress_full_plastic});
  add(table, "CLOAD", {&r::nodal_load});
  add(table, "PLOAD", {&r::pressure});
  add(table, "GRAV", {&r::gravity});
  add(table, "RWALL/PLANE", {&r::wall_nodes, &r::wall_friction, &r::wall_point, &r::wall_head});
  add(table, "RBODY", {&r::rigid_body, &r::rigid_inertia, &r::rigid_products, &r::rigid_options});
  add(table, "PROP/KJOINT2", {&r::joint, &r::joint_stiffness, &r::joint_damping, &r::joint_friction});
  add(table, "SPRING", {&r::spring});
  add(table, "ADMAS", {&r::added_mass});
  add(table, "DAMP", {&r::damping, &r::damping_more});
  add(table, "TH/NODE", {&r::variables, &r::watched_node});
  add(table, "TH/BRIC", {&r::variables, &r::watched_brick});
}

void add_contacts(Table& table) {
  namespace r = radioss;
  add(table, "INTER/TYPE2", {&r::tie});
  add(table, "INTER/TYPE7",
      {&r::type7_sides, &r::type7_gap, &r::type7_stiffness, &r::inter_scales, &r::inter_start, &r::type7_friction});
  add(table, "INTER/TYPE11",
      {&r::type11_sides, &r::type11_stiffness, &r::inter_scales, &r::inter_start, &r::type11_friction});
  for (const char* keyword : {"INTER/TYPE24", "INTER/TYPE25"})
    add(table, keyword,
        {&r::type24_sides, &r::type24_gap, &r::type24_stiffness, &r::type24_scales, &r::type24_start,
         &r::type24_friction});
}

void add_controls(Table& table) {
  namespace r = radioss;
  add(table, "ANALY", {&r::analysis});
  add(table, "RANDOM", {&r::random_noise});
  add(table, "RUN", {&r::run});
  for (const char* keyword : {"DT", "DT/BRICK/STOP", "DT/BRICK/CST", "DT/NODA"}) add(table, keyword, {&r::step});
  add(table, "DT/NODA/CST", {&r::step_mass});
  add(table, "DTIX", {&r::first_step});
  for (const char* keyword : {"STOP", "KILL"}) add(table, keyword, {&r::limits});
  add(table, "TFILE", {&r::th_step});
  add(table, "ANIM/DT", {&r::anim_step});
}

}  // namespace

const std::vector<RadiossCards>& radioss_cards() {
  static const Table table = [] {
    Table all;
    add_mesh(all);
    add_materials(all);
    add_boundaries(all);
    add_contacts(all);
    add_controls(all);
    return all;
  }();
  return table;
}

}  // namespace pinball
