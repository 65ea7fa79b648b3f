#pragma once

#include <string>
#include <vector>

#include <solver/scene.hpp>

/// A scene as it is run: every key with its value, also those that the file lacks.
namespace pinball {

struct SceneEntry {
  std::string table;  ///< "contact", "material.copper", "body.rod.mesh"; empty for the top level
  std::string key;
  std::string value;        ///< as in TOML; "not set" for what has neither a value nor a default
  std::string unit;         ///< of T, L and M, as in data/scenes/README.md: "L/T", "M/(L T^2)", "-"; empty: no number
  bool is_default = false;  ///< the value is what it would be without the key
};

/// Of a completed scene, in the order of the scene format.
std::vector<SceneEntry> list_scene(const Scene& scene);

}  // namespace pinball
