#pragma once

#include <string>
#include <vector>

#include <solver/scene.hpp>

namespace pinball {

/// Keys with another value than where they are left out, which say nothing as the scene is, since others are so or are
/// not there: a sentence for each table and reason. Each key says itself where that holds (Key::idle_where in
/// scene/schema). scene: completed, with contact decided.
std::vector<std::string> idle_keys(const Scene& scene);

}  // namespace pinball
