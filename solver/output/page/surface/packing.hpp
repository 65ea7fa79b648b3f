#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

/// Numbers as a page has them: differences that are mostly small, their bytes sorted by place, compressed, as text.
/// viewer_data.js reads them.
namespace pinball {

/// Appends 6 bytes a number: all lowest bytes, all second ones, ... of the differences to the number before, as 2 d or
/// -2 d - 1. Numbers that 47 bits do not hold become -1.
void pack_integers(std::string& to, std::span<const std::int64_t> numbers);

/// Appends 2 bytes a code, in the same way: the difference to the same code of an earlier time less that of the code
/// before, modulo 2^16. `before` is as long, or empty at the first time.
void pack_codes(std::string& to, std::span<const std::uint16_t> codes, std::span<const std::uint16_t> before);

/// In the format of zlib (RFC 1950); as they are where this program was built without zlib.
std::string deflated(const std::string& bytes);
bool can_deflate();

std::string base64(std::string_view bytes);

}  // namespace pinball
