#pragma once

#include "collapsed_case.hpp"

/// Wedges that are listed in all the ways that there are.
namespace pinball::test {

inline constexpr int mixed_layout = 6;

/// The same elements; way: 0 to 5, or mixed_layout for one after the other: which node of the first triangle of each
/// wedge is its third, and from 3 on with the triangles exchanged, so that the third comes first.
inline HostMesh listed(HostMesh mesh, int way) {
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    Corners8& c = mesh.elements[e];
    if (c[2] != c[3] || c[6] != c[7] || different_nodes(c) != 6) continue;
    const int own = way == mixed_layout ? static_cast<int>(7 * e % 6) : way;
    const std::array<std::int32_t, 3> below{c[0], c[1], c[2]}, above{c[4], c[5], c[6]};
    const auto node = [own](const std::array<std::int32_t, 3>& of, int i) { return of[(own + i) % 3]; };
    c = own < 3 ? wedge(node(below, 0), node(below, 1), node(below, 2), node(above, 0), node(above, 1), node(above, 2))
                : wedge(node(above, 2), node(above, 1), node(above, 0), node(below, 2), node(below, 1), node(below, 0));
  }
  return mesh;
}

}  // namespace pinball::test
