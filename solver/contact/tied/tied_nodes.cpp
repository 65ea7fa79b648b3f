#include "tied_nodes.hpp"

#include <algorithm>
#include <cmath>

#include <kernels/exec.hpp>

namespace pinball {

namespace {

/// Tied nodes from which on a second thread gains more than it has to wait for.
constexpr std::size_t worth_a_thread = 4096;

template <class S>
void copy_inverse_masses(const S* from, Array<S>& to) {
  std::copy_n(from, to.size(), to.data());
}

}  // namespace

template <class S>
TiedNodes<S>::TiedNodes(std::vector<TiedNode> nodes, std::vector<TieTimes> times, std::int32_t node_count)
    : nodes_(std::move(nodes)),
      times_(std::move(times)),
      active_(nodes_.size(), 0),
      offset_(nodes_.size()),
      place_(nodes_.empty() ? 0 : node_count, -1),
      free_inverse_mass_(place_.size()) {}

template <class S>
void TiedNodes<S>::remember_masses(const TiedMotion<S>& motion) {
  std::vector<std::int32_t> concerned;
  for (const TiedNode& tied : nodes_) {
    concerned.push_back(tied.node);
    concerned.insert(concerned.end(), tied.corner.begin(), tied.corner.end());
  }
  std::sort(concerned.begin(), concerned.end());
  concerned.erase(std::unique(concerned.begin(), concerned.end()), concerned.end());
  for (const std::int32_t n : concerned) mass_.emplace_back(n, (*motion.node_mass)[n]);
  copy_inverse_masses(motion.inverse_mass, free_inverse_mass_);
}

/// Masses as ties make them, from those without ties: in one order, whatever the ties before were.
template <class S>
void TiedNodes<S>::set_masses(const TiedMotion<S>& motion) {
  std::vector<double>& mass = *motion.node_mass;
  for (const auto& [n, own] : mass_) mass[n] = own;
  std::fill(place_.begin(), place_.end(), -1);
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    if (active_[i] == 0) continue;
    const TiedNode& tied = nodes_[i];
    place_[tied.node] = i;
    double& own = mass[tied.node];
    for (std::size_t k = 0; k < 4; ++k) mass[tied.corner[k]] += tied.weight[k] * own;
    own = 0;
  }
  for (const auto& [n, without] : mass_) {
    const double own = mass[n];
    motion.inverse_mass[n] = own > 0 ? static_cast<S>(1.0 / own) : S(0);
    free_inverse_mass_[n] = static_cast<S>(1.0 / (own > 0 ? own : without));
  }
}

/// Kinetic energy of the nodes that ties concern, with the masses of now.
template <class S>
double TiedNodes<S>::kinetic(const TiedMotion<S>& motion) const {
  double twice = 0;
  for (const auto& [n, without] : mass_) {
    for (int k = 0; k < 3; ++k) {
      const double v = record(motion.velocity, n)[k];
      twice += (*motion.node_mass)[n] * v * v;
    }
  }
  return 0.5 * twice;
}

template <class S>
std::size_t TiedNodes<S>::place_of_mass(std::int32_t node) const {
  return std::ranges::lower_bound(mass_, node, {}, &std::pair<std::int32_t, double>::first) - mass_.begin();
}

/// Impulses on tied nodes act on the corners as all forces on them do: with the masses that move there.
template <class S>
void TiedNodes<S>::give_momentum(const TiedMotion<S>& motion,
                                 const std::vector<std::array<double, 3>>& momentum) const {
  for (std::size_t i = 0; i < mass_.size(); ++i) {
    const std::int32_t n = mass_[i].first;
    const double mass = (*motion.node_mass)[n];
    if (!(mass > 0)) continue;
    for (std::size_t c = 0; c < 3; ++c) {
      S& v = record(motion.velocity, n)[c];
      v = static_cast<S>(v + momentum[i][c] / mass);
    }
  }
}

/// From the ties that were to those that are: what is let go gets its mass back, what is tied gives the corners the
/// momentum that it has beyond that of its place on the face.
template <class S>
void TiedNodes<S>::join(const TiedMotion<S>& motion, const std::vector<std::uint8_t>& before) {
  const double energy = kinetic(motion);
  const std::vector<std::uint8_t> now = active_;
  for (std::size_t i = 0; i < nodes_.size(); ++i) active_[i] = before[i] & now[i];
  set_masses(motion);
  const std::vector<double> mass_before = *motion.node_mass;
  active_ = now;
  set_masses(motion);
  bool from_start = false;
  double beyond_faces = 0;
  std::vector<std::array<double, 3>> momentum(mass_.size(), {0, 0, 0});
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    if (before[i] != 0 || now[i] == 0) continue;
    const TiedNode& tied = nodes_[i];
    const bool later = times_[tied.tie].start > 0;
    from_start = from_start || !later;
    offset_[i] = {0, 0, 0};
    const double mass = mass_before[tied.node];
    for (std::size_t c = 0; c < 3; ++c) {
      const double own = record(motion.velocity, tied.node)[c];
      double foot = 0, of_face = 0;
      for (std::size_t k = 0; k < 4; ++k) {
        foot += tied.weight[k] * record(motion.position, tied.corner[k])[c];
        of_face += tied.weight[k] * record(motion.velocity, tied.corner[k])[c];
      }
      for (std::size_t k = 0; k < 4; ++k)
        momentum[place_of_mass(tied.corner[k])][c] += tied.weight[k] * mass * (own - of_face);
      beyond_faces += 0.5 * mass * (own * own - of_face * of_face);
      if (later) offset_[i][c] = record(motion.position, tied.node)[c] - foot;
    }
  }
  // The masses of a tie from the start are those of the model: what moves as it has to has its energy with these.
  const double moving = from_start ? kinetic(motion) + beyond_faces : energy;
  give_momentum(motion, momentum);
  follow(motion);
  lost_ += moving - kinetic(motion);
}

template <class S>
double TiedNodes<S>::leap_of_begun(const S* velocity, double from, double to) const {
  double largest = 0;  // square
  for (const TiedNode& tied : nodes_) {
    if (!times_[tied.tie].begin(from, to)) continue;
    double square = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      double beyond = record(velocity, tied.node)[c];
      for (std::size_t k = 0; k < 4; ++k) beyond -= tied.weight[k] * record(velocity, tied.corner[k])[c];
      square += beyond * beyond;
    }
    largest = std::max(largest, square);
  }
  return std::sqrt(largest);
}

template <class S>
void TiedNodes<S>::keep_velocities(const TiedMotion<S>& motion) {
  kept_.resize(mass_.size());
  for (std::size_t i = 0; i < mass_.size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) kept_[i][c] = static_cast<double>(record(motion.velocity, mass_[i].first)[c]);
  }
}

template <class S>
void TiedNodes<S>::take_velocities(const TiedMotion<S>& motion) {
  if (kept_.empty()) return;
  const auto change = [&](std::size_t i, std::size_t c) {
    return static_cast<double>(record(motion.velocity, mass_[i].first)[c]) - kept_[i][c];
  };
  std::vector<std::array<double, 3>> momentum(mass_.size(), {0, 0, 0});
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    if (active_[i] == 0) continue;
    const std::size_t own = place_of_mass(nodes_[i].node);
    std::array<std::size_t, 4> corner{};
    for (std::size_t k = 0; k < 4; ++k) corner[k] = place_of_mass(nodes_[i].corner[k]);
    for (std::size_t c = 0; c < 3; ++c) {
      double beyond = change(own, c);
      for (std::size_t k = 0; k < 4; ++k) beyond -= nodes_[i].weight[k] * change(corner[k], c);
      for (std::size_t k = 0; k < 4; ++k) momentum[corner[k]][c] += nodes_[i].weight[k] * mass_[own].second * beyond;
    }
  }
  give_momentum(motion, momentum);
  kept_.clear();
  follow(motion);
}

template <class S>
void TiedNodes<S>::distribute(S* force) const {
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    if (active_[i] == 0) continue;
    S* const own = record(force, nodes_[i].node);
    for (std::size_t k = 0; k < 4; ++k) {
      S* const f = record(force, nodes_[i].corner[k]);
      const auto weight = static_cast<S>(nodes_[i].weight[k]);
      for (int c = 0; c < 4; ++c) f[c] += weight * own[c];
    }
    for (int c = 0; c < 4; ++c) own[c] = S(0);
  }
}

template <class S>
void TiedNodes<S>::put_accelerations(const S* inverse_mass, S* force) const {
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    if (active_[i] == 0) continue;
    S* const own = record(force, nodes_[i].node);
    for (int c = 0; c < 3; ++c) own[c] = S(0);
    for (std::size_t k = 0; k < 4; ++k) {
      const std::int32_t corner = nodes_[i].corner[k];
      const S* const f = record(force, corner);
      const S factor = static_cast<S>(nodes_[i].weight[k]) * inverse_mass[corner];
      for (int c = 0; c < 3; ++c) own[c] += factor * f[c];
    }
  }
}

template <class S>
void TiedNodes<S>::follow(const TiedMotion<S>& motion) const {
  const auto put = [&](std::int64_t number) {
    const std::size_t i = number;
    if (active_[i] == 0) return;
    const TiedNode& tied = nodes_[i];
    for (std::size_t c = 0; c < 3; ++c) {
      double x = offset_[i][c], v = 0;
      for (std::size_t k = 0; k < 4; ++k) {
        x += tied.weight[k] * record(motion.position, tied.corner[k])[c];
        v += tied.weight[k] * record(motion.velocity, tied.corner[k])[c];
      }
      record(motion.position, tied.node)[c] = static_cast<S>(x);
      record(motion.velocity, tied.node)[c] = static_cast<S>(v);
    }
  };
  const std::int64_t count = nodes_.size();
  if (nodes_.size() < worth_a_thread) {
    for (std::int64_t i = 0; i < count; ++i) put(i);
  } else {
    parallel_for("tied nodes", RangePolicy<>{0, count}, put);
  }
}

template <class S>
std::vector<std::int16_t> TiedNodes<S>::ties_of_nodes() const {
  std::vector<std::int16_t> ties(place_.size(), -1);
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    if (active_[i] != 0) ties[nodes_[i].node] = nodes_[i].tie;
  }
  return ties;
}

template <class S>
std::int64_t TiedNodes<S>::active() const {
  return std::count(active_.begin(), active_.end(), 1);
}

template <class S>
void TiedNodes<S>::persist(StateArchive& archive, const TiedMotion<S>& motion) {
  if (nodes_.empty()) return;
  archive.of_fixed_size(active_);
  archive.of_fixed_size(offset_);
  archive(lost_, kept_);
  archive.require(kept_.empty() || kept_.size() == mass_.size());
  for (const std::uint8_t active : active_) archive.require(active <= 1);
  if (!archive.reads()) return;
  set_masses(motion);
}

template <class S>
std::size_t TiedNodes<S>::bytes() const {
  return nodes_.capacity() * sizeof(nodes_[0]) + active_.capacity() + offset_.capacity() * sizeof(offset_[0]) +
         place_.capacity() * sizeof(place_[0]) + mass_.capacity() * sizeof(mass_[0]) +
         kept_.capacity() * sizeof(kept_[0]) + free_inverse_mass_.bytes();
}

template class TiedNodes<double>;
template class TiedNodes<float>;

}  // namespace pinball
