#include "overrides.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>

#include <solver/base/error.hpp>
#include <solver/base/text_distance.hpp>
#include <solver/scene/given/key_depth.hpp>
#include <solver/scene/given/toml_file.hpp>
#include <solver/scene/schema/scene.hpp>

#include "table.hpp"

namespace pinball {

namespace {

/// "a.b.c" as its parts. Throws InputError if one is empty.
std::vector<std::string> split_key(const std::string& key, const std::string& where) {
  std::vector<std::string> parts;
  std::size_t begin = 0;
  while (true) {
    const std::size_t end = std::min(key.find('.', begin), key.size());
    if (end == begin) fail(where, "", fmt::format("expected a key such as contact.beta, got \"{}\"", key));
    parts.push_back(key.substr(begin, end - begin));
    if (parts.size() > most_key_parts) {
      fail(where, "", fmt::format("expected a key of at most {} parts, got more", most_key_parts));
    }
    if (end == key.size()) return parts;
    begin = end + 1;
  }
}

/// Of the tables of which a scene may have several, whether --set knows them by their names: each has one.
class Lists {
 public:
  template <class Key>
  void operator()(const Key&) {}
  template <class Part>
  void operator()(const schema::Tables<Scene, std::vector<Part>>& tables) {
    named[tables.name] = schema::about<Part>("name").need == schema::Need::required;
  }

  std::map<std::string, bool, std::less<>> named;
};

const std::map<std::string, bool, std::less<>>& lists() {
  static const auto all = [] {
    Lists found;
    describe(schema::Of<Scene>{}, found);
    return found.named;
  }();
  return all;
}

/// The element of an array of tables that the second part of a key selects.
GivenTable& element(GivenValue& value, const std::vector<std::string>& parts, const std::string& key,
                    const std::string& where) {
  const std::string& kind = parts[0];
  const bool numbered = !lists().at(kind);
  auto* array = value.as<GivenArray>();
  if (!array) fail(value.place.text(where), kind, fmt::format("expected tables [[{}]]", kind));
  if (parts.size() < 3) {
    fail(where, key, fmt::format("expected {}.{}.KEY", kind, numbered ? "NUMBER" : "NAME"));
  }
  std::vector<std::string> names;
  for (std::size_t i = 0; i < array->size(); ++i) {
    auto* table = (*array)[i].as<GivenTable>();
    if (!table) continue;
    const GivenValue* named = table->find("name");
    const auto* name = named ? named->as<std::string>() : nullptr;
    names.push_back(numbered ? std::to_string(i) : name ? *name : "");
    if (names.back() == parts[1]) return *table;
  }
  if (names.empty()) fail(where, key, fmt::format("the scene has no [[{}]]", kind));
  if (numbered) {
    fail(where, key, fmt::format("expected a number from 0 to {}, got {}", names.size() - 1, parts[1]));
  }
  fail(where, key, fmt::format("no {} is named \"{}\", nearest is \"{}\"", kind, parts[1], nearest(parts[1], names)));
}

/// The table of a list that a number selects.
GivenTable& numbered(GivenArray& array, const std::string& part, const std::string& key, const std::string& where) {
  for (std::size_t i = 0; i < array.size(); ++i) {
    auto* table = array[i].as<GivenTable>();
    if (table && part == std::to_string(i)) return *table;
  }
  fail(where, key, fmt::format("expected a number from 0 to {}, got {}", static_cast<int>(array.size()) - 1, part));
}

/// Puts the value under its key. `where` names the change, `source` goes to tables and keys that are made on the way.
void assign(GivenTable& scene, const std::string& key, const GivenValue& value, const std::string& where,
            const GivenPlace& source) {
  const auto parts = split_key(key, where);
  GivenTable* table = &scene;
  std::size_t next = 0;
  if (parts.size() > 1 && lists().contains(parts[0])) {
    GivenValue* elements = scene.find(parts[0]);
    if (!elements) fail(where, key, fmt::format("the scene has no [[{}]]", parts[0]));
    table = &element(*elements, parts, key, where);
    next = 2;
  }
  for (; next + 1 < parts.size(); ++next) {
    GivenValue* inner = table->find(parts[next]);
    if (!inner) {
      inner = &table->set(parts[next], GivenValue(GivenTable{}, source), source);
    } else if (inner->as<GivenArray>() && next + 2 < parts.size()) {  // contact.pair.NUMBER.KEY
      table = &numbered(*inner->as<GivenArray>(), parts[++next], key, where);
      continue;
    } else if (!inner->is_table()) {
      fail(where, key, fmt::format("{} is no table, it is {}", parts[next], describe(*inner)));
    }
    table = inner->as<GivenTable>();
  }
  table->set(parts.back(), value, source);
}

struct VariantKey {
  std::string key;
  GivenPlace place;
  GivenValue value;
};

/// A variant's keys are quoted dotted keys; unquoted ones make nested tables, which mean the same.
void collect(const GivenTable& table, const std::string& prefix, std::vector<VariantKey>& keys) {
  for (const auto& [key, place, value] : table.entries()) {
    const std::string path = prefix.empty() ? key : fmt::format("{}.{}", prefix, key);
    if (value.is_table() && !value.is_inline) {
      collect(*value.as<GivenTable>(), path, keys);
    } else {
      keys.push_back({path, place, value});
    }
  }
}

}  // namespace

Override parse_override(const std::string& option, const std::string& key_value) {
  const std::string where = option + " " + key_value;
  const auto equals = key_value.find('=');
  if (equals == std::string::npos || equals == 0) fail(where, "", "expected KEY=VALUE, as in contact.beta=2");
  const std::string key = key_value.substr(0, equals);
  const std::string text = key_value.substr(equals + 1);
  split_key(key, where);
  auto value = parse_toml_value(text, where);
  if (!value && !text.empty() && text.find_first_not_of("0123456789+-.eE") == std::string::npos) {
    // TOML wants digits on both sides of the point.
    double number = 0.0;
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (problem == std::errc() && end == text.data() + text.size())
      value = parse_toml_value(fmt::format("{:e}", number), where);
  }
  return {key, value ? std::move(*value) : GivenValue(text, GivenPlace(where)), where};
}

void apply_override(GivenTable& scene, const Override& change) {
  assign(scene, change.key, change.value, change.where, GivenPlace(change.where));
}

void apply_variant(GivenTable& scene, const std::string& name, const std::string& where) {
  const auto names = variant_names(scene, where);
  if (names.empty()) fail(where, "variant", fmt::format("the scene has no variants, got \"{}\"", name));
  if (std::find(names.begin(), names.end(), name) == names.end()) {
    fail(where, "variant", fmt::format("expected {}, got \"{}\"", alternatives(names), name));
  }
  std::vector<VariantKey> keys;
  collect(*scene.find("variant")->as<GivenTable>()->find(name)->as<GivenTable>(), "", keys);
  std::ranges::stable_sort(keys, [](const VariantKey& a, const VariantKey& b) { return a.place.before(b.place); });
  for (const auto& [key, place, value] : keys) assign(scene, key, value, place.text(where), place);
}

std::vector<std::string> variant_names(const GivenTable& scene, const std::string& file) {
  const GivenValue* variants = scene.find("variant");
  if (!variants) return {};
  const auto expected = "expected tables [variant.NAME], got ";
  const auto* tables = variants->as<GivenTable>();
  if (!tables) fail(variants->place.text(file), "variant", expected + describe(*variants));
  std::vector<std::string> names;
  for (const auto& [key, place, value] : tables->entries()) {
    if (!value.is_table()) fail(value.place.text(file), fmt::format("variant.{}", key), expected + describe(value));
    names.push_back(key);
  }
  return names;
}

}  // namespace pinball
