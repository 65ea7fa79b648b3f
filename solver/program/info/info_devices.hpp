#pragma once

#include <string>

#include <solver/scene.hpp>

namespace pinball {

/// "63.5 MB"
std::string readable_bytes(double bytes);

/// What of a scene no device can do yet.
void print_missing_on_devices(const Scene& scene);

/// One line for each device: what it is, or why there is none.
void print_devices();

}  // namespace pinball
