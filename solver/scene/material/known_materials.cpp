#include "known_materials.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <set>
#include <string_view>
#include <type_traits>

#include <solver/base/error.hpp>
#include <solver/base/text_distance.hpp>
#include <solver/mesh/file/input_file.hpp>
#include <solver/scene/data_folders.hpp>
#include <solver/scene/given/toml_file.hpp>
#include <solver/scene/schema/material.hpp>
#include <solver/scene/toml/table.hpp>
#include <solver/scene/units/units.hpp>

namespace pinball {

namespace {

namespace fs = std::filesystem;

/// What a known material has beside the keys of one in a scene.
constexpr std::string_view words_about_it[] = {"name", "source", "range"};

std::string text_under(const GivenTable& table, std::string_view key) {
  const GivenValue* value = table.find(key);
  const auto* text = value != nullptr ? value->as<std::string>() : nullptr;
  return text != nullptr ? *text : std::string();
}

void add_materials_of(const fs::path& file, std::set<std::string>& names, std::vector<GivenTable>& found) {
  const GivenTable table = parse_toml(bytes_of_file(file.string()), file.string());
  const GivenValue* all = table.find("material");
  const auto* materials = all != nullptr ? all->as<GivenArray>() : nullptr;
  if (materials == nullptr) throw InputError(fmt::format("{}: expected tables [[material]]", file.string()));
  for (const GivenValue& material : *materials) {
    const auto* keys = material.as<GivenTable>();
    const std::string name = keys != nullptr ? text_under(*keys, "name") : "";
    if (name.empty())
      throw InputError(fmt::format("{}: material.name: expected a text", material.place.text(file.string())));
    if (names.insert(name).second) found.push_back(*keys);
  }
}

/// What one of a unit of the schema is in SI; 0: it is not one of those that materials have.
double size_in_si(std::string_view unit, const Units& units) {
  if (unit == "-" || unit == "K") return 1;
  if (unit == "T") return units.seconds;
  if (unit == "1/T") return 1 / units.seconds;
  if (unit == "L/T") return units.velocity_si();
  if (unit == "M/L^3") return units.density_si();
  if (unit == "M/(L T^2)") return units.stress_si();
  if (unit == "M^2/(L^2 T^4)") return units.stress_si() * units.stress_si();
  if (unit == "L^2/(T^2 K)") return units.velocity_si() * units.velocity_si();
  return 0;
}

void divide(GivenValue& value, double by) {
  if (auto* all = value.as<GivenArray>()) {
    for (GivenValue& one : *all) divide(one, by);
  } else if (const std::optional<double> number = value.number()) {
    value.any = *number / by;
  }
}

/// From SI to the units of a scene.
template <class T>
void convert(GivenTable& table, const Units& units) {
  describe(schema::Of<T>{}, [&]<class AKey>(const AKey& key) {
    if constexpr (requires { key.about; }) {
      GivenValue* const value = table.find(key.name);
      if (value == nullptr) return;
      if constexpr (requires { key.member; }) {
        using Value = std::remove_cvref_t<decltype(std::declval<T&>().*key.member)>;
        if constexpr (schema::InnerTable<Value>) {
          if (auto* inner = value->as<GivenTable>()) convert<typename Value::value_type>(*inner, units);
          return;
        }
      }
      const std::string_view unit = key.about.unit;
      const double size = unit.empty() ? 1 : size_in_si(unit, units);
      // Coefficients of a polynomial have several units, and curves are tables of their own.
      if (size == 0 || value->is_table() || key.name == std::string_view("coefficients") ||
          key.name == std::string_view("yield_curves")) {
        throw InputError(fmt::format("{}: {}: expected none in a material that scenes use by its name",
                                     value->place.text("material"), key.name));
      }
      divide(*value, size);
    }
  });
}

/// What a table does not have; tables within it are filled, too. place: of what comes.
void fill(GivenTable& table, const GivenTable& from, const GivenPlace& place) {
  for (const GivenEntry& entry : from.entries()) {
    GivenValue* const own = table.find(entry.key);
    if (own == nullptr) {
      table.set(entry.key, entry.value, place);
    } else if (auto* inner = own->as<GivenTable>(); inner != nullptr && entry.value.is_table()) {
      fill(*inner, *entry.value.as<GivenTable>(), place);
    }
  }
}

/// A known material as a scene of these units says it.
GivenTable in_units(const GivenTable& known, const Units& units) {
  GivenTable material = known;
  std::erase_if(material.entries(), [](const GivenEntry& entry) {
    return std::ranges::find(words_about_it, entry.key) != std::end(words_about_it);
  });
  convert<Material>(material, units);
  return material;
}

/// K and G of a material that gives its own are not to meet E and nu.
void leave_out_other_moduli(const GivenTable& own, GivenTable& known) {
  constexpr std::string_view moduli[] = {"bulk_modulus", "shear_modulus", "young_modulus", "poisson_ratio"};
  const bool gives = std::ranges::any_of(moduli, [&own](std::string_view key) { return own.contains(key); });
  if (!gives || own.contains("equation_of_state") || known.contains("equation_of_state")) return;
  for (const std::string_view key : moduli)
    std::erase_if(known.entries(), [key](const GivenEntry& entry) { return entry.key == key; });
}

/// Of a material that gives its own equation of state, which says what pressures are, the known one has the shear
/// modulus alone: G = E/(2 (1 + nu)), where it is given so.
void leave_pressures_to_own(const GivenTable& own, GivenTable& known) {
  if (!own.contains("equation_of_state") || known.contains("equation_of_state")) return;
  const auto number_of = [&known](std::string_view key) {
    const GivenValue* const value = known.find(key);
    return value != nullptr ? value->number() : std::nullopt;
  };
  const auto young = number_of("young_modulus"), poisson = number_of("poisson_ratio");
  if (young && poisson) known.set("shear_modulus", GivenValue(*young / (2 * (1 + *poisson))));
  for (const std::string_view key : {"bulk_modulus", "young_modulus", "poisson_ratio"})
    std::erase_if(known.entries(), [key](const GivenEntry& entry) { return entry.key == key; });
}

std::string names_of(const std::vector<GivenTable>& known, const std::string& wanted) {
  if (known.empty()) {
    return "no materials are found beside the program; PINBALL_DATA may name the folder that holds \"materials\"";
  }
  std::vector<std::string> names;
  for (const GivenTable& one : known) names.push_back(text_under(one, "name"));
  return fmt::format("expected one of {}, got \"{}\"; nearest is \"{}\"", alternatives(names), wanted,
                     nearest(wanted, names));
}

/// known: where it has none yet, it gets all.
void take_known_material(GivenTable& material, const GivenValue& use, const Units& units,
                         std::vector<GivenTable>& known) {
  const std::string place = use.place.text("material"),
                    key = fmt::format("material.{}.use", text_under(material, "name"));
  const auto* const wanted = use.as<std::string>();
  if (wanted == nullptr) fail(place, key, fmt::format("expected a text, got {}", describe(use)));
  if (!units.known()) return;
  if (known.empty()) known = known_materials();
  const auto found = std::ranges::find(known, *wanted, [](const GivenTable& one) { return text_under(one, "name"); });
  if (found == known.end()) fail(place, key, names_of(known, *wanted));
  GivenTable filling = in_units(*found, units);
  leave_out_other_moduli(material, filling);
  leave_pressures_to_own(material, filling);
  const GivenPlace of_use = use.place;  // filled, the table moves its entries, and `use` with them
  fill(material, filling, of_use);
}

}  // namespace

std::vector<GivenTable> known_materials() {
  std::vector<GivenTable> found;
  std::set<std::string> names;
  for (const std::string& folder : data_folders()) {
    std::vector<fs::path> files;
    std::error_code problem;
    for (fs::directory_iterator entry(fs::path(folder) / "materials", problem), end; !problem && entry != end;
         entry.increment(problem)) {
      if (entry->path().extension() == ".toml") files.push_back(entry->path());
    }
    std::ranges::sort(files);
    for (const fs::path& file : files) add_materials_of(file, names, found);
  }
  return found;
}

void take_known_materials(GivenTable& scene) {
  GivenValue* const all = scene.find("material");
  auto* const materials = all != nullptr ? all->as<GivenArray>() : nullptr;
  if (materials == nullptr) return;
  const Units units = parse_units(text_under(scene, "units"));
  std::vector<GivenTable> known;
  for (GivenValue& value : *materials) {
    auto* const material = value.as<GivenTable>();
    const GivenValue* const use = material != nullptr ? material->find("use") : nullptr;
    if (use != nullptr) take_known_material(*material, *use, units, known);
  }
}

}  // namespace pinball
