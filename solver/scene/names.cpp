#include "names.hpp"

#include <fmt/format.h>

#include <solver/base/text_distance.hpp>

namespace pinball {

std::optional<Problem> Names::add(const std::string& name) {
  if (!known_.insert(name).second) {
    return Problem{"name", fmt::format("expected a name of its own, got \"{}\" a second time", name)};
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

}  // namespace pinball
