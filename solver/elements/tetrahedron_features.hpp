#pragma once

#include "element_features.hpp"

namespace pinball {

/// Of the one kernel that there is of tetrahedra.
inline constexpr ElementFeatures tetrahedron_features{.plastic = true,
                                                      .erosion = built::erosion,
                                                      .bulk_viscosity = built::bulk_viscosity,
                                                      .hourglass = HourglassKind::none,
                                                      .yield = YieldLaw::general,
                                                      .rare_cases = true,
                                                      .tetrahedra = true};

}  // namespace pinball
