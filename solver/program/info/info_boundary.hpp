#pragma once

#include <string>

#include <solver/model/model.hpp>
#include <solver/scene/units/units.hpp>

namespace pinball {

/// "(1, 2, 3) m"
std::string vector_text(const Point& p, const std::string& unit);

/// "1/s": the unit of a rate; empty without units.
std::string per_time(const Units& units);

/// "(1, 0, 0), (0, 1, 0)"
std::string directions_text(const std::vector<Point>& directions);

/// "velocity 3 m/s", "displacement 3 m", "acceleration 3 m/s^2": what a prescribed motion gives; way: the unit of a
/// displacement, a length or, of a rotation, "rad".
std::string motion_text(MotionQuantity quantity, const std::string& amount, const std::string& way, const Units& units);

/// ", from time 1, up to time 2": nothing where it acts from the start to the end.
std::string span_text(const TimeSpan& when, const Units& units);
std::string table_text(const TimeTable& table);

/// Prints a line for each kind of boundary condition that the model has ("pinball info").
template <class S>
void print_boundary_conditions(const Model<S>& model, const Units& units);

}  // namespace pinball
