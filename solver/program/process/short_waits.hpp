#pragma once

#include <solver/base/export.h>

namespace pinball {

/// Threads of GCC's OpenMP that wait for each other spin for long, as if the machine were theirs alone: beside other
/// work a run of a second takes a minute. How long they spin stands in the environment alone, and is read before main.
/// So, where several threads will work and the environment says nothing of it, this starts the program again in its own
/// place, with its arguments and GOMP_SPINCOUNT=1000 (docs/performance.md, "How many threads"). Nothing must have been
/// read or written yet. Returns where there is nothing to do, or it cannot be done.
PINBALL_API void start_again_with_short_waits(char** arguments, int threads);

}  // namespace pinball
