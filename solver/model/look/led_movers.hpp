#pragma once

#include <cstdint>
#include <vector>

#include "driven_motion.hpp"
#include "movers.hpp"

namespace pinball {

/// Movers of which one may take the others along: those that a joint joins, or an equation.
struct Lead {
  std::vector<std::size_t> movers;  ///< by their places in Movers::all
  double ratio = 1;                 ///< as many times as far as all others together one of them may go [-]
  bool may_meet_walls = false;      ///< of the scene: rigid bodies meet none
};

/// group: of each body, the place of its mover. Of the ground a joint joins none, of one mover an equation leads none.
std::vector<Lead> leads_of(const Scene& scene, const ModelMesh& mesh, const std::vector<std::int32_t>& group);

/// Those that hang together go where the others lead them, to any side: as far as one of them would by itself, or as
/// many times as far, and as they all are long. Those that nothing moves stay.
void let_others_lead(const std::vector<Lead>& leads, const std::vector<DrivenMotion>& driven, Movers& movers);

}  // namespace pinball
