#include <algorithm>
#include <cmath>

#include <kernels/exec.hpp>

#include "impulse_iterations.hpp"

namespace pinball {

void ImpulseIterations::project(const RowSystem& system, double* velocity) {
  const std::int64_t rows = system.size(), nodes = static_cast<std::int64_t>(system.nodes().size());
  change_.renew(4 * system.places());
  const auto move = [&](const Records& impulses) {
    parallel_for("projection", RangePolicy<>{0, nodes}, [&](std::int64_t i) {
      const std::int32_t place = system.nodes()[static_cast<std::size_t>(i)];
      const Vec3<double> by = moved_by(system.node(place), system.impulse_at(place, impulses.data()));
      double* const v = record(velocity, place);
      v[0] -= by.x;
      v[1] -= by.y;
      v[2] -= by.z;
    });
  };
  // u of the rows that close, and the sum of their weights at each node.
  parallel_for("closing rows", RangePolicy<>{0, rows}, [&](std::int64_t k) {
    const RowSystem::Row& row = system.row(k);
    record(gradient_.data(), k)[0] = std::max(0.0, dot(row.direction, system.approach(k, velocity)) + row.rate);
  });
  parallel_for("shares of rows", RangePolicy<>{0, nodes}, [&](std::int64_t i) {
    const std::int32_t place = system.nodes()[static_cast<std::size_t>(i)];
    double& share = record(change_.data(), place)[0] = 0;
    system.for_rows_of(place, [&](std::int32_t k, double weight) {
      if (record(gradient_.data(), k)[0] > 0) share += std::abs(weight);
    });
  });
  parallel_for("shared impulses", RangePolicy<>{0, rows}, [&](std::int64_t k) {
    const RowSystem::Row& row = system.row(k);
    const RowView entries = system.entries(k);
    const double closing = record(gradient_.data(), k)[0];
    double sum = 0;
    for (int e = 0; e < entries.nodes; ++e) {
      const Vec3<double> by = moved_by(system.node(entries.node[e]), row.direction);
      sum += std::abs(entries.weight[e]) * record(change_.data(), entries.node[e])[0] * std::sqrt(dot(by, by));
    }
    const double p = closing > 0 ? closing / sum : 0.0;
    const Vec3<double> before = get(impulse_, k), across = before - system.along(k, before) * row.direction;
    const Vec3<double> b = p * row.direction;
    put(impulse_, k, system.rubs() ? allowed_impulse(b + across, row.direction, {row.coefficient, 0}) : b);
  });
  move(impulse_);
  if (!system.rubs()) return;
  parallel_for("friction", RangePolicy<>{0, rows}, [&](std::int64_t k) {
    const RowSystem::Row& row = system.row(k);
    const Vec3<double> b = get(impulse_, k), s = system.approach(k, velocity);
    const Vec3<double> sliding = s - dot(row.direction, s) * row.direction;
    const Vec3<double> after = allowed_impulse(b + (1 / row.bound) * sliding, row.direction, {row.coefficient, 0});
    put(trial_, k, after - b);
    put(impulse_, k, after);
  });
  move(trial_);
}

}  // namespace pinball
