#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include <solver/mesh/mesh_file.hpp>

/// What becomes of a deck, to be compared.
namespace pinball::test {

/// All of a mesh: nodes, elements, parts, sets.
inline std::string text_of(const MeshFile& file) {
  std::string text;
  for (std::size_t n = 0; n < file.node_ids.size(); ++n)
    text += fmt::format("{} {}\n", file.node_ids[n], fmt::join(file.mesh.nodes[n], " "));
  for (std::size_t e = 0; e < file.element_ids.size(); ++e)
    text += fmt::format("{} {} {}\n", file.element_ids[e], file.part[e], fmt::join(file.mesh.hexahedra[e], " "));
  for (const MeshPart& part : file.parts) text += fmt::format("{} {}\n", part.id, part.name);
  for (const auto* sets : {&file.node_sets, &file.element_sets}) {
    for (const MeshSet& set : *sets)
      text += fmt::format("{}: {} {}\n", set.id, fmt::join(set.members, " "), set.problem);
  }
  for (const FaceSet& set : file.face_sets) {
    text += fmt::format("{} {}: {}\n", set.id, set.name, set.problem);
    for (const auto& face : set.faces) text += fmt::format("{}\n", fmt::join(face, " "));
  }
  return text;
}

/// What stands between commas, at least so many fields.
inline std::vector<std::string> cut(const std::string& line, std::size_t count) {
  std::vector<std::string> fields;
  std::stringstream stream(line);
  for (std::string field; std::getline(stream, field, ',');) fields.push_back(field);
  fields.resize(std::max(count, fields.size()));
  return fields;
}

}  // namespace pinball::test
