#include "named_forces.hpp"

#include <algorithm>

#include "boundary_conditions.hpp"

namespace pinball {

NamedForces::NamedForces(const Scene& scene) {
  const auto add = [this](const auto& tables) {
    for (const auto& table : tables) {
      if (!table.name.empty() && std::ranges::find(names_, table.name) == names_.end()) names_.push_back(table.name);
    }
  };
  add(scene.constraints);
  add(scene.fixed_constraints);
  of_constraints_ = !names_.empty();
  add(scene.prescribed_velocities);
  add(scene.gravities);
  for (const PlaneConstraint& plane : scene.constraints) of_each_constraint_.push_back(plane.name);
  for (const FixedConstraint& fixed : scene.fixed_constraints) of_each_constraint_.push_back(fixed.name);
  for (const PrescribedVelocity& given : scene.prescribed_velocities) of_each_prescribed_.push_back(given.name);
}

void NamedForces::add(const std::string& name, const Point& force, std::vector<Point>& sums) const {
  if (name.empty()) return;
  Point& sum = sums[std::ranges::find(names_, name) - names_.begin()];
  for (std::size_t k = 0; k < 3; ++k) sum[k] += force[k];
}

template <class S>
void BoundaryConditions<S>::add_held_forces(std::vector<Point>& sums) const {
  const auto add = [&](const std::vector<std::string>& names, const auto& force_of) {
    for (std::size_t t = 0; t < names.size(); ++t) {
      if (names[t].empty()) continue;
      const VectorSum force = force_of(t);
      named_.add(names[t], {force.x, force.y, force.z}, sums);
    }
  };
  if (constrains_) add(named_.of_each_constraint(), [&](std::int32_t t) { return held_->force_of_constraint(t); });
  if (prescribes_) add(named_.of_each_prescribed(), [&](std::int32_t t) { return held_->force_of_prescribed(t); });
}

template <class S>
std::vector<Point> BoundaryConditions<S>::named_forces(const Model<S>& model) const {
  if (forces_read_) return *forces_read_;
  std::vector<Point> sums = steps_before_ > 0 ? forces_before_ : std::vector<Point>(named_.names().size(), Point{});
  add_held_forces(sums);
  for (Point& sum : sums) {
    for (double& component : sum) component /= steps_before_ + 1;
  }
  if (named_.any()) gravity_.add_forces(model, named_, sums);
  return sums;
}

template <class S>
std::vector<ForceResult> BoundaryConditions<S>::forces(const Model<S>& model) const {
  const std::vector<Point> sums = named_forces(model);
  std::vector<ForceResult> results;
  for (std::size_t i = 0; i < sums.size(); ++i) results.push_back({named_.names()[i], sums[i]});
  return results;
}

template std::vector<Point> BoundaryConditions<double>::named_forces(const Model<double>&) const;
template std::vector<Point> BoundaryConditions<float>::named_forces(const Model<float>&) const;
template std::vector<ForceResult> BoundaryConditions<double>::forces(const Model<double>&) const;
template std::vector<ForceResult> BoundaryConditions<float>::forces(const Model<float>&) const;

}  // namespace pinball
