#include "run_outputs.hpp"

#include <algorithm>
#include <cmath>

namespace pinball {

namespace {

double times_within(double time, double interval, double steps) {
  return std::min(std::floor(time / interval * (1 + 1e-9)), steps) + 1;
}

}  // namespace

RunOutputs outputs_of(const Scene& scene, double steps, double time) {
  const OutputSettings& output = scene.output;
  const double interval = output.interval > 0 ? output.interval : scene.time.end / 200;
  RunOutputs outputs;
  outputs.rows = output.every_step ? steps + 1 : times_within(time, interval, steps);
  if (output.field_interval > 0) outputs.fields = times_within(time, output.field_interval, steps);
  for (const double t : output.field_times) outputs.fields += t <= time * (1 + 1e-9) ? 1 : 0;
  return outputs;
}

}  // namespace pinball
