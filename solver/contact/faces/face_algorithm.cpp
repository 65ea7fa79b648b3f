#include "face_algorithm.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include <kernels/exec.hpp>
#include <solver/base/lists_in_order.hpp>
#include <solver/contact/impulses/rows_of_lists.hpp>

namespace pinball {

namespace {

constexpr int searches_per_collection = 4;

/// Depth of a row, over the size of its segment, from which on it is noted: what is less deep is found in any case.
constexpr double worth_noting = 0.05;
static_assert(worth_noting < deepest_edges && worth_noting < near_gap);

/// Depth at which nodes of bodies that overlap at the start are found, over the size of a segment around them.
constexpr double deepest_at_start = 0.3;

/// Lists are built for leaps of so many times those that ask for them: motions that set out slowly become faster.
constexpr double margin_of_leaps = 2;

/// Pairs of a part of a list where several processes share it: so few that each gets about as many.
constexpr std::int64_t most_pairs_of_part = 256;

/// Bounds of velocities [length/time].
struct VelocityBox {
  Vec3<double> low{HUGE_VAL, HUGE_VAL, HUGE_VAL}, high{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
  void take(const VelocityBox& other) {
    low = {std::min(low.x, other.low.x), std::min(low.y, other.low.y), std::min(low.z, other.low.z)};
    high = {std::max(high.x, other.high.x), std::max(high.y, other.high.y), std::max(high.z, other.high.z)};
  }
};

/// The way that some of these nodes can make towards each other within a step, or towards one that is at rest
/// [length].
template <class S>
double largest_approach(const SurfaceSource<S>& source, const std::vector<std::int32_t>& nodes, double dt,
                        bool one_rests = false) {
  if (nodes.empty()) return 0;
  VelocityBox box;
  if (one_rests) box.take({{0, 0, 0}, {0, 0, 0}});
  parallel_reduce(
      "velocities", RangePolicy<>{0, std::ssize(nodes)}, box,
      [&](std::int64_t begin, std::int64_t end, VelocityBox& partial) {
        for (std::int64_t i = begin; i < end; ++i) {
          const Vec3<double> v = double_vector_of(source.v(nodes[i]));
          partial.take({v, v});
        }
      },
      [](VelocityBox& whole, const VelocityBox& partial) { whole.take(partial); });
  const Vec3<double> most = box.high - box.low;
  return std::sqrt(dot(most, most)) * dt;
}

}  // namespace

template <class S>
FaceAlgorithm<S>::FaceAlgorithm(const ContactSettings& settings, const SurfaceSource<S>& source, InitialSurface start)
    : ContactAlgorithm<S>(settings, source, start),
      surface_(source, std::move(start.topology)),
      spheres_(source, surface_.topology()),
      depth_(source.node_count, 0) {
  edges_.collect(surface_);
  lists_.set_pairs(this->pairs_.get());
  // Bodies that overlap from the start come no nearer.
  for (const auto& slave : surface_.slaves()) {
    deep_.push_back(slave.node);
    const double size = surface_.segments()[slave.owner].size;
    depth_[slave.node] = static_cast<float>(deepest_at_start * size);
  }
}

template <class S>
void FaceAlgorithm<S>::update_surface(const SurfaceSource<S>& source, const std::vector<std::int64_t>& eroded) {
  if (surface_.remove_eroded(eroded)) {
    if (!surface_.complete()) {
      lists_.invalidate();
      return;  // the search collects it anew
    }
    if (lists_.follow_erosion(surface_, edges_, spheres_)) choose_more();
  }
  surface_.update(source);
}

template <class S>
void FaceAlgorithm<S>::search(const SurfaceSource<S>& source, double dt) {
  const bool reuse = source.lists_last;
  const double ahead = std::max(dt, this->coming_.dt), leap = this->leap(source, ahead);
  if (this->may_keep_lists(source) && lists_.reach(static_cast<S>(this->coming_.dt), static_cast<S>(leap))) {
    const bool hold = lists_hold(source), follow = !hold && follow_strays(source);
    if (hold || follow) {
      ++this->searches_skipped_;
      return;
    }
  }
  source.before_search();
  ++this->searches_;
  // Now and then those behind the new surface are to wait: each collection costs as much as a search.
  if (surface_.changed() && (!surface_.complete() || ++searches_since_ >= searches_per_collection)) {
    searches_since_ = 0;
    surface_.collect(source);
    edges_.collect(surface_);
    lists_.invalidate();
  }
  lists_.build(source, surface_, edges_, spheres_, this->settings_, depth_, static_cast<S>(ahead),
               static_cast<S>(margin_of_leaps * leap), reuse);
  this->lists_outdated_ = false;
  kernels_outdated_ = true;
  choose_listed();
  surface_.update(source);
}

template <class S>
bool FaceAlgorithm<S>::work_with(std::unique_ptr<PinballKernels<S>>& kernels) {
  if (spheres_.count() != 0) return false;
  kernels_ = std::move(kernels);
  return true;
}

template <class S>
bool FaceAlgorithm<S>::lists_hold(const SurfaceSource<S>& source) {
  if (!kernels_) return lists_.holds(source);
  if (!lists_.may_hold()) return false;
  if (kernels_outdated_) {
    PinballArrays<S> arrays;
    arrays.expected = lists_.expected();
    kernels_->take(arrays);
    kernels_outdated_ = false;
  }
  return !kernels_->any_strays(source.nodes(false), lists_.elapsed());
}

template <class S>
bool FaceAlgorithm<S>::follow_strays(const SurfaceSource<S>& source) {
  source.before_following();
  kernels_outdated_ = true;
  if (!lists_.follow_strays(source, surface_, edges_, spheres_, depth_)) return false;
  if (lists_.more_nodes().pieces.entries + lists_.more_edges().pieces.entries > 0) {
    choose_more();
    surface_.update(source);
  }
  return true;
}

template <class S>
void FaceAlgorithm<S>::list_slave(std::int32_t slave) {
  if (adds_to_choice_ && listed_slave_[slave] == 0) listed_nodes_.push_back(surface_.slaves()[slave].node);
  set_mark(listed_slave_[slave]);
}

template <class S>
void FaceAlgorithm<S>::choose_edge(std::int32_t edge) {
  for (const std::int32_t s : edges_.segments_of(edge)) surface_.choose(s);
  for (const std::int32_t slave : edges_.edges()[edge].slave) {
    list_slave(slave);
    read_around(slave);
  }
}

template <class S>
void FaceAlgorithm<S>::choose_node(std::int32_t slave) {
  surface_.choose_around(slave);
  list_slave(slave);
  read_around(slave);
}

template <class S>
void FaceAlgorithm<S>::choose_face(std::int32_t segment) {
  surface_.choose(segment);
  for (const std::int32_t slave : surface_.slaves_of(segment)) list_slave(slave);
  read_corners(segment);
}

template <class S>
void FaceAlgorithm<S>::read_corners(std::int32_t segment) {
  if (!kernels_) return;
  for (const std::int32_t slave : surface_.slaves_of(segment)) set_mark(read_slave_[slave]);
}

template <class S>
void FaceAlgorithm<S>::read_around(std::int32_t slave) {
  if (!kernels_) return;
  for (const std::int32_t segment : surface_.around(slave)) read_corners(segment);
}

template <class S>
void FaceAlgorithm<S>::choose_listed() {
  surface_.choose_none();
  listed_slave_.assign(surface_.slaves().size(), 0);
  if (kernels_) read_slave_.assign(surface_.slaves().size(), 0);
  const auto for_each_new = [](const std::vector<std::int32_t>& list, const auto& work) {
    for_all_of("chosen of lists", std::ssize(list), std::ssize(list), [&](std::int64_t i) {
      if (i == 0 || list[i] != list[i - 1]) work(list[i]);
    });
  };
  for_each_new(lists_.nodes().second, [this](std::int32_t segment) { choose_face(segment); });
  for_each_new(lists_.nodes().first, [this](std::int32_t slave) { choose_node(slave); });
  for_each_new(lists_.edges().first, [this](std::int32_t edge) { choose_edge(edge); });
  for_each_new(lists_.edges().second, [this](std::int32_t edge) { choose_edge(edge); });
  list_where("listed nodes", std::ssize(listed_slave_), listed_nodes_,
             [this](std::int64_t slave) { return listed_slave_[slave] != 0; });
  const std::int64_t count = std::ssize(listed_nodes_);
  for_all_of("nodes of slaves", count, count, [this](std::int64_t i) {
    std::int32_t& number = listed_nodes_[i];
    number = surface_.slaves()[number].node;
  });
  finish_choice();
}

/// By the calling thread.
template <class S>
void FaceAlgorithm<S>::choose_more() {
  adds_to_choice_ = true;
  lists_.more_nodes().for_each([this](std::int32_t slave, std::int32_t segment) {
    choose_face(segment);
    choose_node(slave);
  });
  lists_.more_edges().for_each([this](std::int32_t e, std::int32_t f) {
    choose_edge(e);
    choose_edge(f);
  });
  adds_to_choice_ = false;
  finish_choice();
}

template <class S>
void FaceAlgorithm<S>::finish_choice() {
  surface_.finish_choice();
  if (kernels_) list_read_nodes();
}

template <class S>
void FaceAlgorithm<S>::list_read_nodes() {
  list_where("nodes that are read", std::ssize(read_slave_), read_nodes_,
             [this](std::int64_t slave) { return read_slave_[slave] != 0; });
  for (std::int32_t& number : read_nodes_) number = surface_.slaves()[number].node;
  ++choices_;
}

template <class S>
void FaceAlgorithm<S>::collect_impulses(const SurfaceSource<S>& source, double dt) {
  lists_.count_step(static_cast<S>(dt));
  const double ahead = std::max(dt, this->coming_.dt), leap = this->leap(source, ahead);
  const double approach = 2 * (largest_approach(source, listed_nodes_, ahead) + leap);
  const StepReach step{ahead, approach, depth_.data(), !deep_.empty(), this->pairs_.get(), leap};
  find_rows(source, step);
  sphere_rows_.find(source, surface_, spheres_, lists_.spheres(), step);
  ImpulseSolver<S>& impulses = *this->impulses_;
  std::vector<std::span<const FeatureRow>> lists;
  node_rows_.rows().add_to(lists);
  edge_rows_.rows().add_to(lists);
  impulses.begin_rows(std::span<const std::span<const FeatureRow>>(lists));
  sphere_rows_.give_to(impulses);
  impulses.finish_rows(source, dt);
  note_depths();
}

/// The way that given motions may add within a step to what velocities tell [length].
template <class S>
double FaceAlgorithm<S>::leap(const SurfaceSource<S>& source, double dt) const {
  const double given = this->coming_.leap * dt;
  return this->coming_.stops ? given + largest_approach(source, surface_.nodes(), dt, true) : given;
}

template <class S>
void FaceAlgorithm<S>::find_rows(const SurfaceSource<S>& source, const StepReach& step) {
  const std::int64_t most = source.sharers != nullptr ? most_pairs_of_part : std::numeric_limits<std::int64_t>::max();
  ListShare nodes(lists_.nodes(), most), edges(lists_.edges(), most);
  std::vector<std::int64_t> pairs_of;
  for (const ListShare* list : {&nodes, &edges}) {
    for (const ListPart& part : list->parts()) pairs_of.push_back(part.pairs());
  }
  const PieceShare share(source.sharers, pairs_of);
  nodes.leave_to_others(share, 0);
  edges.leave_to_others(share, std::ssize(nodes.parts()));
  node_rows_.find(source, surface_, lists_.nodes(), step, nodes);
  edge_rows_.find(source, surface_, edges_, lists_.edges(), step, this->impulses_.get(), edges);
  if (share.is_shared()) {
    found_rows_.clear();
    node_rows_.rows().put_into(found_rows_);
    edge_rows_.rows().put_into(found_rows_);
    share.to_all(found_rows_, [&](std::span<const std::byte> theirs) {
      node_rows_.rows().take_from(theirs, nodes);
      edge_rows_.rows().take_from(theirs, edges);
    });
  }
  node_rows_.drop_mirrored(source, surface_);
}

/// What is deep stays in the lists.
template <class S>
void FaceAlgorithm<S>::note_depths() {
  for (const std::int32_t node : deep_) depth_[node] = 0;
  deep_.clear();
  const auto note = [this](const FeatureRow& row) {
    if (!(row.depth > worth_noting * row.reach)) return;
    for (int k = 0; k < row.nodes; ++k) {
      float& deepest = depth_[row.node[k]];
      if (deepest == 0) deep_.push_back(row.node[k]);
      deepest = std::max(deepest, static_cast<float>(row.depth));
    }
  };
  node_rows_.rows().for_each(note);
  edge_rows_.rows().for_each(note);
}

template <class S>
std::vector<std::int32_t> FaceAlgorithm<S>::nodes() const {
  std::vector<std::int32_t> nodes = surface_.nodes();
  for (const auto& sphere : spheres_.spheres()) nodes.push_back(sphere.node);
  return nodes;
}

template <class S>
void FaceAlgorithm<S>::add_node_forces(std::span<Point> node_force) const {
  this->impulses_->add_node_forces(node_force);
}

template <class S>
void FaceAlgorithm<S>::put_radii(const SurfaceSource<S>& /*source*/, std::vector<double>& slot_radius) const {
  for (const auto& segment : surface_.segments()) {
    if (!surface_.exposed(segment.slot, segment.face)) continue;
    slot_radius[segment.slot] = segment.radius;
  }
  for (const auto& sphere : spheres_.spheres()) {
    if (surface_.topology().alive(sphere.slot)) slot_radius[sphere.slot] = sphere.radius;
  }
}

template <class S>
void FaceAlgorithm<S>::persist(StateArchive& archive, const SurfaceSource<S>& source) {
  ContactAlgorithm<S>::persist(archive, source);
  surface_.persist(archive, source);
  if (archive.reads()) edges_.collect(surface_);
  lists_.persist(archive, surface_, edges_, spheres_, this->settings_, source.node_count);
  if (archive.reads() && lists_.valid()) choose_listed();
  if (archive.reads()) kernels_outdated_ = true;
  archive(searches_since_, deep_);
  archive.of_fixed_size(depth_);
  archive.require_all(deep_, 0, source.node_count);
}

template <class S>
std::size_t FaceAlgorithm<S>::bytes() const {
  return surface_.bytes() + edges_.bytes() + spheres_.bytes() + lists_.bytes() + node_rows_.bytes() +
         edge_rows_.bytes() + sphere_rows_.bytes() + found_rows_.capacity() + this->impulses_->bytes();
}

template class FaceAlgorithm<double>;
template class FaceAlgorithm<float>;

}  // namespace pinball
