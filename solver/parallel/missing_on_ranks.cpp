#include "missing_on_ranks.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <vector>

#include <solver/base/error.hpp>
#include <solver/model/model.hpp>
#include <solver/scene_rules.hpp>

namespace pinball {

std::string missing_on_ranks(const Scene& scene, bool averages_volumes) {
  if (scene.device == Device::none) return "";
  std::vector<std::string> missing;
  const auto add = [&missing](bool is_there, const char* what) {
    if (is_there) missing.emplace_back(what);
  };
  add(scene.time.subcycling, "subcycling");
  add(averages_volumes, "elements with averaged volumes");
  return fmt::format("{}", fmt::join(missing, ", "));
}

void require_ranks_can(const Scene& scene, bool averages_volumes) {
  const std::string missing = missing_on_ranks(scene, averages_volumes);
  if (missing.empty()) return;
  throw InputError(
      fmt::format("{}several ranks with a device each cannot do this scene yet: it has {}; expected --device none, or "
                  "one process, without mpirun",
                  message_head(scene), missing));
}

}  // namespace pinball
