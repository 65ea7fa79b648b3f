#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include <kernels/exec/array.hpp>
#include <solver/base/records.hpp>
#include <solver/base/state_archive.hpp>

namespace pinball {

/// A node that moves with a place on a face.
struct TiedNode {
  std::int32_t node = 0;                 ///< of the store
  std::array<std::int32_t, 4> corner{};  ///< of the store
  std::array<double, 4> weight{};        ///< of the corners, of sum 1, none below 0 [-]
  std::int64_t slot = 0;                 ///< of the element whose face it is
  std::int16_t tie = 0;                  ///< number of the tied contact
};

struct TieTimes {
  double start = 0, end = std::numeric_limits<double>::infinity();  ///< [time]

  bool begin(double from, double to) const { return start > from && start > 0 && start <= to; }
};

/// What tied contact works on; all by nodes of the store.
template <class S>
struct TiedMotion {
  S* position;  ///< records of four
  S* velocity;  ///< records of four
  S* inverse_mass;
  std::vector<double>* node_mass;
};

/// Nodes tied to faces, as a constraint of the motion:
///
///     x_s = sum_i w_i x_i + d ,   v_s = sum_i w_i v_i           s: tied node; i: corners of its face
///     f_i <- f_i + w_i f_s ,      m_i <- m_i + w_i m_s          f_s, m_s <- 0
///
/// Weights are the shape functions of the face at the node's place. Momentum is kept to round-off, for weights sum
/// to 1. Angular momentum too where d = 0, as it is for nodes that begin on their faces: f_s acts at sum w_i x_i.
/// Lumping m_s makes the matrix of masses larger than the consistent one, w w^T m_s, so that no frequency rises: the
/// stable step of the elements remains one. The kinetic energy is that of the masses as they are lumped here, which the
/// motion keeps.
///
/// A node that is tied while it moves otherwise gives what it has beyond its face to the corners, as in a plastic
/// impact, and so does one whose velocity a host changes. u: velocities before; M_i: all mass at i, of all nodes tied
/// there:
///
///     v_i = u_i + (1/M_i) sum_s w_si m_s r_s ,   r_s = u_s - sum_j w_sj u_j
///
/// That is what the impulses m_s r_s on the tied nodes do in the motion as it is lumped, of all of them at once.
/// Momentum is kept, and what they have beyond their faces comes with its angular momentum, as f_s does. Motions that
/// obey the ties, spin and stretch among them, have r = 0 and stay as they are. It costs, with p_i = sum_s w_si m_s
/// r_s,
///
///     1/2 sum_s m_s r_s^2 - 1/2 sum_i p_i^2 / M_i >= 0        as p^T M^-1 p <= r^T m r for weights of sum 1
///
/// and the energy of motions that obey is that of the masses as lumped: for a tie from the start that of the model from
/// its beginning. A later one adds 1/2 sum_s m_s (sum_i w_i u_i^2 - (sum_i w_i u_i)^2) of what turns or stretches,
/// which is counted against the cost. A node that is let go takes its mass along with the velocity that it had, which
/// gives that back.
///
/// No tied node is a corner of a face that others are tied to.
template <class S>
class TiedNodes {
 public:
  TiedNodes() = default;
  TiedNodes(std::vector<TiedNode> nodes, std::vector<TieTimes> times, std::int32_t node_count);

  bool any() const { return !nodes_.empty(); }
  /// Takes the masses as they are without ties; before anything else.
  void remember_masses(const TiedMotion<S>& motion);
  /// Ties and lets go what begins and ends at a time, and what has lost its element. alive(slot): of an element.
  /// Returns whether anything has changed.
  template <class Alive>
  bool update(const TiedMotion<S>& motion, double time, const Alive& alive);
  /// Whether any begin after `from` and by `to`; and the largest difference of velocities of the nodes that they will
  /// tie from those of their faces [length/time]. velocity: records of four.
  bool begin(double from, double to) const {
    return std::ranges::any_of(times_, [=](const TieTimes& times) { return times.begin(from, to); });
  }
  double leap_of_begun(const S* velocity, double from, double to) const;
  /// Kinetic energy that the changes since the last call have cost [energy].
  double take_lost_energy() { return std::exchange(lost_, 0.0); }
  /// Gives the corners what acts on the tied nodes. force: records of four.
  void distribute(S* force) const;
  /// Accelerations of the tied nodes, in the place of their forces, which are zero: where the work of what acts on them
  /// is counted. force: of the corners all that acts on them, given by records of four.
  void put_accelerations(const S* inverse_mass, S* force) const;
  /// Keeps the velocities of tied nodes and corners, which a host may change then.
  void keep_velocities(const TiedMotion<S>& motion);
  /// Gives the corners the momentum by which a host has changed that of the tied nodes since, beyond that of their
  /// faces.
  void take_velocities(const TiedMotion<S>& motion);
  /// Puts tied nodes where their corners take them, with their velocities.
  void follow(const TiedMotion<S>& motion) const;
  /// The tie of a node at present; null: it has none.
  const TiedNode* tie_of(std::int32_t node) const {
    const std::int32_t place = place_[node];
    return place < 0 ? nullptr : &nodes_[place];
  }
  /// Number of the tied contact that holds each node at present; -1: none.
  std::vector<std::int16_t> ties_of_nodes() const;
  std::int64_t active() const;  ///< nodes tied at present
  /// Inverse masses of the store, but those of tied nodes as if they were free: for springs on them [1/mass].
  const S* free_inverse_mass() const { return free_inverse_mass_.data(); }
  /// Nodes with the masses that they have without ties.
  const std::vector<std::pair<std::int32_t, double>>& masses_without() const { return mass_; }
  /// motion: with its own state read before.
  void persist(StateArchive& archive, const TiedMotion<S>& motion);
  std::size_t bytes() const;

 private:
  std::size_t place_of_mass(std::int32_t node) const;
  void set_masses(const TiedMotion<S>& motion);
  void join(const TiedMotion<S>& motion, const std::vector<std::uint8_t>& before);
  void give_momentum(const TiedMotion<S>& motion, const std::vector<std::array<double, 3>>& momentum) const;
  double kinetic(const TiedMotion<S>& motion) const;

  std::vector<TiedNode> nodes_;
  std::vector<TieTimes> times_;                        ///< per tied contact
  std::vector<std::uint8_t> active_;                   ///< per tied node
  std::vector<std::array<double, 3>> offset_;          ///< d, per tied node [length]
  std::vector<std::int32_t> place_;                    ///< per node of the store: among nodes_ if it is tied; -1
  std::vector<std::pair<std::int32_t, double>> mass_;  ///< of tied nodes and corners, without ties [mass]
  std::vector<std::array<double, 3>> kept_;            ///< velocities of these, before a host changes them
  Array<S> free_inverse_mass_;
  double lost_ = 0;
};

template <class S>
template <class Alive>
bool TiedNodes<S>::update(const TiedMotion<S>& motion, double time, const Alive& alive) {
  if (nodes_.empty()) return false;
  const std::vector<std::uint8_t> before = active_;
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const TieTimes& times = times_[nodes_[i].tie];
    active_[i] = time >= times.start && time < times.end && alive(nodes_[i].slot) ? 1 : 0;
  }
  if (active_ == before) return false;
  join(motion, before);
  return true;
}

}  // namespace pinball
