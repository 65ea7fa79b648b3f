#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <solver/mesh/mesh_file.hpp>
#include <solver/mesh_settings.hpp>
#include <solver/scene.hpp>
#include <solver/scene/given/given_scene.hpp>

namespace pinball {

class DeckScene;

/// How a deck is to be understood.
struct DeckOptions {
  std::optional<std::int64_t> chosen_case;  ///< --case: of those of *CASE; none: what belongs to no case
  bool lenient = false;                     ///< --lenient: unknown output and control keywords are ignored, not refused
  /// How the scene names the deck, from which its meshes are read; empty: the file's own name, beside the scene.
  std::string name_in_scene;

  /// The file of the meshes as the scene names it. path: of the deck.
  std::string mesh_file(const std::string& path) const;
};

/// A deck of another program as a scene of this one.
struct TranslatedDeck {
  std::shared_ptr<GivenScene> given{};    ///< what it says as keys of a scene, each with its card
  std::vector<std::string> understood{};  ///< lines that say what was made of what, and where they differ
  std::vector<std::string> ignored{};     ///< keywords that cannot change the answer, with how many and where

  /// From which the scene is read. path: in the folder of the deck.
  SceneSource source(const std::string& path, const SceneOverrides& overrides = {}) const {
    return {path, "", overrides, given};
  }
};

/// With what its keywords give, and the mesh that was read with them; nothing is understood yet. mesh: by which the
/// mesh would be read, its file the deck as it was opened.
TranslatedDeck given_deck(DeckScene&& scene, bool contact_said, MeshFile&& file, FileMesh mesh);

}  // namespace pinball
