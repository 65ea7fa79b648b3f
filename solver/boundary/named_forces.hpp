#pragma once

#include <string>
#include <vector>

#include <solver/scene.hpp>

namespace pinball {

/// Names of constraints, prescribed velocities and accelerations whose force on the nodes is asked for: each once, in
/// the order of the scene.
class NamedForces {
 public:
  explicit NamedForces(const Scene& scene);

  const std::vector<std::string>& names() const { return names_; }
  bool any() const { return !names_.empty(); }
  bool of_constraints() const { return of_constraints_; }  ///< whether any constraint has a name

  /// Of each [[constraint]] by its number in NodeConstraint, and of each [[prescribed_velocity]]; empty: none.
  const std::vector<std::string>& of_each_constraint() const { return of_each_constraint_; }
  const std::vector<std::string>& of_each_prescribed() const { return of_each_prescribed_; }
  /// Adds a force of a table to the sum for its name; to none where that is empty. sums: one per name [force].
  void add(const std::string& name, const Point& force, std::vector<Point>& sums) const;

 private:
  std::vector<std::string> names_, of_each_constraint_, of_each_prescribed_;
  bool of_constraints_ = false;
};

}  // namespace pinball
