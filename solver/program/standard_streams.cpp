#include "standard_streams.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>

#include <solver/base/error.hpp>

namespace pinball {

void open_closed_streams() {
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(descriptor, F_GETFD) >= 0 || errno != EBADF) continue;
    ::open("/dev/null", O_RDWR);  // takes the lowest number that is free: this one
  }
}

namespace {

int errors_before = -1;  // descriptor; < 0: they were not muted

}  // namespace

void mute_output() {
  std::fflush(stdout);
  std::fflush(stderr);
  errors_before = ::dup(STDERR_FILENO);
  const int nothing = ::open("/dev/null", O_WRONLY);
  ::dup2(nothing, STDOUT_FILENO);
  ::dup2(nothing, STDERR_FILENO);
  ::close(nothing);
}

void unmute_errors() {
  if (errors_before >= 0) ::dup2(errors_before, STDERR_FILENO);
}

void finish_stdout() {
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return;
  throw RunError("standard output has not taken all that was written to it: no room is left, or nobody reads it");
}

}  // namespace pinball
