#include "names.hpp"

#include <fmt/format.h>

#include <solver/base/text_distance.hpp>

namespace pinball {

namespace {

/// Of a place FILE:LINE:COLUMN.
std::string line_of(const std::string& place) {
  const std::size_t column = place.rfind(':');
  if (column == std::string::npos || column == 0) return {};
  const std::size_t line = place.rfind(':', column - 1) + 1;  // npos + 1 is 0
  return place.substr(line, column - line);
}

}  // namespace

std::optional<Problem> Names::add(const std::string& name, const std::string& place) {
  if (const auto [known, is_new] = known_.emplace(name, place); !is_new) {
    const std::string line = line_of(known->second);
    return Problem{"name", fmt::format("expected a name of its own, got \"{}\" a second time{}", name,
                                       line.empty() ? "" : "; the first is in line " + line)};
  }
  in_order_.push_back(name);
  return {};
}

std::optional<Problem> Names::reference_problem(std::string_view key, std::string_view kind,
                                                const std::string& name) const {
  if (has(name)) return {};
  const std::string hint = in_order_.empty() ? fmt::format("the scene has no [[{}]]", kind)
                                             : fmt::format("nearest is \"{}\"", nearest(name, in_order_));
  return Problem{std::string(key), fmt::format("no {} is named \"{}\", {}", kind, name, hint)};
}

std::optional<Problem> column_problem(const std::string& pair, const Names& bodies) {
  constexpr std::string_view ending = "_contact";
  if (!pair.ends_with(ending) || !bodies.has(pair.substr(0, pair.size() - ending.size()))) return {};
  return Problem{"name",
                 fmt::format("\"{}\" would give its columns of history.csv the names of those of a body", pair)};
}

std::optional<Problem> force_name_problem(const std::string& name, const Scene& scene) {
  if (name.empty()) return {};
  if (auto problem = name_problem(name)) return problem;
  const bool taken = Names(scene.pressures).has(name) || Names(scene.contact_pairs).has(name);
  if (!taken) return column_problem(name, Names(scene.bodies));
  return Problem{"name", fmt::format("expected a name that no pressure and no contact pair has, got \"{}\"", name)};
}

}  // namespace pinball
