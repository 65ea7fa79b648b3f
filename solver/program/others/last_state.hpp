#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <solver/field_base.hpp>
#include <solver/results.hpp>

#include "other_history.hpp"

namespace pinball {

/// Nodes that a mesh file numbers, at the end of a run, by ascending numbers. A number that two files give is left out.
struct LastState {
  double time = 0;
  std::vector<std::int64_t> numbers;
  std::vector<Point> displacements, velocities;  ///< one per number [length], [length/time]
};

LastState last_state(const FieldSnapshot& snapshot, const FieldBase& base);

/// A vector of nodes here beside that of another program, at the end of this run. Shares are of the longest vector
/// there.
struct StateDifference {
  std::string quantity;                    ///< "displacement" or "velocity"
  std::int64_t nodes = 0;                  ///< that both have
  double scale = 0;                        ///< the longest vector there
  std::optional<double> largest;           ///< the longest difference, as a share; none where all is zero there
  std::int64_t largest_node = 0;           ///< where that is
  std::optional<double> root_mean_square;  ///< of the differences over the nodes, as a share
};

/// Of what the other program has for nodes by their numbers, taken by straight lines at the time of the state. Empty:
/// there are no such nodes, or that time is none of its (a part in 1e-5 behind its last one counts as that).
std::vector<StateDifference> state_differences(const LastState& here, const OtherHistory& other);

/// What the name of a curve is of: "node_17_displacement_x".
struct NumberedQuantity {
  bool of_element = false;
  std::int64_t number = 0;
  std::string_view quantity;  ///< "displacement_x"
};
std::optional<NumberedQuantity> numbered_quantity(std::string_view name);

}  // namespace pinball
