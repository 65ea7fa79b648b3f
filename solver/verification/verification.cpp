#include "verification.hpp"

#include <cmath>
#include <numeric>
#include <utility>

#include <solver/base/error.hpp>

namespace pinball {

VerificationRow compare(const std::string& quantity, double value, double reference, double tolerance,
                        const std::string& source) {
  const double error = std::abs(value - reference) / (reference != 0 ? std::abs(reference) : 1.0);
  return {"", quantity, value, reference, source, error, tolerance, error <= tolerance};
}

VerificationRow compare_with_zero(const std::string& quantity, double value, double tolerance,
                                  const std::string& source) {
  return compare(quantity, value, 0.0, tolerance, source);
}

const std::vector<VerificationCase>& verification_cases() {
  static const std::vector<VerificationCase> cases{
      {"patch_test", verify_patch_test},         {"uniaxial_strain", verify_uniaxial_strain},
      {"spinning_block", verify_spinning_block}, {"block", verify_block},
      {"plate_impact", verify_plate_impact},     {"cantilever", verify_cantilever},
      {"two_blocks", verify_two_blocks},         {"taylor_bar", verify_taylor_bar},
      {"taylor_plate", verify_taylor_plate},     {"two_bars", verify_two_bars},
      {"sphere_wall", verify_sphere_wall},       {"sphere_wall_full", verify_sphere_wall_full},
      {"sphere_sphere", verify_sphere_sphere},   {"rod_plate", verify_rod_plate},
      {"rod_oblique", verify_rod_oblique},       {"refined_layer", verify_refined_layer},
  };
  return cases;
}

std::vector<VerificationRow> verify_scene(const VerificationCase& verification) {
  std::vector<VerificationRow> rows;
  try {
    rows = verification.run(read_scene(find_scene(verification.scene)));
  } catch (const RunError& error) {
    rows = {{"", "run to the end", std::nan(""), 0.0, error.what(), std::nan(""), 0.0, false}};
  }
  for (VerificationRow& row : rows) row.scene = verification.scene;
  return rows;
}

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
  nodes_.resize(solver.model().mesh.nodes.size());
  std::iota(nodes_.begin(), nodes_.end(), 0);
}

void PrescribedMotion::step() {
  const double before = solver_.time();
  solver_.step();
  Model<double>& model = solver_.model();
  for (const std::int32_t node : nodes_) {
    const auto n = static_cast<std::size_t>(node);
    const auto place = 4 * static_cast<std::size_t>(model.node_of_scene_node[n]);
    const Point from = path_(model.mesh.nodes[n], before), to = path_(model.mesh.nodes[n], solver_.time());
    for (std::size_t k = 0; k < 3; ++k) {
      model.nodes.position[place + k] = to[k];
      model.nodes.velocity[place + k] = (to[k] - from[k]) / solver_.dt();
    }
  }
}

std::array<double, 6> stress_of(const Solver<double>& solver, std::size_t element) {
  const Model<double>& model = solver.model();
  std::array<double, 6> stress{};
  for (int c = 0; c < 6; ++c) {
    stress[c] = model.elements.stress[ElementStore<double>::at(model.slot_of_element[element], c, 6)];
  }
  return stress;
}

namespace {

Point from_record(const double* records, std::int32_t n) {
  const double* r = records + 4 * static_cast<std::ptrdiff_t>(n);
  return {r[0], r[1], r[2]};
}

}  // namespace

Point position_of(const Solver<double>& solver, std::size_t node) {
  return from_record(solver.model().nodes.position.data(), solver.model().node_of_scene_node[node]);
}

Point velocity_of(const Solver<double>& solver, std::size_t node) {
  return from_record(solver.model().nodes.velocity.data(), solver.model().node_of_scene_node[node]);
}

}  // namespace pinball
