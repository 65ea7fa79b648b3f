#include "found_features.hpp"

#include <cstddef>
#include <span>

namespace pinball {

void FoundFeatures::add_from_others(const PieceShare& share) {
  if (!share.is_shared()) return;
  std::vector<std::byte> message;
  for (std::size_t p = 0; p < nodes.size(); ++p) {
    nodes[p].put_into(message);
    edges[p].put_into(message);
    put_list(message, with_segments[p]);
    put_list(message, with_spheres[p]);
  }
  share.to_all(message, [this](std::span<const std::byte> theirs) {
    for (std::size_t p = 0; p < nodes.size(); ++p) {
      nodes[p].add_from(theirs);
      edges[p].add_from(theirs);
      add_list(theirs, with_segments[p]);
      add_list(theirs, with_spheres[p]);
    }
  });
}

}  // namespace pinball
