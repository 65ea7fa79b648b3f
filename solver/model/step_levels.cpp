#include "step_levels.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <kernels/stable_time_step.hpp>
#include <solver/base/faces.hpp>
#include <solver/base/hexahedron_of_points.hpp>
#include <solver/mesh/element_types.hpp>
#include <solver/model/selection/node_selection.hpp>
#include <solver/model/selection/pressed_faces.hpp>

#include "elements/element_parts.hpp"
#include "exposed_faces.hpp"

namespace pinball {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// The highest level at which a group is stable with a smallest step. The slack is for round-off of equal elements.
int level_for(const StepGroup& group, double step) {
  if (!(group.stable_step < infinite)) return group.highest;
  const double ratio = group.stable_step / step * (1 + 1e-9);
  return ratio < 2 ? 0 : std::min(group.highest, static_cast<int>(std::log2(ratio)));
}

/// Per element. Volumes that are averaged over nodes are of the time that all around a node have come to.
std::vector<int> highest_levels(const Scene& scene, const ModelMesh& mesh) {
  std::vector<int> highest(mesh.hexahedra.size());
  for (std::size_t e = 0; e < highest.size(); ++e)
    highest[e] = worked_shape(scene, mesh, e) == WorkedShape::hexahedron ? highest_step_level : 0;
  return highest;
}

/// Elements of about equal stable steps as one group: 32 to a factor of two. Those of the lowest level are one behind
/// these.
std::vector<StepGroup> groups_of(const std::vector<double>& stable_steps, const std::vector<int>& highest) {
  const double least = *std::min_element(stable_steps.begin(), stable_steps.end());
  std::vector<StepGroup> bins;
  StepGroup of_nodes{infinite, 0, 0};
  const auto add = [](StepGroup& group, double step) {
    group.stable_step = std::min(group.stable_step, step);
    group.elements += 1;
  };
  for (std::size_t e = 0; e < stable_steps.size(); ++e) {
    const double step = stable_steps[e];
    if (highest[e] == 0) {
      add(of_nodes, step);
      continue;
    }
    const auto bin = static_cast<std::size_t>(std::min(32 * std::log2(step / least), 32.0 * 40));
    if (bin >= bins.size()) bins.resize(bin + 1, {infinite, 0, highest_step_level});
    add(bins[bin], step);
  }
  bins.push_back(of_nodes);
  return bins;
}

/// Calls visit(node) for the nodes on which something else than elements may act, some of them several times.
template <class Visit>
void for_each_node_acted_on(const Scene& scene, const ModelMesh& mesh, const Visit& visit) {
  for (const NodalLoad& load : scene.loads) {
    for (const std::int32_t n : select_nodes(mesh, load.nodes)) visit(n);
  }
  for (const PrescribedVelocity& prescribed : scene.prescribed_velocities) {
    for (const std::int32_t n : select_nodes(mesh, prescribed.nodes)) visit(n);
  }
  for (const EquationTerm& term : scene.equation_terms) {
    for (const std::int32_t n : select_nodes(mesh, term.nodes)) visit(n);
  }
  for (const Pressure& pressure : scene.pressures) {
    for (const PressedFace& face : pressed_faces(mesh, scene.constraints, pressure)) {
      for (const std::int32_t n : face.corners) visit(n);
    }
  }
  if (scene.contact.method == ContactMethod::none && scene.rigid_walls.empty()) return;
  const std::vector<std::uint8_t> exposed =
      find_exposed_faces(mesh, scene.constraints, face_neighbours(mesh.hexahedra));
  for (std::size_t e = 0; e < exposed.size(); ++e) {
    for (unsigned f = 0; f < 6; ++f) {
      if ((exposed[e] >> f & 1U) == 0) continue;
      for (const int corner : face_nodes[f]) visit(mesh.hexahedra[e][corner]);
    }
  }
}

}  // namespace

double smallest_step(const std::vector<StepGroup>& groups, const std::vector<int>& levels) {
  double step = infinite;
  for (std::size_t g = 0; g < groups.size(); ++g) step = std::min(step, std::ldexp(groups[g].stable_step, -levels[g]));
  return step;
}

double work_per_time(const std::vector<StepGroup>& groups, const std::vector<int>& levels, double every_step) {
  double work = every_step;
  for (std::size_t g = 0; g < groups.size(); ++g) work += std::ldexp(groups[g].elements, -levels[g]);
  return work / smallest_step(groups, levels);
}

std::vector<int> choose_levels(const std::vector<StepGroup>& groups, double every_step) {
  double least = infinite;
  for (const StepGroup& group : groups) least = std::min(least, group.stable_step);
  std::vector<int> best(groups.size(), 0);
  if (!(least < infinite)) return best;
  double best_work = work_per_time(groups, best, every_step);
  constexpr int candidates = 32;  // smallest steps between half of the smallest stable step and all of it
  for (int c = 0; c < candidates; ++c) {
    const double step = least * std::exp2(-static_cast<double>(c) / candidates);
    std::vector<int> levels(groups.size());
    int lowest = highest_step_level;
    for (std::size_t g = 0; g < groups.size(); ++g) {
      levels[g] = level_for(groups[g], step);
      if (groups[g].stable_step < infinite) lowest = std::min(lowest, levels[g]);
    }
    for (int& level : levels) level = std::max(0, level - lowest);
    const double work = work_per_time(groups, levels, every_step);
    if (work < best_work) {
      best_work = work;
      best = std::move(levels);
    }
  }
  return best;
}

double element_stable_step(const Scene& scene, const ModelMesh& mesh, std::size_t element, const Material& material) {
  const auto [volume, b_b, area] = element_size(worked_shape(scene, mesh, element), mesh.corners(element));
  const double inverse_square = 1 / (volume * volume);
  const double lambda = material.bulk_modulus - 2.0 / 3.0 * material.shear_modulus;
  const double rate = element_stable_rate(inverse_square * largest_principal_value(b_b), inverse_square * trace(b_b),
                                          volume, 1 / (material.density * volume), lambda, material.shear_modulus, 0.0);
  return 2 / rate;
}

ElementLevels element_step_levels(const Scene& scene, const ModelMesh& mesh, const std::vector<double>& mass_factor) {
  const std::size_t count = mesh.hexahedra.size();
  std::vector<const Material*> of_body;
  for (const std::size_t material : material_of_bodies(scene)) of_body.push_back(&scene.materials[material]);
  std::vector<double> stable_steps(count);
  for (std::size_t e = 0; e < count; ++e) {
    stable_steps[e] = element_stable_step(scene, mesh, e, *of_body[mesh.body[e]]);
    if (!mass_factor.empty()) stable_steps[e] *= std::sqrt(mass_factor[e]);
  }
  const std::vector<int> highest = highest_levels(scene, mesh);
  const std::vector<StepGroup> groups = groups_of(stable_steps, highest);
  const double step = smallest_step(groups, choose_levels(groups, 0));

  ElementLevels levels;
  std::vector<std::uint8_t> of_node(mesh.nodes.size(), highest_step_level);
  for_each_node_acted_on(scene, mesh, [&](std::int32_t n) { of_node[n] = 0; });
  for (std::size_t e = 0; e < count; ++e) {
    levels.own.push_back(level_for({stable_steps[e], 1, highest[e]}, step));
    for (const std::int32_t n : mesh.hexahedra[e]) {
      std::uint8_t& node = of_node[n];
      node = std::min(node, levels.own.back());
    }
  }
  for (const auto& hexahedron : mesh.hexahedra) {
    std::uint8_t level = highest_step_level;
    for (const std::int32_t n : hexahedron) level = std::min(level, of_node[n]);
    levels.level.push_back(level);
  }
  return levels;
}

}  // namespace pinball
