#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <iterator>

#include <kernels/exec.hpp>
#include <solver/base/lists_in_order.hpp>
#include <solver/model/body_parts.hpp>

#include "report.hpp"

namespace pinball {

namespace {

/// Of each rigid body: its centre, and what holds and moves it.
constexpr std::array rigid_quantities{"centre", "centre_velocity", "angular_velocity", "reaction_force",
                                      "reaction_moment"};

/// Those of these nodes that several bodies have; both ascending.
std::vector<std::int32_t> shared_among(const std::vector<std::int32_t>& nodes, const ModelMesh& mesh) {
  std::vector<std::int32_t> shared, found;
  for (const std::vector<std::int32_t>& of_body : mesh.shared)
    shared.insert(shared.end(), of_body.begin(), of_body.end());
  std::sort(shared.begin(), shared.end());
  shared.erase(std::unique(shared.begin(), shared.end()), shared.end());
  std::ranges::set_intersection(nodes, shared, std::back_inserter(found));
  return found;
}

}  // namespace

template <class S>
std::vector<std::string> more_columns(const Solver<S>& solver) {
  std::vector<std::string> columns;
  for (const WallResult& wall : solver.boundary().walls()) {
    for (const char* quantity : {"force", "impulse"}) columns.push_back(fmt::format("{}_{}", wall.name, quantity));
    if (!wall.moves) continue;
    for (const char* quantity : {"displacement", "velocity"})
      columns.push_back(fmt::format("{}_{}", wall.name, quantity));
  }
  for (const RigidBody& rigid : solver.scene().rigid_bodies) {
    for (const char* quantity : rigid_quantities) {
      for (const char axis : {'x', 'y', 'z'}) columns.push_back(fmt::format("{}_{}_{}", rigid.name, quantity, axis));
    }
  }
  for (const Joint& joint : solver.scene().joints) {
    for (const char* quantity : {"joint_force", "joint_moment"}) {
      for (const char axis : {'x', 'y', 'z'}) columns.push_back(fmt::format("{}_{}_{}", joint.name, quantity, axis));
    }
  }
  for (const PressureResult& pressure : solver.boundary().pressures()) {
    for (const char* quantity : {"force_x", "force_y", "force_z", "work"})
      columns.push_back(fmt::format("{}_{}", pressure.name, quantity));
  }
  for (const PairResult& pair : solver.contact_pairs()) {
    for (const char* quantity : {"force", "impulse"}) {
      for (const char axis : {'x', 'y', 'z'}) columns.push_back(fmt::format("{}_{}_{}", pair.name, quantity, axis));
    }
  }
  const std::vector<std::string> of_probes = solver.probes().columns();
  columns.insert(columns.end(), of_probes.begin(), of_probes.end());
  const std::vector<Body>& bodies = solver.scene().bodies;
  for (const Body& body : bodies) {
    if (solver.contact() == nullptr) break;
    for (const char axis : {'x', 'y', 'z'}) columns.push_back(fmt::format("{}_contact_force_{}", body.name, axis));
  }
  for (const std::string& name : solver.boundary().force_names()) {
    for (const char axis : {'x', 'y', 'z'}) columns.push_back(fmt::format("{}_force_{}", name, axis));
  }
  for (const Body& body : bodies) {
    if (!solver.body_energies().any()) break;
    for (const char* quantity :
         {"kinetic", "momentum_x", "momentum_y", "momentum_z", "mass", "internal", "hourglass", "bulk_viscosity"})
      columns.push_back(fmt::format("{}_{}", body.name, quantity));
  }
  return columns;
}

/// What contact does to each body as a whole, of nodes that bodies share by the masses that these have there [force].
template <class S>
std::vector<Point> contact_forces_on_bodies(const Solver<S>& solver) {
  const Model<S>& model = solver.layout();
  Array<Point> in_store(model.mesh.nodes.size());
  solver.contact()->add_node_forces({in_store.data(), in_store.size()});
  const auto force_of = [&](std::int64_t n) -> const Point& { return in_store[model.node_of_scene_node[n]]; };
  std::vector<std::int32_t> nodes;
  list_where("nodes in contact", std::ssize(model.mesh.nodes), nodes, [&](std::int64_t n) {
    return std::ranges::any_of(force_of(n), [](double component) { return component != 0; });
  });
  std::vector<Point> sums(model.scene.bodies.size(), Point{});
  const std::vector<std::int32_t> shared = shared_among(nodes, model.mesh);
  const std::vector<std::vector<BodyPart>> parts = parts_of_bodies(model, shared);
  std::size_t next = 0;  // of the shared ones
  for (const std::int32_t n : nodes) {
    const Point& force = force_of(n);
    if (next == shared.size() || shared[next] != n) {
      Point& sum = sums[model.mesh.body_of_node[n]];
      for (std::size_t k = 0; k < 3; ++k) sum[k] += force[k];
      continue;
    }
    for (const BodyPart& part : parts[next]) {
      for (std::size_t k = 0; k < 3; ++k) sums[part.body][k] += part.share * force[k];
    }
    ++next;
  }
  return sums;
}

template <class S>
HistoryRow history_row(const Solver<S>& solver) {
  HistoryRow row;
  row.step = solver.steps();
  row.time = solver.force_time();
  row.dt = solver.dt() > 0 ? solver.dt() : solver.clock().dt_before();
  row.energy = reported_energies(solver);
  row.balance_error = solver.balance_error();
  row.momentum = solver.momentum();
  row.inside_out = solver.inside_out().now();
  row.bodies = body_results(solver);
  for (const WallResult& wall : solver.boundary().walls()) {
    row.more.push_back(wall.force);
    row.more.push_back(wall.impulse);
    if (wall.moves) row.more.insert(row.more.end(), {wall.row_displacement, wall.velocity});
  }
  for (const RigidBodyResult& rigid : solver.rigid().results()) {
    for (const Point& quantity : {rigid.centre, rigid.velocity, rigid.angular_velocity, rigid.force, rigid.moment})
      row.more.insert(row.more.end(), quantity.begin(), quantity.end());
  }
  for (const JointResult& joint : solver.rigid().joint_results()) {
    for (const Point& quantity : {joint.force, joint.moment})
      row.more.insert(row.more.end(), quantity.begin(), quantity.end());
  }
  for (const PressureResult& pressure : solver.boundary().pressures()) {
    row.more.insert(row.more.end(), pressure.force.begin(), pressure.force.end());
    row.more.push_back(pressure.work);
  }
  for (const PairResult& pair : solver.contact_pairs()) {
    row.more.insert(row.more.end(), pair.force.begin(), pair.force.end());
    row.more.insert(row.more.end(), pair.impulse.begin(), pair.impulse.end());
  }
  const std::vector<double> of_probes = solver.probe_values();
  row.more.insert(row.more.end(), of_probes.begin(), of_probes.end());
  if (solver.contact() != nullptr) {
    for (const Point& force : contact_forces_on_bodies(solver)) {
      row.more.insert(row.more.end(), force.begin(), force.end());
    }
  }
  for (const ForceResult& named : solver.named_forces()) {
    row.more.insert(row.more.end(), named.force.begin(), named.force.end());
  }
  for (const BodyShare& body : solver.body_shares()) {
    const Point& p = body.momentum;
    row.more.insert(row.more.end(), {std::max(0.0, body.kinetic), p[0], p[1], p[2], body.mass, body.internal,
                                     body.hourglass, body.bulk_viscosity});
  }
  return row;
}

template std::vector<std::string> more_columns(const Solver<double>&);
template std::vector<std::string> more_columns(const Solver<float>&);
template HistoryRow history_row(const Solver<double>&);
template HistoryRow history_row(const Solver<float>&);

}  // namespace pinball
