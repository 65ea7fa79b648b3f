#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include <kernels/hexahedron.hpp>
#include <solver/base/error.hpp>

#include "solver.hpp"

/// What ends a run that has gone wrong: each throws RunError that says what, where, when and what to try. They look at
/// sums that the step has made anyway; where it went wrong is looked for only then.
namespace pinball {

namespace {

/// Volume of an element over that of the undeformed one; at the time of the forces, dt before that of the positions.
template <class S>
double volume_ratio(const Model<S>& model, std::int64_t slot, double dt) {
  Vec3<double> x[8];
  for (int i = 0; i < 8; ++i) {
    const auto node = 4 * static_cast<std::size_t>(model.elements.corner[ElementStore<S>::at(slot, i, 8)]);
    const auto at = [&](std::size_t k) {
      return static_cast<double>(model.nodes.position[node + k]) -
             dt * static_cast<double>(model.nodes.velocity[node + k]);
    };
    x[i] = {at(0), at(1), at(2)};
  }
  const HexahedronModes<double> modes = to_modes(x);
  const auto element = static_cast<std::size_t>(model.element_of_slot[static_cast<std::size_t>(slot)]);
  return hexahedron_volume(uniform_gradient(modes), modes) / element_volume(model.mesh, element);
}

/// What is not finite of the state of an element, or nothing.
template <class S>
std::string not_finite_part(const Model<S>& model, std::int64_t slot) {
  const ElementStore<S>& e = model.elements;
  const auto bad = [slot](const AlignedArray<S>& array, int components) {
    if (array.empty()) return false;
    for (int c = 0; c < components; ++c) {
      if (!std::isfinite(array[ElementStore<S>::at(slot, c, components)])) return true;
    }
    return false;
  };
  if (bad(e.stress, 6)) return "stress";
  if (bad(e.plastic_strain, 1)) return "plastic strain";
  if (bad(e.hourglass_force, 12)) return "hourglass force";
  if (bad(e.viscous_stress, 1)) return "bulk viscosity";
  if (bad(e.internal_energy, 1)) return "internal energy";
  return "";
}

/// Whether a corner of an element has a velocity or a place that is not finite.
template <class S>
bool corner_not_finite(const Model<S>& model, std::int64_t slot) {
  for (int i = 0; i < 8; ++i) {
    const auto node = 4 * static_cast<std::size_t>(model.elements.corner[ElementStore<S>::at(slot, i, 8)]);
    for (std::size_t k = 0; k < 3; ++k) {
      if (!std::isfinite(model.nodes.velocity[node + k]) || !std::isfinite(model.nodes.position[node + k])) return true;
    }
  }
  return false;
}

constexpr const char* try_smaller_steps = "try a smaller time.cfl";

}  // namespace

/// Elements that are turned inside out, where they are not to be eroded for it.
template <class S>
void Solver<S>::check_volumes(const InternalForceResult<S>& internal) const {
  if (internal.inverted_count == 0) return;
  constexpr int W = ElementStore<S>::width;
  std::int64_t worst = -1;
  double least = 0;
  for (std::size_t t = 0; t < internal_forces_.tiles().size(); ++t) {
    if (internal_forces_.tiles()[t].inverted_count == 0) continue;
    for (std::int64_t slot = model_.tile_packs[t] * W; slot < model_.tile_packs[t + 1] * W; ++slot) {
      if (!(model_.elements.mass[static_cast<std::size_t>(slot)] > S(0))) continue;
      const double ratio = volume_ratio(model_, slot, dt_);
      if (worst >= 0 && !(ratio < least)) continue;
      least = ratio;
      worst = slot;
    }
  }
  throw RunError(
      fmt::format("{} of {} elements have no volume left {}, first of all {}: {}, "
                  "element.negative_volume=\"erode\", or an erosion_strain for the material",
                  internal.inverted_count, model_.element_count(), when(), element_name(worst), try_smaller_steps));
}

/// energy: a sum that every element and every node goes into. A number that is not finite reaches it in the step in
/// which it arises, before it spreads to other elements.
template <class S>
void Solver<S>::check_finite(double energy) const {
  if (std::isfinite(energy)) return;
  std::int64_t beside = -1;
  for (const std::int64_t slot : model_.slot_of_element) {  // the first in the order of the scene
    if (!(model_.elements.mass[static_cast<std::size_t>(slot)] > S(0))) continue;
    const std::string part = not_finite_part(model_, slot);
    if (!part.empty()) {
      throw RunError(fmt::format("the {} of {} is not finite {}: {}, and look at its material and its shape there",
                                 part, element_name(slot), when(), try_smaller_steps));
    }
    if (beside < 0 && corner_not_finite(model_, slot)) beside = slot;
  }
  if (beside >= 0) {
    throw RunError(
        fmt::format("a node of {} has a velocity that is not finite {}: {}, and look at loads, prescribed "
                    "velocities and contact there",
                    element_name(beside), when(), try_smaller_steps));
  }
  throw RunError(fmt::format("the energy is not finite {}, though all elements are: {}, or precision=\"double\"",
                             when(), try_smaller_steps));
}

template <class S>
void Solver<S>::check_energy() const {
  if (std::abs(balance_error()) <= model_.scene.guard.energy_error) return;
  throw RunError(fmt::format(
      "the energy balance is off by {:.3g} % {}, more than guard.energy_error = {:.3g} %; the time step is "
      "set by {}: {}, or a finer mesh where most is going on",
      100 * balance_error(), when(), 100 * model_.scene.guard.energy_error, dt_limited_by_, try_smaller_steps));
}

template <class S>
void Solver<S>::check_time_step() const {
  const double ratio = model_.scene.guard.time_step_collapse;
  if (!(dt_ > 0 && dt_ < ratio * dt_max_ && model_.scene.time.end - time_ > dt_)) return;
  throw RunError(
      fmt::format("the stable step has collapsed to {:.3g} {}, less than guard.time_step_collapse = {:.3g} of the "
                  "largest, {:.3g}; it is set by {}: {}",
                  dt_, when(), ratio, dt_max_, dt_limited_by_,
                  dt_limited_by_ == "contact"
                      ? "try a smaller contact.beta, or contact.enforcement=\"lagrange\", which does not limit it"
                      : "try an erosion_strain for its material, or a better shape of its mesh"));
}

template <class S>
std::string Solver<S>::when() const {
  return fmt::format("in step {} at time {:.6g}", steps_, force_time_);
}

template class Solver<double>;
template class Solver<float>;

}  // namespace pinball
