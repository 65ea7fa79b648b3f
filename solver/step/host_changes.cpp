#include <algorithm>

#include <solver/base/built_features.hpp>
#include <solver/base/error.hpp>

#include "impact_speed.hpp"
#include "solver.hpp"

namespace pinball {

template <class S>
AlignedArray<S>& Solver<S>::change_velocities() {
  if (subcycling_) throw InputError("velocities: expected time.subcycling = false, with it they cannot be changed");
  if (!kinetic_before_change_) kinetic_before_change_ = kinetic_energy_now();
  return model().nodes.velocity;
}

template <class S>
AlignedArray<S>& Solver<S>::host_forces() {
  if (!built::boundary_conditions) {
    throw InputError("external forces: this library was built without boundary conditions (PINBALL_WITHOUT)");
  }
  return boundary_.host_forces(model_);
}

template <class S>
double Solver<S>::kinetic_energy_now() const {
  double twice = 0;
  for (std::size_t n = 0; n < model_.node_mass.size(); ++n) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto v = static_cast<double>(model_.nodes.velocity[4 * n + k]);
      twice += model_.node_mass[n] * v * v;
    }
  }
  return 0.5 * twice;
}

template <class S>
void Solver<S>::take_changed_velocities() {
  const double added = kinetic_energy_now() - *kinetic_before_change_;
  kinetic_before_change_.reset();
  internal_forces_.forget_resting();
  if (contact_) longest_contact_step_ = std::min(longest_contact_step_, longest_contact_step(model_));
  if (steps_ > 0) {
    boundary_.add_work(added);
  } else {
    initial_momentum_ = momentum();
  }
}

template class Solver<double>;
template class Solver<float>;

}  // namespace pinball
