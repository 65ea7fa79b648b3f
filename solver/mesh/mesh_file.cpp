#include "mesh_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include <solver/base/error.hpp>
#include <solver/base/text_distance.hpp>

#include "gmsh_reader.hpp"
#include "keyword_mesh.hpp"

namespace pinball {

namespace {

/// The one of this name, or else of this number; null: none. Of several the last one counts, as in a deck.
template <class Named>
const Named* find_named(const std::vector<Named>& items, const std::string& name) {
  const Named* found = nullptr;
  for (const Named& item : items) {
    if (item.name == name) found = &item;
  }
  if (found != nullptr) return found;
  for (const Named& item : items) {
    if (item.id != 0 && std::to_string(item.id) == name) found = &item;
  }
  return found;
}

template <class Named>
void add_names(const std::vector<Named>& items, std::vector<std::string>& names) {
  for (const Named& item : items) {
    if (!item.name.empty()) names.push_back(item.name);
    if (item.id != 0) names.push_back(std::to_string(item.id));
  }
}

[[noreturn]] void fail_unknown(const MeshFile& file, const char* what, const std::string& name,
                               const std::vector<std::string>& known) {
  throw InputError(fmt::format(
      "{}: no {} is named or numbered \"{}\": {}", file.path, what, name,
      known.empty() ? std::string("there are none") : fmt::format("nearest is \"{}\"", nearest(name, known))));
}

}  // namespace

MeshFile read_mesh_file(const FileMesh& settings, const std::vector<std::string>& parts) {
  std::vector<std::string> wanted = parts;
  if (std::ranges::count(wanted, "") > 0) wanted.clear();
  MeshFile file = settings.format == MeshFormat::gmsh ? read_gmsh(settings.file, wanted)
                                                      : keyword_mesh(read_keyword_deck(settings.file));
  for (Point& node : file.mesh.nodes) {
    for (double& coordinate : node) coordinate *= settings.scale;
  }
  return file;
}

std::vector<std::int32_t> elements_of_part(const MeshFile& file, const std::string& part) {
  std::vector<std::int32_t> elements;
  if (part.empty()) {
    elements.resize(file.mesh.hexahedra.size());
    std::iota(elements.begin(), elements.end(), 0);
    return elements;
  }
  if (const MeshPart* found = find_named(file.parts, part)) {
    const auto place = static_cast<std::int32_t>(found - file.parts.data());
    for (std::size_t e = 0; e < file.part.size(); ++e) {
      if (file.part[e] == place) elements.push_back(static_cast<std::int32_t>(e));
    }
    return elements;
  }
  if (const MeshSet* found = find_named(file.element_sets, part)) {
    if (!found->problem.empty()) throw InputError(found->problem);
    return found->members;
  }
  std::vector<std::string> known;
  add_names(file.parts, known);
  add_names(file.element_sets, known);
  fail_unknown(file, "part or set of elements", part, known);
}

const MeshSet* find_set(const std::vector<MeshSet>& sets, const std::string& name) { return find_named(sets, name); }

std::vector<std::string> set_names(const std::vector<MeshSet>& sets) {
  std::vector<std::string> names;
  add_names(sets, names);
  return names;
}

std::vector<std::string> files_of(const FileMesh& settings) {
  if (settings.format == MeshFormat::gmsh) return {settings.file};
  return read_keyword_deck(settings.file).files;
}

}  // namespace pinball
