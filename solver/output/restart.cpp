#include <filesystem>

#include <solver/base/error.hpp>
#include <solver/restart.hpp>

#include "recorder.hpp"

namespace pinball {

namespace {

SceneSource source_of(const Checkpoint& checkpoint, const std::vector<std::string>& set) {
  SceneSource source = checkpoint.head.source;
  change_scene(source, set);
  check_mesh_files(checkpoint.head);
  return source;
}

}  // namespace

void save_checkpoint(const std::string& path, Simulation& simulation, const SceneSource& source) {
  if (simulation.complete())
    throw InputError("checkpoint: expected a run that is not complete: nothing is left to go on with");
  CheckpointHead head = checkpoint_head(source, simulation);
  head.fingerprint = simulation.fingerprint();
  RunRecord record;  // of no files
  record.wall_seconds = simulation.summary().wall_seconds;
  StateBytes state;
  StateArchive::save(state, [&](StateArchive& archive) {
    record.persist(archive);
    simulation.persist(archive);
  });
  write_checkpoint(path, head, state);
}

SceneSource scene_of_checkpoint(const std::string& path, const std::vector<std::string>& set) {
  return source_of(read_checkpoint(path), set);
}

void load_checkpoint(const std::string& path, Simulation& simulation) { take_state(read_checkpoint(path), simulation); }

std::string folder_of_checkpoint(const std::string& path) {
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  return folder.empty() ? "." : folder.string();
}

RunSummary restart_recorded(const std::string& path, const std::vector<std::string>& set,
                            const RecordOptions& options) {
  const Checkpoint checkpoint = read_checkpoint(path);
  const SceneSource source = source_of(checkpoint, set);
  RecordOptions from_here = options;
  from_here.source = &source;
  from_here.restart = &checkpoint;
  from_here.deck = checkpoint.head.deck;
  if (options.out.empty()) from_here.out = folder_of_checkpoint(path);
  Scene scene = read_scene(source);
  scene.device = options.device;
  return run_recorded(scene, from_here);
}

}  // namespace pinball
