#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "table.hpp"

namespace pinball {

std::vector<Point> SceneTable::directions(std::string_view key, const std::array<const char*, 3>& names) const {
  std::vector<Point> axes{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const std::string expected = fmt::format(
      "\"all\" or an array of directions, each \"{}\", \"{}\", \"{}\" or 3 numbers", names[0], names[1], names[2]);
  const GivenValue* node = find(key);
  if (!node) fail_missing(key, expected);
  if (is_text(key) && text(key) == "all") return axes;
  const auto& array = array_of(*node, key_path(key), expected, std::nullopt);
  if (array.empty()) fail(key, fmt::format("expected {}, got none", expected));
  std::vector<Point> result;
  for (std::size_t i = 0; i < array.size(); ++i) {
    const GivenValue& element = array[i];
    if (const auto* name = element.as<std::string>()) {
      const auto found = std::find(names.begin(), names.end(), *name);
      if (found == names.end()) {
        pinball::fail(element.place.text(where_), key_path(key),
                      fmt::format("expected {}, got \"{}\"", expected, *name));
      }
      result.push_back(axes[found - names.begin()]);
      continue;
    }
    Point d = point_of(element, fmt::format("{}[{}]", key_path(key), i), any_number);
    if (const auto problem = direction_problem(key, d)) {
      pinball::fail(element.place.text(where_), key_path(key), problem->text);
    }
    const double length = std::hypot(d[0], d[1], d[2]);
    for (double& c : d) c /= length;
    result.push_back(d);
  }
  return result;
}

std::vector<std::array<std::int64_t, 4>> SceneTable::faces(std::string_view key) const {
  std::vector<std::array<std::int64_t, 4>> faces;
  const GivenValue* node = find(key);
  if (!node) return faces;
  const auto& array = array_of(*node, key_path(key), "an array of faces, each of 4 integers", std::nullopt);
  for (std::size_t i = 0; i < array.size(); ++i) {
    const std::string path = fmt::format("{}[{}]", key_path(key), i);
    const auto& corners = array_of(array[i], path, "an array of 4 integers", 4);
    auto& face = faces.emplace_back();
    for (std::size_t c = 0; c < 4; ++c) face[c] = integer_of(corners[c], fmt::format("{}[{}]", path, c), 0);
  }
  return faces;
}

}  // namespace pinball
