#include "thread_count.hpp"

#include <unistd.h>

namespace pinball {

bool has_lost_its_helpers() {
  thread_local const pid_t first_process = getpid();  // in which this thread first asked
  return getpid() != first_process;
}

}  // namespace pinball
