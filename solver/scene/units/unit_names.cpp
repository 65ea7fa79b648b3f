#include "unit_names.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace pinball {

namespace {

constexpr double inch = 0.0254, foot = 0.3048, pound = 0.45359237, pound_force = 4.4482216152605;
/// What a pound-force accelerates by an inch per second squared.
constexpr double slinch = pound_force / inch;

struct Entry {
  std::string_view name;  ///< as it is printed
  Dimension dimension;
  double si;
  std::vector<std::string_view> others;  ///< that mean the same
};

/// Of several of one size the first is the one that a derived unit is called by.
const std::vector<Entry>& entries() {
  using enum Dimension;
  static const std::vector<Entry> all{
      {"m", length, 1, {"meter", "metre"}},
      {"dm", length, 0.1, {}},
      {"cm", length, 1e-2, {"centimeter", "centimetre"}},
      {"mm", length, 1e-3, {"millimeter", "millimetre"}},
      {"um", length, 1e-6, {"µm", "μm", "micron", "micrometer", "micrometre"}},
      {"nm", length, 1e-9, {"nanometer", "nanometre"}},
      {"km", length, 1e3, {"kilometer", "kilometre"}},
      {"in", length, inch, {"inch", "inches"}},
      {"ft", length, foot, {"foot", "feet"}},
      {"s", time, 1, {"sec", "second"}},
      {"ms", time, 1e-3, {"msec", "millisecond"}},
      {"us", time, 1e-6, {"µs", "μs", "usec", "microsecond", "microsec"}},
      {"ns", time, 1e-9, {"nsec", "nanosecond"}},
      {"min", time, 60, {"minute"}},
      {"kg", mass, 1, {"kilogram"}},
      {"g", mass, 1e-3, {"gram", "gm", "gr"}},
      {"mg", mass, 1e-6, {"milligram"}},
      {"ug", mass, 1e-9, {"µg", "μg", "microgram"}},
      {"t", mass, 1e3, {"tonne", "ton", "Mg", "megagram"}},
      {"lbm", mass, pound, {}},
      {"slug", mass, pound_force / foot, {}},
      {"slinch", mass, slinch, {"blob", "snail"}},
      {"N", force, 1, {"newton"}},
      {"kN", force, 1e3, {"kilonewton"}},
      {"MN", force, 1e6, {"meganewton"}},
      {"mN", force, 1e-3, {"millinewton"}},
      {"uN", force, 1e-6, {"µN", "μN", "micronewton"}},
      {"dyn", force, 1e-5, {"dyne"}},
      {"lbf", force, pound_force, {}},
      {"kip", force, 1e3 * pound_force, {"kips"}},
      {"kgf", force, 9.80665, {}},
      {"Pa", stress, 1, {"pascal"}},
      {"kPa", stress, 1e3, {"kilopascal"}},
      {"MPa", stress, 1e6, {"megapascal"}},
      {"GPa", stress, 1e9, {"gigapascal"}},
      {"TPa", stress, 1e12, {"terapascal"}},
      {"Mbar", stress, 1e11, {"megabar"}},
      {"bar", stress, 1e5, {}},
      {"psi", stress, pound_force / (inch * inch), {}},
      {"ksi", stress, 1e3 * pound_force / (inch * inch), {}},
      {"psf", stress, pound_force / (foot * foot), {}},
      {"J", energy, 1, {"joule"}},
      {"kJ", energy, 1e3, {"kilojoule"}},
      {"MJ", energy, 1e6, {"megajoule"}},
      {"GJ", energy, 1e9, {"gigajoule"}},
      {"mJ", energy, 1e-3, {"millijoule"}},
      {"uJ", energy, 1e-6, {"µJ", "μJ", "microjoule"}},
      {"nJ", energy, 1e-9, {"nanojoule"}},
      {"erg", energy, 1e-7, {}},
  };
  return all;
}

std::string lower(std::string_view text) {
  std::string small(text);
  std::transform(small.begin(), small.end(), small.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return small;
}

/// The only unit one of whose names fulfils this.
template <class Fits>
const Entry* only_one(const Fits& fits) {
  const Entry* found = nullptr;
  for (const Entry& entry : entries()) {
    if (!fits(entry.name) && std::none_of(entry.others.begin(), entry.others.end(), fits)) continue;
    if (found != nullptr) return nullptr;
    found = &entry;
  }
  return found;
}

}  // namespace

std::optional<NamedUnit> named_unit(std::string_view text) {
  const Entry* found = only_one([text](std::string_view name) { return name == text; });
  const std::string small = lower(text);
  if (found == nullptr) found = only_one([&small](std::string_view name) { return lower(name) == small; });
  if (found == nullptr && small.size() > 3 && small.ends_with('s')) {
    found = only_one([one = small.substr(0, small.size() - 1)](std::string_view name) { return lower(name) == one; });
  }
  if (found == nullptr) return {};
  return NamedUnit{std::string(found->name), found->dimension, found->si};
}

std::string name_of_unit(Dimension dimension, double si) {
  for (const Entry& entry : entries()) {
    if (entry.dimension == dimension && std::abs(si / entry.si - 1) < 1e-6) return std::string(entry.name);
  }
  return "";
}

const char* in_words(Dimension dimension) {
  static constexpr std::array words{"a length", "a time", "a mass", "a force", "a stress", "an energy"};
  return words.at(static_cast<std::size_t>(dimension));
}

}  // namespace pinball
