#pragma once

#include <string>

#include <solver/model/model.hpp>
#include <solver/scene/units/units.hpp>

namespace pinball {

/// "(1, 2, 3) m"
std::string vector_text(const Point& p, const std::string& unit);

/// Prints a line for each kind of boundary condition that the model has ("pinball info").
template <class S>
void print_boundary_conditions(const Model<S>& model, const Units& units);

}  // namespace pinball
