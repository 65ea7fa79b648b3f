#include "faces.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "error.hpp"
#include "message.hpp"

namespace pinball {
namespace {

using Hexahedron = std::array<std::int32_t, 8>;

/// A face without regard to its orientation, in the bucket of its lowest node. `slot` = 6 * element + local face.
/// A triangle has its highest node twice, wherever the face it was collapsed from repeats one.
struct Face {
  std::uint64_t highest_nodes;  // the highest node times 2^32, plus the second highest
  std::int32_t low_node;        // the second lowest node
  std::int32_t slot;

  bool same_nodes(const Face& other) const {
    return highest_nodes == other.highest_nodes && low_node == other.low_node;
  }
  bool operator<(const Face& other) const {
    if (highest_nodes != other.highest_nodes) return highest_nodes < other.highest_nodes;
    return low_node != other.low_node ? low_node < other.low_node : slot < other.slot;
  }
};

/// Distinct nodes of a face: 4 of a quadrilateral, 3 of a triangle, fewer where nothing of its area is left.
int distinct_nodes(const Hexahedron& hexahedron, int face) {
  const auto& local = face_nodes[face];
  int count = 0;
  for (int i = 0; i < 4; ++i) {
    bool is_new = true;
    for (int j = 0; j < i; ++j) is_new = is_new && hexahedron[local[i]] != hexahedron[local[j]];
    count += is_new;
  }
  return count;
}

/// Throws InputError where a face with area has the same node at both ends of a diagonal: it is folded.
void check_diagonals(const Hexahedron& hexahedron, std::size_t element) {
  for (int face = 0; face < 6; ++face) {
    const auto& local = face_nodes[face];
    for (int i = 0; i < 2; ++i)
      if (hexahedron[local[i]] == hexahedron[local[i + 2]] && distinct_nodes(hexahedron, face) == 3)
        throw InputError(message_of("mesh: element ", element, ": node ", hexahedron[local[i]],
                                    " is at two opposite corners of a face"));
  }
}

std::int32_t lowest_node(const Hexahedron& hexahedron, int face) {
  const auto& local = face_nodes[face];
  return std::min({hexahedron[local[0]], hexahedron[local[1]], hexahedron[local[2]], hexahedron[local[3]]});
}

Face keyed_face(const Hexahedron& hexahedron, std::int32_t slot) {
  const auto& local = face_nodes[slot % 6];
  const auto [low1, high1] = std::minmax(hexahedron[local[0]], hexahedron[local[1]]);
  const auto [low2, high2] = std::minmax(hexahedron[local[2]], hexahedron[local[3]]);
  std::int32_t second = std::max(low1, low2), third = std::min(high1, high2);
  if (third < second) std::swap(second, third);
  const std::int32_t lowest = std::min(low1, low2), highest = std::max(high1, high2);
  // The sorted nodes of a triangle are aabc, abbc or abcc; all become abcc.
  if (second == lowest) second = third;
  if (second == third) third = highest;
  return {static_cast<std::uint64_t>(highest) << 32 | static_cast<std::uint64_t>(third), second, slot};
}

bool have_same_nodes(Hexahedron a, Hexahedron b) {
  std::sort(a.begin(), a.end());
  std::sort(b.begin(), b.end());
  return a == b;
}

/// Throws InputError where two elements of the same nodes are each other's neighbours: nothing would be exposed.
void check_twins(const std::vector<Hexahedron>& hexahedra, const std::vector<std::array<std::int32_t, 6>>& neighbours) {
  for (std::size_t element = 0; element < neighbours.size(); ++element) {
    const std::array<std::int32_t, 6>& beyond = neighbours[element];
    for (std::size_t face = 1; face < 6; ++face) {
      const std::int32_t other = beyond[face];
      if (other < 0 || std::find(beyond.begin(), beyond.begin() + face, other) == beyond.begin() + face) continue;
      if (have_same_nodes(hexahedra[element], hexahedra[other]))
        throw InputError(message_of("mesh: elements ", element, " and ", other, " have the same nodes"));
    }
  }
}

std::int32_t checked_node_count(const std::vector<Hexahedron>& hexahedra) {
  std::int32_t highest = -1;
  for (std::size_t element = 0; element < hexahedra.size(); ++element)
    for (const std::int32_t node : hexahedra[element]) {
      if (node < 0 || node == std::numeric_limits<std::int32_t>::max())
        throw InputError(message_of("mesh: element ", element, ": node index ", node, " is out of range"));
      highest = std::max(highest, node);
    }
  for (std::size_t element = 0; element < hexahedra.size(); ++element) check_diagonals(hexahedra[element], element);
  return highest + 1;
}

}  // namespace

std::vector<std::array<std::int32_t, 6>> face_neighbours(const std::vector<Hexahedron>& hexahedra) {
  if (hexahedra.size() > static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max()) / 6)
    throw InputError(message_of("mesh: ", hexahedra.size(), " elements are more than face numbers can count"));
  const std::int32_t element_count = hexahedra.size();
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
    for (std::int32_t i = bucket_begin[node]; i < bucket_begin[node + 1]; ++i) {
      const std::int32_t element = slots[i] / 6, face = slots[i] % 6;
      if (distinct_nodes(hexahedra[element], face) < 3) {
        neighbours[element][face] = collapsed_face;
      } else {
        bucket.push_back(keyed_face(hexahedra[element], slots[i]));
      }
    }
    std::sort(bucket.begin(), bucket.end());
    for (std::size_t i = 0; i + 1 < bucket.size(); ++i) {
      if (!bucket[i].same_nodes(bucket[i + 1])) continue;
      const std::int32_t first = bucket[i].slot, second = bucket[i + 1].slot;
      if (first / 6 == second / 6)
        throw InputError(message_of("mesh: element ", first / 6, " has two faces with the same nodes"));
      if (i + 2 < bucket.size() && bucket[i].same_nodes(bucket[i + 2]))
        throw InputError(message_of("mesh: element ", bucket[i + 2].slot / 6, " shares a face with elements ",
                                    first / 6, " and ", second / 6, "; a face has at most two sides"));
      neighbours[first / 6][first % 6] = second / 6;
      neighbours[second / 6][second % 6] = first / 6;
      ++i;
    }
  }
  check_twins(hexahedra, neighbours);
  return neighbours;
}

}  // namespace pinball
