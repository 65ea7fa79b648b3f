#include "recorder.hpp"

#include <fmt/format.h>

#include <cmath>

#include <solver/base/error.hpp>
#include <solver/scene_rules.hpp>

#include "message.hpp"
#include "rank_pieces.hpp"
#include "run_files.hpp"

namespace pinball {

namespace {

/// A copy of the state is made as often as takes this share of the time.
constexpr double share_of_copies = 0.005;
/// ... while the error of the energy balance is below this share of its bound: beyond it the trouble may have begun.
constexpr double share_of_energy_error = 0.2;

double history_interval(const Scene& scene) {
  return scene.output.interval > 0 ? scene.output.interval : scene.time.end / 200;
}

/// What a restart asks for has to lie ahead.
void check_limits(const Simulation& simulation) {
  const TimeSettings& limits = simulation.scene().time;
  if (limits.end < simulation.time() * (1 - 1e-12)) {
    throw InputError(fmt::format("time.end: expected at least {:.9g}, the time of the checkpoint, got {:.9g}",
                                 simulation.time(), limits.end));
  }
  if (limits.steps >= 0 && limits.steps < simulation.steps()) {
    throw InputError(fmt::format("time.steps: expected at least {}, the step of the checkpoint, got {}",
                                 simulation.steps(), limits.steps));
  }
}

}  // namespace

Recorder::Recorder(Simulation& simulation, const RecordOptions& options, bool continues)
    : folder_(options.out),
      history_times_(history_interval(simulation.scene()), {}),
      every_step_(simulation.scene().output.every_step),
      field_times_(simulation.scene().output.field_interval, simulation.scene().output.field_times),
      units_(simulation.scene().units),
      in_pieces_(options.pieces && options.ranks != nullptr),
      checkpoint_every_(options.checkpoint_every) {
  if (options.source != nullptr) {
    head_ = checkpoint_head(*options.source, simulation);
    head_->deck = options.deck;
  } else if (checkpoint_every_ > 0) {
    throw InputError("a checkpoint needs the source of the scene");
  }
  std::optional<RunRecord> kept;
  if (options.restart != nullptr) {
    kept = restart(*options.restart, simulation);
    if (!continues) kept.reset();  // its files are elsewhere
  }
  if (folder_.empty()) return;
  open_files(simulation, kept);
  if (fields_ && !fields_->lost().empty() && !options.silent) {
    print_message(fmt::format("warning: {} of the run so far, {} of {}, {} not in {}: fields.pvd goes on without {}",
                              fields_->lost().front(), fields_->lost().size(), kept->fields.size(),
                              fields_->lost().size() == 1 ? "is" : "are", folder_,
                              fields_->lost().size() == 1 ? "it" : "them"));
  }
  if (simulation.steps() > 0) {
    history_times_.passed(simulation.state_time());
    field_times_.passed(simulation.state_time());
  }
  keep_state(simulation);
  start_ = Clock::now();
}

RunRecord take_state(const Checkpoint& checkpoint, Simulation& simulation) {
  const auto fail = [&checkpoint](const std::string& reason) {
    throw InputError(fmt::format("{}: {}", checkpoint.path, reason));
  };
  const CheckpointHead& head = checkpoint.head;
  if (head.simd_width != simulation.simd_width()) {
    fail(fmt::format("written by pinball {} with packs of {}, this one has packs of {}", head.version, head.simd_width,
                     simulation.simd_width()));
  }
  if (head.fingerprint != simulation.fingerprint()) fail("this program makes another mesh of the scene");
  RunRecord record;
  StateArchive archive = StateArchive::reading(checkpoint.state);
  try {
    record.persist(archive);
    simulation.persist(archive);
    if (archive.left() > 0) StateArchive::throw_foreign();
  } catch (const InputError& error) {
    fail(error.what());
  }
  check_limits(simulation);
  return record;
}

RunRecord Recorder::restart(const Checkpoint& checkpoint, Simulation& simulation) {
  RunRecord record = take_state(checkpoint, simulation);
  wall_seconds_before_ = record.wall_seconds;
  return record;
}

void Recorder::open_files(const Simulation& simulation, const std::optional<RunRecord>& kept) {
  std::optional<HistoryPart> rows;
  if (kept) rows = kept->history;
  history_ =
      std::make_unique<HistoryWriter>(folder_, names_of(simulation.scene().bodies), simulation.history_columns(), rows);
  const OutputSettings& output = simulation.scene().output;
  if (output.field_interval > 0 || !output.field_times.empty()) {
    fields_ = std::make_unique<FieldWriter>(folder_, "fields", output.fields, units_,
                                            kept ? kept->fields : FieldWriter::Written{},
                                            names_of(simulation.scene().bodies), simulation.field_base());
  }
}

void Recorder::record(Simulation& simulation, bool last) {
  if (!history_) return;
  const double time = simulation.state_time();
  const bool fields_due = fields_ && field_times_.due(time);
  if (last || every_step_ || history_times_.due(time)) {
    history_->write(simulation.history_row());
    last_row_ = time;
    history_times_.passed(time);
    if (!last && !fields_due) keep_state(simulation);
  }
  if (!fields_due) return;
  last_good_ = {};  // never two copies: this one is as large as the arrays of the step
  write_fields(simulation);
  field_times_.passed(time);
  if (!last) save(simulation);
}

void Recorder::write_fields(Simulation& simulation) {
  if (in_pieces_) {
    write_pieces(simulation, *fields_);
  } else {
    fields_->write(simulation.snapshot());
  }
}

void Recorder::save(Simulation& simulation) {
  RunRecord record{wall_seconds(), history_->written(), fields_ ? fields_->written() : FieldWriter::Written{}};
  StateArchive::save(last_good_, [&](StateArchive& archive) {
    record.persist(archive);
    simulation.persist(archive);
  });
}

void Recorder::keep_state(Simulation& simulation) {
  const auto start = Clock::now();
  const double most = share_of_energy_error * simulation.scene().guard.energy_error;
  if (start < next_copy_ || std::abs(simulation.balance_error_in_motion()) > most) return;
  save(simulation);
  const auto end = Clock::now();
  next_copy_ = end + std::chrono::duration_cast<Clock::duration>((end - start) / share_of_copies);
}

void Recorder::checkpoint(Simulation& simulation, bool last) {
  if (checkpoint_every_ <= 0 || (++since_checkpoint_ < checkpoint_every_ && !last)) return;
  since_checkpoint_ = 0;
  write_state(simulation);
}

void Recorder::write_state(Simulation& simulation) {
  save(simulation);
  write_file(checkpoint_name, simulation);
}

/// The fingerprint goes through the whole model: it is made where there is a file to write.
void Recorder::write_file(const char* name, const Simulation& simulation) {
  if (head_->fingerprint == 0) head_->fingerprint = simulation.fingerprint();
  write_checkpoint(path(name), *head_, last_good_);
}

/// The checkpoint comes first: a restart cuts off the row and the fields that an unbroken run would not have here.
std::string Recorder::stop(Simulation& simulation) {
  if (!history_) return "";
  if (head_) write_state(simulation);
  const double time = simulation.state_time();
  if (last_row_ != time) history_->write(simulation.history_row());
  const bool has_fields = fields_ && !fields_->written().empty() && fields_->written().back().first == time;
  if (fields_ && !has_fields) write_fields(simulation);
  return head_ ? path(checkpoint_name) : "";
}

std::string Recorder::save_last_good(Simulation& simulation) {
  if (last_good_.empty()) return "";
  RunRecord record;
  StateArchive archive = StateArchive::reading({last_good_.data(), last_good_.size()});
  record.persist(archive);
  simulation.persist(archive);
  const auto sentence = [&simulation](const std::string& file) {
    return fmt::format("; the last good state, of step {}, is in {}", simulation.steps(), file);
  };
  std::string restart;
  if (head_) {
    write_file(last_good_name, simulation);
    restart = fmt::format(" and, for --restart, in {}", path(last_good_name));
  }
  last_good_ = {};
  return sentence(write_last_good_state(folder_, simulation.snapshot(), units_, names_of(simulation.scene().bodies),
                                        simulation.field_base())) +
         restart;
}

double Recorder::wall_seconds() const {
  return wall_seconds_before_ + std::chrono::duration<double>(Clock::now() - start_).count();
}

std::string Recorder::path(const char* name) const { return in_folder(folder_, name); }

}  // namespace pinball
