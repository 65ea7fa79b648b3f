#include <fmt/core.h>

#include <chrono>
#include <cmath>

#include <solver/base/error.hpp>
#include <solver/base/thread_count.hpp>
#include <solver/device/devices.hpp>
#include <solver/step/report.hpp>

#include "simulation_implementation.hpp"

namespace pinball {

namespace {

/// Adds the time of its life to a sum.
class Stopwatch {
 public:
  explicit Stopwatch(double& seconds) : seconds_(seconds) {}
  ~Stopwatch() { seconds_ += std::chrono::duration<double>(Clock::now() - start_).count(); }
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;

 private:
  using Clock = std::chrono::steady_clock;
  double& seconds_;
  Clock::time_point start_ = Clock::now();
};

}  // namespace

Simulation::Simulation(const Scene& given, const SimulationOptions& options)
    : implementation_(std::make_unique<Implementation>()) {
  if (options.threads < 0 || options.threads > most_threads) {
    throw InputError(fmt::format("threads: expected an integer >= 0 and <= {}, got {}", most_threads, options.threads));
  }
  const ThreadCount threads(options.threads);
  const Scene scene = checked_scene(given);
  require_device(scene.device);
  implementation_->options = options;
  if (scene.precision == Precision::float32) {
    implementation_->solver = std::make_unique<Solver<float>>(scene, options.ranks);
  } else {
    implementation_->solver = std::make_unique<Solver<double>>(scene, options.ranks);
  }
  implementation_->elements = implementation_->read([](const auto& solver) { return solver.element_count(); });
}

Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

bool Simulation::step() {
  Implementation& own = *implementation_;
  if (own.complete) return false;
  const ThreadCount threads(own.threads());
  const Stopwatch watch(own.wall_seconds);
  own.change([&own](auto& solver) {
    if (solver.at_end()) {
      solver.finish();
      own.complete = true;
    } else {
      solver.step();
    }
  });
  bool stops = false;
  own.change([&](auto& solver) {
    solver.timers().measure(Phase::output, [&] {
      for (std::size_t c = 0; c < own.callbacks.size(); ++c) {  // a callback may add others
        const StepCallback callback = own.callbacks[c];
        stops |= callback(*this) == AfterStep::stop;
      }
    });
  });
  return !own.complete && !stops;
}

bool Simulation::run_until(double time) {
  if (std::isnan(time)) throw InputError("run_until: expected a time, got nan");
  while (this->time() < time * (1 - 1e-12)) {
    if (!step()) return false;
  }
  return !complete();
}

bool Simulation::run() {
  while (step()) {
  }
  return complete();
}

void Simulation::follow_rank_0(const RankAnswer& answer) {
  const ThreadCount threads(implementation_->threads());
  implementation_->change([&](auto& solver) {
    solver.follow_rank_0([&](std::int64_t number) { return answer ? answer(*this, number) : std::string(); });
  });
}

std::vector<std::string> Simulation::ask_ranks(std::int64_t number, const RankAnswer& answer) {
  return implementation_->change(
      [&](auto& solver) { return solver.ask_ranks(number, [&](std::int64_t n) { return answer(*this, n); }); });
}

void Simulation::on_step(StepCallback callback) {
  if (!callback) throw InputError("on_step: expected a function, got none");
  implementation_->callbacks.push_back(std::move(callback));
}

bool Simulation::complete() const { return implementation_->complete; }
bool Simulation::at_end() const {
  return implementation_->read([](const auto& solver) { return solver.at_end(); });
}
double Simulation::time() const {
  return implementation_->read([](const auto& solver) { return solver.time(); });
}
double Simulation::state_time() const {
  return implementation_->read([](const auto& solver) { return solver.force_time(); });
}
double Simulation::dt() const {
  return implementation_->read([](const auto& solver) { return solver.dt(); });
}
std::int64_t Simulation::steps() const {
  return implementation_->read([](const auto& solver) { return solver.steps(); });
}

const Scene& Simulation::scene() const {
  return *implementation_->read([](const auto& solver) { return &solver.scene(); });
}
const Energies& Simulation::energies() const {
  return *implementation_->read([](const auto& solver) { return &solver.energies(); });
}
double Simulation::balance_error() const {
  return implementation_->read([](const auto& solver) { return solver.balance_error(); });
}
double Simulation::balance_error_in_motion() const {
  return implementation_->read([](const auto& solver) { return solver.balance_error_in_motion(); });
}
std::vector<BodyResult> Simulation::bodies() const {
  return implementation_->read([](const auto& solver) { return pinball::body_results(solver); });
}
ProgressState Simulation::progress() const {
  return implementation_->read([](const auto& solver) { return pinball::progress_state(solver); });
}
HistoryRow Simulation::history_row() const {
  return implementation_->read([](const auto& solver) { return pinball::history_row(solver); });
}
std::vector<std::string> Simulation::history_columns() const {
  return implementation_->read([](const auto& solver) { return pinball::more_columns(solver); });
}
std::vector<ProbeResult> Simulation::probes() const {
  return implementation_->read([](const auto& solver) { return solver.probe_results(); });
}
RunSummary Simulation::summary() const {
  const ThreadCount threads(implementation_->threads());
  RunSummary summary;
  summary.wall_seconds = implementation_->wall_seconds;
  implementation_->read([&summary](const auto& solver) { fill_summary(solver, summary); });
  if (complete()) summary.status = RunStatus::done;
  return summary;
}
std::uint64_t Simulation::state_hash() const {
  return implementation_->read([](const auto& solver) { return pinball::state_hash(solver.model()); });
}
FieldSnapshot Simulation::snapshot() const {
  return implementation_->read([](const auto& solver) { return pinball::snapshot(solver); });
}

FieldSnapshot Simulation::own_snapshot() const {
  return implementation_->read([](const auto& solver) { return pinball::own_snapshot(solver); });
}
int Simulation::rank() const {
  return implementation_->read([](const auto& solver) { return solver.rank(); });
}
std::vector<std::int32_t> Simulation::rank_of_elements() const {
  return implementation_->read([](const auto& solver) { return solver.rank_of_elements(); });
}

void Simulation::persist(StateArchive& archive) {
  const ThreadCount threads(implementation_->threads());
  implementation_->change([&archive](auto& solver) { solver.persist(archive); });
  std::uint8_t complete = implementation_->complete ? 1 : 0;
  archive(complete);
  implementation_->complete = complete != 0;
}
std::uint64_t Simulation::fingerprint() const {
  return implementation_->read([](const auto& solver) { return pinball::fingerprint(solver.model()); });
}
std::vector<MeshSource> Simulation::mesh_sources() const {
  return implementation_->read([](const auto& solver) {
    std::vector<MeshSource> all;
    for (const FileNodes& file : solver.model().mesh.files)
      all.insert(all.end(), file.sources.begin(), file.sources.end());
    return all;
  });
}
int Simulation::simd_width() const {
  return implementation_->read([](const auto& solver) { return solver.model().elements.width; });
}

}  // namespace pinball
