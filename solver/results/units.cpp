#include "units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

namespace pinball {
namespace {

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == separator) {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

bool is_mass(const std::string& name) {
  static constexpr std::array<std::string_view, 10> masses = {"kg", "g",   "mg",  "ug",   "t",
                                                              "Mg", "ton", "lbm", "slug", "tonne"};
  return std::find(masses.begin(), masses.end(), name) != masses.end();
}

}  // namespace

Units parse_units(const std::string& units) {
  std::vector<std::string> parts = split(units, '-');
  if (std::any_of(parts.begin(), parts.end(), [](const std::string& part) { return part.empty(); })) return {};
  Units u;
  if (parts.size() > 1) u.time = parts.back();
  if (parts.size() != 3) return u;
  if (is_mass(parts[0])) std::swap(parts[0], parts[1]);  // "kg-m-s"

  u.length = parts[0];
  u.velocity = fmt::format("{}/{}", u.length, u.time);
  if (is_mass(parts[1])) {
    u.mass = parts[1];
    u.force = fmt::format("{} {}/{}^2", u.mass, u.length, u.time);
    u.momentum = fmt::format("{} {}/{}", u.mass, u.length, u.time);
    u.energy = fmt::format("{} {}^2/{}^2", u.mass, u.length, u.time);
    u.stress = fmt::format("{}/({} {}^2)", u.mass, u.length, u.time);
  } else {
    u.force = parts[1];
    u.mass = fmt::format("{} {}^2/{}", u.force, u.time, u.length);
    u.momentum = fmt::format("{} {}", u.force, u.time);
    u.energy = fmt::format("{} {}", u.force, u.length);
    u.stress = fmt::format("{}/{}^2", u.force, u.length);
  }
  return u;
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
