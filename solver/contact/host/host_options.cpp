#include "host_options.hpp"

#include <cmath>

#include <solver/base/thread_count.hpp>

#include "host_error.hpp"

namespace pinball {

namespace {

void require_choice(std::int32_t value, std::int32_t last, const char* name) {
  if (value < 0 || value > last) {
    throw HostError(PINBALL_CONTACT_BAD_OPTION, "options->", name, ": ", value, " is not one of 0 ... ", last);
  }
}

void require_number(double value, double least, bool may_be_least, const char* name) {
  if (std::isfinite(value) && (value > least || (may_be_least && value == least))) return;
  throw HostError(PINBALL_CONTACT_BAD_OPTION, "options->", name, ": expected a number ", may_be_least ? ">= " : "> ",
                  least, ", got ", value);
}

void require_at_most(double value, double most, const char* name) {
  if (value <= most) return;
  throw HostError(PINBALL_CONTACT_BAD_OPTION, "options->", name, ": expected a number <= ", most, ", got ", value);
}

}  // namespace

ContactSettings settings_of(const pinball_contact_options* options) {
  require_version(options, "options");
  require_choice(options->number, PINBALL_CONTACT_FLOAT, "number");
  require_choice(options->index, PINBALL_CONTACT_INT64, "index");
  require_choice(options->first_index, 1, "first_index");
  require_choice(options->method, PINBALL_CONTACT_SLIDELINE, "method");
  require_choice(options->enforcement, PINBALL_CONTACT_LAGRANGE, "enforcement");
  require_choice(options->gap, PINBALL_CONTACT_GAP_FACE, "gap");
  require_choice(options->radius, PINBALL_CONTACT_RADIUS_CURRENT, "radius");
  require_choice(options->self, 1, "self");
  require_choice(options->keep_lists, 1, "keep_lists");
  if (options->threads < 0) {
    throw HostError(PINBALL_CONTACT_BAD_OPTION, "options->threads: expected 0 or more, got ", options->threads);
  }
  require_at_most(options->threads, most_threads, "threads");
  require_number(options->beta, 0, false, "beta");
  require_number(options->damping, 0, true, "damping");
  require_number(options->friction, 0, true, "friction");
  require_number(options->radius_factor, 0, false, "radius_factor");
  require_at_most(options->radius_factor, largest_radius_factor, "radius_factor");
  require_number(options->skin, 0, false, "skin");
  require_at_most(options->skin, largest_skin, "skin");
  ContactSettings settings;
  settings.method = options->method == PINBALL_CONTACT_SLIDELINE ? ContactMethod::slideline : ContactMethod::pinball;
  settings.enforcement = options->enforcement == PINBALL_CONTACT_PENALTY      ? Enforcement::penalty
                         : options->enforcement == PINBALL_CONTACT_PROJECTION ? Enforcement::projection
                                                                              : Enforcement::lagrange;
  settings.gap = options->gap == PINBALL_CONTACT_GAP_FACE ? ContactGap::face : ContactGap::pinball;
  settings.radius = options->radius == PINBALL_CONTACT_RADIUS_CURRENT ? ContactRadius::current : ContactRadius::initial;
  settings.self = options->self == 1;
  settings.beta = options->beta;
  settings.damping = options->damping;
  settings.friction = options->friction;
  settings.static_friction = options->static_friction < 0 ? options->friction : options->static_friction;
  require_number(settings.static_friction, settings.friction, true, "static_friction");
  if (settings.static_friction > 0 && settings.enforcement == Enforcement::penalty) {
    throw HostError(PINBALL_CONTACT_BAD_OPTION, "options->friction: springs have none; expected another enforcement");
  }
  if (settings.static_friction > 0 && settings.method == ContactMethod::pinball &&
      settings.gap == ContactGap::pinball) {
    throw HostError(PINBALL_CONTACT_BAD_OPTION,
                    "options->friction: balls do not touch where elements do; expected gap = PINBALL_CONTACT_GAP_FACE");
  }
  settings.radius_factor = options->radius_factor;
  settings.skin = options->skin;
  return settings;
}

}  // namespace pinball
