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
}

const std::string& NamedForces::name_of_constraint(const Scene& scene, std::size_t table) {
  const std::size_t planes = scene.constraints.size();
  return table < planes ? scene.constraints[table].name : scene.fixed_constraints[table - planes].name;
}

void NamedForces::add(const std::string& name, const Point& force, std::vector<Point>& sums) const {
  if (name.empty()) return;
  Point& sum = sums[std::ranges::find(names_, name) - names_.begin()];
  for (std::size_t k = 0; k < 3; ++k) sum[k] += force[k];
}

template <class S>
std::vector<Point> BoundaryConditions<S>::named_forces(const Model<S>& model, double time) const {
  if (forces_read_) return *forces_read_;
  const Scene& scene = model.scene;
  std::vector<Point> sums(named_.names().size(), Point{});
  const auto add = [&](const std::string& name, const VectorSum& force) {
    named_.add(name, {force.x, force.y, force.z}, sums);
  };
  for (std::size_t t = 0; constrains_ && t < scene.constraints.size() + scene.fixed_constraints.size(); ++t) {
    const std::string& name = NamedForces::name_of_constraint(scene, t);
    if (!name.empty()) add(name, held_->force_of_constraint(t));
  }
  for (std::size_t t = 0; prescribes_ && t < scene.prescribed_velocities.size(); ++t) {
    const std::string& name = scene.prescribed_velocities[t].name;
    if (!name.empty()) add(name, held_->force_of_prescribed(t));
  }
  if (named_.any()) gravity_.add_forces(model, time, named_, sums);
  return sums;
}

template <class S>
std::vector<ForceResult> BoundaryConditions<S>::forces(const Model<S>& model, double time) const {
  const std::vector<Point> sums = named_forces(model, time);
  std::vector<ForceResult> results;
  for (std::size_t i = 0; i < sums.size(); ++i) results.push_back({named_.names()[i], sums[i]});
  return results;
}

template std::vector<Point> BoundaryConditions<double>::named_forces(const Model<double>&, double) const;
template std::vector<Point> BoundaryConditions<float>::named_forces(const Model<float>&, double) const;
template std::vector<ForceResult> BoundaryConditions<double>::forces(const Model<double>&, double) const;
template std::vector<ForceResult> BoundaryConditions<float>::forces(const Model<float>&, double) const;

}  // namespace pinball
