#pragma once

#include <optional>

#include "comparison.hpp"

/// What the times of a comparison come to.
namespace pinball {

/// Of one time over the repeats [s].
struct Spread {
  double median = 0.0, smallest = 0.0, largest = 0.0;
};

struct VariantTimes {
  Spread total;                ///< of all steps
  Spread contact;              ///< all that contact costs: in each repeat the sum of the three below
  Spread surface;              ///< what contact needs to know of the elements: pinballs, or segments and their normals
  Spread search;               ///< for what may touch
  Spread forces;               ///< or impulses, and their scatter to the nodes
  double contact_share = 0.0;  ///< median of contact over median of total [-]
};

VariantTimes times_of(const VariantRuns& variant);

/// Times of the first variant over those of another one: above 1, the other one is faster. None where one of the two
/// failed, or where the other one's time is 0.
struct TimeRatios {
  std::optional<double> total, contact;
};

TimeRatios first_over(const VariantRuns& first, const VariantRuns& other);

}  // namespace pinball
