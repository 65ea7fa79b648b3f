#pragma once

#include <string>

#include "units.hpp"

namespace pinball {

/// Why an acceleration by gravity [length/time^2] is the earth's in other units than the scene's, as the end of a
/// sentence; empty: it may be meant, as 100 times the earth's are in a centrifuge, or no units are named.
std::string unlikely_gravity(double acceleration, const Units& units);

}  // namespace pinball
