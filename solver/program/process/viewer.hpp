#pragma once

#include <string>
#include <vector>

/// The viewer (python/view), which draws what runs have left.
namespace pinball {

/// The command that starts it with these arguments. Throws InputError where its files are not installed.
std::vector<std::string> viewer_command(const std::vector<std::string>& arguments);

/// Runs it to its end, with what it prints read. Returns why it drew nothing, in a sentence; empty: it did.
std::string draw_with_viewer(const std::vector<std::string>& arguments);

}  // namespace pinball
