#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include <solver/scene_rules.hpp>

namespace pinball {

/// The names of the tables of one kind, however many: each name is looked up in the same time.
class Names {
 public:
  Names() = default;
  /// The names of all of them, which may repeat.
  template <class Named>
  explicit Names(const std::vector<Named>& items) {
    for (const auto& item : items) add(item.name);
  }

  bool has(const std::string& name) const { return known_.contains(name); }
  /// A name that an earlier table has is a problem, and not added. place: FILE:LINE:COLUMN, for that message; empty: in
  /// no file.
  std::optional<Problem> add(const std::string& name, const std::string& place = {});
  /// A reference under `key` to a name of `kind` ("material") that is none of these.
  std::optional<Problem> reference_problem(std::string_view key, std::string_view kind, const std::string& name) const;

 private:
  std::vector<std::string> in_order_;
  std::unordered_map<std::string, std::string> known_;  ///< with their places
};

/// The columns NAME_force_x of a pair would be those of a body, BODY_contact_force_x.
std::optional<Problem> column_problem(const std::string& pair, const Names& bodies);

/// The columns NAME_force_x of constraints, prescribed velocities and accelerations would be those of a pressure, a
/// pair or a body. An empty name has none.
std::optional<Problem> force_name_problem(const std::string& name, const Scene& scene);

}  // namespace pinball
