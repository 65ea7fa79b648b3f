#pragma once

#include <string>

namespace pinball {

/// The processor as it calls itself, "Intel(R) Xeon(R) ..."; "unknown" where the system does not say.
std::string processor_name();

}  // namespace pinball
