#include "segment_surface.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

#include <kernels/exec.hpp>
#include <kernels/gather.hpp>
#include <kernels/hexahedron.hpp>
#include <solver/base/lists_in_order.hpp>

namespace pinball {

namespace {

/// Square of the area of a face of an undeformed element [length^4].
double squared_area(const ContactElement& element, int face) {
  Vec3<double> x[4];
  for (int i = 0; i < 4; ++i) {
    const Point& p = element.reference[face_nodes[face][i]];
    x[i] = {p[0], p[1], p[2]};
  }
  const Vec3<double> area = 0.5 * cross(x[2] - x[0], x[3] - x[1]);
  return dot(area, area);
}

}  // namespace

template <class S>
bool SegmentSurface<S>::remove_eroded(const std::vector<std::int64_t>& eroded) {
  just_changed_.clear();
  if (!topology_.remove_eroded(eroded)) return false;
  changed_ = true;
  for (const std::int32_t slot : topology_.rearranged()) {
    const auto by_slot = [](const Segment& segment, std::int32_t wanted) { return segment.slot < wanted; };
    auto segment = std::lower_bound(segments_.begin(), segments_.end(), slot, by_slot);
    for (; segment != segments_.end() && segment->slot == slot; ++segment) {
      const std::int32_t s = segment - segments_.begin();
      if (renew_activity(s)) just_changed_.push_back(s);
    }
  }
  for (const std::int32_t s : just_changed_) {
    for (const std::int32_t slave : slaves_of_[s]) update_slave(slave);
  }
  return true;
}

template <class S>
void SegmentSurface<S>::collect(const SurfaceSource<S>& source) {
  changed_ = false;
  collect_faces(source, exposed_and_waiting(source));
}

template <class S>
void SegmentSurface<S>::collect_faces(const SurfaceSource<S>& source, const std::vector<std::uint8_t>& faces) {
  collect_segments(source, faces);
  collect_slaves(source.node_count);

  constexpr std::size_t W = native_width<S>;
  const std::size_t padded = packs() * W;
  corner_.reset(4 * padded);
  active_.reset(padded);
  reach_.reset(padded);
  sphere_.reset(4 * padded);
  plane_.reset(4 * padded);
  parallel_for("corners of segments", RangePolicy<>{0, static_cast<std::int64_t>(padded)}, [&](std::int64_t place) {
    const std::size_t s = place;  // padding repeats the last segment
    const Segment& segment = segments_[std::min(s, segments_.size() - 1)];
    for (std::size_t i = 0; i < 4; ++i) corner_[(s / W * 4 + i) * W + s % W] = segment.node[i];
    reach_[s] = deepest * segment.radius;
    if (s < segments_.size()) active_[s] = exposed(segment.slot, segment.face) ? S(1) : S(0);
  });
  chosen_.resize(packs());
  std::iota(chosen_.begin(), chosen_.end(), 0);
  just_changed_.clear();
  active_segments_ = 0;
  parallel_reduce(
      "active segments", RangePolicy<>{0, std::ssize(segments_)}, active_segments_,
      [&](std::int64_t begin, std::int64_t end, std::int64_t& partial) {
        for (std::int64_t s = begin; s < end; ++s) partial += active_segment(static_cast<std::int32_t>(s)) ? 1 : 0;
      },
      [](std::int64_t& whole, std::int64_t partial) { whole += partial; });
  parallel_for("slaves", RangePolicy<>{0, std::ssize(slaves_)}, [&](std::int64_t slave) { update_slave(slave); });
}

template <class S>
void SegmentSurface<S>::finish_choice() {
  list_where("chosen segments", std::ssize(asked_for_), chosen_,
             [this](std::int64_t pack) { return asked_for_[pack] != 0; });
}

/// Per slot a bit for each face that is to be a segment.
template <class S>
std::vector<std::uint8_t> SegmentSurface<S>::exposed_and_waiting(const SurfaceSource<S>& source) const {
  std::vector<std::uint8_t> faces(topology_.slots());
  parallel_for("faces of a surface", RangePolicy<>{0, topology_.slots()}, [&](std::int64_t slot) {
    const std::uint8_t exposed = topology_.exposed(slot);
    if (exposed == 0) return;
    set_bits(faces[slot], exposed);
    if (!source.may_soon_erode(slot)) return;
    topology_.for_each_face_behind(slot, [&](std::int32_t behind, unsigned face) {
      set_bits(faces[behind], static_cast<std::uint8_t>(1U << face));
    });
  });
  return faces;
}

template <class S>
void SegmentSurface<S>::collect_segments(const SurfaceSource<S>& source, const std::vector<std::uint8_t>& faces) {
  std::vector<std::int32_t> slots;
  list_where("elements of a surface", std::ssize(faces), slots, [&](std::int64_t slot) { return faces[slot] != 0; });
  std::vector<std::int64_t> first(slots.size());
  constexpr std::uint8_t all_faces = 63;  // as spheres have them
  parallel_for("faces of elements", RangePolicy<>{0, std::ssize(slots)}, [&](std::int64_t i) {
    const std::int32_t slot = slots[i];
    const bool sphere = faces[slot] == all_faces && source.element(slot).sphere;
    first[i] = sphere ? 0 : std::popcount(faces[slot]);
  });
  segments_.resize(make_offsets(first));
  parallel_for("segments of elements", RangePolicy<>{0, std::ssize(slots)}, [&](std::int64_t i) {
    const std::int32_t slot = slots[i];
    const ContactElement element = source.element(slot);
    if (element.sphere) return;
    Segment* next = segments_.data() + first[i];
    for (int f = 0; f < 6; ++f) {
      if ((faces[slot] >> f & 1U) != 0) *next++ = segment_of(element, slot, f);
    }
  });
}

template <class S>
typename SegmentSurface<S>::Segment SegmentSurface<S>::segment_of(const ContactElement& element, std::int32_t slot,
                                                                  int face) {
  Segment segment{};
  for (int i = 0; i < 4; ++i) segment.node[i] = element.corners[face_nodes[face][i]];
  segment.slot = slot;
  segment.face = face;
  segment.body = element.body;
  segment.rigid = element.rigid;
  segment.corners = element.corners;
  segment.radius = static_cast<S>(element.radius);
  const double area2 = squared_area(element, face);
  segment.thickness = static_cast<S>(area2 > 0 ? element.volume / std::sqrt(area2) : 0.0);
  segment.size = area2 > 0 ? std::min(segment.radius, segment.thickness) : segment.radius;
  segment.stiffness = static_cast<S>(element.bulk_modulus * area2 / element.volume);
  return segment;
}

/// One slave per node, sorted by node, and the segments around it in their order.
template <class S>
void SegmentSurface<S>::collect_slaves(std::size_t nodes) {
  const RangePolicy<> all{0, std::ssize(segments_)};
  Array<std::int32_t> count(nodes), slave_of;
  slave_of.renew(nodes);
  std::vector<std::int32_t> nodes_of_slaves;
  parallel_for("segments around nodes", all, [&](std::int64_t s) {
    for (const std::int32_t node : segments_[s].node) count_one(count[node]);
  });
  list_where("nodes of a surface", static_cast<std::int64_t>(nodes), nodes_of_slaves,
             [&](std::int64_t node) { return count[node] != 0; });
  slaves_.resize(nodes_of_slaves.size());
  around_first_.resize(slaves_.size() + 1);
  const RangePolicy<> all_slaves{0, std::ssize(slaves_)};
  parallel_for("nodes of slaves", all_slaves, [&](std::int64_t i) {
    const std::int32_t node = nodes_of_slaves[i];
    slaves_[i] = {node, 0, 0, S(0), S(0), S(0)};
    slave_of[node] = static_cast<std::int32_t>(i);
    around_first_[i] = count[node];
  });
  around_first_.back() = 0;
  around_.resize(make_offsets(around_first_));
  parallel_for("places around slaves", all_slaves, [&](std::int64_t i) { count[slaves_[i].node] = around_first_[i]; });
  slaves_of_.resize(segments_.size());
  parallel_for("segments around slaves", all, [&](std::int64_t segment) {
    const auto s = static_cast<std::int32_t>(segment);
    for (std::size_t k = 0; k < 4; ++k) {
      const std::int32_t node = segments_[s].node[k];
      around_[count_one(count[node])] = s;
      slaves_of_[s][k] = slave_of[node];
    }
  });
  parallel_for("owners of slaves", all_slaves, [&](std::int64_t i) {
    std::sort(around_.begin() + around_first_[i], around_.begin() + around_first_[i + 1]);
    slaves_[i].owner = around(i).front();
    slaves_[i].body = segments_[slaves_[i].owner].body;
  });
}

template <class S>
bool SegmentSurface<S>::renew_activity(std::int32_t segment) {
  const bool is = exposed(segments_[segment].slot, segments_[segment].face), was = active_segment(segment);
  active_[segment] = is ? S(1) : S(0);
  active_segments_ += static_cast<int>(is) - static_cast<int>(was);
  return is != was;
}

/// What the active segments give to a slave is added up in their order.
template <class S>
void SegmentSurface<S>::update_slave(std::size_t number) {
  Slave& slave = slaves_[number];
  slave.share = slave.radius = slave.stiffness = S(0);
  slave.owner = around(number).front();
  for (const std::int32_t s : around(number)) {
    if (!active_segment(s)) continue;
    if (!active(number)) slave.owner = s;
    slave.share += S(0.25);
    slave.radius += segments_[s].radius;
    slave.stiffness += S(0.25) * segments_[s].stiffness;
  }
  if (active(number)) slave.radius /= S(4) * slave.share;
}

template <class S>
bool SegmentSurface<S>::faces(std::size_t slave, const Vec3<S>& normal) const {
  for (std::int32_t a = around_first_[slave]; a < around_first_[slave + 1]; ++a) {
    const S* own = record(plane_.data(), around_[a]);
    if (own[0] * normal.x + own[1] * normal.y + own[2] * normal.z < S(-0.5)) return true;
  }
  return false;
}

template <class S>
bool SegmentSurface<S>::beside(std::span<const std::int32_t> some, std::span<const std::int32_t> others) const {
  for (const std::int32_t a : some) {
    for (const std::int32_t b : others) {
      if (active_segment(a) && active_segment(b) && share_corner(segments_[a].corners, segments_[b].corners))
        return true;
    }
  }
  return false;
}

template <class S>
void SegmentSurface<S>::update(const SurfaceSource<S>& source) {
  using T = Pack<S, native_width<S>>;
  constexpr int W = width_of<T>;
  parallel_for("segments", RangePolicy<>{0, std::ssize(chosen_)}, [&](std::int64_t p) {
    const std::int64_t pack = chosen_[p];
    Vec3<T> x[4];
    for (int i = 0; i < 4; ++i) {
      x[i] = gather_vectors<T>(source.position, corner_.data() + (pack * 4 + i) * W);
    }
    const Vec3<T> centre = number<T>(0.25) * (x[0] + x[1] + x[2] + x[3]);
    T farthest2(0);
    for (const Vec3<T>& corner : x) farthest2 = maximum(farthest2, dot(corner - centre, corner - centre));
    const Vec3<T> area = cross(x[2] - x[0], x[3] - x[1]);
    const T size2 = dot(area, area);
    const T active = load<T>(active_.data() + pack * W);
    const Vec3<T> normal = select(size2 > T(0), active / square_root(size2), T(0)) * area;
    const T reach = active * (square_root(farthest2) + load<T>(reach_.data() + pack * W));
    const T warp = absolute(dot(x[0] - centre, normal));  // the same at all corners, but for its sign
    for (int i = 0; i < W; ++i) {
      S* flat = record(plane_.data(), pack * W + i);
      flat[0] = lane(normal.x, i);
      flat[1] = lane(normal.y, i);
      flat[2] = lane(normal.z, i);
      flat[3] = lane(warp, i);
      S* sphere = record(sphere_.data(), pack * W + i);
      sphere[0] = lane(centre.x, i);
      sphere[1] = lane(centre.y, i);
      sphere[2] = lane(centre.z, i);
      sphere[3] = lane(reach, i);
    }
  });
}

/// Which faces wait was decided when they were collected: they are not what would wait now.
template <class S>
void SegmentSurface<S>::persist(StateArchive& archive, const SurfaceSource<S>& source) {
  topology_.persist(archive, source);
  std::vector<std::uint8_t> faces(topology_.slots());
  for (const Segment& s : segments_) {
    faces[s.slot] |= 1U << static_cast<unsigned>(s.face);
  }
  archive.of_fixed_size(faces);
  for (std::size_t slot = 0; archive.reads() && slot < faces.size(); ++slot) {
    archive.require(faces[slot] == 0 || (faces[slot] < 64 && source.is_element(slot) && !source.element(slot).sphere));
  }
  if (archive.reads()) collect_faces(source, faces);
  archive(chosen_, changed_);
  archive.require_all(chosen_, 0, packs());
}

template <class S>
std::vector<std::int32_t> SegmentSurface<S>::nodes() const {
  std::vector<std::int32_t> nodes(slaves_.size());
  parallel_for("nodes of slaves", RangePolicy<>{0, std::ssize(nodes)},
               [&](std::int64_t i) { nodes[i] = slaves_[i].node; });
  return nodes;
}

template <class S>
std::int64_t SegmentSurface<S>::chosen() const {
  return std::ssize(chosen_) * native_width<S>;
}

template <class S>
std::size_t SegmentSurface<S>::bytes() const {
  return topology_.bytes() + segments_.capacity() * sizeof(Segment) + slaves_.capacity() * sizeof(Slave) +
         (around_.capacity() + around_first_.capacity() + chosen_.capacity() + 4 * slaves_of_.capacity()) * 4 +
         corner_.bytes() + active_.bytes() + reach_.bytes() + sphere_.bytes() + plane_.bytes();
}

template class SegmentSurface<double>;
template class SegmentSurface<float>;

}  // namespace pinball
