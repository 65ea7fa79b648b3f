#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <nanoflann.hpp>
#include <utility>
#include <vector>

#include <solver/mesh.hpp>

/// The pairs of a contact search as one makes them with nanoflann, a library of k-d trees: an index over all centres,
/// and a search around each of them. What to compare the search of pinballs with.
namespace pinball::bench {

class NanoflannPairs {
 public:
  using Pair = std::pair<std::int32_t, std::int32_t>;

  /// centres and body outlive the object. leaf: most points in a leaf of the tree.
  NanoflannPairs(const std::vector<Point>& centres, const std::vector<int>& body, int leaf)
      : points_{centres}, body_(body), leaf_(static_cast<std::size_t>(leaf)) {}

  /// Finds the pairs of different bodies that are nearer to each other than `reach`, each once.
  void build(double reach, int threads) {
    // The same way for the tree and for whoever asks it: points are not copied, the loop over axes has a fixed length.
    using Tree =
        nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Points>, Points, 3, std::uint32_t>;
    Tree tree(3, points_, nanoflann::KDTreeSingleIndexAdaptorParams(leaf_));
    const auto count = static_cast<std::int64_t>(points_.centres.size());
#pragma omp parallel for num_threads(threads) schedule(static)
    for (int piece = 0; piece < pieces; ++piece) {
      std::vector<Pair>& found = found_[static_cast<std::size_t>(piece)];
      found.clear();
      const auto end = static_cast<std::int32_t>(count * (piece + 1) / pieces);
      for (auto i = static_cast<std::int32_t>(count * piece / pieces); i < end; ++i) {
        Near near{reach * reach, i, body_, found};
        tree.findNeighbors(near, points_.centres[static_cast<std::size_t>(i)].data(), {});
      }
    }
  }

  std::int64_t pairs() const {
    std::size_t sum = 0;
    for (const std::vector<Pair>& found : found_) sum += found.size();
    return static_cast<std::int64_t>(sum);
  }

 private:
  static constexpr int pieces = 64;  // as in the list of pinballs (PairList)

  /// What nanoflann asks of a set of points.
  struct Points {
    const std::vector<Point>& centres;
    std::size_t kdtree_get_point_count() const { return centres.size(); }
    double kdtree_get_pt(std::size_t i, std::size_t axis) const { return centres[i][axis]; }
    template <class Box>
    bool kdtree_get_bbox(Box&) const {
      return false;
    }
  };

  /// What nanoflann asks of a result. It takes pairs as they are found, which is faster than the library's own
  /// RadiusResultSet (indices and distances of both halves of every pair, looked through afterwards).
  struct Near {
    double reach2;
    std::int32_t i;
    const std::vector<int>& body;
    std::vector<Pair>& found;

    bool addPoint(double, std::uint32_t index) const {
      const auto j = static_cast<std::int32_t>(index);
      if (j > i && body[static_cast<std::size_t>(j)] != body[static_cast<std::size_t>(i)]) found.emplace_back(i, j);
      return true;
    }
    double worstDist() const { return reach2; }
    std::size_t size() const { return found.size(); }
    bool full() const { return true; }
    void sort() const {}
  };

  Points points_;
  const std::vector<int>& body_;
  std::size_t leaf_;
  std::array<std::vector<Pair>, pieces> found_;
};

}  // namespace pinball::bench
