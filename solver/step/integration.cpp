#include "integration.hpp"

#include <algorithm>
#include <vector>

#include <kernels/exec.hpp>

namespace pinball {

namespace {

/// Steps of nodes [time].
template <class S>
struct NodeSteps {
  S velocity, position, energy;
};

/// Of the nodes of a span; there once in machine code, whoever adds up the spans. The energy is no value that is
/// returned: GCC 12 would add it up where it can be taken apart for that, in memory, and each node would wait for the
/// one before.
template <class S>
PINBALL_ONE_COPY void integrate_span(Model<S>& model, std::int64_t span, const NodeSteps<S>& steps,
                                     MotionEnergy& energy) {
  const std::int64_t begin = span * nodes_per_span;
  const std::int64_t end = std::min<std::int64_t>(model.nodes.count, begin + nodes_per_span);
  // Locals: as far as the compiler knows, stores to the arrays might change anything that is reached by reference.
  S* position = model.nodes.position.data();
  S* velocity = model.nodes.velocity.data();
  S* force = model.nodes.force.data();
  const S* inverse_mass = model.nodes.inverse_mass.data();
  const double* mass = model.node_mass.data();
  const S velocity_step = steps.velocity, position_step = steps.position, energy_step = steps.energy;
  MotionEnergy sum;
  for (std::int64_t n = begin; n < end; ++n) {
    sum.add(mass[n], integrate_node(position + 4 * n, velocity + 4 * n, force + 4 * n, inverse_mass[n], velocity_step,
                                    position_step, energy_step));
  }
  energy = sum;
}

/// of_span(span): of each span that is due.
template <class OfSpan>
MotionEnergy sum_of_spans(std::int64_t spans, const DueSpans& due, const OfSpan& of_span) {
  MotionEnergy energy;
  parallel_reduce(
      "integration", RangePolicy<>{0, spans}, energy,
      [&](std::int64_t begin, std::int64_t end, MotionEnergy& partial) {
        for (std::int64_t span = begin; span < end; ++span) {
          if (due.contain(span)) partial.join(of_span(span));
        }
      },
      [](MotionEnergy& whole, const MotionEnergy& partial) { whole.join(partial); });
  return energy;
}

}  // namespace

template <class S>
MotionEnergy integrate_nodes(Model<S>& model, const DueSpans& due, const StepLengths& step,
                             const Subdomain<S>* domain) {
  const auto position_step = static_cast<S>(step.after);
  const auto integrate = [&](std::int64_t span) {
    MotionEnergy energy;
    integrate_span(
        model, span,
        NodeSteps<S>{static_cast<S>(step.velocity()), position_step * due.steps(span), static_cast<S>(step.before)},
        energy);
    return energy;
  };
  const std::int64_t spans = span_count(model.nodes.count);
  if (domain == nullptr) return sum_of_spans(spans, due, integrate);
  std::vector<MotionEnergy> of_span(spans);
  for (const SharedBlocks::Run& run : domain->node_blocks().worked()) {
    parallel_for("integration", RangePolicy<>{run.begin, run.end},
                 [&](std::int64_t span) { of_span[span] = due.contain(span) ? integrate(span) : MotionEnergy(); });
  }
  domain->node_blocks().gather(of_span.data(), [&due](std::size_t span) { return due.contain(span); });
  return sum_of_spans(spans, due, [&](std::int64_t span) { return of_span[span]; });
}

template MotionEnergy integrate_nodes(Model<double>&, const DueSpans&, const StepLengths&, const Subdomain<double>*);
template MotionEnergy integrate_nodes(Model<float>&, const DueSpans&, const StepLengths&, const Subdomain<float>*);

}  // namespace pinball
