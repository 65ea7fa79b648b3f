#include <algorithm>

#include <solver/scene_rules.hpp>

namespace pinball {

std::optional<Problem> problem_of(const ErosionSettings& e) {
  const auto limits = {e.tension,      e.compression, e.principal_stress, e.effective_stress, e.principal_strain,
                       e.shear_strain, e.time,        e.smallest_step,    e.step_share};
  if (std::ranges::none_of(limits, [](double limit) { return limit > 0; })) {
    return Problem{"tension", "expected this or another limit > 0, got none"};
  }
  return {};
}

}  // namespace pinball
