#include "energy_checks.hpp"

#include <fmt/core.h>

#include "percent.hpp"
#include "sound_bounds.hpp"

namespace pinball {

namespace {

/// ", beyond 10 % since time 1.2e-05 (node 17 of body rod)"
std::string since(const WatchedShare& share, double bound, const char* what) {
  std::string text = fmt::format(", beyond {} since time {:.6g}", percent(bound), share.since);
  if (!share.place.empty()) text += fmt::format(" ({} {})", what, share.place);
  return text;
}

}  // namespace

std::vector<EnergyCheck> energy_checks(const RunSummary& s) {
  std::vector<EnergyCheck> checks;
  const auto add = [&checks](const char* what, const WatchedShare& share, double bound, const std::string& head,
                             const char* place, const std::string& advice) {
    const bool sound = !(share.largest > bound);
    checks.push_back({what, share.largest, bound, sound ? "" : head + since(share, bound, place) + ": " + advice});
  };
  const bool contact = s.contact_method != "none";
  const char* const eroded = s.energy.eroded > 0 ? " and that of eroded elements" : "";
  const bool springs = contact && s.contact_enforcement == "penalty";
  // Shorter steps lose more of what is slow, not less.
  const char* const digits = s.precision == "float" ? "precision = \"mixed\", which keeps what is slow, or " : "";
  add("error of the balance, of the energy in motion", s.balance_error_in_motion, sound::balance,
      fmt::format("the energy balance was off by up to {} of the energy in motion",
                  percent(s.balance_error_in_motion.largest)),
      "the step was set by", fmt::format("try {}a smaller time.cfl{}", digits, contact ? " or contact.beta" : ""));
  if (contact) {
    add("energy that contact made, of that in motion", s.contact_created, sound::contact_created,
        fmt::format("contact made energy out of nothing, up to {} of that in motion",
                    percent(s.contact_created.largest)),
        "largest force on",
        springs ? "try a smaller time.cfl or contact.enforcement = \"lagrange\""
                : "try contact.enforcement = \"lagrange\", or a finer mesh");
  }
  if (s.contact_swallowed_sound > 0) {
    add("energy that contact swallowed, of that in motion", s.contact_swallowed, s.contact_swallowed_sound,
        fmt::format("contact swallowed {} of the energy in motion, although nothing is plastic or rubs",
                    percent(s.contact_swallowed.largest)),
        "largest force on", "try a finer mesh there");
  }
  add("energy that hourglass forces made, of the internal energy", s.hourglass_created, sound::hourglass_created,
      fmt::format("hourglass forces made energy out of nothing, up to {} of the internal energy",
                  percent(s.hourglass_created.largest)),
      "most of it in", "try a finer mesh there, or another element.hourglass");
  add("hourglass energy, of the internal energy", s.hourglass_large, sound::hourglass,
      fmt::format("hourglass energy reached {} of the internal energy{}", percent(s.hourglass_large.largest), eroded),
      "most of it in", "try a finer mesh there, with several elements through what bends");
  add("plastic work of hourglass modes, of the internal energy", s.hourglass_plastic, sound::hourglass_plastic,
      fmt::format("hourglass modes have taken {} of the internal energy{} by yielding",
                  percent(s.hourglass_plastic.largest), eroded),
      "most of what is left in", "elements bend or fold by themselves: try several elements through what bends");
  add("kinetic energy below zero, of the energy in motion", s.kinetic_below_zero, sound::kinetic_below_zero,
      fmt::format(
          "the kinetic energy was below zero, by up to {} of the energy in motion, and is reported as zero there",
          percent(s.kinetic_below_zero.largest)),
      "the step was set by", "the step is too long for what moves: try a smaller time.cfl");
  add("internal energy below zero, of the energy in motion", s.internal_below_zero, sound::internal_below_zero,
      fmt::format("the internal energy was below zero, by up to {} of the energy in motion",
                  percent(s.internal_below_zero.largest)),
      "the step was set by",
      fmt::format("elements gave back more than they took: try {}a smaller time.cfl, or a finer mesh", digits));
  return checks;
}

}  // namespace pinball
