#include <algorithm>
#include <cmath>

#include "impulse_iterations.hpp"
#include "island_loops.hpp"

namespace pinball {

void ImpulseIterations::project(const RowSystem& system, double* velocity) {
  change_.renew(4 * system.places());
  const IslandLoops loops(system.size() >= rows_to_share);
  const auto for_rows = [&](const auto& body) { loops.for_each(0, system.size(), body); };
  const auto for_nodes = [&](const auto& body) {
    loops.for_each(0, system.nodes().size(), [&](std::int64_t i) { body(system.nodes()[i]); });
  };
  // u of the rows that close, and the sum of their weights at each node.
  for_rows([&](std::int64_t k) {
    const RowSystem::Row& row = system.row(k);
    record(gradient_.data(), k)[0] = std::max(0.0, dot(row.direction, system.approach(k, velocity)) + row.rate);
  });
  for_nodes([&](std::int32_t place) {
    double& share = record(change_.data(), place)[0] = 0;
    system.for_rows_of(place, [&](std::int32_t k, double weight) {
      if (record(gradient_.data(), k)[0] > 0) share += std::abs(weight);
    });
  });
  for_rows([&](std::int64_t k) {
    const RowSystem::Row& row = system.row(k);
    const RowView entries = system.entries(k);
    const double closing = record(gradient_.data(), k)[0];
    double sum = 0;
    for (int e = 0; e < entries.nodes; ++e) {
      const Vec3<double> by = moved_by(system.node(entries.node[e]), row.direction);
      sum += std::abs(entries.weight[e]) * record(change_.data(), entries.node[e])[0] * std::sqrt(dot(by, by));
    }
    const double p = closing > 0 ? closing / sum : 0.0;
    const Vec3<double> before = get(impulse_, k), across = before - dot(row.direction, before) * row.direction;
    put(impulse_, k, allowed_impulse(p * row.direction + across, row.direction, {row.coefficient, 0}));
  });
  for_nodes([&](std::int32_t place) { system.move(place, impulse_.data(), velocity); });
  if (!system.rubs()) return;
  for_rows([&](std::int64_t k) {
    const RowSystem::Row& row = system.row(k);
    const Vec3<double> b = get(impulse_, k), s = system.approach(k, velocity);
    const Vec3<double> sliding = s - dot(row.direction, s) * row.direction;
    const Vec3<double> after = allowed_impulse(b + (1 / row.bound) * sliding, row.direction, {row.coefficient, 0});
    put(trial_, k, after - b);
    put(impulse_, k, after);
  });
  for_nodes([&](std::int32_t place) { system.move(place, trial_.data(), velocity); });
}

}  // namespace pinball
