#include "checkpoint.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>

#include <solver/base/error.hpp>
#include <solver/base/state_hash.hpp>
#include <solver/base/version.h>
#include <solver/mesh/file/input_file.hpp>
#include <solver/mesh/mesh_file.hpp>
#include <solver/model/stores.hpp>
#include <solver/scene/given/given_archive.hpp>
#include <solver/scene/toml/overrides.hpp>

#include "output_file.hpp"

namespace pinball {

namespace {

constexpr std::array<char, 8> magic{'P', 'I', 'N', 'B', 'A', 'L', 'L', '\n'};
constexpr std::uint64_t format_version = 21;  ///< to be raised with every change of what is persistent

struct FileHeader {
  std::array<char, 8> magic{};
  std::uint64_t version = 0, bytes = 0, hash = 0;
};

std::int32_t simd_width(Precision precision) { return ElementStore::width_in(has_single_elements(precision)); }

/// The content of a file whose header, size and hash are right.
StateBytes read_content(const std::string& path) {
  require_file(path);
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  if (!file) throw InputError(path + ": no such file, or it cannot be read");
  const auto size = static_cast<std::uint64_t>(file.tellg());
  FileHeader header;
  file.seekg(0);
  file.read(reinterpret_cast<char*>(&header), sizeof header);
  if (!file || header.magic != magic) throw InputError(path + ": expected a checkpoint of pinball");
  if (header.version != format_version) {
    throw InputError(
        fmt::format("{}: expected format {} of checkpoints, got {}", path, format_version, header.version));
  }
  if (header.bytes != size - sizeof header) {
    throw InputError(fmt::format("{}: damaged: expected {} bytes, got {}", path, header.bytes, size - sizeof header));
  }
  StateBytes content(header.bytes);
  file.read(reinterpret_cast<char*>(content.data()), content.size());
  StateHash hash;
  hash.add(content.data(), content.size());
  if (!file || hash.value() != header.hash) throw InputError(path + ": damaged: its checksum is wrong");
  return content;
}

}  // namespace

void CheckpointHead::persist(StateArchive& archive) {
  std::int32_t precision = source.overrides.precision ? static_cast<std::int32_t>(*source.overrides.precision) : -1;
  archive(source.path, source.text, source.overrides.set, source.overrides.refine, precision, source.overrides.vary,
          mesh_files, fingerprint, simd_width, version, deck.lines);
  pinball::persist(archive, source.given);
  source.overrides.precision.reset();
  if (precision >= 0) source.overrides.precision = static_cast<Precision>(precision);
}

CheckpointHead checkpoint_head(const SceneSource& source, const Simulation& simulation) {
  CheckpointHead head;
  head.source = source;
  head.source.path = std::filesystem::absolute(source.path).string();
  head.simd_width = simd_width(simulation.scene().precision);
  head.version = PINBALL_VERSION;
  for (const MeshSource& file : simulation.mesh_sources()) {  // bodies may have one file
    std::string path = std::filesystem::absolute(file.path).string();
    const auto same = [&path](const auto& known) { return known.first == path; };
    if (std::ranges::none_of(head.mesh_files, same)) head.mesh_files.emplace_back(path, file.hash);
  }
  return head;
}

void write_checkpoint(const std::string& path, CheckpointHead head, const StateBytes& state) {
  StateBytes bytes_of_head;
  StateArchive::save(bytes_of_head, [&head](StateArchive& archive) { head.persist(archive); });
  StateHash hash;
  hash.add(bytes_of_head.data(), bytes_of_head.size());
  hash.add(state.data(), state.size());
  const FileHeader header{magic, format_version, bytes_of_head.size() + state.size(), hash.value()};
  OutputFile file(path);
  file.write(&header, sizeof header);
  file.write(bytes_of_head.data(), bytes_of_head.size());
  file.write(state.data(), state.size());
  file.commit_durably();
}

Checkpoint read_checkpoint(const std::string& path) {
  Checkpoint checkpoint;
  checkpoint.path = path;
  checkpoint.content = read_content(path);
  StateArchive archive = StateArchive::reading({checkpoint.content.data(), checkpoint.content.size()});
  try {
    checkpoint.head.persist(archive);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", path, error.what()));
  }
  checkpoint.state = archive.rest();
  return checkpoint;
}

void check_mesh_files(const CheckpointHead& head) {
  for (const auto& [path, hash] : head.mesh_files) {
    if (hash_of_file(path) != hash) throw InputError(path + ": is not what it was when the checkpoint was written");
  }
}

void change_scene(SceneSource& source, const std::vector<std::string>& set) {
  for (const std::string& change : set) {
    const std::string key = parse_override("--set", change).key;
    const bool free = key == "time.end" || key == "time.steps" || key == "time.cfl" || key.starts_with("guard.") ||
                      (key.starts_with("output.") && key != "output.body_energies");
    if (!free) {
      throw InputError(fmt::format(
          "--set {}: with --restart expected time.end, time.steps, time.cfl, output.* but body_energies, or "
          "guard.*: the state depends on the other keys",
          change));
    }
    source.overrides.set.push_back(change);
  }
}

}  // namespace pinball
