#include "pinball_algorithm.hpp"

#include <algorithm>
#include <utility>

#include <kernels/exec.hpp>
#include <solver/base/lists_in_order.hpp>

#include "pinball_rows.hpp"

namespace pinball {

namespace {

/// Growth of a radius for which the list allows, where radii change.
constexpr double radius_growth = 1.02;

/// Mean of the corners of an element.
template <class S>
std::array<S, 3> centre_of(const S* records, const std::array<std::int32_t, 8>& corners) {
  std::array<S, 3> sum{};
  for (const std::int32_t node : corners) {
    for (std::size_t k = 0; k < 3; ++k) sum[k] += record(records, node)[k];
  }
  return {S(0.125) * sum[0], S(0.125) * sum[1], S(0.125) * sum[2]};
}

/// Exposed on two pairs of opposite faces.
bool is_of_bar(std::uint8_t faces) {
  int pairs = 0;
  for (int axis = 0; axis < 3; ++axis) pairs += (faces >> 2 * axis & 3) == 3 ? 1 : 0;
  return pairs > 1;
}

}  // namespace

template <class S>
PinballAlgorithm<S>::PinballAlgorithm(const ContactSettings& settings, const SurfaceSource<S>& source,
                                      InitialSurface start)
    : ContactAlgorithm<S>(settings, source, start),
      on_faces_(SphereSprings<S>::wanted(settings, source, start.topology)
                    ? std::make_unique<SphereSprings<S>>(settings, source, start.topology)
                    : nullptr),
      surface_(std::move(start.topology)),
      joined_(source, surface_) {
  penalty_ = {static_cast<S>(settings.beta), static_cast<S>(settings.damping)};
  std::vector<std::int32_t> exposed;
  list_where("elements of a surface", surface_.slots(), exposed,
             [this](std::int64_t slot) { return surface_.exposed(slot) != 0; });
  for (std::int64_t slot = 0; slot < surface_.slots(); ++slot) faces_at_start_.push_back(surface_.exposed(slot));
  all_.update(source, settings.radius_factor, surface_, exposed, all_before_);
  watch_nodes(source);
  give_lists(source);
}

template <class S>
void PinballAlgorithm<S>::watch_nodes(const SurfaceSource<S>& source) {
  motion_.watch(
      source.node_count, 8 * std::ssize(all_.corners), [&](std::int64_t i) { return all_.corners[i / 8][i % 8]; },
      [&](std::int64_t i) { return all_.radius[i / 8]; });
}

template <class S>
void PinballAlgorithm<S>::update_exposure() {
  parallel_for("exposed faces", RangePolicy<>{0, pinballs_.count}, [this](std::int64_t p) {
    const std::uint8_t exposed = surface_.exposed(pinballs_.slot[p]);
    for (int f = 0; f < 6; ++f) {
      pinballs_.exposed[place_in_packs<native_width<S>>(p, f, 6)] = (exposed >> f & 1) != 0 ? S(1) : S(0);
    }
    const S radius = record(pinballs_.centre.data(), p)[3];
    record(pinballs_.outward.data(), p)[3] = exposed != 0 ? pinballs_.bulk_modulus[p] * radius : S(0);
  });
}

template <class S>
void PinballAlgorithm<S>::update_surface(const SurfaceSource<S>& source, const std::vector<std::int64_t>& eroded) {
  lost_energy_ = 0;
  if (surface_.remove_eroded(eroded)) {
    surface_changed_ = true;
    kernels_->bring_back();
    update_exposure();
    lost_energy_ = list_.end_pairs_of_inactive(pinballs_.outward.data());
    for (const std::int32_t slot : surface_.uncovered()) {
      uncovered_.push_back(slot);
      list_valid_ = list_valid_ && all_.chosen[slot] != 0;
    }
    if (on_faces_) {
      lost_energy_ += on_faces_->remove_eroded(eroded);
      list_valid_ = list_valid_ && on_faces_->complete();
    }
    give_lists(source);
  }
  update_geometry(source);
}

template <class S>
bool PinballAlgorithm<S>::work_with(std::unique_ptr<PinballKernels<S>>& kernels) {
  if (this->impulses_ || this->pairs_ || on_faces_) return false;
  device_kernels_ = std::move(kernels);
  kernels_ = device_kernels_.get();
  return true;
}

template <class S>
void PinballAlgorithm<S>::give_lists(const SurfaceSource<S>& source) {
  PinballArrays<S> arrays;
  arrays.pinballs = pinballs_.count;
  arrays.geometry = pinballs_.geometry();
  arrays.force = pinballs_.force.data();
  arrays.pairs = list_.listed_pairs();
  arrays.pieces = list_.pieces();
  arrays.nodes = node_;
  arrays.node_count = source.node_count;
  arrays.expected = motion_.expected();
  arrays.balls = static_cast<std::int32_t>(radius_.size());
  if (!radius_.empty()) {
    arrays.corner = all_.corners.front().data();
    arrays.radius = radius_.data();
  }
  arrays.tile_first = pinballs_.tile_first;
  if (source.tile_colours != nullptr) tile_colours_ = *source.tile_colours;
  arrays.colour_offsets = tile_colours_.colour_offsets;
  arrays.tiles = tile_colours_.items;
  kernels_->take(arrays);
}

template <class S>
void PinballAlgorithm<S>::update_geometry(const SurfaceSource<S>& source) {
  kernels_->update_geometry(source.nodes(false), this->settings_.radius == ContactRadius::current);
}

template <class S>
bool PinballAlgorithm<S>::list_holds(const SurfaceSource<S>& source) const {
  if (!list_valid_ || clock_.over()) return false;
  const SurfaceNodes<S> nodes = source.nodes(false);
  if (kernels_->any_strays(nodes, clock_.elapsed())) return false;
  return radius_.empty() || !kernels_->any_grows(nodes, static_cast<S>(radius_growth));
}

template <class S>
void PinballAlgorithm<S>::search(const SurfaceSource<S>& source, double /*dt*/) {
  if (this->may_keep_lists(source) && list_holds(source)) {
    ++this->searches_skipped_;
    return;
  }
  source.before_search();
  ++this->searches_;
  kernels_->bring_back();
  build_list(source);
  update_geometry(source);
}

template <class S>
void PinballAlgorithm<S>::build_list(const SurfaceSource<S>& source) {
  const bool reuse = source.lists_last;
  const S horizon = reuse ? horizon_steps * clock_.last_step() : S(0);
  motion_.adapt(source.position, clock_.elapsed(), horizon);
  if (surface_changed_) {  // a good moment to take in the elements behind the new surface
    all_.update(source, this->settings_.radius_factor, surface_, uncovered_, all_before_);
    watch_nodes(source);
    uncovered_.clear();
    surface_changed_ = false;
  }
  source.before_motion(motion_.nodes());
  motion_.start(source.position, source.velocity, reuse ? static_cast<S>(this->settings_.skin) : S(0));
  clock_.restart(horizon);

  const bool current = this->settings_.radius == ContactRadius::current;
  const S radius_factor = static_cast<S>(this->settings_.radius_factor);
  radius_.resize(current ? all_.radius.size() : 0);
  // Where each ball may be, and what the rounding of single precision adds.
  const S factor =
      static_cast<S>(1.0001 * (this->impulses_ ? pinball_pair_margin : 1.0) * (current && reuse ? radius_growth : 1.0));
  balls_.reset(all_.count);
  parallel_for("balls", RangePolicy<>{0, all_.count}, [&](std::int64_t i) {
    const std::size_t p = i;
    std::array<S, 3> way = centre_of(source.velocity, all_.corners[p]);
    for (S& w : way) w *= horizon;
    if (current) radius_[p] = present_radius(source.position, all_.corners[p].data(), radius_factor);
    const S radius = current ? radius_[p] : all_.radius[p];
    balls_.set(i, centre_of(source.position, all_.corners[p]), way,
               factor * radius + motion_.allowance(all_.corners[p]));
  });
  const double stored_before = this->lists_outdated_ ? list_.stored_energy() : 0.0;
  list_.build(all_, balls_, this->settings_.self, this->settings_.search, this->pairs_.get(), on_faces_ != nullptr,
              source.sharers, joined_);
  if (on_faces_) on_faces_->build(source, motion_, joined_, horizon);
  if (this->lists_outdated_) ended_energy_ += stored_before - list_.stored_energy();
  this->lists_outdated_ = false;
  list_valid_ = true;
  collect_listed(source);
}

template <class S>
void PinballAlgorithm<S>::collect_listed(const SurfaceSource<S>& source) {
  constexpr int W = native_width<S>;
  const std::int32_t n = list_.size();
  pinballs_.reset(n, W);
  pinballs_.radius_factor = static_cast<S>(this->settings_.radius_factor);
  const std::int32_t padded = (n + W - 1) / W * W;
  parallel_for("listed pinballs", RangePolicy<>{0, padded}, [&](std::int64_t p) {
    const std::int32_t a = list_.listed()[std::min<std::int64_t>(p, n - 1)];  // padding repeats corners of the last one
    for (int i = 0; i < 8; ++i) pinballs_.corner[place_in_packs<native_width<S>>(p, i, 8)] = all_.corners[a][i];
    if (p >= n) return;
    pinballs_.slot[p] = all_.slot[a];
    pinballs_.corners[p] = all_.corners[a];
    pinballs_.bulk_modulus[p] = all_.bulk_modulus[a];
    record(pinballs_.centre.data(), p)[3] = all_.radius[a];
    record(pinballs_.velocity.data(), p)[3] = all_.mass[a];
    record(pinballs_.two_sided.data(), p)[3] = is_of_bar(faces_at_start_[all_.slot[a]]) ? S(1) : S(0);
  });
  pinballs_.tile_first.resize(source.tile_packs.size());
  parallel_for("pinballs of tiles", RangePolicy<>{0, std::ssize(source.tile_packs)}, [&](std::int64_t tile) {
    const auto begin = pinballs_.slot.begin();
    const std::int64_t slot = source.tile_packs[tile] * source.tile_pack_width;
    pinballs_.tile_first[tile] = std::lower_bound(begin, pinballs_.slot.end(), slot) - begin;
  });
  update_exposure();
  list_nodes(source.node_count);
  give_lists(source);
}

template <class S>
void PinballAlgorithm<S>::list_nodes(std::int32_t node_count) {
  is_listed_.resize(node_count, 0);
  const auto for_each_node = [this](const std::vector<std::int32_t>& nodes, std::uint8_t mark) {
    parallel_for("marks of nodes", RangePolicy<>{0, std::ssize(nodes)},
                 [&](std::int64_t i) { is_listed_[nodes[i]] = mark; });
  };
  for_each_node(node_, 0);
  parallel_for("nodes of pinballs", RangePolicy<>{0, std::ssize(pinballs_.corners)}, [this](std::int64_t p) {
    for (const std::int32_t node : pinballs_.corners[p]) set_mark(is_listed_[node]);
  });
  if (on_faces_) for_each_node(on_faces_->listed_nodes(), 1);
  list_where("listed nodes", node_count, node_, [this](std::int64_t node) { return is_listed_[node] != 0; });
}

template <class S>
void PinballAlgorithm<S>::collect_impulses(const SurfaceSource<S>& source, double dt) {
  clock_.count_step(static_cast<S>(dt));
  this->impulses_->begin_rows();
  add_pinball_rows(pinballs_, list_, this->pairs_.get(), *this->impulses_);
  this->impulses_->finish_rows(source, dt);
}

template <class S>
ContactWork PinballAlgorithm<S>::spring_forces(const SurfaceSource<S>& source, S dt) {
  clock_.count_step(dt);
  const PairSums<S> sums = kernels_->find_forces(penalty_, dt);
  ContactWork work;
  work.stored = sums.stored;
  work.eroded = lost_energy_;
  work.damped_power = sums.damped;
  work.dissipated = std::exchange(ended_energy_, 0.0);
  work.penetration_ratio = sums.penetration_ratio;
  if (sums.deepest >= 0) work.deepest = pinballs_.corners[sums.deepest][0];
  work.pairs = sums.pairs;
  if (on_faces_) {
    const SphereSums spheres = on_faces_->compute(source, dt);
    ContactWork of_spheres;
    of_spheres.stored = spheres.stored;
    of_spheres.damped_power = spheres.damped;
    of_spheres.dissipated = spheres.lost;
    of_spheres.penetration_ratio = spheres.penetration_ratio;
    of_spheres.deepest = spheres.deepest;
    of_spheres.pairs = spheres.pairs;
    work += of_spheres;
  }
  return work;
}

template <class S>
void PinballAlgorithm<S>::add_spring_forces(const SurfaceSource<S>& source, ContactWork& work) {
  if (work.pairs == 0) return;
  const SurfaceNodes<S> nodes = source.nodes(true);
  kernels_->add_forces(nodes);
  if (on_faces_) on_faces_->add_forces(source);
  // Gershgorin: a pair of stiffness p2 enters the row of each of its 16 nodes with p2/8 (8/8 + 8/8) / m_I.
  work.frequency2 = this->damping_factor_ * kernels_->largest_row(nodes);
}

template <class S>
void PinballAlgorithm<S>::add_pair_forces_of_springs(std::vector<Point>& sums) const {
  if (!this->pairs_) return;
  host_kernels_.pair_forces().for_each_touch([&](std::int32_t first, std::int32_t second, const Point& force) {
    const PairOf of = this->pairs_->elements(pinballs_.slot[first], pinballs_.corners[first], pinballs_.slot[second],
                                             pinballs_.corners[second]);
    if (of.pair < 0) return;
    Point& sum = sums[of.pair];
    for (std::size_t c = 0; c < 3; ++c) sum[c] += of.sign * force[c];
  });
}

template <class S>
void PinballAlgorithm<S>::put_radii(const SurfaceSource<S>& source, std::vector<double>& slot_radius) const {
  const bool current = this->settings_.radius == ContactRadius::current;
  const S radius_factor = static_cast<S>(this->settings_.radius_factor);
  for (std::size_t p = 0; p < all_.slot.size(); ++p) {
    if (surface_.exposed(all_.slot[p]) == 0) continue;  // behind the surface, or eroded
    slot_radius[all_.slot[p]] = static_cast<double>(
        current ? present_radius(source.position, all_.corners[p].data(), radius_factor) : all_.radius[p]);
  }
}

template <class S>
void PinballAlgorithm<S>::add_node_forces(std::span<Point> node_force) const {
  kernels_->bring_back();
  const std::size_t count = pinballs_.count;
  for (std::size_t p = 0; p < count; ++p) {
    if (!(pinballs_.outward[4 * p + 3] > S(0))) continue;
    for (const std::int32_t node : pinballs_.corners[p]) {
      for (std::size_t k = 0; k < 3; ++k) {
        node_force[node][k] += static_cast<double>(pinballs_.force[4 * p + k]) / 8;
      }
    }
  }
  if (on_faces_) on_faces_->add_node_forces(node_force);
  if (this->impulses_) this->impulses_->add_node_forces(node_force);
}

template <class S>
void PinballAlgorithm<S>::persist(StateArchive& archive, const SurfaceSource<S>& source) {
  kernels_->bring_back();
  ContactAlgorithm<S>::persist(archive, source);
  surface_.persist(archive, source);
  all_.persist(archive, source, this->settings_.radius_factor);
  motion_.persist(archive, source.node_count, true);
  list_.persist(archive, all_);
  clock_.persist(archive);
  archive(uncovered_, radius_, list_valid_, surface_changed_);
  for (const std::int32_t slot : uncovered_) archive.require(source.is_element(slot));
  archive.require(radius_.empty() || radius_.size() == all_.radius.size());
  if (archive.reads()) collect_listed(source);
  archive.of_fixed_size(pinballs_.centre);
  archive.of_fixed_size(pinballs_.outward);
  archive.of_fixed_size(pinballs_.force);  // for the report alone
  if (archive.reads()) give_lists(source);
}

template <class S>
std::size_t PinballAlgorithm<S>::bytes() const {
  return pinballs_.bytes() + faces_at_start_.capacity() + list_.bytes() + host_kernels_.bytes() + surface_.bytes() +
         joined_.bytes() + all_.bytes() + all_before_.bytes() + balls_.bytes() + motion_.bytes() +
         radius_.capacity() * sizeof(S) + node_.capacity() * sizeof(node_[0]) + is_listed_.capacity() +
         (this->impulses_ ? this->impulses_->bytes() : 0) + (on_faces_ ? on_faces_->bytes() : 0) +
         (device_kernels_ ? device_kernels_->bytes() : 0);
}

template class PinballAlgorithm<double>;
template class PinballAlgorithm<float>;

}  // namespace pinball
