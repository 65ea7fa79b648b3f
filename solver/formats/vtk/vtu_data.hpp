#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace pinball {

/// How the data of a file of VTK's XML is encoded.
struct VtuEncoding {
  bool wide_header = false;  ///< header_type UInt64, else UInt32
  bool compressed = false;   ///< by zlib, in blocks
};

/// Characters of base64 as bytes. Stops at what is not base64; no more than `most` bytes, if that is not 0.
std::string decoded_base64(std::string_view text, std::size_t most = 0);

/// The bytes of an array, which begin at the beginning of `text`; `whole` holds what does not lie in the text itself.
/// expected: how many bytes there have to be. problem: what is wrong; empty: nothing.
std::string_view vtu_bytes(std::string_view text, bool base64, const VtuEncoding& encoding, std::size_t expected,
                           std::string& whole, std::string& problem);

}  // namespace pinball
