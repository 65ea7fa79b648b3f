#include "info_cost.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <ctime>

#include <kernels/exec.hpp>
#include <solver/base/error.hpp>
#include <solver/output/progress.hpp>
#include <solver/results/forecast.hpp>
#include <solver/step/report.hpp>

#include "info_devices.hpp"
#include "info_material.hpp"

namespace pinball {

namespace {

constexpr double trial_seconds = 0.5;
/// A place of the run is noted as often as this [s].
constexpr double note_seconds = 0.01;

/// Of one thread the time that it had a processor: what else the machine does is no part of the run.
double now() {
  if (DefaultExecutionSpace::concurrency() == 1) return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

template <class S>
RunPlace place_of(const Solver<S>& solver, double seconds) {
  return {solver.time(), solver.dt(), solver.steps(), seconds, solver.counts().pairs_max() > 0};
}

/// What rows of the history cost, without writing them [s].
template <class S>
double seconds_of_rows(const Solver<S>& solver, double steps) {
  const OutputSettings& output = solver.scene().output;
  const double interval = output.interval > 0 ? output.interval : solver.scene().time.end / 200;
  const double rows = output.every_step ? steps : std::min(steps, solver.scene().time.end / interval);
  const double start = now();
  history_row(solver);
  return rows * (now() - start);
}

std::string time_text(double seconds) {
  return seconds < 60 ? fmt::format("{:.2g} s", seconds) : readable_duration(seconds);
}

template <class S>
void print_store(const Solver<S>& solver) {
  const Model<S>& model = solver.model();
  fmt::print("  {} tiles of elements in {} colours, {} elements per pack (SIMD), {} thread{}\n", model.tile_count(),
             model.tile_colours.colour_offsets.size() - 1, ElementStore<S>::width, DefaultExecutionSpace::concurrency(),
             DefaultExecutionSpace::concurrency() == 1 ? "" : "s");
  const auto contact_bytes = solver.contact() != nullptr ? solver.contact()->bytes() : 0;
  const auto bytes = static_cast<double>(model.bytes() + contact_bytes);
  fmt::print("  memory of the stores: {}, {:.0f} bytes per element\n", readable_bytes(bytes),
             bytes / static_cast<double>(model.element_count()));
}

}  // namespace

template <class S>
void print_cost(Solver<S>& solver, const Units& units) {
  const Scene& scene = solver.scene();
  fmt::print("cost\n");
  print_store(solver);
  Forecast forecast(scene, solver.look().impact_speed);
  const double start = now();
  double noted = -note_seconds;
  const auto note = [&] {
    const double seconds = now() - start;
    if (seconds - noted >= note_seconds || solver.at_end()) forecast.take(place_of(solver, noted = seconds));
  };
  try {
    solver.step();
    const double first = solver.dt();
    fmt::print("  first step {} (time.cfl {:.3g})\n", with_unit(first, units.time), scene.time.cfl);
    for (note(); now() - start < trial_seconds && !solver.at_end(); note()) solver.step();
    forecast.take(place_of(solver, now() - start));
  } catch (const RunError& error) {
    fmt::print("  the run fails: {}\n", error.what());
    return;
  }
  const double element_steps = static_cast<double>(solver.element_count()) * static_cast<double>(solver.steps());
  const double resting = static_cast<double>(solver.counts().work().resting_element_steps);
  const ExpectedRun run = forecast.expected(resting / element_steps);
  const double seconds = run.seconds + seconds_of_rows(solver, run.steps);
  const double per_step = run.seconds / run.steps;
  fmt::print(
      "  {:.0f} steps to {}, {}run time about {} ({:.3g} ms per step, {:.3g} million element steps per second)\n",
      run.steps, with_unit(solver.at_end() ? solver.time() : scene.time.end, units.time),
      solver.at_end() ? "all made just now, " : "", time_text(seconds), 1e3 * per_step,
      1e-6 * static_cast<double>(solver.element_count()) / per_step);
}

template void print_cost(Solver<double>&, const Units&);
template void print_cost(Solver<float>&, const Units&);

}  // namespace pinball
