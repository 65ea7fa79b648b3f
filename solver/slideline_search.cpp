#include <algorithm>
#include <pinball/kernels/exec.hpp>
#include <pinball/solver/slideline_search.hpp>

namespace pinball {

template <class S>
SlidelineSearch<S>::SlidelineSearch(const Model<S>& model)
    : self_(model.scene.contact.self),
      reference_node_(model.node_mass.size()),
      reference_centre_(static_cast<std::size_t>(model.elements.slots)) {
  const auto in_float = [](const Point& p) {
    return std::array<float, 3>{static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])};
  };
  for (std::size_t n = 0; n < model.mesh.nodes.size(); ++n) {
    reference_node_[static_cast<std::size_t>(model.node_of_scene_node[n])] = in_float(model.mesh.nodes[n]);
  }
  for (std::size_t e = 0; e < model.mesh.hexahedra.size(); ++e) {
    reference_centre_[static_cast<std::size_t>(model.slot_of_element[e])] = in_float(element_centre(model.mesh, e));
  }
}

/// A node touches a segment of its own body only if they were well apart at first: what is near was kept apart by the
/// mesh.
template <class S>
bool SlidelineSearch<S>::may_touch(const SlidelineSurface<S>& surface, std::size_t slave, std::size_t segment) const {
  const auto& own = surface.slaves()[slave];
  const auto& other = surface.segments()[segment];
  if (own.body != other.body) return true;
  if (!self_) return false;
  const std::array<float, 3>& p = reference_node_[static_cast<std::size_t>(own.node)];
  const std::array<float, 3>& q = reference_centre_[static_cast<std::size_t>(other.slot)];
  float d2 = 0;
  for (std::size_t k = 0; k < 3; ++k) d2 += (p[k] - q[k]) * (p[k] - q[k]);
  // Two and a half elements: from a node of a cube to the centre of the one after the next.
  const auto apart = 2.0F * static_cast<float>(own.radius + other.radius);
  return d2 > apart * apart;
}

template <class S>
void SlidelineSearch<S>::build(const Model<S>& model, const SlidelineSurface<S>& surface, S skin) {
  const auto& segments = surface.segments();
  const auto& slaves = surface.slaves();
  const auto n = static_cast<std::int32_t>(segments.size());
  const auto size = segments.size();
  const S* sphere = surface.sphere().data();
  skin_ = skin;
  valid_ = true;
  start_.assign(slaves.size() + 1, 0);
  candidate_.clear();
  node_at_.resize(3 * slaves.size());
  reach_at_.resize(size);
  if (n == 0) return;

  S largest = 0;
  for (std::size_t s = 0; s < size; ++s) {
    reach_at_[s] = sphere[4 * s + 3];
    largest = std::max(largest, reach_at_[s]);
  }
  const double cell_size = static_cast<double>(largest + skin) * 1.000001;
  int bits = 1;
  while ((std::int64_t(1) << bits) < 2 * std::int64_t(n) && bits < 30) ++bits;
  bucket_start_.resize((std::size_t(1) << bits) + 1);
  entry_cell_.resize(size);
  entry_point_.resize(size);
  entry_record_.resize(4 * size);
  cell_.resize(size);
  const SpatialHashView<S> hash{
      {{static_cast<double>(sphere[0]), static_cast<double>(sphere[1]), static_cast<double>(sphere[2])},
       1.0 / cell_size},
      bits,
      bucket_start_.data(),
      entry_cell_.data(),
      entry_point_.data(),
      entry_record_.data()};
  build_spatial_hash(hash, sphere, n, cell_.data());

  // Slaves are worked in fixed pieces, each with a list of its own; the lists are joined in order.
  constexpr std::int64_t pieces = 64;
  const auto count = static_cast<std::int64_t>(slaves.size());
  std::array<std::vector<std::int32_t>, pieces> found;
  parallel_for("slave candidates", RangePolicy<>{0, pieces}, [&](std::int64_t piece) {
    std::vector<std::int32_t>& list = found[static_cast<std::size_t>(piece)];
    for (auto i = static_cast<std::size_t>(count * piece / pieces);
         i < static_cast<std::size_t>(count * (piece + 1) / pieces); ++i) {
      const S* x = model.nodes.position.data() + 4 * static_cast<std::int64_t>(slaves[i].node);
      std::copy(x, x + 3, &node_at_[3 * i]);
      const auto before = list.size();
      for_each_near(hash, x, [&](std::int32_t s, const S* record) {
        const S a = x[0] - record[0], b = x[1] - record[1], c = x[2] - record[2];
        const S reach = record[3] + skin;
        if (a * a + b * b + c * c < reach * reach && may_touch(surface, i, static_cast<std::size_t>(s))) {
          list.push_back(s);
        }
      });
      start_[i + 1] = static_cast<std::int64_t>(list.size() - before);
    }
  });
  for (std::size_t i = 0; i < slaves.size(); ++i) start_[i + 1] += start_[i];
  candidate_.reserve(static_cast<std::size_t>(start_.back()));
  for (const std::vector<std::int32_t>& list : found) candidate_.insert(candidate_.end(), list.begin(), list.end());
}

template <class S>
bool SlidelineSearch<S>::holds(const Model<S>& model, const SlidelineSurface<S>& surface) const {
  if (!valid_) return false;
  // A node and the centre of a segment may each have moved as far as the farthest node; the segment may have grown.
  S moved2 = 0, grown = 0;
  const auto larger = [](S& whole, const S& partial) { whole = whole < partial ? partial : whole; };
  const auto& slaves = surface.slaves();
  parallel_reduce(
      "distance moved", RangePolicy<>{0, static_cast<std::int64_t>(slaves.size())}, moved2,
      [&](std::int64_t begin, std::int64_t end, S& largest) {
        for (std::int64_t i = begin; i < end; ++i) {
          const S* x =
              model.nodes.position.data() + 4 * static_cast<std::int64_t>(slaves[static_cast<std::size_t>(i)].node);
          S d2 = 0;
          for (std::int64_t k = 0; k < 3; ++k) {
            const S d = x[k] - node_at_[static_cast<std::size_t>(3 * i + k)];
            d2 += d * d;
          }
          larger(largest, d2);
        }
      },
      larger);
  const S* sphere = surface.sphere().data();
  parallel_reduce(
      "growth of segments", RangePolicy<>{0, static_cast<std::int64_t>(reach_at_.size())}, grown,
      [&](std::int64_t begin, std::int64_t end, S& largest) {
        for (std::int64_t s = begin; s < end; ++s) {
          larger(largest, sphere[4 * s + 3] - reach_at_[static_cast<std::size_t>(s)]);
        }
      },
      larger);
  const S left = skin_ - grown;
  return left >= S(0) && S(4) * moved2 <= left * left;
}

template <class S>
std::size_t SlidelineSearch<S>::bytes() const {
  const auto of = [](const auto& v) { return v.capacity() * sizeof(v[0]); };
  return of(reference_node_) + of(reference_centre_) + of(start_) + of(candidate_) + of(node_at_) + of(reach_at_) +
         of(bucket_start_) + of(entry_point_) + of(entry_cell_) + of(cell_) + of(entry_record_);
}

template class SlidelineSearch<double>;
template class SlidelineSearch<float>;

}  // namespace pinball
