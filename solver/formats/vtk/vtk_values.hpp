#pragma once

#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace pinball {

/// Types of the numbers in a file of VTK.
enum class VtkType { i8, u8, i16, u16, i32, u32, i64, u64, f32, f64 };

/// By its name in files of XML ("Int64") or in legacy files ("vtktypeint64", "long").
std::optional<VtkType> vtk_type(std::string_view name);
std::size_t size_of(VtkType type);
inline bool is_integer(VtkType type) { return type != VtkType::f32 && type != VtkType::f64; }

/// A number as T: none where it is not finite or T cannot hold it.
template <class T, class From>
std::optional<T> converted(From value) {
  if constexpr (std::is_floating_point_v<T>) {
    if (!std::isfinite(static_cast<T>(value))) return {};
  } else if constexpr (std::is_floating_point_v<From>) {
    if (!(std::abs(value) < 9e15) || std::trunc(value) != value) return {};
    return converted<T>(static_cast<std::int64_t>(value));
  } else if constexpr (std::is_unsigned_v<From>) {
    if (value > static_cast<std::uint64_t>(std::numeric_limits<T>::max())) return {};
  } else {
    const std::int64_t wide = value;
    if (wide < std::numeric_limits<T>::min() || (sizeof(T) < 8 && wide > std::numeric_limits<T>::max())) return {};
  }
  return static_cast<T>(value);
}

template <class From, class T>
std::size_t append_as(std::string_view bytes, bool swapped, std::vector<T>& to) {
  const std::size_t count = bytes.size() / sizeof(From);
  to.reserve(to.size() + count);
  for (std::size_t i = 0; i < count; ++i) {
    char raw[sizeof(From)];
    std::memcpy(raw, bytes.data() + i * sizeof(From), sizeof raw);
    if (swapped) {
      for (std::size_t k = 0; k < sizeof raw / 2; ++k) std::swap(raw[k], raw[sizeof raw - 1 - k]);
    }
    const auto number = converted<T>(std::bit_cast<From>(raw));
    if (!number) return i;
    to.push_back(*number);
  }
  return count;
}

/// Adds numbers of a type as T. Returns how many: fewer than there are where the next one is not finite, or T cannot
/// hold it.
template <class T>
std::size_t append_numbers(std::string_view bytes, VtkType type, bool swapped, std::vector<T>& to) {
  switch (type) {
    case VtkType::i8:
      return append_as<std::int8_t>(bytes, swapped, to);
    case VtkType::u8:
      return append_as<std::uint8_t>(bytes, swapped, to);
    case VtkType::i16:
      return append_as<std::int16_t>(bytes, swapped, to);
    case VtkType::u16:
      return append_as<std::uint16_t>(bytes, swapped, to);
    case VtkType::i32:
      return append_as<std::int32_t>(bytes, swapped, to);
    case VtkType::u32:
      return append_as<std::uint32_t>(bytes, swapped, to);
    case VtkType::i64:
      return append_as<std::int64_t>(bytes, swapped, to);
    case VtkType::u64:
      return append_as<std::uint64_t>(bytes, swapped, to);
    case VtkType::f32:
      return append_as<float>(bytes, swapped, to);
    case VtkType::f64:
      return append_as<double>(bytes, swapped, to);
  }
  return 0;
}

/// Adds the next number of a text, and takes it off. False: there is none, or T cannot hold it.
template <class T>
bool append_word(std::string_view& text, std::vector<T>& to) {
  const auto is_space = [](char c) { return c == ' ' || (c >= '\t' && c <= '\r'); };
  std::size_t at = 0;
  while (at < text.size() && is_space(text[at])) ++at;
  if (at < text.size() && text[at] == '+') ++at;
  T value{};
  const auto [end, problem] = std::from_chars(text.data() + at, text.data() + text.size(), value);
  if (problem == std::errc::result_out_of_range && std::is_floating_point_v<T>) {
    value = 0;  // it is too small to be told from zero, as those of single precision may be
    if (std::string_view(text.data() + at, end).find("e-") == std::string_view::npos) return false;
  } else if (problem != std::errc()) {
    return false;
  }
  if (end != text.data() + text.size() && !is_space(*end)) return false;
  if constexpr (std::is_floating_point_v<T>) {
    if (!std::isfinite(value)) return false;
  }
  to.push_back(value);
  text.remove_prefix(end - text.data());
  return true;
}

}  // namespace pinball
