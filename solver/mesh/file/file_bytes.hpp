#pragma once

#include <string>

namespace pinball {

/// All of a file. Throws InputError where it cannot be read.
std::string bytes_of_file(const std::string& path);

}  // namespace pinball
