#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace pinball {

/// Physical groups of a Gmsh mesh: their names, and to which of them the entities of the geometry belong (4.1).
class GmshGroups {
 public:
  explicit GmshGroups(std::string path) : path_(std::move(path)) {}

  void add_name(int dimension, std::int64_t group, const std::string& name) { names_[dimension].insert({group, name}); }
  void add_entity(int dimension, std::int64_t entity, std::int64_t group) {
    of_entity_[dimension][entity].push_back(group);
    numbers_[dimension].insert(group);
  }
  void found_entities() { has_entities_ = true; }

  std::span<const std::int64_t> of_entity(int dimension, std::int64_t entity) const;
  std::string name_of(int dimension, std::int64_t group) const;

  /// Numbers of physical volumes, given by name or number. is_4: entities say what belongs to a group. Throws
  /// InputError for what the file does not name, with the nearest that it does.
  std::vector<std::int64_t> volumes(const std::vector<std::string>& wanted, bool is_4) const;

 private:
  std::int64_t volume(const std::string& wanted, bool is_4) const;
  /// Throws InputError for a name of several.
  void require_one(const std::string& wanted) const;
  std::string hint(const std::string& wanted) const;

  std::string path_;
  std::array<std::multimap<std::int64_t, std::string>, 4> names_;  ///< by dimension
  std::array<std::map<std::int64_t, std::vector<std::int64_t>>, 4> of_entity_;
  std::array<std::set<std::int64_t>, 4> numbers_;
  bool has_entities_ = false;
};

}  // namespace pinball
