#pragma once

#include <kernels/boundary/external_work.hpp>
#include <kernels/node_update.hpp>
#include <solver/model/model.hpp>
#include <solver/model/node_spans.hpp>
#include <solver/parallel/subdomain.hpp>

namespace pinball {

/// Accelerations, velocities and positions of the nodes that are due (report figure 4, 5-6; node_update.hpp), and zero
/// forces. domain: of several ranks, of which this one moves the nodes that it holds; null: one process moves all.
template <class S>
MotionEnergy integrate_nodes(Model<S>& model, const DueSpans& due, const StepLengths& step,
                             const Subdomain<S>* domain = nullptr);

}  // namespace pinball
