#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <kernels/exec.hpp>
#include <kernels/node_update.hpp>
#include <solver/boundary/boundary_conditions.hpp>
#include <solver/boundary/space/space_boundary_kernels.hpp>
#include <solver/boundary/symmetry_walls.hpp>

namespace pinball::test {

/// What elements would do to a node, and its motion. Forces stay as they are, to be looked at.
template <class S>
struct PushNodes {
  S* force;
  S step;
  PINBALL_FUNCTION void operator()(std::int64_t n) const {
    for (int k = 0; k < 3; ++k) force[4 * n + k] = S((7 * n + 3 * k + std::int64_t(step)) % 11 - 5) * S(1e4);
  }
};
template <class S>
struct IntegrateNodes {
  NodeArrays<S> nodes;
  S* force;  ///< a copy
  S velocity_step, position_step;
  PINBALL_FUNCTION void operator()(std::int64_t n) const {
    for (int c = 0; c < 4; ++c) force[c + 4 * n] = nodes.force[c + 4 * n];
    integrate_node(nodes.position + 4 * n, nodes.velocity + 4 * n, force + 4 * n, nodes.inverse_mass[n], velocity_step,
                   position_step, velocity_step);
  }
};

/// Nodes of a scene without forces of elements: pushed to and fro, and held by all that acts on them from outside, in
/// the memory of a space.
template <class S, class Space>
class SpaceRun {
 public:
  explicit SpaceRun(const Scene& scene)
      : model_(build_model<S>(scene)),
        boundary_(model_, std::make_unique<SpaceBoundaryKernels<S, Space>>()),
        symmetry_(model_, SpaceBoundaryKernels<S, Space>()),
        position_(in_space(model_.nodes.position)),
        velocity_(in_space(model_.nodes.velocity)),
        force_(model_.nodes.force.size()),
        force_left_(model_.nodes.force.size()),
        inverse_mass_(in_space(model_.nodes.inverse_mass)),
        element_mass_(in_space(model_.elements.mass.template in<S>())) {
    mass_.renew(model_.node_mass.size());
    deep_copy(mass_, model_.node_mass.data(), model_.node_mass.size());
  }

  Model<S>& model() { return model_; }
  std::vector<ForceResult> named_forces() const {
    std::vector<ForceResult> forces = boundary_.forces(model_);
    symmetry_.add_forces(forces);
    return forces;
  }
  BoundaryConditions<S>& boundary() { return boundary_; }
  /// Takes an element of the scene away, as erosion does.
  void erode(std::size_t element) {
    model_.elements.mass[static_cast<std::size_t>(model_.slot_of_element[element])] = S(0);
    deep_copy(element_mass_, model_.elements.mass.template in<S>());
  }

  void step(double length) {
    const StepLengths lengths{before_, length};
    parallel_for("push", RangePolicy<Space>{0, model_.nodes.count}, PushNodes<S>{force_.data(), S(steps_)});
    symmetry_.keep_forces(arrays());
    boundary_.follow(model_, arrays(), time_, lengths);
    boundary_.add_loads(arrays(), time_, lengths);
    boundary_.hold(arrays(), time_, lengths);
    boundary_.add_wall_reactions(arrays(), time_, lengths, {});
    boundary_.count_work(arrays(), lengths);
    parallel_for("integration", RangePolicy<Space>{0, model_.nodes.count},
                 IntegrateNodes<S>{arrays(), force_left_.data(), S(lengths.velocity()), S(length)});
    boundary_.add_work(symmetry_.reflect(arrays(), lengths, true));
    before_ = length;
    time_ += length;
    ++steps_;
  }

  std::vector<S> forces() const { return on_host(force_); }
  std::vector<S> velocities() const { return on_host(velocity_); }
  std::vector<S> positions() const { return on_host(position_); }

 private:
  using Memory = typename Space::memory_space;
  NodeArrays<S> arrays() {
    return {position_.data(),     velocity_.data(), force_.data(),
            inverse_mass_.data(), mass_.data(),     element_mass_.data()};
  }
  static Array<S, Memory> in_space(const Array<S>& from) {
    Array<S, Memory> array(from.size());
    deep_copy(array, from);
    return array;
  }
  static std::vector<S> on_host(const Array<S, Memory>& from) {
    std::vector<S> copy(from.size());
    deep_copy(copy.data(), from);
    return copy;
  }

  Model<S> model_;
  BoundaryConditions<S> boundary_;
  SymmetryWalls<S> symmetry_;
  Array<S, Memory> position_, velocity_, force_, force_left_, inverse_mass_, element_mass_;
  Array<double, Memory> mass_;
  double time_ = 0, before_ = 0;
  int steps_ = 0;
};

}  // namespace pinball::test
