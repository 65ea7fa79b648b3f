#pragma once

#include <cmath>
#include <cstdint>

#include <kernels/macros.hpp>

namespace pinball::test {

/// What a step tells of itself: a sum, an extreme, a count.
struct Record {
  double sum = 0, least = INFINITY;
  std::int64_t count = 0;
  PINBALL_FUNCTION void join(const Record& other) {
    sum += other.sum;
    if (other.least < least) least = other.least;
    count += other.count;
  }
  bool operator==(const Record&) const = default;
};

struct RecordOf {
  const double* value;
  PINBALL_FUNCTION void operator()(std::int64_t i, Record& record) const { record.join({value[i], value[i], 1}); }
};

}  // namespace pinball::test
