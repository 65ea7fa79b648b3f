#include "place_names.hpp"

#include <fmt/core.h>

#include <algorithm>

namespace pinball {

namespace {

using Numbers = std::vector<std::pair<std::int64_t, std::int32_t>>;

/// Looked up place by place: messages name few.
std::string name_of(const ModelMesh& mesh, const char* kind, std::int64_t place, std::int32_t body,
                    Numbers FileNodes::*numbers) {
  std::int64_t number = place;
  if (const std::int32_t file = mesh.file_of_body.empty() ? -1 : mesh.file_of_body[body]; file >= 0) {
    const Numbers& known = mesh.files[file].*numbers;
    const auto found = std::ranges::find(known, place, &Numbers::value_type::second);
    if (found != known.end()) number = found->first;
  }
  return fmt::format("{} {} of body {}", kind, number, mesh.body_names[body]);
}

}  // namespace

std::string element_name(const ModelMesh& mesh, std::int64_t element) {
  return name_of(mesh, "element", element, mesh.body[element], &FileNodes::element_numbers);
}

std::string node_name(const ModelMesh& mesh, std::int64_t node) {
  return name_of(mesh, "node", node, mesh.body_of_node[node], &FileNodes::numbers);
}

}  // namespace pinball
