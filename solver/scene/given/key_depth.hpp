#pragma once

#include <cstddef>
#include <string>

namespace pinball {

/// Parts that a dotted key may have; scenes need six, in the keys of a variant. The parser makes a table of each and
/// works on them recursively: of tens of thousands the stack runs over.
inline constexpr std::size_t most_key_parts = 32;

/// Throws InputError for a text in TOML with a key of more parts. path: for the message.
void require_short_keys(const std::string& text, const std::string& path);

}  // namespace pinball
