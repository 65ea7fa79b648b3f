#pragma once

#include <string>

namespace pinball {

/// Before runs that take long: throws InputError where the file of an option cannot be written. Empty path: there is
/// none.
void check_result_path(const std::string& option, const std::string& path);

/// Throws RunError that names the file.
void write_result_file(const std::string& path, const std::string& text);

}  // namespace pinball
