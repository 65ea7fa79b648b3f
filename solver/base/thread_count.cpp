#include "thread_count.hpp"

#include <unistd.h>

namespace pinball {

bool has_lost_its_helpers() {
#if defined(_OPENMP) && defined(PINBALL_OPENMP_REGIONS)
  thread_local const pid_t first_process = getpid();  // in which this thread first asked
  return getpid() != first_process;
#else
  return false;
#endif
}

}  // namespace pinball
