#include "translated_deck.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <utility>

#include <solver/mesh/held_mesh.hpp>

#include "deck_scene.hpp"

namespace pinball {

std::string DeckOptions::mesh_file(const std::string& path) const {
  return name_in_scene.empty() ? std::filesystem::path(path).filename().string() : name_in_scene;
}

TranslatedDeck given_deck(DeckScene&& scene, bool contact_said, MeshFile&& file, FileMesh mesh) {
  const std::filesystem::path path(mesh.file);
  const std::string name = path.filename().string();
  mesh.file = (path.parent_path() / name).string();  // as the scene has it, also where it was opened as FOLDER//deck.k
  auto given = std::make_shared<GivenScene>();
  given->table = scene.take(fmt::format("{} as this program understands it.", name));
  given->contact_said = contact_said;
  given->mesh = std::make_shared<HeldMesh>(std::move(file), std::move(mesh));
  return {std::move(given)};
}

}  // namespace pinball
