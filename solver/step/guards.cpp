#include "guards.hpp"

#include <fmt/core.h>

#include <cmath>

#include <solver/base/counted.hpp>
#include <solver/base/error.hpp>
#include <solver/base/hexahedron_of_points.hpp>

#include "inside_out.hpp"
#include "places.hpp"
#include "report.hpp"

namespace pinball {

namespace {

/// Volume of an element over that of the undeformed one; at the time of the forces, dt before that of the positions.
template <class S>
double volume_ratio(const Model<S>& model, std::int64_t slot, double dt) {
  return hexahedron_volume(corners_at_forces(model, slot, dt)) /
         element_volume(model.mesh, model.element_of_slot[slot]);
}

/// What a number of material_state is.
const char* name_of(const MaterialPlaces& places, int number) {
  const auto is_of = [number](int place, int count) { return place >= 0 && number >= place && number < place + count; };
  return is_of(places.temperature, 1)   ? "temperature"
         : is_of(places.energy, 1)      ? "energy of the equation of state"
         : is_of(places.damage, 1)      ? "damage"
         : is_of(places.hardening, 1)   ? "strain of hardening"
         : is_of(places.strain, 6)      ? "strain"
         : is_of(places.deformation, 6) ? "deformation"
         : is_of(places.gradient, 9)    ? "deformation gradient"
                                        : "back stress";
}

/// What is not finite of the state of an element, or nothing.
template <class S>
std::string not_finite_part(const Model<S>& model, std::int64_t slot) {
  const ElementStore& e = model.elements;
  const auto bad = [&e, slot](const RealArray& array, int components) {
    if (array.empty()) return false;
    for (int c = 0; c < components; ++c) {
      if (!std::isfinite(array[e.at(slot, c, components)])) return true;
    }
    return false;
  };
  if (bad(e.stress, 6)) return "stress";
  if (bad(e.plastic_strain, 1)) return "plastic strain";
  if (bad(e.hourglass_state, 12)) return "hourglass force";
  if (bad(e.viscous_stress, 1)) return "bulk viscosity";
  if (bad(e.internal_energy, 1)) return "internal energy";
  const MaterialPlaces& places = model.constants[model.part_of_slot(slot)].places;
  for (int number = 0; number < places.numbers; ++number) {
    if (!std::isfinite(e.material_number(slot, number))) return name_of(places, number);
  }
  return "";
}

/// Whether a corner of an element has a velocity or a place that is not finite.
template <class S>
bool corner_not_finite(const Model<S>& model, std::int64_t slot) {
  for (const std::int32_t node : model.elements.corners(slot)) {
    const S *const x = model.nodes.position_of(node), *const v = model.nodes.velocity_of(node);
    for (int k = 0; k < 3; ++k) {
      if (!std::isfinite(v[k]) || !std::isfinite(x[k])) return true;
    }
  }
  return false;
}

constexpr const char* try_smaller_steps = "try a smaller time.cfl";

}  // namespace

template <class S>
void Guards<S>::check_volumes(const InternalForceResult<S>& element) const {
  if (element.inverted_count == 0) return;
  std::int64_t worst = -1;
  double least = 0;
  for (std::int64_t slot = 0; slot < model_.elements.slots; ++slot) {
    if (!model_.elements.alive(slot)) continue;
    const double ratio = volume_ratio(model_, slot, clock_.dt());
    if (worst >= 0 && !(ratio < least)) continue;
    least = ratio;
    worst = slot;
  }
  fail(fmt::format("{} {} no volume left {}, first of all {}",
                   counted_of(element.inverted_count, model_.element_count(), "element"),
                   element.inverted_count == 1 ? "has" : "have", when(), element_name(model_, worst)),
       fmt::format("{}, element.negative_volume=\"erode\", or an erosion_strain for the material", try_smaller_steps));
}

template <class S>
void Guards<S>::check_inside_out(std::int64_t count) const {
  if (count == 0) return;
  const FoldedElement worst = most_folded(model_, clock_.dt(), true);
  if (worst.slot < 0 || worst.share > 0) return;
  fail(fmt::format("{} {} inside out at a corner {}, first of all {}",
                   counted_of(count, model_.element_count(), "element"), count == 1 ? "is" : "are", when(),
                   element_name(model_, worst.slot)),
       fmt::format("{}, a finer mesh there, or element.inside_out=\"warn\"", try_smaller_steps));
}

template <class S>
void Guards<S>::check_finite(double energy) const {
  if (std::isfinite(energy)) return;
  std::int64_t beside = -1;
  for (const std::int64_t slot : model_.slot_of_element) {  // the first in the order of the scene
    if (!model_.elements.alive(slot)) continue;
    const std::string part = not_finite_part(model_, slot);
    if (!part.empty()) {
      fail(fmt::format("the {} of {} is not finite {}", part, element_name(model_, slot), when()),
           fmt::format("{}, and look at its material and its shape there", try_smaller_steps));
    }
    if (beside < 0 && corner_not_finite(model_, slot)) beside = slot;
  }
  if (beside >= 0) {
    fail(fmt::format("a node of {} has a velocity that is not finite {}", element_name(model_, beside), when()),
         fmt::format("{}, and look at loads, prescribed velocities and contact there", try_smaller_steps));
  }
  fail(fmt::format("the energy is not finite {}, though all elements are", when()),
       fmt::format("{}, or precision=\"double\"", try_smaller_steps));
}

template <class S>
void Guards<S>::check_energy(const EnergyLedger& ledger) const {
  if (std::abs(ledger.balance_error_in_motion()) <= model_.scene.guard.energy_error) return;
  fail(fmt::format("the energy balance is off by {:.3g} % of the energy in motion {}, more than guard.energy_error = "
                   "{:.3g} %; the time step is set by {}",
                   100 * ledger.balance_error_in_motion(), when(), 100 * model_.scene.guard.energy_error,
                   step_limit(model_, clock_)),
       fmt::format("{}, or a finer mesh where most is going on", try_smaller_steps));
}

template <class S>
void Guards<S>::check_time_step() const {
  const double ratio = model_.scene.guard.time_step_collapse, dt = clock_.dt();
  if (clock_.lost()) {
    throw RunError(fmt::format("no number of steps of {:.3g}, as {}, reaches time.end = {:.6g}; the step is set by {}",
                               dt, when(), model_.scene.time.end, step_limit(model_, clock_)));
  }
  if (!(dt > 0 && dt < ratio * clock_.dt_max() && clock_.remaining() > 2 * dt)) return;
  fail(fmt::format("the stable step has collapsed to {:.3g} {}, less than guard.time_step_collapse = {:.3g} of the "
                   "largest, {:.3g}; it is set by {}",
                   dt, when(), ratio, clock_.dt_max(), step_limit(model_, clock_)),
       clock_.limited_by() == StepLimit::contact
           ? "try a smaller contact.beta, or contact.enforcement=\"lagrange\", which does not limit it"
           : "try an erosion_strain for its material, or a better shape of its mesh");
}

template <class S>
void Guards<S>::fail(const std::string& what, const std::string& advice) const {
  throw RunError(fmt::format("{}: {}", what, cause_.empty() ? advice : cause_));
}

template <class S>
std::string Guards<S>::when() const {
  return fmt::format("in step {} at time {:.6g}", clock_.steps(), clock_.force_time());
}

template class Guards<double>;
template class Guards<float>;

}  // namespace pinball
