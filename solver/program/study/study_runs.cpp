#include "study_runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <sstream>
#include <tuple>

#include <solver/base/error.hpp>
#include <solver/base/state_hash.hpp>
#include <solver/base/version.h>
#include <solver/formats/mesh_reader.hpp>
#include <solver/output/message.hpp>
#include <solver/output/run_files.hpp>
#include <solver/output/run_folder.hpp>
#include <solver/program/result_file.hpp>
#include <solver/program/stop_signals.hpp>
#include <solver/program/text_table.hpp>
#include <solver/recorded_run.hpp>
#include <solver/scene/schema/choices.hpp>
#include <solver/scene/toml/listing.hpp>
#include <solver/scene_rules.hpp>

#include "numbered_sets.hpp"

namespace pinball {

namespace {

/// Of all files that meshes are read from; bodies of one file have it read once.
class MeshHashes {
 public:
  std::uint64_t of(FileMesh mesh) {
    const auto [found, is_new] = known_.try_emplace({mesh.format, mesh.file, mesh.chosen_case});
    if (!is_new) return found->second;
    mesh.held.reset();  // what was read with a deck is for the model
    mesh.splits = 0;
    StateHash hash;
    for (const MeshSource& source : read_mesh_file(mesh, {""}).sources) hash.add(&source.hash, sizeof(source.hash));
    return found->second = hash.value();
  }

 private:
  std::map<std::tuple<MeshFormat, std::string, std::optional<std::int64_t>>, std::uint64_t> known_;
};

std::string text_of_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// Of a run with these settings that came to its end.
std::optional<RunResults> results_there(const std::string& folder, const std::string& settings) {
  if (text_of_file(in_folder(folder, study_settings_name)) != settings) return std::nullopt;
  try {
    RunResults results = read_run_results(folder);
    if (results.status == "done") return results;
  } catch (const RunError&) {  // lost or damaged: it is made again
  }
  return std::nullopt;
}

/// Why a run does not fit into the time of the study; empty: it does.
std::string too_long(const StudyBudget* budget, std::optional<double> expected) {
  if (budget == nullptr) return "";
  const double left = std::max(0.0, budget->left());
  if (left > expected.value_or(0)) return "";
  return fmt::format("it is expected to take {}, {} of the budget are left",
                     expected ? duration_cell(*expected) : "a while", duration_cell(left));
}

std::vector<double> times_of_states(int states, double end) {
  std::vector<double> times;
  for (int k = 1; k < states; ++k) times.push_back(end * (k - 1) / (states - 1));
  if (states > 0) times.push_back(end);
  return times;
}

}  // namespace

std::string study_settings_text(const Scene& scene) {
  std::string text = fmt::format("version = {}\ndevice = {}\n", PINBALL_VERSION, schema::name_of(scene.device));
  Scene completed = scene;
  completed.output.field_interval = 0;
  completed.output.field_times.clear();
  complete_scene(completed);
  for (const SceneEntry& entry : list_scene(completed)) {
    text += fmt::format("{}{}{} = {}\n", entry.table, entry.table.empty() ? "" : ".", entry.key, entry.value);
  }
  MeshHashes hashes;
  for (const Body& body : scene.bodies) {
    const auto* mesh = std::get_if<FileMesh>(&body.mesh);
    if (mesh == nullptr) continue;
    text += fmt::format("body.{}.mesh: split {} times, file {:016x}\n", body.name, mesh->splits, hashes.of(*mesh));
  }
  return text;
}

RunResults study_results_to_come(const Scene& scene, const StudyFolder& folder) {
  Scene run_scene = scene;
  carry_numbers(run_scene);
  return results_to_come(Simulation(run_scene, {folder.threads}));
}

StudyRun make_study_run(const Scene& scene, const std::string& name, const std::string& what, const StudyFolder& folder,
                        std::optional<double> expected) {
  Scene run_scene = scene;
  run_scene.output.field_interval = 0;
  run_scene.output.field_times.clear();
  const std::string settings = study_settings_text(run_scene);
  StudyRun run;
  run.folder = in_folder(folder.out, name);
  run.results = results_there(run.folder, settings);
  run.was_there = run.results.has_value();
  if (!run.was_there) run.left_out = too_long(folder.budget, expected);
  const char* fate = run.was_there ? "is there" : run.left_out.empty() ? "runs" : "left out";
  if (!folder.quiet) print_message(fmt::format("{}: {}", fate, what));
  if (run.was_there || !run.left_out.empty()) return run;

  carry_numbers(run_scene);
  run_scene.output.field_times = times_of_states(folder.states, run_scene.time.end);
  RecordOptions options;
  options.out = run.folder;
  options.quiet = folder.quiet;
  options.silent = true;
  options.threads = folder.threads;
  options.stop = [] { return stop_signal() != 0; };
  try {
    run.stopped = run_recorded(run_scene, options).status == RunStatus::stopped;
  } catch (const RunError& error) {
    run.failure = error.what();
  } catch (const NoFileError& error) {  // in the way of this run alone
    run.failure = error.what();
  }
  if (run.stopped || !run.failure.empty()) return run;
  write_result_file(in_folder(run.folder, study_settings_name), settings);
  run.results = read_run_results(run.folder);
  return run;
}

}  // namespace pinball
