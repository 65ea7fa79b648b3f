#pragma once

#include <sstream>
#include <string>

namespace pinball {

/// Words and numbers one after the other.
template <class... Parts>
std::string message_of(const Parts&... parts) {
  std::ostringstream text;
  (text << ... << parts);
  return text.str();
}

}  // namespace pinball
