#pragma once

#include <string>
#include <vector>

#include "deck_scene.hpp"

namespace pinball {

/// One side of a contact: bodies, or a set of the mesh.
struct DeckSide {
  std::vector<std::string> bodies{};
  std::string kind{}, set{};  ///< "faces" or "nodes" and the name of the set, in the place of bodies

  bool operator==(const DeckSide&) const = default;
  bool empty() const { return bodies.empty() && kind.empty(); }
  GivenValue given() const {
    if (kind.empty()) return pinball::given(bodies);
    InnerKeys<schema::SideOfSet> keys;
    if (kind == "faces") {
      keys.set("faces", set);
    } else {
      keys.set("nodes", set);
    }
    return keys.value();
  }
};

}  // namespace pinball
