#include "given.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace pinball {

std::string GivenPlace::text(const std::string& otherwise) const {
  if (!source_) return otherwise;
  return line_ == 0 ? *source_ : fmt::format("{}:{}:{}", *source_, line_, column_);
}

const GivenValue* GivenTable::find(std::string_view key) const {
  const auto found = std::ranges::find(entries_, key, &GivenEntry::key);
  return found == entries_.end() ? nullptr : &found->value;
}

GivenValue* GivenTable::find(std::string_view key) {
  const auto found = std::ranges::find(entries_, key, &GivenEntry::key);
  return found == entries_.end() ? nullptr : &found->value;
}

GivenValue& GivenTable::set(std::string_view key, GivenValue value, GivenPlace place) {
  if (GivenValue* present = find(key)) return *present = std::move(value);
  return entries_.emplace_back(GivenEntry{std::string(key), std::move(place), std::move(value)}).value;
}

std::optional<double> GivenValue::number() const {
  if (const double* value = as<double>()) return *value;
  constexpr std::int64_t exact = std::int64_t{1} << 53;
  const std::int64_t* integer = as<std::int64_t>();
  if (integer == nullptr || *integer > exact || *integer < -exact) return std::nullopt;
  return static_cast<double>(*integer);
}

std::string describe(const GivenValue& value) {
  if (const auto* text = value.as<std::string>()) return fmt::format("\"{}\"", *text);
  if (const auto* integer = value.as<std::int64_t>()) return fmt::format("{}", *integer);
  if (const auto* number = value.as<double>()) return fmt::format("{}", *number);
  if (const auto* boolean = value.as<bool>()) return *boolean ? "true" : "false";
  if (const auto* array = value.as<GivenArray>())
    return fmt::format("an array of {} value{}", array->size(), array->size() == 1 ? "" : "s");
  return value.is_table() ? "a table" : "a date or time";
}

}  // namespace pinball
