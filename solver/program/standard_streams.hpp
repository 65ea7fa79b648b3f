#pragma once

#include <solver/base/export.h>

namespace pinball {

/// Opens stdin, stdout and stderr on /dev/null where the program was started without them: else the next file that is
/// opened would take their place, and messages would go into it.
PINBALL_API void open_closed_streams();

/// Writes out what is left for stdout. Throws RunError where not all of it has got there: a full disk.
PINBALL_API void finish_stdout();

/// From now on this process says nothing, and unmute_errors() lets it: of several that run one scene, one speaks.
PINBALL_API void mute_output();
PINBALL_API void unmute_errors();

}  // namespace pinball
