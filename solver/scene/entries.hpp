#pragma once

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "listing.hpp"
#include "numbers.hpp"

/// How the values of a scene are written, for listing.cpp and those beside it.
namespace pinball {

std::string toml_text(const std::string& text);  ///< in quotes
inline std::string toml_text(const char* text) { return toml_text(std::string(text)); }
inline std::string toml_text(bool value) { return value ? "true" : "false"; }
inline std::string toml_text(double value) { return fmt::format("{:.12g}", value); }
template <class Integer, std::enable_if_t<std::is_integral_v<Integer> && !std::is_same_v<Integer, bool>, int> = 0>
std::string toml_text(Integer value) {
  return fmt::format("{}", value);
}
template <class List, class = typename List::value_type>
std::string toml_text(const List& values) requires(!std::is_same_v<List, std::string>) {
  std::string text;
  for (const auto& value : values) {
    if (!text.empty()) text += ", ";
    text += toml_text(value);
  }
  return fmt::format("[{}]", text);
}

/// The rows of one table.
class Entries {
 public:
  Entries(std::vector<SceneEntry>& all, std::string table) : all_(all), table_(std::move(table)) {}

  template <class Value>
  void add(std::string_view key, const Value& value, const std::string& unit = {}) {
    push(key, toml_text(value), unit, false);
  }
  template <class Value>
  void add(std::string_view key, const Value& value, const Value& without, const std::string& unit) {
    push(key, toml_text(value), unit, value == without);
  }
  /// A text that is written as it stands, and not in quotes.
  void add_words(std::string_view key, const std::string& words, bool is_default, const std::string& unit = {}) {
    push(key, words, unit, is_default);
  }
  /// A name; empty: not given, which means what `without` says.
  void add_name(std::string_view key, const std::string& name, const std::string& without) {
    push(key, name.empty() ? without : toml_text(name), "", name.empty());
  }
  /// All numbers of a kind of table (numbers.hpp). `without`: what they are where none is given.
  template <class Settings>
  void add_numbers(Settings settings, Settings without) {
    visit_numbers(without, [&](std::string_view key, auto& other, const Bound&, Need need = Need::optional) {
      visit_numbers(settings, [&](std::string_view name, auto& value, const Bound&, Need = Need::optional) {
        if constexpr (std::is_same_v<decltype(value), decltype(other)>) {
          if (name == key) push(key, toml_text(value), unit_of(key), need == Need::optional && value == other);
        }
      });
    });
  }

 private:
  void push(std::string_view key, const std::string& value, const std::string& unit, bool is_default) {
    all_.push_back({table_, std::string(key), value, unit, is_default});
  }
  /// Of the numbers that visit_numbers knows.
  std::string unit_of(std::string_view key) const;

  std::vector<SceneEntry>& all_;
  std::string table_;
};

void list_element(const ElementSettings& element, const std::string& name, std::vector<SceneEntry>& all);
/// Pairs and tied contacts.
void list_contact_parts(const Scene& scene, std::vector<SceneEntry>& all);
void list_bodies(const Scene& scene, std::vector<SceneEntry>& all);
/// What acts from outside, and probes.
void list_boundary(const Scene& scene, std::vector<SceneEntry>& all);

}  // namespace pinball
