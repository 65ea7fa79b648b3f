#pragma once

#include <array>
#include <cstdint>
#include <string>

#include <solver/contact/algorithm/contact_algorithm.hpp>
#include <solver/model/model.hpp>

namespace pinball {

/// Corners of an element at the time of the forces, dt before that of the positions [length].
template <class S>
std::array<Point, 8> corners_at_forces(const Model<S>& model, std::int64_t slot, double dt);
/// The name of a node of the store (place_names.hpp); empty for a negative number.
template <class S>
std::string node_name(const Model<S>& model, std::int64_t node);
/// Node of the store on which the last step's contact force was largest; negative where there was none.
template <class S>
std::int64_t most_pushed_node(const Model<S>& model, const ContactAlgorithm<S>& contact);
/// Slot whose hourglass forces have most energy: what they have kept from step to step, or, of a form that keeps
/// nothing, what they take while a wave crosses the element. Negative where there is none.
template <class S>
std::int64_t most_hourglassed_slot(const Model<S>& model);

}  // namespace pinball
