#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <solver/scene/toml/entries.hpp>

#include "toml_file.hpp"

namespace pinball {

namespace {

/// With all of its digits, unlike in a listing.
std::string exact(double value) {
  std::string text = fmt::format("{}", value);
  if (!std::isfinite(value)) return text;
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text;
}

std::string text_of(const GivenValue& value);

template <class Items, class Text>
std::string joined(const Items& items, const Text& text) {
  std::string all;
  for (const auto& item : items) all += (all.empty() ? "" : ", ") + text(item);
  return all;
}

std::string text_of(const GivenValue& value) {
  if (const auto* number = value.as<double>()) return exact(*number);
  if (const auto* integer = value.as<std::int64_t>()) return toml_text(*integer);
  if (const auto* boolean = value.as<bool>()) return toml_text(*boolean);
  if (const auto* text = value.as<std::string>()) return toml_text(*text);
  if (const auto* array = value.as<GivenArray>()) return fmt::format("[{}]", joined(*array, text_of));
  const auto* table = value.as<GivenTable>();
  return fmt::format("{{ {} }}", joined(table->entries(), [](const GivenEntry& entry) {
                       return fmt::format("{} = {}", entry.key, text_of(entry.value));
                     }));
}

/// Whether a value has tables of its own, [KEY] or [[KEY]].
bool is_section(const GivenValue& value) {
  if (value.is_table()) return !value.is_inline;
  const auto* array = value.as<GivenArray>();
  return array != nullptr && !array->empty() &&
         std::ranges::all_of(*array, [](const GivenValue& one) { return one.is_table() && !one.is_inline; });
}

/// Its keys, and then what has tables of its own. path: of the table.
void write_keys(const GivenTable& table, const std::string& path, std::string& text);

void write_section(const GivenTable& table, const std::string& head, const std::string& path, std::string& text) {
  text += fmt::format("\n{}{}\n", head, table.comment.empty() ? "" : "  # " + table.comment);
  write_keys(table, path, text);
}

void write_keys(const GivenTable& table, const std::string& path, std::string& text) {
  for (const auto& [key, place, value] : table.entries()) {
    if (!is_section(value)) text += fmt::format("{} = {}\n", key, text_of(value));
  }
  for (const auto& [key, place, value] : table.entries()) {
    if (!is_section(value)) continue;
    const std::string inner = path.empty() ? key : fmt::format("{}.{}", path, key);
    if (const auto* one = value.as<GivenTable>()) {
      write_section(*one, fmt::format("[{}]", inner), inner, text);
    } else {
      for (const GivenValue& item : *value.as<GivenArray>())
        write_section(*item.as<GivenTable>(), fmt::format("[[{}]]", inner), inner, text);
    }
  }
}

}  // namespace

std::string write_toml(const GivenTable& scene) {
  std::string text = scene.comment.empty() ? "" : fmt::format("# {}\n", scene.comment);
  write_keys(scene, "", text);
  return text;
}

}  // namespace pinball
