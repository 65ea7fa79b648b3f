#pragma once

#include <string>
#include <vector>

#include <solver/scene.hpp>

namespace pinball {

/// What begins when the run has ended, each as a sentence.
std::vector<std::string> never_begun(const Scene& scene);

}  // namespace pinball
