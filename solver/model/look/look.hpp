#pragma once

#include <string>
#include <vector>

#include <solver/scene.hpp>

namespace pinball {

struct ModelMesh;

/// What a look at a scene finds before anything is computed.
struct Look {
  std::vector<std::string> unlikely;  ///< what nobody is likely to mean, a sentence each
  std::string cause;                  ///< the one of them that a run which fails owes it to; empty: none
  std::string contact_because;        ///< why contact is on or off, where the scene leaves it open
  double closing_speed = 0;  ///< of the fastest impact that is not on springs; 0: none is expected [length/time]
  double impact_speed = 0;   ///< that a body takes in the fastest impact; 0: none is expected [length/time]
};

/// Looks at units and materials, at speeds beside those of waves, at what can meet what and whether anything does, at
/// motions that constraints keep from acting, at keys that say nothing, and at layers of elements; decides contact
/// where the scene leaves it open (contact.method). mesh: of the scene, with ties found.
Look look_at(Scene& scene, const ModelMesh& mesh);

}  // namespace pinball
