#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include <solver/base/state_archive.hpp>
#include <solver/model/model.hpp>

namespace pinball {

/// Velocities that a host changes between two steps, from v to v'. The nodes have gone the last step with v, so that
/// strains come of these; v' come in when the elements have been worked. The work of that is what it adds to the energy
/// that central differences keep, m/2 v.(v + dt(n-1/2) a): m/2 (v' - v).(v + v') and, of forces f whose energy is known
/// by the places of the nodes, those of elements and springs, dt(n-1/2)/2 (v' - v).f. All others count their work with
/// v'.
template <class S>
class ChangedVelocities {
 public:
  bool any() const { return !other_.empty(); }

  /// Of the last step, in place of those of the model, while a change is there.
  const S* of_last_step(const Model<S>& model, std::int32_t node) const {
    return any() ? other_.data() + 4 * static_cast<std::size_t>(node) : model.nodes.velocity_of(node);
  }

  /// Before a host changes them.
  void keep(const Model<S>& model) {
    const auto& velocity = model.nodes.velocity;
    other_.assign(velocity.data(), velocity.data() + velocity.size());
  }
  void forget() { other_.clear(); }

  /// Those from before come into the model, and those of the host with the next call, and so on.
  void exchange(Model<S>& model) { std::swap_ranges(other_.begin(), other_.end(), model.nodes.velocity.data()); }

  /// Those of the model are the new ones, of which constraints let nothing come along what they hold. Returns the first
  /// part of the work, and keeps what they change [energy].
  double begin(Model<S>& model) {
    double work = 0;
    for (const NodeConstraint<S>& held : model.constraints) {
      S* const v = model.nodes.velocity_of(held.node);
      const S along = v[0] * held.normal[0] + v[1] * held.normal[1] + v[2] * held.normal[2];
      for (std::size_t k = 0; k < 3; ++k) v[k] -= along * held.normal[k];
    }
    for_each_component([&](std::size_t n, std::size_t k) {
      const double v = model.nodes.velocity[k], before = other_[k];
      work += 0.5 * model.node_mass[n] * (v - before) * (v + before);
      other_[k] = static_cast<S>(v - before);
    });
    return work;
  }
  /// Since begin(): v' - v, in records of four.
  const S* changes() const { return other_.data(); }
  /// force: those of elements and springs, in records of four. Returns the second part [energy].
  double end(const S* force, double dt) {
    double power = 0;
    for_each_component([&](std::size_t /*node*/, std::size_t k) {
      power += static_cast<double>(other_[k]) * static_cast<double>(force[k]);
    });
    other_.clear();
    return 0.5 * dt * power;
  }

  void persist(StateArchive& archive, const Model<S>& model) {
    archive(other_);
    archive.require(other_.empty() || other_.size() == model.nodes.velocity.size());
  }
  std::size_t bytes() const { return other_.capacity() * sizeof(S); }

 private:
  template <class Function>
  void for_each_component(const Function& function) {
    for (std::size_t n = 0; 4 * n < other_.size(); ++n) {
      for (std::size_t k = 0; k < 3; ++k) function(n, 4 * n + k);
    }
  }

  std::vector<S> other_;  ///< four of each node, as in the model; empty: nobody changes them
};

}  // namespace pinball
