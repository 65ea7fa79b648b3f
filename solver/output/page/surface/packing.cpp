#include "packing.hpp"

#include <algorithm>

namespace pinball {
namespace {

/// Small differences of either sign become small numbers.
std::uint64_t unsigned_of(std::int64_t difference) {
  return static_cast<std::uint64_t>(difference) << 1 ^ static_cast<std::uint64_t>(difference >> 63);
}

std::int64_t within_47_bits(std::int64_t number) {
  constexpr std::int64_t most = std::int64_t{1} << 46;
  return number < -most || number >= most ? -1 : number;
}

}  // namespace

void pack_integers(std::string& to, std::span<const std::int64_t> numbers) {
  const std::size_t begin = to.size(), count = numbers.size();
  to.resize(begin + 6 * count);
  std::int64_t last = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::int64_t number = within_47_bits(numbers[i]);
    const std::uint64_t difference = unsigned_of(number - last);
    for (std::size_t k = 0; k < 6; ++k) to[begin + k * count + i] = static_cast<char>(difference >> (8 * k) & 0xff);
    last = number;
  }
}

void pack_codes(std::string& to, std::span<const std::uint16_t> codes, std::span<const std::uint16_t> before) {
  const std::size_t begin = to.size(), count = codes.size();
  to.resize(begin + 2 * count);
  std::uint16_t last = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint16_t since = static_cast<std::uint16_t>(codes[i] - (before.empty() ? 0 : before[i]));
    const std::uint64_t difference = unsigned_of(static_cast<std::int16_t>(since - last));
    to[begin + i] = static_cast<char>(difference & 0xff);
    to[begin + count + i] = static_cast<char>(difference >> 8 & 0xff);
    last = since;
  }
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view characters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t there = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      bits = bits << 8 | (k < there ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    }
    for (std::size_t k = 0; k < 4; ++k) text += k <= there ? characters[bits >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

}  // namespace pinball
