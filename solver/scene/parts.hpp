#pragma once

#include <solver/scene.hpp>

#include "table.hpp"

/// The tables that a scene holds any number of. Each function throws InputError on a missing key or a bad value.
namespace pinball {

/// The unit vector along the one under a required key. Throws InputError if that is zero.
Point read_direction(const SceneTable& table, std::string_view key);

/// One [[material]]. Moduli of either kind become K and G; an elastic material carries no yield or erosion data.
Material read_material(const SceneTable& table);

/// One [[body]], the element counts of its mesh multiplied by `refine`. Whether its material exists is not checked.
Body read_body(const SceneTable& table, int refine);

/// The mesh of a body, its element counts multiplied by `refine`.
MeshSettings read_mesh(const SceneTable& body, int refine);

/// One [[constraint]] of type "symmetry", its normal a unit vector. Whether its body exists is not checked.
PlaneConstraint read_constraint(const SceneTable& table);

}  // namespace pinball
