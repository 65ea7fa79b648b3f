#include "units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>
#include <vector>

#include "unit_names.hpp"

namespace pinball {
namespace {

constexpr const char* expected =
    "expected a length, a time and a mass, a force or a stress in any order, such as \"g-mm-ms\", \"in-lbf-s\" and "
    "\"tonne-mm-s\", or \"SI\", \"CGS\" or \"none\"";

std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (std::string_view("-/,;_ \t").find(c) == std::string_view::npos) {
      parts.back() += c;
    } else if (!parts.back().empty()) {
      parts.emplace_back();
    }
  }
  if (parts.back().empty()) parts.pop_back();
  return parts;
}

/// Systems that have a name, in units.
std::string spelled_out(const std::string& units) {
  std::string name;
  for (const char c : units) {
    if (c != ' ' && c != '.') name += static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  }
  if (name == "si" || name == "mks") return "m-kg-s";
  return name == "cgs" ? "cm-g-s" : units;
}

bool names_none(const std::string& units) {
  return units.empty() || units == "none" || units == "None" || units == "dimensionless";
}

using NamedUnits = std::map<Dimension, NamedUnit>;

/// What is wrong with it as a sentence; empty: nothing, and `found` has its units.
std::string find_units(const std::string& units, NamedUnits& found) {
  for (const std::string& part : split(spelled_out(units))) {
    const auto unit = named_unit(part);
    if (!unit) return fmt::format("\"{}\" is the name of none, or of several", part);
    if (!found.emplace(unit->dimension, *unit).second) {
      return fmt::format("\"{}\" is {} where there is one already", part, in_words(unit->dimension));
    }
  }
  for (const Dimension needed : {Dimension::length, Dimension::time}) {
    if (!found.contains(needed)) return fmt::format("{} is missing", in_words(needed));
  }
  return found.size() < 3 ? "a mass, a force or a stress is missing" : "";
}

struct Sizes {
  double length, time, mass;
  double of(Dimension dimension) const {
    const double force = mass * length / (time * time);
    switch (dimension) {
      case Dimension::length:
        return length;
      case Dimension::time:
        return time;
      case Dimension::mass:
        return mass;
      case Dimension::force:
        return force;
      case Dimension::stress:
        return force / (length * length);
      case Dimension::energy:
        break;
    }
    return force * length;
  }
};

/// In SI, with the mass that follows from what is named in its place.
Sizes sizes_of(const NamedUnits& found) {
  Sizes sizes{found.at(Dimension::length).si, found.at(Dimension::time).si, 1};
  for (const Dimension given : {Dimension::mass, Dimension::force, Dimension::stress, Dimension::energy}) {
    if (const auto unit = found.find(given); unit != found.end()) {
      sizes.mass = unit->second.si / sizes.of(given);
      break;
    }
  }
  return sizes;
}

/// What is named besides and does not follow from the rest.
std::string contradiction(const NamedUnits& found) {
  const Sizes sizes = sizes_of(found);
  for (const auto& [dimension, unit] : found) {
    if (std::abs(sizes.of(dimension) / unit.si - 1) < 1e-6) continue;
    const std::string name = name_of_unit(dimension, sizes.of(dimension));
    return fmt::format("\"{}\" is not {} of these units{}", unit.name, in_words(dimension),
                       name.empty() ? "" : fmt::format(", which is \"{}\"", name));
  }
  return "";
}

std::string problem_with(const std::string& units, NamedUnits& found) {
  const std::string problem = find_units(units, found);
  return problem.empty() ? contradiction(found) : problem;
}

}  // namespace

Units parse_units(const std::string& units) {
  NamedUnits found;
  if (names_none(units) || !problem_with(units, found).empty()) return {};
  const Sizes sizes = sizes_of(found);
  const auto name = [&](Dimension dimension) {
    const auto given = found.find(dimension);
    return given != found.end() ? given->second.name : name_of_unit(dimension, sizes.of(dimension));
  };
  Units u;
  u.metres = sizes.length;
  u.seconds = sizes.time;
  u.kilograms = sizes.mass;
  u.length = name(Dimension::length);
  u.time = name(Dimension::time);
  u.velocity = fmt::format("{}/{}", u.length, u.time);
  u.mass = name(Dimension::mass);
  u.force = name(Dimension::force);
  // What has no name of its own is made of what has one.
  const bool made_of_mass = u.force.empty();
  if (u.mass == "slinch") u.mass.clear();  // nearly everybody writes it as below
  if (u.mass.empty() && made_of_mass) u.mass = fmt::format("{:.6g} kg", sizes.mass);
  if (u.mass.empty()) u.mass = fmt::format("{} {}^2/{}", u.force, u.time, u.length);
  if (made_of_mass) u.force = fmt::format("{} {}/{}^2", u.mass, u.length, u.time);
  u.momentum = made_of_mass ? fmt::format("{} {}", u.mass, u.velocity) : fmt::format("{} {}", u.force, u.time);
  u.energy = name(Dimension::energy);
  if (u.energy.empty()) {
    u.energy =
        made_of_mass ? fmt::format("{} {}^2/{}^2", u.mass, u.length, u.time) : fmt::format("{} {}", u.force, u.length);
  }
  u.stress = name(Dimension::stress);
  if (u.stress.empty()) {
    u.stress = made_of_mass ? fmt::format("{}/({} {}^2)", u.mass, u.length, u.time)
                            : fmt::format("{}/{}^2", u.force, u.length);
  }
  // Of a mass that is itself a force times time squared over length the "/in" becomes "/in^4".
  u.density = u.mass.ends_with("/" + u.length) ? u.mass + "^4" : u.mass + "/" + u.length + "^3";
  return u;
}

std::optional<Problem> units_problem(const std::string& units) {
  NamedUnits found;
  if (names_none(units)) return {};
  const std::string problem = problem_with(units, found);
  if (problem.empty()) return {};
  return Problem{"units", fmt::format("{}, got \"{}\": {}", expected, units, problem)};
}

std::string units_line(const std::string& units) {
  const Units u = parse_units(units);
  std::string line = fmt::format("units: {}", units.empty() ? "not named" : units);
  const auto add = [&line](std::string_view quantity, const std::string& unit) {
    if (!unit.empty()) line += fmt::format("; {} [{}]", quantity, unit);
  };
  add("time", u.time);
  add("length", u.length);
  add("velocity", u.velocity);
  add("mass", u.mass);
  add("force", u.force);
  add("momentum", u.momentum);
  add("energy", u.energy);
  add("stress", u.stress);
  std::replace_if(
      line.begin(), line.end(), [](char c) { return c == ',' || c == '\n' || c == '\r'; }, ' ');
  return line;
}

}  // namespace pinball
