#pragma once

#include <string>
#include <vector>

namespace pinball {

/// Folders that may hold scenes, decks and materials, the most particular first: what the user says (PINBALL_DATA),
/// what was installed with this library or program, the source tree.
std::vector<std::string> data_folders();

}  // namespace pinball
