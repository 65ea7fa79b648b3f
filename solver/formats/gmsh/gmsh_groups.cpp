#include "gmsh_groups.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <optional>

#include <solver/base/error.hpp>
#include <solver/base/text_distance.hpp>

namespace pinball {

namespace {

std::optional<std::int64_t> as_number(const std::string& text) {
  std::int64_t value = 0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (problem != std::errc() || end != text.data() + text.size()) return {};
  return value;
}

}  // namespace

std::span<const std::int64_t> GmshGroups::of_entity(int dimension, std::int64_t entity) const {
  const auto found = of_entity_[dimension].find(entity);
  if (found == of_entity_[dimension].end()) return {};
  return found->second;
}

std::string GmshGroups::name_of(int dimension, std::int64_t group) const {
  const auto found = names_[dimension].find(group);
  return found == names_[dimension].end() ? "" : found->second;
}

std::vector<std::int64_t> GmshGroups::volumes(const std::vector<std::string>& wanted, bool is_4) const {
  std::vector<std::int64_t> groups;
  for (const std::string& name : wanted) groups.push_back(volume(name, is_4));
  return groups;
}

std::int64_t GmshGroups::volume(const std::string& wanted, bool is_4) const {
  require_one(wanted);
  for (const auto& [group, name] : names_[3]) {
    if (name != wanted) continue;
    if (is_4 && !has_entities_) {
      throw InputError(fmt::format("{}: expected a section $Entities, which says what \"{}\" is", path_, wanted));
    }
    return group;
  }
  // Which numbers there are without a name, the elements of format 2.2 show first.
  if (const auto number = as_number(wanted); number && (!is_4 || numbers_[3].contains(*number))) return *number;
  throw InputError(fmt::format("{}: no physical volume is named \"{}\": {}", path_, wanted, hint(wanted)));
}

void GmshGroups::require_one(const std::string& wanted) const {
  std::set<std::int64_t> groups;
  for (const auto& [group, name] : names_[3]) {
    if (name == wanted) groups.insert(group);
  }
  if (groups.size() > 1)
    throw InputError(fmt::format("{}: the physical volumes {} have the name \"{}\": ask for them by their numbers",
                                 path_, fmt::join(groups, ", "), wanted));
}

std::string GmshGroups::hint(const std::string& wanted) const {
  std::vector<std::string> known;
  for (const auto& group : names_[3]) known.push_back(group.second);
  std::string text = "it has none with a name";
  if (!known.empty()) text = fmt::format("nearest is \"{}\"", nearest(wanted, known));
  for (int dimension = 0; dimension < 3; ++dimension) {
    if (std::ranges::any_of(names_[dimension], [&](const auto& group) { return group.second == wanted; }))
      return "it is a group of surfaces, curves or points; " + text;
  }
  return text;
}

}  // namespace pinball
