#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include <solver/output/history.hpp>
#include <tests/support/solver_case.hpp>

/// Every column of the history, and what summary.json has of the same, against sums over the fields made here.
namespace pinball::report_test {
namespace {

using namespace test;
using Columns = std::map<std::string, double>;

/// What acts on bodies, and what is watched of them, of every kind that has columns.
Scene with_every_column() {
  Scene scene = pressed_blocks(3e-4);
  scene.materials = {plastic_material("steel", 3e8, 0.5)};
  scene.contact.enforcement = Enforcement::lagrange;
  scene.contact.gap = ContactGap::face;
  ContactPair pair;
  pair.name = "meet";
  pair.first.bodies = {"b"};
  pair.second.bodies = {"a"};
  pair.friction = pair.static_friction = 0.3;
  scene.contact_pairs = {pair};
  scene.bodies[1].position[2] = 0.7002;  // they touch within a step
  scene.prescribed_velocities[0].nodes.plane = Plane{{0, 0, 1.1002}, {0, 0, 1}};
  scene.rigid_walls[1].speed = 2;
  Pressure gas;
  gas.name = "gas";
  gas.faces.body = "b";
  gas.faces.plane = Plane{{0.5, 0, 0}, {1, 0, 0}};
  gas.pressure = 1e6;
  scene.pressures = {gas};
  scene.prescribed_velocities[0].name = "push";
  scene.probes = {{"tip", ProbeKind::node, {0.5, 0.5, 1.1002}, "b", probe_quantities(ProbeKind::node)},
                  {"core", ProbeKind::element, {0.25, 0.25, 0.35}, "a", probe_quantities(ProbeKind::element)}};
  scene.output.body_energies = true;
  return scene;
}

Columns columns_of(const Solver<double>& solver) {
  const std::vector<std::string> names = history_column_names({"a", "b"}, more_columns(solver));
  const std::vector<double> numbers = history_numbers(history_row(solver));
  EXPECT_EQ(names.size(), numbers.size());
  Columns columns;
  for (std::size_t i = 0; i < std::min(names.size(), numbers.size()); ++i) {
    EXPECT_TRUE(columns.emplace(names[i], numbers[i]).second) << names[i];
  }
  return columns;
}

void put(Columns& columns, const std::string& head, const Point& vector) {
  for (std::size_t k = 0; k < 3; ++k) columns[head + '_' + "xyz"[k]] = vector[k];
}

/// Of the bodies, by their elements and nodes.
void put_bodies(const Solver<double>& solver, const FieldSnapshot& fields, Columns& columns) {
  const Model<double>& model = solver.model();
  Point momentum_of_all{};
  for (std::int32_t b = 0; b < 2; ++b) {
    const std::string name = b == 0 ? "a" : "b";
    double mass = 0, strain = 0;
    std::int64_t eroded = 0;
    Point p{}, force{};
    for (std::size_t e = 0; e < fields.hexahedra.size(); ++e) {
      if (fields.body[e] != b) continue;
      eroded += fields.alive[e] == 0;
      if (fields.alive[e] == 0) continue;
      mass += model.element_mass[e];
      strain = std::max(strain, fields.plastic_strain[e]);
      for (const std::int32_t node : fields.hexahedra[e]) {
        for (std::size_t k = 0; k < 3; ++k) p[k] += model.element_mass[e] / 8 * fields.velocity[node][k];
      }
    }
    Point momentum_of_body{};
    double kinetic_mass = 0;
    for (std::size_t n = 0; n < fields.velocity.size(); ++n) {
      if (model.mesh.body_of_node[n] != b) continue;
      const double of_node = model.node_mass[model.node_of_scene_node[n]];
      kinetic_mass += of_node;
      for (std::size_t k = 0; k < 3; ++k) {
        force[k] += fields.contact_force[n][k];
        momentum_of_body[k] += of_node * fields.velocity[n][k];
        momentum_of_all[k] += of_node * fields.velocity[n][k];
      }
    }
    put(columns, name + "_velocity", {p[0] / mass, p[1] / mass, p[2] / mass});
    put(columns, name + "_contact_force", force);
    put(columns, name + "_momentum", momentum_of_body);
    columns[name + "_mass"] = kinetic_mass;
    columns[name + "_mass_remaining"] = mass;
    columns[name + "_eroded_elements"] = static_cast<double>(eroded);
    columns[name + "_max_plastic_strain"] = strain;
  }
  put(columns, "momentum", momentum_of_all);
}

/// Of the probes, by the fields: places and velocities of a node, stresses of an element.
void put_probes(const Solver<double>& solver, const FieldSnapshot& fields, Columns& columns) {
  const ModelMesh& mesh = solver.mesh();
  std::size_t node = 0, element = 0;
  const auto square = [](const Point& a, const Point& b) { return dot(minus(a, b), minus(a, b)); };
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
    if (mesh.body_of_node[n] == 1 && square(mesh.nodes[n], {0.5, 0.5, 1.1002}) < 1e-6) node = n;
  }
  for (std::size_t e = 0; e < mesh.hexahedra.size(); ++e) {
    if (mesh.body[e] == 0 && square(element_centre(mesh, e), {0.25, 0.25, 0.35}) < 1e-6) element = e;
  }
  put(columns, "tip_position", fields.position[node]);
  put(columns, "tip_displacement", minus(fields.position[node], mesh.nodes[node]));
  put(columns, "tip_velocity", fields.velocity[node]);
  const std::array<double, 6>& s = fields.stress[element];
  const char* const names[] = {"xx", "yy", "zz", "xy", "yz", "zx"};
  for (std::size_t c = 0; c < 6; ++c) columns["core_stress_" + std::string(names[c])] = s[c];
  const double mean = (s[0] + s[1] + s[2]) / 3;
  double square_of_deviator = 0;
  for (std::size_t c = 0; c < 6; ++c) {
    const double d = c < 3 ? s[c] - mean : s[c];
    square_of_deviator += (c < 3 ? 1 : 2) * d * d;
  }
  columns["core_effective_stress"] = std::sqrt(1.5 * square_of_deviator);
  columns["core_plastic_strain"] = fields.plastic_strain[element];
}

/// What others keep the accounts of.
void put_accounts(const Solver<double>& solver, Columns& columns) {
  const Energies& e = solver.energies();
  columns.insert({{"kinetic", std::max(0.0, e.kinetic)},
                  {"kinetic_below_zero", std::min(0.0, e.kinetic)},
                  {"internal", e.internal},
                  {"hourglass", e.hourglass},
                  {"hourglass_plastic", e.hourglass_plastic},
                  {"bulk_viscosity", e.bulk_viscosity},
                  {"folding", e.folding},
                  {"contact_stored", e.contact_stored},
                  {"contact_damped", e.contact_damped},
                  {"eroded", e.eroded},
                  {"external", e.external},
                  {"total", e.total()},
                  {"balance_error", solver.balance_error()},
                  {"step", static_cast<double>(solver.steps())},
                  {"time", solver.force_time()},
                  {"dt", solver.dt()},
                  {"inside_out_elements", static_cast<double>(solver.inside_out().now())}});
  for (const WallResult& wall : solver.boundary().walls()) {
    columns[wall.name + "_force"] = wall.force;
    columns[wall.name + "_impulse"] = wall.impulse;
    if (wall.name != "side") continue;
    columns["side_displacement"] = wall.displacement - solver.dt() * wall.velocity;  // at the time of the forces
    columns["side_velocity"] = wall.velocity;
  }
  put(columns, "gas_force", solver.boundary().pressures().at(0).force);
  columns["gas_work"] = solver.boundary().pressures()[0].work;
  put(columns, "meet_force", solver.contact_pairs().at(0).force);
  put(columns, "meet_impulse", solver.contact_pairs()[0].impulse);
  put(columns, "push_force", solver.boundary().forces(solver.model()).at(0).force);
  const auto shares = solver.body_shares();
  for (std::size_t b = 0; b < 2; ++b) {
    const std::string name = b == 0 ? "a" : "b";
    columns[name + "_kinetic"] = std::max(0.0, shares.at(b).kinetic);
    columns[name + "_internal"] = shares[b].internal;
    columns[name + "_hourglass"] = shares[b].hourglass;
    columns[name + "_bulk_viscosity"] = shares[b].bulk_viscosity;
  }
}

void expect_columns(const Solver<double>& solver) {
  const FieldSnapshot fields = snapshot(solver);
  Columns expected;
  put_accounts(solver, expected);
  put_bodies(solver, fields, expected);
  put_probes(solver, fields, expected);
  const Columns columns = columns_of(solver);
  EXPECT_EQ(columns.size(), expected.size());
  for (const auto& [name, number] : columns) {
    ASSERT_TRUE(expected.contains(name)) << name;
    const double scale = name.find("momentum") != std::string::npos ? 1e3 : 1e-6;
    EXPECT_NEAR(number, expected[name], 1e-10 * (std::abs(expected[name]) + scale)) << name;
  }
}

TEST(Report, EveryColumnOfTheHistoryIsOfTheFieldsAndAccounts) {
  Solver<double> solver(with_every_column());
  for (int step = 0; step < 12; ++step) {
    if (step == 6) strain_to_failure(solver, {0, 17, 211});
    solver.step();
    if (step % 3 == 2) expect_columns(solver);
  }
  EXPECT_GT(norm(solver.contact_pairs().at(0).impulse), 0) << "they are to touch";
  EXPECT_EQ(body_results(solver)[0].eroded_elements, 2);
  EXPECT_EQ(body_results(solver)[1].eroded_elements, 1);
}

TEST(Report, TheSummaryIsOfTheSameNumbers) {
  Solver<double> solver(with_every_column());
  const Point at_start = solver.momentum();
  double dt_max = 0;
  for (int step = 0; step < 12; ++step) {
    solver.step();
    dt_max = std::max(dt_max, solver.dt());
  }
  RunSummary s;
  fill_summary(solver, s);
  const HistoryRow row = history_row(solver);
  EXPECT_EQ(s.steps, row.step);
  EXPECT_EQ(s.steps, 12);
  EXPECT_EQ(s.end_time, row.time);
  EXPECT_EQ(s.elements, 6 * 5 * 7 + 4 * 5 * 4);
  EXPECT_EQ(s.nodes, 7 * 6 * 8 + 5 * 6 * 5);
  EXPECT_EQ(s.element_steps, 12 * s.elements);
  EXPECT_EQ(s.dt_max, dt_max);
  EXPECT_GT(s.dt_min, 0);
  EXPECT_EQ(s.energy.total(), row.energy.total());
  EXPECT_EQ(s.final_total, solver.energies().total());
  EXPECT_EQ(s.initial_total, solver.initial_energy());
  EXPECT_EQ(s.momentum_final, row.momentum);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(s.momentum_initial[k], at_start[k], 1e-9 * norm(at_start)) << k;
  ASSERT_EQ(s.bodies.size(), 2U);
  EXPECT_EQ(s.bodies[0].elements, 210);
  EXPECT_NEAR(s.bodies[0].mass_initial, 7850 * 0.6 * 0.5 * 0.7, 1e-9 * 7850);
  EXPECT_EQ(s.bodies[1].velocity, row.bodies[1].velocity);
  EXPECT_EQ(s.walls.size(), 2U);
  EXPECT_EQ(s.probes.size(), 2U);
  EXPECT_EQ(s.contact_pairs.at(0).impulse, solver.contact_pairs().at(0).impulse);
  EXPECT_EQ(s.contact_method, "pinball");
  EXPECT_EQ(s.contact_enforcement, "lagrange");
  EXPECT_EQ(s.contact_gap, "face");
  EXPECT_GE(s.searches, 1);
  EXPECT_EQ(s.searches + s.searches_skipped, 12);
  EXPECT_EQ(s.energy_in_motion, solver.ledger().in_motion());
  EXPECT_EQ(s.balance_error_in_motion.largest, solver.ledger().balance_error_in_motion_max());
  using Share = std::pair<const WatchedShare&, Watched>;
  for (const auto& [share, kind] :
       {Share(s.contact_created, Watched::contact_created), Share(s.contact_swallowed, Watched::contact_swallowed),
        Share(s.hourglass_created, Watched::hourglass_created), Share(s.hourglass_large, Watched::hourglass_large),
        Share(s.hourglass_plastic, Watched::hourglass_plastic),
        Share(s.kinetic_below_zero, Watched::kinetic_below_zero),
        Share(s.internal_below_zero, Watched::internal_below_zero)}) {
    EXPECT_EQ(share.largest, solver.watch().share(kind)) << static_cast<int>(kind);
    EXPECT_EQ(share.since, solver.watch().since(kind)) << static_cast<int>(kind);
  }
  EXPECT_GT(s.contact_swallowed.largest, 0) << "by friction";
  EXPECT_GT(s.hourglass_large.largest, 0);
}

}  // namespace
}  // namespace pinball::report_test
