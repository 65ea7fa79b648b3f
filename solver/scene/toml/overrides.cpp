#include "overrides.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>
#include <sstream>

#include <solver/base/error.hpp>
#include <solver/base/text_distance.hpp>
#include <solver/scene/schema/scene.hpp>

#include "key_depth.hpp"
#include "table.hpp"

namespace pinball {

namespace {

std::optional<toml::table> parse_value(const std::string& text, const std::string& source) {
  require_short_keys(text, source);
  try {
    // The line break ends a comment that the value may carry; a second key can only come from a line break inside it.
    toml::table table = toml::parse("value = " + text + "\n", source);
    if (table.size() == 1 && table.contains("value")) return table;
  } catch (const toml::parse_error&) {
  }
  return std::nullopt;
}

std::string quoted(const std::string& text) {
  std::ostringstream out;
  out << toml::value<std::string>(text);
  return out.str();
}

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
toml::table& element(toml::node& node, const std::vector<std::string>& parts, const std::string& key,
                     const std::string& where) {
  const std::string& kind = parts[0];
  const bool numbered = !lists().at(kind);
  auto* array = node.as_array();
  if (!array) fail(location(node.source(), where), kind, fmt::format("expected tables [[{}]]", kind));
  if (parts.size() < 3) {
    fail(where, key, fmt::format("expected {}.{}.KEY", kind, numbered ? "NUMBER" : "NAME"));
  }
  std::vector<std::string> names;
  for (std::size_t i = 0; i < array->size(); ++i) {
    auto* table = array->get_as<toml::table>(i);
    if (!table) continue;
    names.push_back(numbered ? std::to_string(i) : (*table)["name"].value_or(std::string()));
    if (names.back() == parts[1]) return *table;
  }
  if (names.empty()) fail(where, key, fmt::format("the scene has no [[{}]]", kind));
  if (numbered) {
    fail(where, key, fmt::format("expected a number from 0 to {}, got {}", names.size() - 1, parts[1]));
  }
  fail(where, key, fmt::format("no {} is named \"{}\", nearest is \"{}\"", kind, parts[1], nearest(parts[1], names)));
}

/// The table of a list that a number selects.
toml::table& numbered(toml::array& array, const std::string& part, const std::string& key, const std::string& where) {
  for (std::size_t i = 0; i < array.size(); ++i) {
    auto* table = array.get_as<toml::table>(i);
    if (table && part == std::to_string(i)) return *table;
  }
  fail(where, key, fmt::format("expected a number from 0 to {}, got {}", static_cast<int>(array.size()) - 1, part));
}

/// Moves the value to its key. `where` names the change, `source` goes to tables and keys that are made on the way.
void assign(toml::table& scene, const std::string& key, toml::node& value, const std::string& where,
            const toml::source_region& source) {
  const auto parts = split_key(key, where);
  toml::table* table = &scene;
  std::size_t next = 0;
  if (parts.size() > 1 && lists().contains(parts[0])) {
    toml::node* elements = scene.get(parts[0]);
    if (!elements) fail(where, key, fmt::format("the scene has no [[{}]]", parts[0]));
    table = &element(*elements, parts, key, where);
    next = 2;
  }
  for (; next + 1 < parts.size(); ++next) {
    toml::node* node = table->get(parts[next]);
    if (!node) {
      node = &table->insert_or_assign(toml::key(parts[next], source), toml::table{}).first->second;
    } else if (node->is_array() && next + 2 < parts.size()) {  // contact.pair.NUMBER.KEY
      table = &numbered(*node->as_array(), parts[++next], key, where);
      continue;
    } else if (!node->is_table()) {
      fail(where, key, fmt::format("{} is no table, it is {}", parts[next], describe(*node)));
    }
    table = node->as_table();
  }
  // Moved, not copied: a copy would forget where the value was written.
  value.visit([&](auto& typed) { table->insert_or_assign(toml::key(parts.back(), source), std::move(typed)); });
}

struct VariantKey {
  std::string key;
  toml::source_region source;
  toml::node* value;
};

/// A variant's keys are quoted dotted keys; unquoted ones make nested tables, which mean the same.
void collect(toml::table& table, const std::string& prefix, std::vector<VariantKey>& keys) {
  for (auto&& [key, value] : table) {
    const std::string path = prefix.empty() ? std::string(key.str()) : fmt::format("{}.{}", prefix, key.str());
    auto* nested = value.as_table();
    if (nested && !nested->is_inline()) {
      collect(*nested, path, keys);
    } else {
      keys.push_back({path, key.source(), &value});
    }
  }
}

}  // namespace

std::string Override::where() const { return *value.get("value")->source().path; }

Override parse_override(const std::string& option, const std::string& key_value) {
  const std::string where = option + " " + key_value;
  const auto equals = key_value.find('=');
  if (equals == std::string::npos || equals == 0) fail(where, "", "expected KEY=VALUE, as in contact.beta=2");
  const std::string key = key_value.substr(0, equals);
  const std::string text = key_value.substr(equals + 1);
  split_key(key, where);
  auto value = parse_value(text, where);
  if (!value && !text.empty() && text.find_first_not_of("0123456789+-.eE") == std::string::npos) {
    // TOML wants digits on both sides of the point.
    double number = 0.0;
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (problem == std::errc() && end == text.data() + text.size())
      value = parse_value(fmt::format("{:e}", number), where);
  }
  if (!value) value = parse_value(quoted(text), where);
  if (!value) fail(where, "", "the value cannot be read");
  return {key, std::move(*value)};
}

void apply_override(toml::table& scene, Override change) {
  toml::node& value = *change.value.get("value");
  const toml::source_region source = value.source();
  const std::string where = change.where();
  assign(scene, change.key, value, where, source);
}

void apply_variant(toml::table& scene, const std::string& name, const std::string& where) {
  const auto names = variant_names(scene, where);
  if (names.empty()) fail(where, "variant", fmt::format("the scene has no variants, got \"{}\"", name));
  if (std::find(names.begin(), names.end(), name) == names.end()) {
    fail(where, "variant", fmt::format("expected {}, got \"{}\"", alternatives(names), name));
  }
  std::vector<VariantKey> keys;
  collect(*scene["variant"][name].as_table(), "", keys);
  std::sort(keys.begin(), keys.end(),
            [](const VariantKey& a, const VariantKey& b) { return a.source.begin < b.source.begin; });
  for (const auto& [key, source, value] : keys) assign(scene, key, *value, location(source, where), source);
}

std::vector<std::string> variant_names(const toml::table& scene, const std::string& file) {
  std::vector<std::pair<toml::source_position, std::string>> found;
  const toml::node* variants = scene.get("variant");
  if (!variants) return {};
  const auto expected = "expected tables [variant.NAME], got ";
  if (!variants->is_table()) fail(location(variants->source(), file), "variant", expected + describe(*variants));
  for (const auto& [key, value] : *variants->as_table()) {
    if (!value.is_table()) {
      fail(location(value.source(), file), fmt::format("variant.{}", key.str()), expected + describe(value));
    }
    found.emplace_back(key.source().begin, key.str());
  }
  std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<std::string> names;
  for (auto& [position, name] : found) names.push_back(name);
  return names;
}

}  // namespace pinball
