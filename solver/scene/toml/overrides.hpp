#pragma once

#include <string>
#include <vector>

#include <solver/scene/given/given.hpp>

/// Changes to a scene as it is given, before it is read: variants and --set. Nothing here knows which keys exist:
/// a wrong key or value is found when the tables are read, with the location of the change.
namespace pinball {

/// "--set KEY=VALUE" (or another option), split. VALUE is a TOML value, or else a number such as ".5", or else a text
/// without quotes.
struct Override {
  std::string key;
  GivenValue value;   ///< which says where it is from
  std::string where;  ///< "--set KEY=VALUE"
};

/// Throws InputError if there is no KEY or no "=".
Override parse_override(const std::string& option, const std::string& key_value);

/// Sets a key, making the tables on the way to it. Elements of [[material]] and [[body]] are named after their
/// `name`, those of [[constraint]] are numbered from 0. Throws InputError if there is no such element.
void apply_override(GivenTable& scene, const Override& change);

/// Applies the keys of [variant.NAME] in the order of the file. `where` is named if there is no such variant.
void apply_variant(GivenTable& scene, const std::string& name, const std::string& where);

/// Names of the variants, in the order of the file. Throws InputError if `variant` holds anything but tables.
std::vector<std::string> variant_names(const GivenTable& scene, const std::string& file);

}  // namespace pinball
