#include "toml_file.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>

#include <solver/base/error.hpp>

#include "key_depth.hpp"
#include "repeated_key.hpp"

namespace pinball {

namespace {

/// What is of the command line names itself.
GivenPlace place_of(const toml::source_region& source) {
  if (!source.path || !source.begin) return {};
  if (source.path->starts_with("--")) return {source.path, 0, 0};
  return {source.path, source.begin.line, source.begin.column};
}

/// Tables and arrays that may lie one in another: each takes its part of the stack. The parser has a bound of its own
/// for those in braces, each of which may have a key of many parts.
constexpr int most_levels = 256;

GivenTable table_of(const toml::table& table, int level);

/// level: number of tables and arrays around it.
GivenValue value_of(const toml::node& node, int level) {
  GivenValue value;
  value.place = place_of(node.source());
  if (const auto* text = node.as_string()) {
    value.any = text->get();
  } else if (const auto* integer = node.as_integer()) {
    value.any = integer->get();
  } else if (const auto* number = node.as_floating_point()) {
    value.any = number->get();
  } else if (const auto* boolean = node.as_boolean()) {
    value.any = boolean->get();
  } else if (const auto* array = node.as_array()) {
    GivenArray values;
    values.reserve(array->size());
    for (const toml::node& one : *array) values.push_back(value_of(one, level + 1));
    value.any = std::move(values);
  } else if (const auto* table = node.as_table()) {
    value.any = table_of(*table, level + 1);
    value.is_inline = table->is_inline();
  } else {
    value.any = GivenDate{};
  }
  return value;
}

/// In the order of the file, not in that of the alphabet.
GivenTable table_of(const toml::table& table, int level) {
  GivenTable given;
  for (const auto& [key, node] : table) {
    if (level > most_levels) {
      throw InputError(fmt::format("{}: expected at most {} tables and arrays, one in another, got more",
                                   place_of(key.source()).text("a key"), most_levels));
    }
    given.entries().push_back({std::string(key.str()), place_of(key.source()), value_of(node, level)});
  }
  std::ranges::stable_sort(given.entries(),
                           [](const GivenEntry& a, const GivenEntry& b) { return a.place.before(b.place); });
  return given;
}

}  // namespace

GivenTable parse_toml(const std::string& text, const std::string& path) {
  require_short_keys(text, path);
  try {
    return table_of(toml::parse(text, path), 0);
  } catch (const toml::parse_error& error) {
    const std::int64_t first = line_of_first(text, error);
    throw InputError(fmt::format("{}: not valid TOML: {}{}", place_of(error.source()).text(path), error.description(),
                                 first > 0 ? fmt::format("; the first is in line {}", first) : ""));
  }
}

std::optional<GivenValue> parse_toml_value(const std::string& text, const std::string& source) {
  require_short_keys(text, source);
  try {
    // The line break ends a comment that the value may carry; a second key can only come from a line break inside it.
    const toml::table table = toml::parse("value = " + text + "\n", source);
    if (table.size() == 1 && table.contains("value")) return value_of(*table.get("value"), 0);
  } catch (const toml::parse_error&) {
  }
  return std::nullopt;
}

}  // namespace pinball
