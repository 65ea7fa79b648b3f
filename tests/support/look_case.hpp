#pragma once

#include <solver/model/model.hpp>
#include <solver/scene_rules.hpp>

/// What a look at a scene before the first step sees and decides.
namespace pinball::test {

inline Look look(Scene scene) {
  complete_scene(scene);
  ModelMesh mesh = build_mesh(scene);
  return look_at(scene, mesh);
}

inline ContactMethod decided(Scene scene) {
  complete_scene(scene);
  ModelMesh mesh = build_mesh(scene);
  look_at(scene, mesh);
  return scene.contact.method;
}

}  // namespace pinball::test
