#pragma once

#include <cstdint>
#include <memory>
#include <string>

namespace pinball {

/// A line of one of the files that a deck is made of.
struct DeckPlace {
  std::shared_ptr<const std::string> file;  ///< path as it was opened
  std::int64_t line = 0;                    ///< from 1

  std::string text() const { return *file + ':' + std::to_string(line); }
};

/// Throws InputError "FILE:LINE: problem".
[[noreturn]] void fail_at(const DeckPlace& place, const std::string& problem);

}  // namespace pinball
