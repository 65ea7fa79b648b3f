#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <solver/base/state_archive.hpp>
#include <solver/recorded_run.hpp>
#include <solver/scene.hpp>
#include <solver/simulation.hpp>

/// A run between two steps as one file, from which it goes on with the same bits, with any number of threads.
///
/// The format is the project's own: a damaged HDF5 file can crash its library.
///
///     8 bytes   "PINBALL" and a line break
///     u64       version of the format
///     u64       bytes of the content
///     u64       StateHash of the content
///     content   CheckpointHead, then the state as Solver and what it has written list it (state_archive.hpp)
///
/// Numbers are as they lie in memory: a file belongs to machines of one byte order. The state is in the order of the
/// stores, which depends on the width of packs: programs built for others reject it.
namespace pinball {

/// What a state belongs to.
struct CheckpointHead {
  SceneSource source;                                             ///< its path absolute
  std::vector<std::pair<std::string, std::uint64_t>> mesh_files;  ///< path and hash of the bytes
  std::uint64_t fingerprint = 0;                                  ///< of the model as built, see Solver
  std::int32_t simd_width = 0;
  std::string version;  ///< of the program
  DeckNotes deck;

  void persist(StateArchive& archive);
};

/// A checkpoint that was read and found whole.
struct Checkpoint {
  std::string path;
  CheckpointHead head;
  StateBytes content;
  std::span<const std::byte> state;  ///< part of the content
};

/// Head for the states of a run, with the hashes of its mesh files as they were read.
CheckpointHead checkpoint_head(const SceneSource& source, const Simulation& simulation);

/// Writes `path` as a whole or leaves what is there. Throws RunError.
void write_checkpoint(const std::string& path, CheckpointHead head, const StateBytes& state);

/// Throws InputError for a file that is not there, damaged, cut off, of another kind, format or width of packs.
Checkpoint read_checkpoint(const std::string& path);

/// Throws InputError that names the file if a mesh file is not what it was.
void check_mesh_files(const CheckpointHead& head);

/// Adds changes of the command line. Throws InputError for keys that the state depends on: all but time.end,
/// time.steps, time.cfl, output.* but body_energies, and guard.*.
void change_scene(SceneSource& source, const std::vector<std::string>& set);

}  // namespace pinball
