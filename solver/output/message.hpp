#pragma once

#include <string>

namespace pinball {

/// Writes "pinball: TEXT" and a line break to stderr. That nobody can read it is no reason to end a run.
void print_message(const std::string& text);

}  // namespace pinball
