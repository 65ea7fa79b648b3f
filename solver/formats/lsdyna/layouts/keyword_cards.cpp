#include "keyword_cards.hpp"

#include "boundary_cards.hpp"
#include "contact_cards.hpp"
#include "control_cards.hpp"
#include "definition_cards.hpp"
#include "mesh_cards.hpp"
#include "rigid_cards.hpp"

namespace pinball {

namespace {

using Lines = std::vector<const CardLayout*>;
using Table = std::vector<KeywordCards>;

constexpr const CardLayout *title_line = nullptr, *file_line = nullptr;

void add_mesh(Table& table) {
  namespace l = layout;
  table.push_back({"NODE", "", {&l::node}});
  table.push_back({"ELEMENT_SOLID", "in one line", {&l::solid}});
  table.push_back({"ELEMENT_SOLID", "in two lines", {&l::solid, &l::solid_nodes}});
  table.push_back({"ELEMENT_SHELL", "", {&l::shell}});
  table.push_back({"ELEMENT_MASS", "", {&l::node_mass}});
  table.push_back({"ELEMENT_MASS_NODE_SET", "", {&l::node_set_mass}});
  table.push_back({"PART", "", {title_line, &l::part}});
  table.push_back({"PART_CONTACT", "", {title_line, &l::part, &l::part_contact}});
  for (const bool in_system : {false, true}) {
    Lines lines{title_line, &l::part, &l::part_inertia, &l::part_moments, &l::part_velocity};
    if (in_system) lines.push_back(&l::part_system);
    table.push_back({"PART_INERTIA", in_system ? "IRCS 1" : "IRCS 0", lines});
  }
  table.push_back({"SECTION_SOLID", "", {&l::section_solid}});
  table.push_back({"SECTION_SHELL", "", {&l::section_shell, &l::shell_thickness}});
  table.push_back({"HOURGLASS", "", {&l::hourglass}});
  table.push_back({"INCLUDE_TRANSFORM",
                   "",
                   {file_line, &l::include_offsets, &l::include_other, &l::include_units, &l::include_transformation}});
  for (const char* kind : {"SET_NODE", "SET_SOLID"}) {
    const auto set = [&](const char* form, const CardLayout& line) {
      table.push_back({std::string(kind) + form, "", {&l::set_head, &line}});
    };
    set("_LIST", l::members);
    set("_LIST_GENERATE", l::set_ranges);
    set("_LIST_GENERATE_INCREMENT", l::set_steps);
    set("_GENERAL", l::set_general);
    set("_ADD", l::members);
    set("_COLUMN", l::set_column);
  }
  table.push_back({"SET_SEGMENT", "", {&l::set_head, &l::segment}});
  table.push_back({"SET_SEGMENT_GENERAL", "", {&l::set_head, &l::set_general}});
  table.push_back({"SET_PART_LIST", "", {&l::set_head, &l::members}});
  table.push_back({"SET_PART_LIST_GENERATE", "", {&l::set_head, &l::set_ranges}});
  table.push_back({"SET_PART_ADD", "", {&l::set_head, &l::members}});
}

void add_definitions(Table& table) {
  namespace l = layout;
  table.push_back({"DEFINE_BOX", "", {&l::box}});
  table.push_back({"DEFINE_CURVE", "", {&l::curve, &l::curve_point}});
  table.push_back({"DEFINE_TABLE", "", {&l::table, &l::table_value}});
  table.push_back({"DEFINE_VECTOR", "", {&l::vector}});
  table.push_back({"DEFINE_COORDINATE_SYSTEM", "", {&l::system, &l::system_plane}});
  table.push_back({"DEFINE_COORDINATE_VECTOR", "", {&l::system_vectors}});
  for (const char* option : {"TRANSL", "SCALE", "ROTATE", "MIRROR"})
    table.push_back({"DEFINE_TRANSFORMATION", option, {&l::transformation, &l::transformation_step}});
  table.push_back({"MAT_ELASTIC", "", {&l::elastic}});
  table.push_back({"MAT_PLASTIC_KINEMATIC", "", {&l::kinematic, &l::kinematic_rate}});
  table.push_back({"MAT_NULL", "", {&l::null}});
  table.push_back({"MAT_ORTHOTROPIC_ELASTIC",
                   "",
                   {&l::orthotropic, &l::orthotropic_shear, &l::orthotropic_first, &l::orthotropic_second}});
  table.push_back({"MAT_MOONEY-RIVLIN_RUBBER", "", {&l::mooney_rivlin, &l::mooney_rivlin_test}});
  table.push_back({"MAT_BLATZ-KO_RUBBER", "", {&l::blatz_ko}});
  table.push_back({"MAT_HYPERELASTIC_RUBBER", "", {&l::hyperelastic, &l::hyperelastic_constants}});
  table.push_back({"MAT_HILL_FOAM", "", {&l::hill_foam, &l::hill_moduli, &l::hill_exponents, &l::hill_unloading}});
  table.push_back({"MAT_OGDEN_RUBBER", "", {&l::ogden, &l::ogden_moduli, &l::ogden_exponents}});
  table.push_back({"MAT_POWER_LAW_PLASTICITY", "", {&l::power_law, &l::power_law_more}});
  table.push_back({"MAT_PIECEWISE_LINEAR_PLASTICITY", "SIGY and ETAN", {&l::piecewise, &l::piecewise_rate}});
  table.push_back({"MAT_PIECEWISE_LINEAR_PLASTICITY", "LCSS", {&l::piecewise, &l::piecewise_rate}});
  table.push_back({"MAT_PIECEWISE_LINEAR_PLASTICITY",
                   "EPS and ES",
                   {&l::piecewise, &l::piecewise_rate, &l::piecewise_strains, &l::piecewise_stresses}});
  table.push_back({"MAT_ISOTROPIC_ELASTIC_PLASTIC", "", {&l::isotropic_plastic}});
  table.push_back(
      {"MAT_SIMPLIFIED_JOHNSON_COOK", "", {&l::simplified_johnson_cook, &l::simplified_johnson_cook_strength}});
  table.push_back({"MAT_JOHNSON_HOLMQUIST_CERAMICS",
                   "",
                   {&l::johnson_holmquist, &l::johnson_holmquist_limits, &l::johnson_holmquist_damage}});
  table.push_back({"MAT_SOIL_AND_FOAM",
                   "",
                   {&l::soil, &l::soil_options, &l::soil_strains, &l::soil_strains_more, &l::soil_pressures,
                    &l::soil_pressures_more}});
  table.push_back({"MAT_SOIL_AND_FOAM_FAILURE",
                   "",
                   {&l::soil, &l::soil_options, &l::soil_strains, &l::soil_strains_more, &l::soil_pressures,
                    &l::soil_pressures_more}});
  table.push_back({"MAT_CRUSHABLE_FOAM", "", {&l::crushable_foam}});
  table.push_back({"MAT_JOHNSON_COOK",
                   "",
                   {&l::johnson_cook, &l::johnson_cook_strength, &l::johnson_cook_failure, &l::johnson_cook_more}});
  table.push_back({"MAT_RIGID", "", {&l::rigid, &l::rigid_held, &l::rigid_system}});
  table.push_back({"CONSTRAINED_RIGID_BODIES", "", {&l::merged_parts}});
  table.push_back({"CONSTRAINED_EXTRA_NODES_NODE", "", {&l::attached_node}});
  table.push_back({"CONSTRAINED_EXTRA_NODES_SET", "", {&l::attached_set}});
  table.push_back({"CONSTRAINED_NODAL_RIGID_BODY", "", {&l::nodal_rigid}});
  for (const char* kind : {"SPHERICAL", "LOCKING"})
    table.push_back({std::string("CONSTRAINED_JOINT_") + kind, "", {&l::joint_pair}});
  for (const char* kind : {"REVOLUTE", "CYLINDRICAL", "TRANSLATIONAL", "UNIVERSAL"})
    table.push_back({std::string("CONSTRAINED_JOINT_") + kind, "", {&l::joint_pairs}});
  table.push_back({"MAT_ADD_EROSION",
                   "",
                   {&l::erosion, &l::erosion_limits, &l::erosion_damage, &l::erosion_curves, &l::erosion_more}});
  table.push_back({"EOS_GRUNEISEN", "", {&l::grueneisen, &l::grueneisen_volume}});
  table.push_back({"EOS_LINEAR_POLYNOMIAL", "", {&l::linear_polynomial, &l::linear_polynomial_state}});
  table.push_back({"EOS_TABULATED",
                   "",
                   {&l::tabulated_state, &l::table_strains, &l::table_strains_more, &l::table_pressures,
                    &l::table_pressures_more, &l::table_factors, &l::table_factors_more}});
  table.push_back(
      {"EOS_TABULATED_COMPACTION",
       "",
       {&l::tabulated_state, &l::table_strains, &l::table_strains_more, &l::table_pressures, &l::table_pressures_more,
        &l::table_factors, &l::table_factors_more, &l::table_moduli, &l::table_moduli_more}});
}

void add_boundaries(Table& table) {
  namespace l = layout;
  table.push_back({"BOUNDARY_SPC_NODE", "", {&l::held_node}});
  table.push_back({"BOUNDARY_SPC_NODE_BIRTH_DEATH", "", {&l::held_node, &l::held_span}});
  table.push_back({"BOUNDARY_SPC_SET", "", {&l::held_set}});
  table.push_back({"BOUNDARY_SPC_SET_BIRTH_DEATH", "", {&l::held_set, &l::held_span}});
  table.push_back({"BOUNDARY_PRESCRIBED_MOTION_NODE", "", {&l::motion_node}});
  table.push_back({"BOUNDARY_PRESCRIBED_MOTION_SET", "", {&l::motion_set}});
  table.push_back({"BOUNDARY_PRESCRIBED_MOTION_RIGID", "", {&l::motion_part}});
  for (const char* name : {"INITIAL_VELOCITY", "INITIAL_VELOCITY_SET"})
    table.push_back({name, "", {&l::velocity_nodes, &l::velocity, &l::velocity_exempt}});
  table.push_back({"INITIAL_VELOCITY_NODE", "", {&l::velocity_node}});
  table.push_back({"INITIAL_VELOCITY_GENERATION", "", {&l::velocity_generation, &l::velocity_axis}});
  for (const auto& [name, head] :
       {std::pair{"INITIAL_STRESS_SOLID", &l::stress_element}, std::pair{"INITIAL_STRESS_SOLID_SET", &l::stress_set}}) {
    table.push_back({name, "", {head, &l::stress_point}});
    table.push_back({name, "LARGE", {head, &l::stress_long, &l::stress_long_more}});
  }
  table.push_back({"INITIAL_VELOCITY_RIGID_BODY", "", {&l::velocity_rigid}});
  table.push_back({"RIGIDWALL_PLANAR", "", {&l::wall_nodes, &l::wall_plane}});
  table.push_back({"RIGIDWALL_PLANAR_FINITE", "", {&l::wall_nodes, &l::wall_plane, &l::wall_rectangle}});
  table.push_back({"RIGIDWALL_PLANAR_MOVING", "", {&l::wall_nodes, &l::wall_plane, &l::wall_mass}});
  table.push_back(
      {"RIGIDWALL_PLANAR_FINITE_MOVING", "", {&l::wall_nodes, &l::wall_plane, &l::wall_rectangle, &l::wall_mass}});
  table.push_back({"LOAD_NODE_SET", "", {&l::load_node_set}});
  table.push_back({"LOAD_NODE_POINT", "", {&l::load_node}});
  table.push_back({"LOAD_SEGMENT", "", {&l::load_segment}});
  table.push_back({"LOAD_SEGMENT_SET", "", {&l::load_segment_set}});
  for (const char* name : {"LOAD_BODY_X", "LOAD_BODY_Y", "LOAD_BODY_Z"}) table.push_back({name, "", {&l::body_load}});
  table.push_back({"LOAD_BODY_VECTOR", "", {&l::body_load, &l::body_load_vector}});
  table.push_back({"LOAD_BODY_PARTS", "", {&l::body_load_parts}});
}

void add_contacts(Table& table) {
  for (const char* name : {"AUTOMATIC_SINGLE_SURFACE",
                           "AUTOMATIC_GENERAL",
                           "AUTOMATIC_GENERAL_INTERIOR",
                           "AIRBAG_SINGLE_SURFACE",
                           "AUTOMATIC_SURFACE_TO_SURFACE",
                           "AUTOMATIC_NODES_TO_SURFACE",
                           "AUTOMATIC_ONE_WAY_SURFACE_TO_SURFACE",
                           "AUTOMATIC_SINGLE_SURFACE_MORTAR",
                           "AUTOMATIC_SURFACE_TO_SURFACE_MORTAR",
                           "ONE_WAY_SURFACE_TO_SURFACE",
                           "SINGLE_SURFACE",
                           "SURFACE_TO_SURFACE",
                           "NODES_TO_SURFACE",
                           "ERODING_SINGLE_SURFACE",
                           "ERODING_SURFACE_TO_SURFACE",
                           "ERODING_NODES_TO_SURFACE",
                           "TIED_NODES_TO_SURFACE",
                           "TIED_NODES_TO_SURFACE_OFFSET",
                           "TIED_NODES_TO_SURFACE_CONSTRAINED_OFFSET",
                           "TIED_SURFACE_TO_SURFACE",
                           "TIED_SURFACE_TO_SURFACE_OFFSET",
                           "TIED_SURFACE_TO_SURFACE_CONSTRAINED_OFFSET",
                           "TIED_SURFACE_TO_SURFACE_BEAM_OFFSET"}) {
    Lines lines{&layout::contact_sides, &layout::contact_friction, &layout::contact_scales};
    if (std::string_view(name).starts_with("ERODING")) lines.push_back(&layout::contact_eroding);
    lines.insert(lines.end(), layout::contact_optional.begin(), layout::contact_optional.end());
    table.push_back({std::string("CONTACT_") + name, "", lines});
  }
  table.push_back({"CONTACT_INTERIOR", "", {&layout::contact_interior}});
}

void add_controls(Table& table) {
  namespace l = layout;
  table.push_back({"CONTROL_BULK_VISCOSITY", "", {&l::bulk_viscosity}});
  table.push_back({"CONTROL_CONTACT", "", Lines(l::control_contact.begin(), l::control_contact.end())});
  table.push_back({"CONTROL_DYNAMIC_RELAXATION", "", {&l::relaxation}});
  table.push_back({"CONTROL_HOURGLASS", "", {&l::control_hourglass}});
  table.push_back({"CONTROL_SOLUTION", "", {&l::solution}});
  table.push_back({"CONTROL_TERMINATION", "", {&l::termination}});
  table.push_back({"CONTROL_TIMESTEP", "", {&l::timestep, &l::timestep_scaling, &l::timestep_more}});
  table.push_back({"DAMPING_GLOBAL", "", {&l::damping}});
  for (const char* what : {"NODE", "NODE_SET", "SOLID", "SOLID_SET"})
    table.push_back({std::string("DATABASE_HISTORY_") + what, "", {&l::members}});
  table.push_back({"DATABASE_BINARY_D3PLOT", "", {&l::plot, &l::plot_more}});
  for (const char* name :
       {"GLSTAT", "MATSUM", "RCFORC", "RWFORC", "SPCFORC", "BNDOUT", "RBDOUT", "NODOUT", "ELOUT", "SLEOUT"})
    table.push_back({std::string("DATABASE_") + name, "", {&l::ascii}});
}

}  // namespace

const std::vector<KeywordCards>& keyword_cards() {
  static const Table table = [] {
    Table all;
    add_mesh(all);
    add_definitions(all);
    add_boundaries(all);
    add_contacts(all);
    add_controls(all);
    return all;
  }();
  return table;
}

}  // namespace pinball
