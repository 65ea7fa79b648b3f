#include "stop_signals.hpp"

#include <signal.h>
#include <unistd.h>

#include <atomic>
#include <string_view>

namespace pinball {

namespace {

// A handler may touch lock-free atomics, and call write() and _exit().
std::atomic<int> asked = 0;
std::atomic<bool> ends_at_once = true;
static_assert(std::atomic<int>::is_always_lock_free && std::atomic<bool>::is_always_lock_free);

extern "C" void handle_stop_signal(int signal) {
  if (signal == SIGXCPU && asked == SIGXCPU) return;  // comes again after every second
  if (ends_at_once.exchange(true)) ::_exit(128 + signal);
  asked = signal;
  constexpr std::string_view text = "\npinball: ends after this step; a second signal ends it at once\n";
  [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, text.data(), text.size());
}

}  // namespace

void catch_stop_signals(AtSignal what) {
  ends_at_once = what == AtSignal::end;
  // A run is not to end in the middle of a step because nobody reads its log, or a file may not grow: writing fails
  // then.
  if (what == AtSignal::ask) {
    for (const int signal : {SIGPIPE, SIGXFSZ}) ::signal(signal, SIG_IGN);
  }
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGUSR1, SIGUSR2, SIGXCPU}) {
    struct sigaction present {};
    if (::sigaction(signal, nullptr, &present) == 0 && present.sa_handler == SIG_IGN) continue;
    struct sigaction action {};
    action.sa_handler = handle_stop_signal;
    action.sa_flags = SA_RESTART;
    ::sigemptyset(&action.sa_mask);
    ::sigaction(signal, &action, nullptr);
  }
}

int stop_signal() { return asked; }

}  // namespace pinball
