#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "deck_place.hpp"

namespace pinball {

/// How many files a deck may be made of, and how large all of them together: two files that include one each twice
/// are 2^64 after 64 of them.
class DeckFiles {
 public:
  /// The bytes of one more. from: the line that names it, of `keyword`; null: it is the deck itself. Throws InputError
  /// as bytes_of_file, and for one file too many.
  std::string open(const std::string& path, const DeckPlace* from, const std::string& keyword);

 private:
  std::size_t files_ = 0;
  std::uintmax_t bytes_ = 0;
};

}  // namespace pinball
