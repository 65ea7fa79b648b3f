#include "short_waits.hpp"

#include <sys/auxv.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>

#include <kernels/exec.hpp>

namespace pinball {

namespace {

bool environment_says() {
  for (const char* name : {"GOMP_SPINCOUNT", "OMP_WAIT_POLICY"}) {
    if (std::getenv(name) != nullptr) return true;
  }
  return false;
}

/// The program itself is what the system has started, and not its loader with the program as an argument.
bool was_started_by_name() { return ::getauxval(AT_BASE) != 0; }

}  // namespace

void start_again_with_short_waits(char** arguments, int threads) {
  if ((threads > 0 ? threads : DefaultExecutionSpace::concurrency()) == 1) return;
  if (environment_says() || !was_started_by_name()) return;
  std::error_code none;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", none);
  if (none || ::setenv("GOMP_SPINCOUNT", "1000", 0) != 0) return;
  ::execv(program.c_str(), arguments);
}

}  // namespace pinball
