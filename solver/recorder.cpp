#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <pinball/solver/error.hpp>
#include <pinball/solver/recorder.hpp>
#include <utility>

namespace pinball {

namespace {

constexpr const char* checkpoint_name = "checkpoint.pinball";
constexpr const char* last_good_name = "last_good.pinball";

/// A copy of the state is made as often as takes this share of the time.
constexpr double share_of_copies = 0.005;
/// ... while the error of the energy balance is below this share of its bound: beyond it the trouble may have begun.
constexpr double share_of_energy_error = 0.2;

bool same_file(const std::filesystem::path& a, const std::filesystem::path& b) {
  std::error_code error;
  return std::filesystem::equivalent(a, b, error);
}

/// What a restart asks for has to lie ahead.
template <class S>
void check_limits(const Solver<S>& solver) {
  const TimeSettings& limits = solver.model().scene.time;
  if (limits.end < solver.time() * (1 - 1e-12)) {
    throw InputError(fmt::format("time.end: expected at least {:.9g}, the time of the checkpoint, got {:.9g}",
                                 solver.time(), limits.end));
  }
  if (limits.steps >= 0 && limits.steps < solver.steps()) {
    throw InputError(fmt::format("time.steps: expected at least {}, the step of the checkpoint, got {}", solver.steps(),
                                 limits.steps));
  }
}

}  // namespace

template <class S>
Recorder<S>::Recorder(const Scene& scene, Solver<S>& solver, const SimulationOptions& options)
    : folder_(options.out),
      history_times_(scene.output.interval > 0 ? scene.output.interval : scene.time.end / 200, {}),
      every_step_(scene.output.every_step),
      field_times_(scene.output.field_interval, scene.output.field_times),
      units_(scene.units),
      checkpoint_every_(options.checkpoint_every) {
  if (options.source != nullptr) {
    head_ = checkpoint_head(*options.source, scene);
    head_->fingerprint = solver.fingerprint();
  } else if (checkpoint_every_ > 0) {
    throw InputError("a checkpoint needs the source of the scene");
  }
  std::optional<RunRecord> kept;
  if (options.restart != nullptr) {
    const Checkpoint& checkpoint = *options.restart;
    kept = restart(checkpoint, solver);
    const auto folder = std::filesystem::absolute(checkpoint.path).parent_path();
    if (!same_file(folder, folder_)) kept.reset();  // its files are elsewhere
  }
  if (folder_.empty()) return;
  std::filesystem::create_directories(folder_);
  for (const char* name : {"last_good.vtu", last_good_name, checkpoint_name, "checkpoint.pinball.part"}) {
    if (options.restart != nullptr && name == checkpoint_name) continue;
    if (options.restart != nullptr && same_file(options.restart->path, path(name))) continue;
    std::filesystem::remove(path(name));
  }
  open_files(scene, solver, kept);
  if (solver.steps() > 0) {
    history_times_.passed(solver.force_time());
    field_times_.passed(solver.force_time());
  }
  keep_state(solver);
  start_ = Clock::now();
}

template <class S>
RunRecord Recorder<S>::restart(const Checkpoint& checkpoint, Solver<S>& solver) {
  const auto refuse = [&checkpoint](const std::string& reason) {
    throw InputError(fmt::format("{}: {}", checkpoint.path, reason));
  };
  const CheckpointHead& head = checkpoint.head;
  if (head.simd_width != ElementStore<S>::width) {
    refuse(fmt::format("written by pinball {} with packs of {}, this one has packs of {}", head.version,
                       head.simd_width, ElementStore<S>::width));
  }
  if (head.fingerprint != solver.fingerprint()) refuse("this program makes another mesh of the scene");
  RunRecord record;
  StateArchive archive = StateArchive::reading(checkpoint.state);
  try {
    record.persist(archive);
    solver.persist(archive);
    if (archive.left() > 0) StateArchive::throw_foreign();
  } catch (const InputError& error) {
    refuse(error.what());
  }
  check_limits(solver);
  wall_seconds_before_ = record.wall_seconds;
  return record;
}

template <class S>
void Recorder<S>::open_files(const Scene& scene, const Solver<S>& solver, const std::optional<RunRecord>& kept) {
  std::optional<std::uint64_t> rows;
  if (kept) rows = kept->history_bytes;
  history_ =
      std::make_unique<HistoryWriter>(folder_, solver.model().mesh.body_names, units_, solver.more_columns(), rows);
  if (scene.output.field_interval > 0 || !scene.output.field_times.empty()) {
    fields_ = std::make_unique<FieldWriter>(folder_, "fields", scene.output.fields, units_,
                                            kept ? kept->fields : FieldWriter::Written{});
  }
}

template <class S>
void Recorder<S>::record(Solver<S>& solver, bool last) {
  if (!history_) return;
  const double time = solver.force_time();
  const bool fields_due = fields_ && field_times_.due(time);
  if (last || every_step_ || history_times_.due(time)) {
    history_->write(solver.history_row());
    history_times_.passed(time);
    if (!last && !fields_due) keep_state(solver);
  }
  if (!fields_due) return;
  last_good_ = {};  // never two copies: this one is as large as the arrays of the step
  fields_->write(solver.snapshot());
  field_times_.passed(time);
  if (!last) save(solver);
}

template <class S>
void Recorder<S>::save(Solver<S>& solver) {
  RunRecord record{wall_seconds(), history_->bytes(), fields_ ? fields_->written() : FieldWriter::Written{}};
  StateArchive::save(last_good_, [&](StateArchive& archive) {
    record.persist(archive);
    solver.persist(archive);
  });
}

template <class S>
void Recorder<S>::keep_state(Solver<S>& solver) {
  const auto start = Clock::now();
  const double most = share_of_energy_error * std::as_const(solver).model().scene.guard.energy_error;
  if (start < next_copy_ || std::abs(solver.balance_error()) > most) return;
  save(solver);
  const auto end = Clock::now();
  next_copy_ = end + std::chrono::duration_cast<Clock::duration>((end - start) / share_of_copies);
}

template <class S>
void Recorder<S>::checkpoint(Solver<S>& solver, bool last) {
  if (checkpoint_every_ <= 0 || (++since_checkpoint_ < checkpoint_every_ && !last)) return;
  since_checkpoint_ = 0;
  save(solver);
  write_checkpoint(path(checkpoint_name), *head_, last_good_);
}

template <class S>
std::string Recorder<S>::save_last_good(Solver<S>& solver) {
  if (last_good_.empty()) return "";
  RunRecord record;
  StateArchive archive = StateArchive::reading({last_good_.data(), last_good_.size()});
  record.persist(archive);
  solver.persist(archive);
  const auto sentence = [&solver](const std::string& file) {
    return fmt::format("; the last good state, of step {}, is in {}", solver.steps(), file);
  };
  std::string restart;
  if (head_) {
    write_checkpoint(path(last_good_name), *head_, last_good_);
    restart = fmt::format(" and, for --restart, in {}", path(last_good_name));
  }
  last_good_ = {};
  return sentence(write_last_good_state(folder_, solver.snapshot(), units_)) + restart;
}

template <class S>
double Recorder<S>::wall_seconds() const {
  return wall_seconds_before_ + std::chrono::duration<double>(Clock::now() - start_).count();
}

template <class S>
std::string Recorder<S>::path(const char* name) const {
  return (std::filesystem::path(folder_) / name).string();
}

template class Recorder<double>;
template class Recorder<float>;

}  // namespace pinball
