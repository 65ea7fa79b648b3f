#pragma once

#include <fmt/format.h>

#include <string>

#include <solver/scene/units/units.hpp>

namespace pinball {

/// A line of XML that says the scene's units to whoever reads the file.
inline std::string units_comment(const std::string& units) {
  std::string safe;
  for (const char c : units_line(units)) {
    if (c == '-' && !safe.empty() && safe.back() == '-') safe += ' ';  // "--" would end it
    safe += c;
  }
  return fmt::format("<!-- {} -->\n", safe);
}

}  // namespace pinball
