#pragma once

#include <functional>
#include <optional>

#include "movers.hpp"

namespace pinball {

/// Two bodies that come to each other.
struct Meeting {
  std::int32_t first = 0, second = 0;  ///< bodies
  double time = 0;                     ///< when, at the earliest [time]
  double speed = 0;                    ///< largest of one as the other sees it [length/time]
};

struct Meetings {
  std::optional<Meeting> expected;  ///< the first of those that go into each other if all goes on as it begins
  std::optional<Meeting>
      possible;  ///< the first of those that touch and move, or that a deformation or a rebound may bring so far
  std::optional<Meeting> fastest;  ///< of those that meet if all goes on as it begins
  std::optional<Meeting> passing;  ///< the first of the expected ones that may not touch
};

/// Which of the movers meet, by the boxes of their cells; those that do not move beside each other do not. At most so
/// many that a tenth of a second is enough: of more than 2,000 movers any two may possibly meet.
/// mesh: of the movers, by whose nodes what gains speed meets; may_touch: of two bodies.
Meetings find_meetings(const Movers& movers, const ModelMesh& mesh,
                       const std::function<bool(std::int32_t, std::int32_t)>& may_touch);

}  // namespace pinball
