#include "missing_on_ranks.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <vector>

#include <solver/base/error.hpp>
#include <solver/model/model.hpp>
#include <solver/scene_rules.hpp>

namespace pinball {

std::string missing_on_ranks(const Scene& scene) {
  std::vector<std::string> missing;
  const auto add = [&missing](bool is_there, const char* what) {
    if (is_there) missing.emplace_back(what);
  };
  add(scene.time.subcycling, "subcycling");
  add(scene.device != Device::none, "--device");
  return fmt::format("{}", fmt::join(missing, ", "));
}

void require_ranks_can(const Scene& scene) {
  const std::string missing = missing_on_ranks(scene);
  if (missing.empty()) return;
  throw InputError(
      fmt::format("{}several ranks cannot do this scene yet: it has {}; expected one process, without "
                  "mpirun",
                  message_head(scene), missing));
}

}  // namespace pinball
