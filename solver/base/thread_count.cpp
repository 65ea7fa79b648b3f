#include "thread_count.hpp"

#include <algorithm>
#include <cstdlib>

namespace pinball {

int earned_threads(std::int64_t elements) {
  const int most = DefaultExecutionSpace::concurrency();
  if (const char* said = std::getenv("OMP_NUM_THREADS"); said != nullptr && *said != '\0') return most;
  return std::clamp<std::int64_t>(elements / elements_of_thread, 1, most);
}

}  // namespace pinball
