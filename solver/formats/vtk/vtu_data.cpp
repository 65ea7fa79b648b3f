#include "vtu_data.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <vector>

#ifdef PINBALL_ZLIB
#include <zlib.h>
#endif

/// Format: "VTK XML File Formats": data begins with its length in bytes; compressed data with the number of its blocks,
/// the length of a block and of the last one (0: it is as long as the others), and the compressed length of each.
namespace pinball {
namespace {

constexpr std::array<signed char, 256> values_of_base64() {
  std::array<signed char, 256> values{};
  for (signed char& value : values) value = -1;
  constexpr std::string_view characters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  for (std::size_t i = 0; i < characters.size(); ++i)
    values[static_cast<unsigned char>(characters[i])] = static_cast<signed char>(i);
  return values;
}
constexpr std::array<signed char, 256> base64_values = values_of_base64();

std::uint64_t number(std::string_view bytes, std::size_t place, bool wide) {
  if (wide) {
    std::uint64_t value = 0;
    std::memcpy(&value, bytes.data() + 8 * place, 8);
    return value;
  }
  std::uint32_t value = 0;
  std::memcpy(&value, bytes.data() + 4 * place, 4);
  return value;
}

/// Characters of base64 that so many bytes take.
std::size_t encoded_length(std::size_t bytes) { return (bytes + 2) / 3 * 4; }

struct Blocks {
  std::uint64_t count = 0, length = 0, last = 0;
  std::uint64_t total() const { return count == 0 ? 0 : (count - 1) * length + (last == 0 ? length : last); }
};

#ifdef PINBALL_ZLIB
/// data: compressed blocks one after the other, as long as the header says.
bool inflate_blocks(std::string_view header, std::string_view data, const Blocks& blocks, bool wide,
                    std::string& whole) {
  whole.resize(blocks.total());
  std::size_t from = 0, to = 0;
  for (std::uint64_t b = 0; b < blocks.count; ++b) {
    const std::uint64_t packed = number(header, 3 + b, wide);
    const bool short_one = b + 1 == blocks.count && blocks.last != 0;
    uLongf length = short_one ? blocks.last : blocks.length;
    const uLongf wanted = length;
    if (packed > data.size() - from) return false;
    const int status = uncompress(reinterpret_cast<Bytef*>(whole.data()) + to, &length,
                                  reinterpret_cast<const Bytef*>(data.data()) + from, packed);
    if (status != Z_OK || length != wanted) return false;
    from += packed;
    to += wanted;
  }
  return true;
}
#endif

std::string_view inflated(std::string_view text, bool base64, bool wide, std::size_t expected, std::string& whole,
                          std::string& problem) {
#ifdef PINBALL_ZLIB
  const std::size_t size = wide ? 8 : 4;
  std::string first = base64 ? decoded_base64(text, 3 * size) : std::string(text.substr(0, 3 * size));
  if (first.size() < 3 * size) return problem = "is cut short", std::string_view();
  const Blocks blocks{number(first, 0, wide), number(first, 1, wide), number(first, 2, wide)};
  if (blocks.count > text.size() / size || blocks.length > std::uint64_t{1} << 40 || blocks.last > blocks.length ||
      blocks.total() != expected || expected / 1032 > text.size())
    return problem = fmt::format("expected {} bytes of compressed data, got others", expected), std::string_view();
  const std::size_t head = (3 + blocks.count) * size, skipped = base64 ? encoded_length(head) : head;
  if (skipped > text.size()) return problem = "is cut short", std::string_view();
  const std::string header = base64 ? decoded_base64(text, head) : std::string(text.substr(0, head));
  if (header.size() < head) return problem = "is cut short", std::string_view();
  const std::string packed = base64 ? decoded_base64(text.substr(skipped)) : std::string();
  if (!inflate_blocks(header, base64 ? std::string_view(packed) : text.substr(skipped), blocks, wide, whole))
    return problem = "has damaged compressed data", std::string_view();
  return whole;
#else
  (void)text, (void)base64, (void)wide, (void)expected, (void)whole;
  problem = "is compressed, and this program was built without zlib: install zlib1g-dev and build it again";
  return {};
#endif
}

}  // namespace

std::string decoded_base64(std::string_view text, std::size_t most) {
  std::string bytes;
  bytes.reserve(most > 0 ? most : text.size() / 4 * 3);
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : text) {
    if (most > 0 && bytes.size() >= most) break;
    const int value = base64_values[static_cast<unsigned char>(c)];
    if (value < 0 && (c == '\n' || c == '\r' || c == ' ')) continue;
    if (value < 0) break;
    bits = bits << 6 | static_cast<std::uint32_t>(value);
    if (++count % 4 != 0) continue;
    for (const int shift : {16, 8, 0}) bytes += static_cast<char>(bits >> shift & 0xff);
    bits = 0;
  }
  // A group that is not complete ends in one or two "=".
  if (count % 4 == 2) bytes += static_cast<char>(bits >> 4 & 0xff);
  if (count % 4 == 3) {
    bytes += static_cast<char>(bits >> 10 & 0xff);
    bytes += static_cast<char>(bits >> 2 & 0xff);
  }
  if (most > 0 && bytes.size() > most) bytes.resize(most);
  return bytes;
}

std::string_view vtu_bytes(std::string_view text, bool base64, const VtuEncoding& encoding, std::size_t expected,
                           std::string& whole, std::string& problem) {
  if (expected == 0) return {};
  if (encoding.compressed) return inflated(text, base64, encoding.wide_header, expected, whole, problem);
  const std::size_t head = encoding.wide_header ? 8 : 4;
  const std::string first = base64 ? decoded_base64(text, head) : std::string(text.substr(0, head));
  if (first.size() < head || number(first, 0, encoding.wide_header) != expected) {
    problem = fmt::format("expected {} bytes of data, got {}", expected,
                          first.size() < head ? "none" : std::to_string(number(first, 0, encoding.wide_header)));
    return {};
  }
  if (!base64) {
    if (text.size() - head < expected) return problem = "is cut short", std::string_view();
    return text.substr(head, expected);
  }
  if (text.size() < expected) return problem = "is cut short", std::string_view();
  // Most programs encode the length together with the data, some by itself, which then ends in "=".
  const std::size_t of_head = encoded_length(head);
  const bool apart = text.size() >= of_head && text[of_head - 1] == '=';
  whole = apart ? decoded_base64(text.substr(of_head), expected) : decoded_base64(text, head + expected);
  const std::string_view data = std::string_view(whole).substr(apart ? 0 : head);
  if (data.size() < expected) return problem = "is cut short", std::string_view();
  return data;
}

}  // namespace pinball
