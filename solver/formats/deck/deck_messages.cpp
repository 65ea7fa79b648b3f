#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>

#include "translated_deck.hpp"

namespace pinball {

namespace {

/// What the manual calls the field that a key of the scene is made of; empty: no one field.
std::string field_of(const std::string& key) {
  static const std::map<std::string, std::string> fields{{"density", "ro"},
                                                         {"young_modulus", "e"},
                                                         {"poisson_ratio", "pr"},
                                                         {"yield_stress", "sigy"},
                                                         {"plastic_modulus", "etan"},
                                                         {"isotropic_share", "beta"},
                                                         {"rate_constant", "c, src"},
                                                         {"rate_exponent", "p, srp"},
                                                         {"erosion_strain", "fs, fail"},
                                                         {"yield_curve", "lcss, es"},
                                                         {"yield_curves", "lcss"},
                                                         {"material", "mid"},
                                                         {"end", "endtim"},
                                                         {"steps", "endcyc"},
                                                         {"cfl", "tssfac"},
                                                         {"set", "set"},
                                                         {"nodes", "node"},
                                                         {"times", "lcid"},
                                                         {"factors", "lcid, sf"},
                                                         {"friction", "fd, fric"},
                                                         {"static_friction", "fs"},
                                                         {"mass", "valdmp"},
                                                         {"interval", "dt"},
                                                         {"field_interval", "dt"},
                                                         {"normal", "xh, yh, zh"},
                                                         {"hourglass_coefficient", "qh, qm"}};
  const auto found = fields.find(key);
  return found == fields.end() ? std::string() : found->second;
}

/// The number at a place of a text, which is moved behind it; 0: there is none.
std::size_t number_at(const std::string& text, std::size_t& at) {
  std::size_t number = 0;
  const char* const begin = text.data() + at;
  at += static_cast<std::size_t>(std::from_chars(begin, text.data() + text.size(), number).ptr - begin);
  return number;
}

/// The key that follows a place: "density" of ": material.mat_1.density: expected ..."
std::string key_at(const std::string& text, std::size_t at) {
  if (text.compare(at, 2, ": ") != 0) return {};
  const std::size_t end = text.find(": ", at + 2);
  const std::string path = end == std::string::npos ? std::string() : text.substr(at + 2, end - at - 2);
  return path.find(' ') == std::string::npos ? path.substr(path.rfind('.') + 1) : std::string();
}

}  // namespace

std::string TranslatedDeck::in_cards(const std::string& message, const std::string& name) const {
  std::string result = message;
  const std::string start = name + ':';
  for (std::size_t at = result.find(start); at != std::string::npos; at = result.find(start, at)) {
    std::size_t end = at + start.size();
    const std::size_t line = number_at(result, end);
    if (end < result.size() && result[end] == ':') number_at(result, ++end);
    const auto after = std::ranges::upper_bound(origins, line, {}, &TextOrigin::line);
    if (line == 0 || after == origins.begin() || (after - 1)->place.empty()) {
      at += start.size();
      continue;
    }
    const TextOrigin& origin = *(after - 1);
    const std::string field = field_of(key_at(result, end));
    const std::string card =
        fmt::format("{}: {}{}", origin.place, origin.keyword, field.empty() ? std::string() : " (" + field + ")");
    result.replace(at, end - at, card);
    at += card.size();
  }
  return result;
}

namespace {

/// Calls act(where) for what messages call each part of a scene.
template <class Act>
void for_each_where(Scene& scene, const Act& act) {
  for (PlaneConstraint& plane : scene.constraints) act(plane.where);
  for (FixedConstraint& fixed : scene.fixed_constraints) act(fixed.nodes.where);
  for (RigidWall& wall : scene.rigid_walls) {
    act(wall.where);
    act(wall.nodes.where);
  }
  for (PrescribedVelocity& given : scene.prescribed_velocities) act(given.nodes.where);
  for (NodalLoad& load : scene.loads) act(load.nodes.where);
  for (Pressure& pressure : scene.pressures) act(pressure.faces.where);
  for (InitialVelocity& given : scene.initial_velocities) act(given.nodes.where);
  for (ContactPair& pair : scene.contact_pairs) act(pair.where);
  for (TiedContact& tied : scene.tied_contacts) act(tied.where);
  for (Probe& probe : scene.probes) act(probe.where);
}

}  // namespace

void TranslatedDeck::name_parts(Scene& read, const std::string& name) const {
  for_each_where(read, [&](std::string& where) { where = in_cards(where, name); });
}

}  // namespace pinball
