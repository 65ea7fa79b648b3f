#pragma once

#include <solver/scene_boundary.hpp>

#include "table.hpp"

/// The tables that say what acts on a scene from outside, and what is watched in it. Each function throws InputError on
/// a missing key or a bad value. Whether a body exists is not checked.
namespace pinball {

/// Something has to be given of a selection that a table has.
void require_selection(const SceneTable& table, const NodeSelection& nodes);
PlaneConstraint read_symmetry(const SceneTable& table);
FixedConstraint read_fixed_constraint(const SceneTable& table);
EquationTerm read_equation_term(const SceneTable& table);
/// `number`: of the wall in the file, for its default name.
RigidWall read_rigid_wall(const SceneTable& table, std::size_t number);
PrescribedVelocity read_prescribed_velocity(const SceneTable& table);
NodalLoad read_load(const SceneTable& table);
/// `number`: of the pressure in the file, for its default name.
Pressure read_pressure(const SceneTable& table, std::size_t number);
/// `bodies`: their names.
Gravity read_gravity(const SceneTable& table, const std::vector<std::string>& bodies);
PointMass read_point_mass(const SceneTable& table);
InitialVelocity read_initial_velocity(const SceneTable& table);
InitialStress read_initial_stress(const SceneTable& table);
Probe read_probe(const SceneTable& table);

}  // namespace pinball
