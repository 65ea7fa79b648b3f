#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <pinball/solver/error.hpp>
#include <pinball/solver/faces.hpp>

namespace pinball {
namespace {

using Hexahedron = std::array<std::int32_t, 8>;

/// A face without regard to its orientation. `slot` = 6 * element + local face.
struct Face {
  std::array<std::int32_t, 4> nodes;  // ascending
  std::int32_t slot;
};

std::int32_t lowest_node(const Hexahedron& hexahedron, int face) {
  const auto& local = face_nodes[face];
  return std::min({hexahedron[local[0]], hexahedron[local[1]], hexahedron[local[2]], hexahedron[local[3]]});
}

Face sorted_face(const Hexahedron& hexahedron, std::int32_t slot) {
  Face face{{}, slot};
  auto& n = face.nodes;
  for (int i = 0; i < 4; ++i) n[i] = hexahedron[face_nodes[slot % 6][i]];
  const auto order = [&](int a, int b) {
    if (n[a] > n[b]) std::swap(n[a], n[b]);
  };
  order(0, 1), order(2, 3), order(0, 2), order(1, 3), order(1, 2);
  return face;
}

std::int32_t checked_node_count(const std::vector<Hexahedron>& hexahedra) {
  std::int32_t highest = -1;
  for (std::size_t element = 0; element < hexahedra.size(); ++element)
    for (const std::int32_t node : hexahedra[element]) {
      if (node < 0 || node == std::numeric_limits<std::int32_t>::max())
        throw InputError(fmt::format("mesh: element {}: node index {} is out of range", element, node));
      highest = std::max(highest, node);
    }
  return highest + 1;
}

}  // namespace

std::vector<std::array<std::int32_t, 6>> face_neighbours(const std::vector<Hexahedron>& hexahedra) {
  if (hexahedra.size() > static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max()) / 6)
    throw InputError(fmt::format("mesh: {} elements are more than face numbers can count", hexahedra.size()));
  const auto element_count = static_cast<std::int32_t>(hexahedra.size());
  const std::int32_t node_count = checked_node_count(hexahedra);

  // Counting sort of all faces by their lowest node: the two sides of a face fall into one short bucket.
  std::vector<std::int32_t> bucket_begin(static_cast<std::size_t>(node_count) + 2, 0);
  for (const Hexahedron& hexahedron : hexahedra)
    for (int face = 0; face < 6; ++face) ++bucket_begin[lowest_node(hexahedron, face) + 2];
  for (std::size_t i = 2; i < bucket_begin.size(); ++i) bucket_begin[i] += bucket_begin[i - 1];
  std::vector<std::int32_t> slots(static_cast<std::size_t>(element_count) * 6);
  for (std::int32_t element = 0; element < element_count; ++element)
    for (int face = 0; face < 6; ++face)  // counted two places on: filling a bucket moves its begin into place
      slots[bucket_begin[lowest_node(hexahedra[element], face) + 1]++] = 6 * element + face;

  std::vector<std::array<std::int32_t, 6>> neighbours(hexahedra.size(), {-1, -1, -1, -1, -1, -1});
  std::vector<Face> bucket;
  for (std::int32_t node = 0; node < node_count; ++node) {
    bucket.clear();
    for (std::int32_t i = bucket_begin[node]; i < bucket_begin[node + 1]; ++i)
      bucket.push_back(sorted_face(hexahedra[slots[i] / 6], slots[i]));
    std::sort(bucket.begin(), bucket.end(),
              [](const Face& a, const Face& b) { return a.nodes != b.nodes ? a.nodes < b.nodes : a.slot < b.slot; });
    for (std::size_t i = 0; i + 1 < bucket.size(); ++i) {
      if (bucket[i].nodes != bucket[i + 1].nodes) continue;
      const std::int32_t first = bucket[i].slot, second = bucket[i + 1].slot;
      if (first / 6 == second / 6)
        throw InputError(fmt::format("mesh: element {} has two faces with the same nodes", first / 6));
      if (i + 2 < bucket.size() && bucket[i + 2].nodes == bucket[i].nodes)
        throw InputError(
            fmt::format("mesh: element {} shares a face with elements {} and {}; a face has at most two sides",
                        bucket[i + 2].slot / 6, first / 6, second / 6));
      neighbours[first / 6][first % 6] = second / 6;
      neighbours[second / 6][second % 6] = first / 6;
      ++i;
    }
  }
  return neighbours;
}

}  // namespace pinball
