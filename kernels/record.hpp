#pragma once

#include <cstdint>

#include "macros.hpp"

namespace pinball {

/// Record n of an array of records of four numbers, as nodes have them (gather.hpp); S may be const.
template <class S>
PINBALL_FUNCTION S* record(S* records, std::int64_t n) {
  return records + 4 * n;
}

}  // namespace pinball
