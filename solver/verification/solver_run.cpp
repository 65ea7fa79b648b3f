#include "solver_run.hpp"

#include <numeric>
#include <utility>

#include <solver/base/hexahedron_of_points.hpp>
#include <solver/base/records.hpp>

namespace pinball {

void run_to_end(Solver<double>& solver, const std::function<void()>& after_step) {
  while (!solver.at_end()) {
    solver.step();
    after_step();
  }
  solver.finish();
}

PrescribedMotion::PrescribedMotion(Solver<double>& solver, Path path, std::vector<std::int32_t> nodes)
    : solver_(solver), path_(std::move(path)), nodes_(std::move(nodes)) {
  if (!nodes_.empty()) return;
  nodes_.resize(solver.mesh().nodes.size());
  std::iota(nodes_.begin(), nodes_.end(), 0);
}

void PrescribedMotion::step() {
  const double before = solver_.time();
  solver_.step();
  Model<double>& model = solver_.change_model();
  for (const std::int32_t node : nodes_) {
    const Point& start = model.mesh.nodes[node];
    const Point from = path_(start, before), to = path_(start, solver_.time());
    const std::int32_t place = model.node_of_scene_node[node];
    double *x = model.nodes.position_of(place), *v = model.nodes.velocity_of(place);
    for (std::size_t k = 0; k < 3; ++k) {
      x[k] = to[k];
      v[k] = (to[k] - from[k]) / solver_.dt();
    }
  }
}

std::array<double, 6> stress_of(const Solver<double>& solver, std::size_t element) {
  const Model<double>& model = solver.model();
  return model.elements.stress_of(model.slot_of_element[element]);
}

Point position_of(const Solver<double>& solver, std::size_t node) {
  const Model<double>& model = solver.model();
  return to_point(vector_of(model.nodes.position_of(model.node_of_scene_node[node])));
}

Point velocity_of(const Solver<double>& solver, std::size_t node) {
  const Model<double>& model = solver.model();
  return to_point(vector_of(model.nodes.velocity_of(model.node_of_scene_node[node])));
}

Point angular_momentum(const Solver<double>& solver) {
  const Model<double>& model = solver.model();
  Point sum{};
  for (std::size_t n = 0; n < model.mesh.nodes.size(); ++n) {
    const double mass = model.node_mass[model.node_of_scene_node[n]];
    const Point l = cross(position_of(solver, n), velocity_of(solver, n));
    for (std::size_t k = 0; k < 3; ++k) sum[k] += mass * l[k];
  }
  return sum;
}

}  // namespace pinball
