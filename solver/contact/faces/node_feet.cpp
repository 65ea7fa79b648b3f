#include "node_feet.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include <kernels/compress.hpp>
#include <kernels/face_projection.hpp>
#include <kernels/gather.hpp>

namespace pinball {

namespace {

/// Points of nodes as double numbers, whatever they are in.
template <class T, class S>
Vec3<T> points(const S* position, const std::int32_t* node) {
  if constexpr (std::is_same_v<S, ScalarOf<T>>) {
    return gather_vectors<T>(position, node);
  } else {
    constexpr int W = width_of<T>;
    alignas(64) double coordinate[3][W];
    for (int i = 0; i < W; ++i) {
      for (int c = 0; c < 3; ++c) coordinate[c][i] = record(position, node[i])[c];
    }
    return {load<T>(coordinate[0]), load<T>(coordinate[1]), load<T>(coordinate[2])};
  }
}

}  // namespace

double NodeFoot::distance() const { return std::sqrt(gap * gap + outside * outside); }

template <class S>
void find_near_nodes(const SurfaceSource<S>& source, const SegmentSurface<S>& surface,
                     const typename FeatureLists<S>::NodePairs& pairs, const ListPart& part, const StepReach& step,
                     std::vector<std::int32_t>& near) {
  using T = Pack<S, native_width<S>>;
  constexpr int W = width_of<T>;
  near.resize(part.pairs() + 3 * W);
  std::int32_t* end_of_near = near.data();
  for (std::int64_t place = part.begin / W * W; place < part.end; place += W) {
    T within = number<T>(near_gap) * load<T>(pairs.size.data() + place) + number<T>(step.approach);
    if (step.some_deep) {
      alignas(64) S deep[W];
      for (int i = 0; i < W; ++i) deep[i] = step.depth[pairs.node[place + i]];
      within = within + load<T>(deep);
    }
    const Vec3<T> x = gather_vectors<T>(source.position, pairs.node.data() + place);
    Vec3<T> centre, normal;
    T ball, warp;
    gather_records(surface.sphere().data(), pairs.second.data() + place, centre.x, centre.y, centre.z, ball);
    gather_records(surface.plane().data(), pairs.second.data() + place, normal.x, normal.y, normal.z, warp);
    const Vec3<T> d = x - centre;
    const T height = dot(d, normal);
    // From the ball, which holds what may touch at all, to the farthest corner and what counts as near.
    const T beside = ball - SegmentSurface<S>::deepest * load<T>(pairs.radius.data() + place) + within;
    unsigned bits =
        lane_bits<T>(ball > T(0) && dot(d, d) - height * height < beside * beside && absolute(height) < within + warp);
    if (place < part.begin) bits &= ~0U << (part.begin - place);
    if (place + W > part.end) bits &= (1U << (part.end - place)) - 1;
    end_of_near += write_numbers<W>(bits, place, end_of_near);
  }
  near.resize(end_of_near - near.data());
}

template <class S>
void find_feet(const SurfaceSource<S>& source, const SegmentSurface<S>& surface,
               const typename FeatureLists<S>::NodePairs& pairs, const std::vector<std::int32_t>& near,
               std::vector<NodeFoot>& feet) {
  using T = Pack<double, native_width<double>>;
  constexpr int W = width_of<T>;
  feet.clear();
  for (std::size_t first = 0; first < near.size(); first += W) {
    const int count = std::min<std::size_t>(W, near.size() - first);
    alignas(64) std::int32_t node[5][W];
    for (int i = 0; i < W; ++i) {
      const std::int32_t place = near[first + std::min(i, count - 1)];
      for (int k = 0; k < 4; ++k) node[k][i] = surface.segments()[pairs.second[place]].node[k];
      node[4][i] = pairs.node[place];
    }
    const auto point = [&](int k) { return points<T>(source.position, node[k]); };
    const Vec3<T> corner[4] = {point(0), point(1), point(2), point(3)};
    FaceProjection<T> at = foot_on_face(corner, point(4));
    move_to_nearest_side(corner, point(4), at);
    for (int i = 0; i < count; ++i) {
      const std::int32_t place = near[first + i];
      const double beyond = std::max(std::abs(lane(at.xi, i)), std::abs(lane(at.eta, i))) - 1;
      const NodeFoot foot{pairs.first[place],
                          pairs.second[place],
                          lane(at.gap, i),
                          lane(at.outside, i),
                          lane(at.outside, i) * std::max(0.0, 1 - edge_margin / beyond),
                          {lane(at.normal.x, i), lane(at.normal.y, i), lane(at.normal.z, i)},
                          {lane(at.weight[0], i), lane(at.weight[1], i), lane(at.weight[2], i), lane(at.weight[3], i)}};
      if (foot.outside < INFINITY) feet.push_back(foot);
    }
  }
}

#define PINBALL_INSTANTIATE(S)                                                                                        \
  template void find_near_nodes(const SurfaceSource<S>&, const SegmentSurface<S>&, const FeatureLists<S>::NodePairs&, \
                                const ListPart&, const StepReach&, std::vector<std::int32_t>&);                       \
  template void find_feet(const SurfaceSource<S>&, const SegmentSurface<S>&, const FeatureLists<S>::NodePairs&,       \
                          const std::vector<std::int32_t>&, std::vector<NodeFoot>&);
PINBALL_INSTANTIATE(double)
PINBALL_INSTANTIATE(float)
#undef PINBALL_INSTANTIATE

}  // namespace pinball
