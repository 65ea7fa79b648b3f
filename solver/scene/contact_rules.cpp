#include <fmt/format.h>

#include <cmath>

#include <solver/scene_rules.hpp>

namespace pinball {

void complete(ContactSettings& contact) {
  if (contact.gap == ContactGap::not_set) {
    contact.gap = contact.enforcement == Enforcement::penalty ? ContactGap::pinball : ContactGap::face;
  }
  if (contact.static_friction < 0) contact.static_friction = contact.friction;
}

void complete(ContactPair& pair, const ContactSettings& contact) {
  if (pair.friction < 0 && pair.static_friction < 0 && pair.friction_decay < 0) {
    pair.friction = contact.friction;
    pair.static_friction = contact.static_friction;
    pair.friction_decay = contact.friction_decay;
  }
  if (pair.friction < 0) pair.friction = 0;
  if (pair.static_friction < 0) pair.static_friction = pair.friction;
  if (pair.friction_decay < 0) pair.friction_decay = 0;
}

std::optional<Problem> problem_of(const ContactSettings& contact) {
  const bool penalty = contact.enforcement == Enforcement::penalty;
  if (contact.method != ContactMethod::slideline && penalty && contact.gap == ContactGap::face) {
    return Problem{"gap", "\"face\" needs enforcement = \"projection\" or \"lagrange\" in this version"};
  }
  const bool any_friction = contact.static_friction > 0 || contact.friction > 0;
  if (contact.static_friction < contact.friction && !(contact.friction_decay > 0)) {
    return Problem{"static_friction", fmt::format("expected a number >= friction = {:.6g}, got {:.6g}",
                                                  contact.friction, contact.static_friction)};
  }
  if (contact.enforcement == Enforcement::projection && contact.static_friction > contact.friction) {
    return Problem{"static_friction", "another value than friction needs enforcement = \"lagrange\""};
  }
  if (penalty && any_friction) {
    return Problem{contact.friction > 0 ? "friction" : "static_friction",
                   "expected 0: friction needs enforcement = \"projection\" or \"lagrange\""};
  }
  const bool balls = contact.method == ContactMethod::pinball || contact.method == ContactMethod::not_set;
  if (balls && contact.gap == ContactGap::pinball && any_friction) {
    return Problem{contact.friction > 0 ? "friction" : "static_friction",
                   "expected 0: balls do not touch where elements do, friction needs gap = \"face\""};
  }
  return {};
}

namespace {

std::optional<Problem> problem_of_times(double start, double end) {
  if (std::isfinite(start) && end > start) return {};
  return Problem{"end", fmt::format("expected a time after start = {:.6g}, got {:.6g}", start, end)};
}

}  // namespace

std::optional<Problem> problem_of(const ContactPair& pair, const ContactSettings& contact) {
  if (contact.method == ContactMethod::none) {
    return Problem{"name", "a pair needs contact.method = \"pinball\" or \"slideline\", got \"none\""};
  }
  if (pair.first.empty()) return Problem{"first", "expected at least one body or set, got none"};
  const bool balls = contact.method != ContactMethod::slideline && contact.gap == ContactGap::pinball;
  const bool nodes = !pair.first.nodes.empty() || !pair.second.nodes.empty();
  if (nodes && balls) return Problem{"first", "balls are those of elements: sets of nodes need contact.gap = \"face\""};
  if (!pair.first.nodes.empty() && pair.second.empty()) {
    return Problem{"second", "missing: a set of nodes needs faces to touch"};
  }
  ContactSettings as_all = contact;
  as_all.friction = pair.friction;
  as_all.static_friction = pair.static_friction;
  as_all.friction_decay = pair.friction_decay;
  if (const auto problem = problem_of(as_all); problem && problem->key.ends_with("friction")) return problem;
  return problem_of_times(pair.start, pair.end);
}

std::optional<Problem> problem_of(const TiedContact& tied) {
  if (tied.first.empty()) return Problem{"first", "expected at least one body or set, got none"};
  if (tied.second.empty()) return Problem{"second", "expected at least one body or set, got none"};
  if (!tied.second.nodes.empty()) return Problem{"second", "expected faces to tie to: no sets of nodes"};
  if (std::isnan(tied.tolerance)) return Problem{"tolerance", "expected a number >= 0"};
  return problem_of_times(tied.start, tied.end);
}

}  // namespace pinball
