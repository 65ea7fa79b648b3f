#include "host_surface.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include <kernels/exec.hpp>
#include <kernels/pinball.hpp>
#include <solver/base/faces.hpp>

#include "host_error.hpp"

namespace pinball {

namespace {

double undeformed_volume(const ContactElement& element) {
  Vec3<double> x[8];
  for (std::size_t i = 0; i < 8; ++i)
    x[i] = {element.reference[i][0], element.reference[i][1], element.reference[i][2]};
  const HexahedronModes<double> modes = to_modes(x);
  return hexahedron_volume(uniform_gradient(modes), modes);
}

template <class S>
[[noreturn]] void throw_unsound(const char* name, std::int32_t node, const std::array<S, 3>& v) {
  throw HostError(PINBALL_CONTACT_BAD_NUMBER, "arrays->", name, ": node ", node, " has ", v[0], ", ", v[1], ", ", v[2],
                  unsound);
}

/// Whether some of many records of four are not sound: the zeros summed are numbers no more. Two sums, so that one need
/// not wait for the other; of whole records, which is one instruction.
template <class S>
class SoundCheck {
 public:
  void add(const S (&v)[4], std::int64_t i) {
    for (std::size_t k = 0; k < 4; ++k) zero_[i & 1][k] += S(0) * (v[k] * v[k]);
  }
  bool fails() const {
    S sum = 0;
    for (std::size_t k = 0; k < 4; ++k) sum += zero_[0][k] + zero_[1][k];
    return !(sum == S(0));
  }

 private:
  S zero_[2][4] = {};
};

}  // namespace

template <class S>
HostSurface<S>::HostSurface(const pinball_contact_options& options, HostMesh<S> mesh,
                            const pinball_contact_input& where)
    : mesh_(std::move(mesh)) {
  this->lists_last = options.keep_lists == 1;
  this->node_count = mesh_.nodes();
  const std::size_t n = mesh_.nodes();
  const HostVectors<S> start(where);
  inverse_.reset(n);
  reference_.resize(3 * n);
  std::vector<std::int32_t> around(n, 0);  // corners at each node
  for (std::int32_t e = 0; e < mesh_.all(); ++e) {
    for (const std::int32_t node : mesh_.corners(e)) {
      const std::size_t at = node;
      if (e < mesh_.elements()) ++around[at];
      inverse_[at] = static_cast<S>(1.0 / mesh_.mass(node));
      const std::array<S, 3> x = start[node];
      std::copy(x.begin(), x.end(), reference_.begin() + (3 * at));
    }
  }
  masses_from_ = mesh_.element_masses() != nullptr ? mesh_.elements() : 0;
  for (std::int32_t e = masses_from_; e < mesh_.all(); ++e) {
    const std::array<std::int32_t, 8> corners = mesh_.corners(e);
    double mass = e < mesh_.elements() ? 0 : mesh_.mass(corners[0]);
    for (std::size_t i = 0; e < mesh_.elements() && i < 8; ++i) {
      mass += mesh_.mass(corners[i]) / around[corners[i]];
    }
    mass_.push_back(mass);
  }
  this->inverse_mass = inverse_.data();
  alive_before_.assign(mesh_.all(), 1);
  is_watched_.assign(n, 0);
  cut_tiles();
}

template <class S>
void HostSurface<S>::cut_tiles() {
  constexpr std::int64_t W = native_width<S>;
  const std::vector<std::int32_t> tiles = mesh_.tiles();
  std::vector<std::array<std::int32_t, 8>> corners;
  packs_.assign(1, 0);
  for (std::size_t t = 0; t + 1 < tiles.size(); ++t) {
    for (std::int32_t e = tiles[t]; e < tiles[t + 1]; ++e) {
      slot_of_element_.push_back(element_of_slot_.size());
      element_of_slot_.push_back(e);
      corners.push_back(mesh_.corners(e));
    }
    packs_.push_back((std::ssize(element_of_slot_) + W - 1) / W);
    element_of_slot_.resize(packs_.back() * W, -1);
  }
  colours_ = colour_tiles(tiles, corners, mesh_.nodes());
  this->slots = element_of_slot_.size();
  this->tile_packs = packs_;
  this->tile_colours = &colours_;
}

template <class S>
ContactElement HostSurface<S>::element(std::int64_t slot) const {
  const std::int32_t e = element_of_slot_[slot];
  ContactElement element{};
  element.corners = mesh_.corners(e);
  for (std::size_t i = 0; i < 8; ++i) {
    const std::size_t node = element.corners[i];
    for (std::size_t k = 0; k < 3; ++k) element.reference[i][k] = reference_[3 * node + k];
  }
  element.body = mesh_.body(e);
  element.bulk_modulus = mesh_.bulk_modulus(e);
  element.sphere = e >= mesh_.elements();
  element.mass = e < masses_from_ ? mesh_.number(mesh_.element_masses(), e) : mass_[e - masses_from_];
  if (element.sphere) {
    element.radius = mesh_.sphere_radius(e - mesh_.elements());
    element.volume = 4.0 / 3.0 * M_PI * element.radius * element.radius * element.radius;
    return element;
  }
  element.volume =
      mesh_.element_volumes() != nullptr ? mesh_.number(mesh_.element_volumes(), e) : undeformed_volume(element);
  element.radius = ball_radius(element.volume);
  return element;
}

template <class S>
InitialSurface HostSurface<S>::start(const pinball_contact_input& where, bool with_held) {
  SurfaceTopology topology(this->slots);
  std::vector<std::array<std::int32_t, 8>> hexahedra;
  for (std::int32_t e = 0; e < mesh_.elements(); ++e) hexahedra.push_back(mesh_.corners(e));
  const std::vector<std::array<std::int32_t, 6>> neighbours = face_neighbours(hexahedra);
  for (std::int32_t e = 0; e < mesh_.all(); ++e) {
    const std::size_t slot = slot_of_element_[e];
    topology.alive[slot] = 1;
    if (e >= mesh_.elements()) {
      topology.exposed[slot] = 0x3F;
    } else {
      const double volume = element(slot).volume;
      if (!(volume > 0) || !std::isfinite(volume)) {
        throw HostError(PINBALL_CONTACT_BAD_NUMBER, "position: element ", e,
                        " of mesh->corners has no volume > 0: ", volume);
      }
      const unsigned hidden = mesh_.hidden_faces() != nullptr ? mesh_.hidden_faces()[e] : 0U;
      for (unsigned f = 0; f < 6; ++f) {
        const std::int32_t beyond = neighbours[e][f];
        if (beyond >= 0) topology.neighbour[slot][f] = slot_of_element_[beyond];
        if (beyond == -1 && (hidden >> f & 1U) == 0) topology.exposed[slot] |= 1U << f;
      }
    }
    if (topology.exposed[slot] != 0) watch(slot);
  }
  InitialSurface start{std::move(topology), with_held ? HeldDirections(mesh_.nodes(), mesh_.held()) : HeldDirections()};
  std::sort(watched_.begin(), watched_.end());
  this->position = gather(where, positions_, watched_, "position");
  mesh_.forget_arguments();
  return start;
}

template <class S>
void HostSurface<S>::watch(std::int64_t slot) {
  for (const std::int32_t node : mesh_.corners(element_of_slot_[slot])) {
    std::uint8_t& watched = is_watched_[node];
    if (watched == 0) watched_.push_back(node);
    watched = 1;
  }
}

template <class S>
std::uint8_t HostSurface<S>::alive_at(std::int64_t slot) const {
  const std::int32_t e = element_of_slot_[slot], sphere = e - mesh_.elements();
  if (sphere >= 0) return sphere_alive_ != nullptr ? sphere_alive_[sphere] : 1;
  return alive_ != nullptr ? alive_[e] : 1;
}

template <class S>
std::vector<std::int64_t> HostSurface<S>::update_alive(const pinball_contact_arrays& arrays, const Surface& surface) {
  alive_ = arrays.alive;
  sphere_alive_ = arrays.sphere_alive;
  std::vector<std::int64_t> eroded;
  const auto update = [&](const std::uint8_t* alive, std::int32_t begin, std::int32_t end) {
    std::uint8_t* before = alive_before_.data() + begin;
    if (alive == nullptr || std::equal(before, before + (end - begin), alive)) return;
    for (std::int32_t e = begin; e < end; ++e) {
      const std::uint8_t now = alive[e - begin];
      std::uint8_t& last = alive_before_[e];
      if (now == last || last == 0) continue;
      last = now;
      if (now == 1) continue;
      const std::int64_t slot = slot_of_element_[e];
      surface.for_each_face_behind(slot, [this](std::int32_t behind, unsigned /*face*/) { watch(behind); });
      if (now == 0) eroded.push_back(slot);
    }
  };
  const std::size_t watched_before = watched_.size();
  update(alive_, 0, mesh_.elements());
  update(sphere_alive_, mesh_.elements(), mesh_.all());
  if (watched_.size() != watched_before) std::sort(watched_.begin(), watched_.end());
  return eroded;
}

template <class S>
const S* HostSurface<S>::gather(const pinball_contact_input& from, Array<S>& records,
                                const std::vector<std::int32_t>& nodes, const char* name) const {
  const HostVectors<S> vectors(from);
  const bool in_place = vectors.are_records();
  if (!in_place && records.empty()) records.reset(std::size_t{4} * mesh_.nodes());
  S* const gathered = in_place ? nullptr : records.data();
  const std::int32_t last = vectors.are_together() ? mesh_.nodes() - 1 : 0;
  bool wrong = false;
  parallel_reduce(
      "gather nodes", RangePolicy<>{0, std::ssize(nodes)}, wrong,
      [&](std::int64_t begin, std::int64_t end, bool& partial) {
        SoundCheck<S> check;
        for (std::int64_t i = begin; i < end; ++i) {
          const std::int32_t node = nodes[i];
          S v[4];
          if (node < last) {
            std::memcpy(v, vectors.x + node * vectors.stride, sizeof v);
          } else {
            const std::array<S, 3> x = vectors[node];
            std::memcpy(v, x.data(), sizeof x);
            v[3] = 0;
          }
          check.add(v, i);
          if (gathered != nullptr) std::memcpy(record(gathered, node), v, sizeof v);
        }
        partial = check.fails();
      },
      [](bool& whole, bool partial) { whole = whole || partial; });
  for (std::size_t i = 0; wrong && i < nodes.size(); ++i) {
    const std::array<S, 3> v = vectors[nodes[i]];
    if (!is_sound(v)) throw_unsound(name, nodes[i], v);
  }
  return in_place ? vectors.x : records.data();
}

template <class S>
void HostSurface<S>::gather_motion(const pinball_contact_arrays& arrays, const std::vector<std::int32_t>* listed) {
  const HostVectors<S> where(arrays.position);
  const bool later = listed != nullptr;
  // Lists do not hold where a position is not a number: records are looked through before a search only.
  this->position = later && where.are_records() ? where.x : gather(arrays.position, positions_, watched_, "position");
  this->velocity = gather(arrays.velocity, velocities_, later ? *listed : watched_, "velocity");
  waiting_ = later ? &arrays : nullptr;
}

template <class S>
void HostSurface<S>::before_search() const {
  if (waiting_ == nullptr) return;
  if (HostVectors<S>(waiting_->position).are_records()) {
    Array<S> none;
    gather(waiting_->position, none, watched_, "position");
  }
  gather(waiting_->velocity, velocities_, watched_, "velocity");
}

template <class S>
void HostSurface<S>::gather_impulse_nodes(const pinball_contact_arrays& arrays,
                                          const std::vector<std::int32_t>& nodes) {
  if (nodes.empty()) return;
  this->velocity = gather(arrays.velocity, velocities_, nodes, "velocity");
  gather_forces(arrays, nodes);
}

template <class S>
void HostSurface<S>::gather_forces(const pinball_contact_arrays& arrays, const std::vector<std::int32_t>& nodes) {
  const HostVectors<S> host({arrays.force.x, arrays.force.y, arrays.force.z, arrays.force.stride});
  for (const std::int32_t node : nodes) {
    if (!is_sound(host[node])) throw_unsound("force", node, host[node]);
  }
  if (arrays.force_records == 1) {
    this->force = static_cast<S*>(arrays.force.x);
    return;
  }
  if (forces_.empty()) forces_.reset(std::size_t{4} * mesh_.nodes());
  this->force = forces_.data();
  for (const std::int32_t node : nodes) {
    const std::array<S, 3> f = host[node];
    const S start[4] = {f[0], f[1], f[2], 0};
    std::memcpy(this->f(node), start, sizeof start);
  }
}

template <class S>
void HostSurface<S>::scatter_forces(const pinball_contact_arrays& arrays, const std::vector<std::int32_t>& nodes) {
  if (arrays.force_records == 1) return;
  S *const x = static_cast<S*>(arrays.force.x), *const y = static_cast<S*>(arrays.force.y),
           *const z = static_cast<S*>(arrays.force.z);
  for (const std::int32_t node : nodes) {
    const S* const sum = record(forces_.data(), node);
    const std::int64_t at = node * arrays.force.stride;
    x[at] = sum[0];
    y[at] = sum[1];
    z[at] = sum[2];
  }
}

template class HostSurface<double>;
template class HostSurface<float>;

}  // namespace pinball
