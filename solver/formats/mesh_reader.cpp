#include "mesh_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include <solver/base/error.hpp>
#include <solver/formats/abaqus/mesh/abaqus_mesh.hpp>
#include <solver/formats/exodus/exodus_reader.hpp>
#include <solver/formats/gmsh/gmsh_reader.hpp>
#include <solver/formats/lsdyna/mesh/keyword_mesh.hpp>
#include <solver/formats/radioss/mesh/radioss_mesh.hpp>
#include <solver/formats/vtk/vtk_reader.hpp>
#include <solver/mesh/file/split_hexahedra.hpp>
#include <solver/mesh/file/split_ten_nodes.hpp>
#include <solver/mesh/file/split_twenty_nodes.hpp>
#include <solver/mesh/held_mesh.hpp>
#include <solver/mesh/number_index.hpp>

namespace pinball {

namespace {

MeshFile read_format(const FileMesh& settings, const std::vector<std::string>& parts) {
  switch (settings.format) {
    case MeshFormat::gmsh:
      return read_gmsh(settings.file, parts);
    case MeshFormat::keyword:
      return keyword_mesh(read_keyword_deck(settings.file, settings.chosen_case));
    case MeshFormat::exodus:
      return read_exodus(settings.file, parts);
    case MeshFormat::vtk:
      return read_vtk(settings.file, settings.array, parts);
    case MeshFormat::abaqus:
      return abaqus_mesh(read_abaqus_deck(settings.file)).file;
    case MeshFormat::radioss:
      return radioss_mesh(read_radioss_deck(settings.file));
  }
  return {};
}

/// Numbers may stand twice where what they number is the same.
void check_numbers(const MeshFile& file) {
  const auto fail = [&](const char* what, std::int64_t id) {
    throw InputError(fmt::format("{}: {} {} is given twice, and not the same", file.path, what, id));
  };
  const NumberIndex nodes(file.node_ids);
  for (std::size_t n = 0; nodes.repeated() >= 0 && n < file.node_ids.size(); ++n) {
    if (file.mesh.nodes[nodes.find(file.node_ids[n])] != file.mesh.nodes[n]) fail("node", file.node_ids[n]);
  }
  const NumberIndex elements(file.element_ids);
  for (std::size_t e = 0; elements.repeated() >= 0 && e < file.element_ids.size(); ++e) {
    if (file.mesh.hexahedra[elements.find(file.element_ids[e])] != file.mesh.hexahedra[e])
      fail("element", file.element_ids[e]);
  }
}

}  // namespace

MeshFile read_mesh_file(const FileMesh& settings, const std::vector<std::string>& parts) {
  std::vector<std::string> wanted = parts;
  if (std::ranges::count(wanted, "") > 0) wanted.clear();
  std::optional<MeshFile> held = settings.held ? settings.held->take(settings) : std::nullopt;
  MeshFile file = held ? std::move(*held) : read_format(settings, wanted);
  // Readers of decks have looked at their numbers, and have split their elements, which have them together now.
  if (!is_of_decks(settings.format)) check_numbers(file);
  split_ten_nodes(file);
  split_twenty_nodes(file);
  for (Point& node : file.mesh.nodes) {
    for (double& coordinate : node) coordinate *= settings.scale;
  }
  for (int i = 0; i < settings.splits; ++i) split_hexahedra(file);
  return file;
}

}  // namespace pinball
