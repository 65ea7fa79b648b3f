#pragma once

#include <cstdint>
#include <string>

namespace pinball {

/// What has become of the nodes of a tied contact's first side at the start.
struct TiedResult {
  std::string name;
  std::int64_t nodes = 0;  ///< follow a face
  std::int64_t free = 0;   ///< of these: held in a direction in which the face may move, which decides
  std::int64_t near = 0;   ///< lie within five times the tolerance, and beyond it
  std::int64_t held = 0;   ///< near enough, but held in all directions or moved as prescribed
  std::int64_t taken = 0;  ///< near enough, but tied already, or corners of faces that others are tied to
  std::int64_t open = 0;   ///< of the second side: lie on faces of the first, and no node follows them
};

}  // namespace pinball
