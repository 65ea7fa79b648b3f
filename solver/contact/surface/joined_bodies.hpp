#pragma once

#include <cstdint>
#include <vector>

#include "surface.hpp"
#include "surface_source.hpp"

namespace pinball {

/// Which bodies hang together by common nodes, directly or over others. What lies near each other in such bodies was
/// put there by the mesh, as in one body.
class JoinedBodies {
 public:
  JoinedBodies() = default;  ///< no body is joined to another
  /// Of the elements that are alive.
  template <class S>
  JoinedBodies(const SurfaceSource<S>& source, const Surface& surface);

  /// The lowest of the bodies that hang together with this one.
  std::int32_t first(std::int32_t body) const { return first_.empty() ? body : first_[body]; }
  bool are_one(std::int32_t a, std::int32_t b) const { return first(a) == first(b); }
  std::size_t bytes() const { return first_.capacity() * sizeof(first_[0]); }

 private:
  std::vector<std::int32_t> first_;  ///< per body; empty: none is joined to another
};

}  // namespace pinball
