#include "integration.hpp"

#include <algorithm>

#include <kernels/exec.hpp>

namespace pinball {

template <class S>
MotionEnergy integrate_nodes(Model<S>& model, const DueSpans& due, const StepLengths& step) {
  const auto position_step = static_cast<S>(step.after), energy_step = static_cast<S>(step.before);
  const auto velocity_step = static_cast<S>(step.velocity());
  const auto integrate = [&](std::int64_t begin, std::int64_t end, S way_step) {
    // Locals: as far as the compiler knows, stores to the arrays might change anything that is reached by reference.
    S* position = model.nodes.position.data();
    S* velocity = model.nodes.velocity.data();
    S* force = model.nodes.force.data();
    const S* inverse_mass = model.nodes.inverse_mass.data();
    const double* mass = model.node_mass.data();
    const S steps[] = {velocity_step, way_step, energy_step};
    MotionEnergy sum;
    for (std::int64_t n = begin; n < end; ++n) {
      sum.add(mass[n], integrate_node(position + 4 * n, velocity + 4 * n, force + 4 * n, inverse_mass[n], steps[0],
                                      steps[1], steps[2]));
    }
    return sum;
  };
  MotionEnergy energy;
  parallel_reduce(
      "integration", RangePolicy<>{0, span_count(model.nodes.count)}, energy,
      [&](std::int64_t begin, std::int64_t end, MotionEnergy& partial) {
        for (std::int64_t span = begin; span < end; ++span) {
          if (!due.contain(span)) continue;
          const std::int64_t first = span * nodes_per_span;
          const std::int64_t last = std::min<std::int64_t>(model.nodes.count, first + nodes_per_span);
          partial.join(integrate(first, last, position_step * due.steps(span)));
        }
      },
      [](MotionEnergy& whole, const MotionEnergy& partial) { whole.join(partial); });
  return energy;
}

template <class S>
double kinetic_energy(const Model<S>& model) {
  double twice = 0;
  for (std::size_t n = 0; n < model.node_mass.size(); ++n) {
    for (std::size_t k = 0; k < 3; ++k) {
      const double v = model.nodes.velocity[4 * n + k];
      twice += model.node_mass[n] * v * v;
    }
  }
  return 0.5 * twice;
}

template MotionEnergy integrate_nodes(Model<double>&, const DueSpans&, const StepLengths&);
template MotionEnergy integrate_nodes(Model<float>&, const DueSpans&, const StepLengths&);
template double kinetic_energy(const Model<double>&);
template double kinetic_energy(const Model<float>&);

}  // namespace pinball
