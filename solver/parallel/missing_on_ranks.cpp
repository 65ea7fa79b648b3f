#include "missing_on_ranks.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <solver/base/error.hpp>
#include <solver/model/model.hpp>

namespace pinball {

namespace {

bool begins_or_ends(const TimeSpan& when) { return when.start > 0 || !std::isinf(when.end); }

}  // namespace

std::string missing_on_ranks(const Scene& scene) {
  std::vector<std::string> missing;
  const auto add = [&missing](bool is_there, const char* what) {
    if (is_there) missing.emplace_back(what);
  };
  const auto changes = [](const auto& list) {
    return std::ranges::any_of(list, [](const auto& given) { return begins_or_ends(given.when); });
  };
  add(scene.contact.method != ContactMethod::none, "contact");
  add(!scene.tied_contacts.empty(), "tied contact");
  add(!scene.rigid_bodies.empty(), "rigid bodies");
  add(scene.time.subcycling, "subcycling");
  add(changes(scene.fixed_constraints) || changes(scene.prescribed_velocities),
      "constraints or prescribed velocities that begin or end");
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
