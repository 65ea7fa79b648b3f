#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

#include "other_history.hpp"

namespace pinball {

namespace {

/// Names in lower case with single blanks; columns of history.csv with single blanks between them.
struct KnownName {
  std::string_view name, columns;
  bool per_mass = false;
};

/// LS-DYNA's internal energy has the work of the bulk viscosity in it, and its total what came from outside.
constexpr std::array<KnownName, 11> names_in_glstat{{
    {"kinetic energy", "kinetic kinetic_below_zero"},
    {"internal energy", "internal bulk_viscosity folding"},
    {"hourglass energy", "hourglass"},
    {"sliding interface energy", "contact_stored contact_damped"},
    {"external work", "external"},
    {"eroded internal energy", "eroded"},
    {"total energy", "total external"},
    {"time step", "dt"},
    {"global x velocity", "momentum_x", true},
    {"global y velocity", "momentum_y", true},
    {"global z velocity", "momentum_z", true},
}};

/// Of OpenRadioss' th_to_csv, and the energies of Abaqus: its ALLIE has those of hourglass control (ALLAE) in it, and
/// its ETOTAL is what is kept, without what came from outside.
constexpr std::array<KnownName, 22> names_of_columns{{
    {"kinetic energy", "kinetic kinetic_below_zero"},
    {"internal energy", "internal bulk_viscosity folding"},
    {"hourglass energy", "hourglass"},
    {"contact energy", "contact_stored contact_damped"},
    {"elastic contact energy", "contact_stored"},
    {"external work", "external"},
    {"total energy", "total external"},
    {"x momentum", "momentum_x"},
    {"y momentum", "momentum_y"},
    {"z momentum", "momentum_z"},
    {"momentum x", "momentum_x"},
    {"momentum y", "momentum_y"},
    {"momentum z", "momentum_z"},
    {"time step", "dt"},
    {"time step size", "dt"},
    {"allke", "kinetic kinetic_below_zero"},
    {"allie", "internal hourglass folding"},
    {"allae", "hourglass"},
    {"allvd", "bulk_viscosity"},
    {"allfd", "contact_damped"},
    {"allwk", "external"},
    {"etotal", "total"},
}};

template <std::size_t n>
Meaning find_meaning(const std::array<KnownName, n>& names, const std::string& name) {
  const auto* const known =
      std::find_if(names.begin(), names.end(), [&](const KnownName& k) { return k.name == name; });
  if (known == names.end()) return {};
  Meaning meaning{{""}, known->per_mass};
  for (const char c : known->columns) {
    if (c == ' ') {
      meaning.columns.emplace_back();
    } else {
      meaning.columns.back() += c;
    }
  }
  return meaning;
}

}  // namespace

std::string plain_name(const std::string& name) {
  std::string plain;
  for (const char c : name.substr(0, name.find_first_of("[("))) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0) {
      plain += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    } else if (!plain.empty() && plain.back() != ' ') {
      plain += ' ';
    }
  }
  while (plain.ends_with(' ')) plain.pop_back();
  return plain;
}

Meaning meaning_in_glstat(const std::string& name) { return find_meaning(names_in_glstat, plain_name(name)); }

Meaning meaning_of_column(const std::string& name) {
  Meaning meaning = find_meaning(names_of_columns, plain_name(name));
  if (meaning.columns.empty()) meaning.columns = {name};
  return meaning;
}

}  // namespace pinball
