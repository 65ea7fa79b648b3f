#pragma once

#include <string>

#include <solver/scene.hpp>

namespace pinball {

/// The processor as it calls itself, "Intel(R) Xeon(R) ..."; "unknown" where the system does not say.
std::string processor_name();

/// Memory of this machine [bytes]; 0 if it does not say.
double memory_bytes();

/// Memory that a run takes for an element with its nodes: what the tables of a scene besides its bodies say of it;
/// element: settings of the body.
double least_bytes_of_element(const Scene& scene, const ElementSettings& element);

}  // namespace pinball
