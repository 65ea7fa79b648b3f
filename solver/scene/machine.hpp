#pragma once

#include <string>

namespace pinball {

/// The processor as it calls itself, "Intel(R) Xeon(R) ..."; "unknown" where the system does not say.
std::string processor_name();

/// Memory of this machine [bytes]; 0 if it does not say.
double memory_bytes();

}  // namespace pinball
