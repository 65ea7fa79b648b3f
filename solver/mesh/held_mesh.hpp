#pragma once

#include <optional>
#include <utility>

#include <solver/mesh_settings.hpp>

#include "mesh_file.hpp"

namespace pinball {

/// A mesh that was read with the deck that it stands in. The model that is built first takes it, so that nothing is
/// kept twice, and no file read; what is built after that reads the file again.
class HeldMesh {
 public:
  /// settings: of the deck, by which the file would be read.
  HeldMesh(MeshFile file, FileMesh settings) : file_(std::move(file)), settings_(std::move(settings)) {}

  /// None: it is another file, or was taken already.
  std::optional<MeshFile> take(const FileMesh& wanted) {
    const bool same = wanted.file == settings_.file && wanted.format == settings_.format &&
                      wanted.chosen_case == settings_.chosen_case;
    return same ? std::exchange(file_, std::nullopt) : std::nullopt;
  }

 private:
  std::optional<MeshFile> file_;
  FileMesh settings_;
};

}  // namespace pinball
