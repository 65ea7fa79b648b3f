#include "integration.hpp"

#include <algorithm>

#include <kernels/exec.hpp>
#include <kernels/node_update.hpp>

namespace pinball {

template <class S>
double integrate_nodes(Model<S>& model, const DueSpans& due, const StepLengths& step) {
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
    double sum = 0;
    for (std::int64_t n = begin; n < end; ++n) {
      const S v2 = integrate_node(position + 4 * n, velocity + 4 * n, force + 4 * n, inverse_mass[n], steps[0],
                                  steps[1], steps[2]);
      sum += mass[n] * static_cast<double>(v2);
    }
    return sum;
  };
  double twice_kinetic = 0;
  parallel_reduce(
      "integration", RangePolicy<>{0, span_count(model.nodes.count)}, twice_kinetic,
      [&](std::int64_t begin, std::int64_t end, double& partial) {
        for (std::int64_t span = begin; span < end; ++span) {
          if (!due.contain(span)) continue;
          const std::int64_t first = span * nodes_per_span;
          const std::int64_t last = std::min<std::int64_t>(model.nodes.count, first + nodes_per_span);
          partial += integrate(first, last, position_step * static_cast<S>(due.steps(span)));
        }
      },
      [](double& whole, double partial) { whole += partial; });
  return 0.5 * twice_kinetic;
}

template <class S>
double kinetic_energy(const Model<S>& model) {
  double twice = 0;
  for (std::size_t n = 0; n < model.node_mass.size(); ++n) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto v = static_cast<double>(model.nodes.velocity[4 * n + k]);
      twice += model.node_mass[n] * v * v;
    }
  }
  return 0.5 * twice;
}

template double integrate_nodes(Model<double>&, const DueSpans&, const StepLengths&);
template double integrate_nodes(Model<float>&, const DueSpans&, const StepLengths&);
template double kinetic_energy(const Model<double>&);
template double kinetic_energy(const Model<float>&);

}  // namespace pinball
