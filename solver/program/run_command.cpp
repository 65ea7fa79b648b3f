#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>

#include <solver/base/counted.hpp>
#include <solver/base/error.hpp>
#include <solver/device/devices.hpp>
#include <solver/output/message.hpp>
#include <solver/output/run_files.hpp>
#include <solver/recorded_run.hpp>
#include <solver/restart.hpp>
#include <solver/results/warnings.hpp>

#include "commands.hpp"
#include "scene_input.hpp"
#include "stop_signals.hpp"
#include "study/bands/kept_bands.hpp"

namespace pinball {

namespace {

void print_result(const RunSummary& s, const std::string& out) {
  const Energies& e = s.energy;
  fmt::print("{}: {}, {} to t = {:.6g} in {:.3g} s ({:.3g} million element steps per second, {})\n", s.scene,
             counted(s.elements, "element"), counted(s.steps, "step"), s.end_time, s.wall_seconds,
             static_cast<double>(s.elements) * static_cast<double>(s.steps) / s.wall_seconds * 1e-6,
             counted(s.threads, "thread"));
  fmt::print(
      "  energy: kinetic {:.4g}, internal {:.4g}, hourglass {:.3g}, bulk viscosity {:.3g}, contact {:.3g}, "
      "eroded {:.3g}; largest balance error {:.3g} %\n",
      e.kinetic, e.internal, e.hourglass, e.bulk_viscosity, e.contact(), e.eroded, 100 * s.balance_error_max);
  if (e.external != 0) fmt::print("  work done from outside: {:.4g}\n", e.external);
  for (const WallResult& w : s.walls) {
    fmt::print("  rigid wall {}: impulse {:.6g}, largest force {:.4g}\n", w.name, w.impulse, w.force_max);
  }
  for (const BodyResult& b : s.bodies) {
    fmt::print(
        "  {}: mass {:.4g} of {:.4g}, {} eroded, velocity ({:.6g}, {:.6g}, {:.6g}), largest "
        "plastic strain {:.3g}\n",
        b.name, b.mass_remaining, b.mass_initial, counted_of(b.eroded_elements, b.elements, "element"), b.velocity[0],
        b.velocity[1], b.velocity[2], b.max_plastic_strain);
  }
  fmt::print("  state {:016x}; results in {}\n", s.state_hash, out);
}

/// All of them, also those of the start, which progress has moved far away by now; where there was none, these once.
void print_warnings(const RunSummary& summary, bool quiet) {
  const std::vector<std::string> reported = quiet ? start_warnings(summary) : std::vector<std::string>();
  for (const std::string& warning : warnings(summary)) {
    if (std::ranges::find(reported, warning) == reported.end()) print_message("warning: " + warning);
  }
}

/// Tells what has become of a run. Returns the exit status.
int print_end(const RunSummary& summary, const RecordOptions& options) {
  print_result(summary, options.out);
  if (!options.converged.empty()) fmt::print("{}", kept_bands_text(options.converged));
  print_warnings(summary, options.quiet);
  if (summary.status != RunStatus::stopped) return 0;
  print_message(fmt::format("stopped in step {}; this goes on: pinball run --restart {}", summary.steps,
                            in_folder(options.out, checkpoint_name)));
  return 128 + stop_signal();
}

bool stop_is_asked() { return stop_signal() != 0; }

RecordOptions record_options(const RunOptions& options, const std::string& out) {
  RecordOptions record;
  record.out = out;
  record.quiet = options.quiet;
  record.checkpoint_every = options.checkpoint_every;
  record.stop = stop_is_asked;
  record.threads = options.threads;
  record.ranks = options.ranks;
  record.pieces = options.pieces;
  // Ranks of one machine would each take all its cores.
  if (record.ranks != nullptr && record.threads == 0 && std::getenv("OMP_NUM_THREADS") == nullptr) record.threads = 1;
  return record;
}

/// Goes on with the scene of the checkpoint, which is read from there.
int restart_command(const RunOptions& options) {
  if (!options.scene.empty()) {
    throw InputError(fmt::format("run {}: with --restart expected no SCENE, it is in the checkpoint", options.scene));
  }
  if (options.overrides.refine != 1 || options.overrides.precision) {
    throw InputError("--restart: expected neither --refine nor --precision, they are in the checkpoint");
  }
  const std::string out = options.out.empty() ? folder_of_checkpoint(options.restart) : options.out;
  RecordOptions record = record_options(options, out);
  record.device = options.device;
  return print_end(restart_recorded(options.restart, options.overrides.set, record), record);
}

}  // namespace

void tell_ranks(Ranks& ranks, int status, const std::string& error) { agree(ranks, {status, error}); }

int run_command(const RunOptions& options) {
  require_device(options.device);
  if (!options.restart.empty()) return restart_command(options);
  if (options.scene.empty()) throw InputError("run: expected a SCENE, or --restart FILE");
  const SceneInput input = scene_input(options);
  Scene scene = input.read();
  scene.device = options.device;
  RecordOptions record = record_options(options, options.out.empty() ? "out/" + scene.name : options.out);
  record.source = &input.source;
  record.deck = input.notes;
  std::string note;
  record.converged = kept_bands_of(path_of_scene(options.scene), scene, note);
  if (!note.empty() && !options.quiet) print_message(note);
  return print_end(run_recorded(scene, record), record);
}

}  // namespace pinball
