#pragma once

#include <string>

namespace pinball {

/// The usual name of a keyword: "MAT/ELAST" of "MAT/LAW1" or "MAT/LAW01", "PROP/SOLID" of "PROP/TYPE14".
std::string radioss_name(const std::string& words);

/// Whether the first line of a keyword of this name is a title.
bool radioss_has_title(const std::string& name);

}  // namespace pinball
