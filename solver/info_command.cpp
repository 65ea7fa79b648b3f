#include <fmt/core.h>
#include <pinball/solver/commands.hpp>
namespace pinball {
int info_command(const RunOptions&) { return 0; }
int verify_command(const VerifyOptions&) { return 0; }
}
