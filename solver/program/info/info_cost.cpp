#include "info_cost.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>

#include <kernels/exec.hpp>
#include <solver/base/counted.hpp>
#include <solver/base/error.hpp>
#include <solver/program/text_table.hpp>
#include <solver/results/forecast.hpp>
#include <solver/results/run_outputs.hpp>
#include <solver/step/report.hpp>

#include "info_devices.hpp"
#include "info_material.hpp"

namespace pinball {

namespace {

constexpr double trial_seconds = 0.05;
/// A place of the run is noted as often as this [s].
constexpr double note_seconds = 0.002;
/// The first three steps build everything: lists that last are those of the third, which knows how long a step is. Some
/// more tell what a step costs.
constexpr std::int64_t building_steps = 3, least_steps = 6;

/// What is not tried, over what was: a row that is written over one that is made, fields that are written over those
/// that are gathered; and over a program that comes up a row, also of the page, a file of fields, and all other files
/// together.
constexpr double row_written = 2, fields_written = 5;
constexpr double row_of_page = 0.005, file_of_fields = 0.035, files_of_run = 0.45;
/// A copy of the state goes with each file of fields [s/byte].
constexpr double copied_byte = 3.5e-10;

/// Of one thread the time that it had a processor: what else the machine does is no part of the run.
double now() {
  if (DefaultExecutionSpace::concurrency() == 1) return processor_seconds();
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// So that the clock of a processor, which is a call of the system, is not what small steps spend their time with.
class Pause {
 public:
  bool is_over() {
    const auto now = Clock::now();
    if (now - begun_ < std::chrono::microseconds(200)) return false;
    begun_ = now;
    return true;
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point begun_ = Clock::now();
};

template <class S>
RunPlace place_of(const Solver<S>& solver, double seconds) {
  return {solver.time(), solver.dt(), solver.steps(), seconds, solver.counts().pairs_max() > 0};
}

/// The least of three times: the first finds nothing in the caches.
template <class Work>
double seconds_of(const Work& work) {
  double least = HUGE_VAL;
  for (int i = 0; i < 3; ++i) {
    const double start = now();
    work();
    least = std::min(least, now() - start);
    if (least > 0.01) break;
  }
  return least;
}

template <class S>
double bytes_of(const Solver<S>& solver) {
  const auto contact = solver.contact() != nullptr ? solver.contact()->bytes() : 0;
  return solver.model().bytes() + contact;
}

/// Of all that a run writes, without writing it [s]. program: what it took to come up [s].
template <class S>
double seconds_of_outputs(const Solver<S>& solver, const ExpectedRun& run, double program) {
  const RunOutputs outputs = outputs_of(solver.scene(), run.steps, run.time);
  double seconds = files_of_run * program;
  seconds += outputs.rows * (row_of_page * program + row_written * seconds_of([&] { history_row(solver); }));
  if (outputs.fields > 0) {
    const double of_one = file_of_fields * program + fields_written * seconds_of([&] { snapshot(solver); }) +
                          copied_byte * bytes_of(solver);
    seconds += outputs.fields * of_one;
  }
  return seconds;
}

/// Of all steps that were made.
template <class S>
StepPhases phases_of(const Solver<S>& solver) {
  const auto of = [&solver](Phase phase) { return solver.timers().seconds(phase); };
  StepPhases phases;
  phases.elements = of(Phase::internal_forces);
  phases.searches = of(Phase::contact_search);
  phases.impulses = of(Phase::contact_forces);
  phases.others = of(Phase::pinballs) + of(Phase::contact_scatter) + of(Phase::time_step) +
                  of(Phase::boundary_conditions) + of(Phase::integration);
  phases.steps = solver.steps();
  const bool lists_last = solver.contact() != nullptr && solver.scene().skip.contact_search;
  phases.lists = lists_last ? solver.contact()->searches() : 0;
  phases.iterations = solver.counts().work().iterations.mean();
  phases.touching = solver.counts().pairs_max() > 0;
  return phases;
}

/// Of the steps after some; iterations of all.
StepPhases after(const StepPhases& some, StepPhases all) {
  all.elements -= some.elements;
  all.searches -= some.searches;
  all.impulses -= some.impulses;
  all.others -= some.others;
  all.steps -= some.steps;
  all.lists -= some.lists;
  if (all.lists == 0 && some.lists > 0) all.of_list = some.searches / some.lists;
  return all;
}

template <class S>
double surface_of(const Solver<S>& solver) {
  if (solver.contact() == nullptr) return 0;
  return static_cast<double>(solver.contact()->surface_elements()) / static_cast<double>(solver.element_count());
}

/// Below a tenth of a second starting and files are most of it, and their times go up and down.
std::string time_text(double seconds) { return seconds < 0.1 ? "under 0.1 s" : "about " + duration_cell(seconds); }

template <class S>
void print_store(const Solver<S>& solver) {
  const Model<S>& model = solver.model();
  fmt::print("  {} of elements in {}, {} per pack (SIMD), {}\n", counted(model.tile_count(), "tile"),
             counted(model.tile_colours.colour_offsets.size() - 1, "colour"), counted(model.elements.width, "element"),
             counted(DefaultExecutionSpace::concurrency(), "thread"));
  const double bytes = bytes_of(solver);
  fmt::print("  memory of the stores: {}, {:.0f} bytes per element\n", readable_bytes(bytes),
             bytes / model.element_count());
}

}  // namespace

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

template <class S>
void print_cost(Solver<S>& solver, const Units& units, const SpentSoFar& spent) {
  const Scene& scene = solver.scene();
  fmt::print("cost\n");
  print_store(solver);
  Forecast forecast(scene, solver.impact_speed(), surface_of(solver));
  const double start = now();
  double noted = -note_seconds;
  StepPhases begun;
  const auto look = [&] {
    const double seconds = now() - start;
    if (seconds - noted >= note_seconds || solver.at_end()) forecast.take(place_of(solver, noted = seconds));
    return seconds;
  };
  try {
    solver.step();
    const double first = solver.dt();
    fmt::print("  first step {} (time.cfl {:.3g})\n", with_unit(first, units.time), scene.time.cfl);
    while (!solver.at_end() && solver.steps() < building_steps) solver.step();
    begun = phases_of(solver);
    look();
    for (Pause pause; !solver.at_end();) {
      solver.step();
      if (!solver.at_end() && !pause.is_over()) continue;
      if (look() >= trial_seconds && solver.steps() >= least_steps) break;
    }
    forecast.take(place_of(solver, now() - start));
  } catch (const RunError& error) {
    fmt::print("  the run fails: {}\n", error.what());
    return;
  }
  const double element_steps = static_cast<double>(solver.element_count()) * static_cast<double>(solver.steps());
  const double resting = solver.counts().work().resting_element_steps;
  const ExpectedRun run = forecast.expected(resting / element_steps, after(begun, phases_of(solver)));
  const double seconds = spent.built + run.seconds + seconds_of_outputs(solver, run, spent.program);
  const double per_step = run.seconds / run.steps;
  fmt::print("  {} to {}, {}run time {} ({:.3g} ms per step, {:.3g} million element steps per second)\n",
             run.steps == 1 ? "1 step" : fmt::format("{:.0f} steps", run.steps),
             with_unit(solver.at_end() ? solver.time() : scene.time.end, units.time),
             solver.at_end() ? "all made just now, " : "", time_text(seconds), 1e3 * per_step,
             1e-6 * solver.element_count() / per_step);
}

template void print_cost(Solver<double>&, const Units&, const SpentSoFar&);
template void print_cost(Solver<float>&, const Units&, const SpentSoFar&);

}  // namespace pinball
