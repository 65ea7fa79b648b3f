#pragma once

#include <solver/base/export.h>

/// Ctrl-C (SIGINT), SIGTERM, the end of the terminal (SIGHUP), and what batch systems send before they kill a job
/// (SIGUSR1, SIGUSR2, SIGXCPU), for the program: the library knows of no signal.
namespace pinball {

/// What the first signal does; a second one always ends the program at once, with status 128 + its number.
enum class AtSignal {
  end,  ///< the same as a second one
  ask   ///< asks the run to end after its step: see stop_signal()
};

/// From now on. A signal that the program was started to ignore (nohup) stays ignored.
PINBALL_API void catch_stop_signals(AtSignal what);

/// The signal that has asked for an end; 0: none.
PINBALL_API int stop_signal();

}  // namespace pinball
