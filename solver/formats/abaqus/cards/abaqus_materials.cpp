#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "abaqus_hyperelastic.hpp"
#include "abaqus_material.hpp"
#include "abaqus_parts.hpp"

namespace pinball {

namespace {

struct Curve {
  double rate = 0;
  std::vector<double> strain, stress;
  DeckPlace place{};
};

std::map<std::string, AbaqusMaterial> materials_of(const AbaqusDeck& deck) {
  std::map<std::string, AbaqusMaterial> materials;
  AbaqusMaterial* current = nullptr;
  for (const AbaqusBlock& block : deck.blocks) {
    if (block.name == "MATERIAL") {
      current = &materials[label_key(block.require("NAME"))];
      current->head = &block;
    } else if (block.step > 0 || block.name == "ASSEMBLY" || block.name == "PART") {
      current = nullptr;
    } else if (current != nullptr) {
      current->add(block);
    }
  }
  return materials;
}

const AbaqusBlock& required(const AbaqusMaterial& material, const char* name, const char* title) {
  if (const AbaqusBlock* block = material.option(name)) return *block;
  fail_at(material.head->place, fmt::format("*MATERIAL {}: expected {}", *material.head->value("NAME"), title));
}

std::vector<Curve> curves_of(const AbaqusMaterial& material) {
  std::vector<Curve> curves;
  for (const AbaqusBlock* block : material.options) {
    if (block->name != "PLASTIC") continue;
    Curve curve{block->number("RATE", 0.0), {}, {}, block->place};
    DataLines lines(*block);
    while (const auto card = lines.next()) {
      const DataFields f(*card);
      curve.stress.push_back(f.number(0, "yield stress"));
      curve.strain.push_back(f.number(1, "plastic strain", 0.0));
    }
    if (curve.stress.empty()) fail_at(block->place, "*PLASTIC: expected yield stresses and plastic strains");
    if (curve.strain.front() != 0)
      fail_at(block->place,
              fmt::format("*PLASTIC: expected a first plastic strain of 0, got {}", curve.strain.front()));
    curves.push_back(std::move(curve));
  }
  std::ranges::stable_sort(curves, {}, &Curve::rate);
  return curves;
}

/// Behind its last point a table of Abaqus goes on without hardening.
GivenValue given_curve(Curve curve, double factor, std::optional<double> rate) {
  const std::size_t points = curve.stress.size();
  if (points > 1 && curve.stress[points - 1] != curve.stress[points - 2]) {
    curve.strain.push_back(curve.strain.back() + 1.0);
    curve.stress.push_back(curve.stress.back());
  }
  for (double& stress : curve.stress) stress *= factor;
  InnerKeys<YieldCurve> keys;
  if (rate) keys.set("rate", *rate);
  keys.set("plastic_strain", curve.strain);
  keys.set("stress", curve.stress);
  return keys.value();
}

/// Of one or two points as a line that ends, of more as a curve, and where it falls.
void set_curve(const Curve& curve, const MaterialKeys& keys) {
  if (curve.stress.size() > 2 || (curve.stress.size() == 2 && curve.stress[1] < curve.stress[0])) {
    keys.set("yield_curve", given_curve(curve, 1.0, {}));
    return;
  }
  keys.set("yield_stress", curve.stress[0]);
  if (curve.stress.size() == 1) return;
  const double strain = curve.strain[1] - curve.strain[0];
  if (!(strain > 0)) fail_at(curve.place, "*PLASTIC: expected plastic strains that increase");
  keys.set("plastic_modulus", (curve.stress[1] - curve.stress[0]) / strain);
  keys.set("ultimate_stress", curve.stress[1]);
}

/// Two points, the slope between which moves the yield surface.
void set_kinematic(const Curve& curve, const MaterialKeys& keys) {
  if (curve.stress.size() != 2 || !(curve.strain[1] > 0))
    fail_at(curve.place, "*PLASTIC, HARDENING=KINEMATIC: expected two lines, of plastic strain 0 and more");
  keys.set("yield_stress", curve.stress[0]);
  keys.set("plastic_modulus", (curve.stress[1] - curve.stress[0]) / curve.strain[1]);
  keys.set("isotropic_share", 0.0);
}

/// Yield stresses over the rate of the plastic strain: factors on one curve, or a law.
void set_rate(const AbaqusBlock& block, const Curve& curve, const MaterialKeys& keys) {
  if (block.option("TYPE") != "YIELDRATIO") {
    const DataLine card = only_card(block, "multiplier and exponent");
    const DataFields f(card);
    set_curve(curve, keys);
    keys.set("rate_constant", f.number(0, "D"), "D");
    keys.set("rate_exponent", f.number(1, "n"), "n");
    return;
  }
  GivenArray curves;
  DataLines lines(block);
  while (const auto card = lines.next()) {
    const DataFields f(*card);
    curves.push_back(given_curve(curve, f.number(0, "ratio"), f.number(1, "rate", 0.0)));
  }
  keys.set("yield_curves", curves);
}

void set_strength(AbaqusData& data, const WrittenMaterial& written, const MaterialKeys& keys) {
  const AbaqusMaterial& material = written.deck;
  if (material.option("PLASTIC")->option("HARDENING") == "JOHNSONCOOK") {
    set_johnson_cook(data, written, keys);
    return;
  }
  const std::vector<Curve> curves = curves_of(material);
  const AbaqusBlock* rate = material.option("RATEDEPENDENT");
  if (rate != nullptr && rate->option("TYPE") == "JOHNSONCOOK") {
    data.report.reject(rate->place, "*RATE DEPENDENT, TYPE=JOHNSON COOK beside another HARDENING",
                       "give HARDENING=JOHNSON COOK");
    return;
  }
  if (material.option("PLASTIC")->option("HARDENING") == "KINEMATIC") {
    set_kinematic(curves.front(), keys);
    if (rate != nullptr || curves.size() > 1)
      data.report.reject(material.head->place, "*PLASTIC, HARDENING=KINEMATIC that depends on the rate");
  } else if (curves.size() > 1) {
    GivenArray of_rates;
    for (const Curve& curve : curves) of_rates.push_back(given_curve(curve, 1.0, curve.rate));
    keys.set("yield_curves", of_rates);
    keys.set("strain_rate", "plastic");
    if (rate != nullptr) data.report.reject(rate->place, "*RATE DEPENDENT beside *PLASTIC, RATE=");
  } else if (rate != nullptr) {
    set_rate(*rate, curves.front(), keys);
    keys.set("strain_rate", "plastic");
  } else {
    set_curve(curves.front(), keys);
  }
}

void set_plasticity(AbaqusData& data, const WrittenMaterial& material, MaterialKeys keys) {
  set_strength(data, material, keys);
  if (const AbaqusBlock* failure = material.deck.option("SHEARFAILURE")) {
    const DataLine card = only_card(*failure, "the plastic strain at failure");
    keys.from(card_of(*failure, card.place));
    keys.set("erosion_strain", DataFields(card).number(0, "plastic strain at failure"));
  }
}

/// Moduli; where plastic work warms it and it expands, the bulk modulus as part of an equation of state.
void set_elasticity(AbaqusData& data, const WrittenMaterial& material, double density, MaterialKeys keys) {
  for (const char* name : {"HYPERELASTIC", "HYPERFOAM"}) {
    if (const AbaqusBlock* rubber = material.deck.option(name)) {
      set_hyperelasticity(data, material, *rubber, keys);
      return;
    }
  }
  const AbaqusBlock& block = required(material.deck, "ELASTIC", "*ELASTIC");
  if (is_orthotropic(block)) {
    set_orthotropic_elasticity(data, material, block, keys);
    return;
  }
  const DataLine elastic = only_card(block, "Young's modulus and Poisson's ratio");
  const DataFields f(elastic);
  const double young = f.number(0, "Young's modulus"), poisson = f.number(1, "Poisson's ratio", 0.0);
  const AbaqusHeat heat = material.deck.heat();
  keys.from({"*ELASTIC", elastic.place});
  if (!material.warms || heat.expansion == nullptr) {
    keys.set("young_modulus", young);
    keys.set("poisson_ratio", poisson);
    return;
  }
  if (!(poisson > -1 && poisson < 0.5))
    fail_at(elastic.place,
            fmt::format("*ELASTIC: Poisson's ratio: expected more than -1 and less than 0.5, got {}", poisson));
  const EquationOfStateSettings pressure = expanding_pressure(heat, heat_constants(heat, material.deck.head->place),
                                                              young / (3 * (1 - 2 * poisson)), density);
  keys.set("shear_modulus", young / (2 * (1 + poisson)));
  keys.from({"*EXPANSION", heat.expansion->place});
  InnerKeys<EquationOfStateSettings> law;
  law.set("form", "polynomial");
  law.set("coefficients", pressure.coefficients);
  keys.set("equation_of_state", law.value());
}

/// What heat does to it, or why it does nothing.
void tell_heat(AbaqusData& data, const WrittenMaterial& material, double density) {
  const AbaqusHeat heat = material.deck.heat();
  const AbaqusBlock* plastic = material.deck.option("PLASTIC");
  if (!material.warms) {
    tell_unused_heat(data, heat, plastic == nullptr ? "nothing warms it" : "without ADIABATIC nothing becomes warm");
    return;
  }
  if (heat.expansion != nullptr)
    data.report.understood(
        fmt::format("*EXPANSION ({}): a pressure that grows with the plastic work (equation_of_state); beside it the "
                    "elastic one is that of *ELASTIC, less by half of the change of the volume where this grows",
                    heat.expansion->place.text()));
  const bool softens = plastic->option("HARDENING") == "JOHNSONCOOK";
  if (heat.expansion == nullptr && !softens) return tell_unused_heat(data, heat, "nothing depends on its temperature");
  require_heat_in_all_steps(data);
  if (heat.specific_heat != nullptr)
    require_little_flow(data, material.key, heat, heat_constants(heat, material.deck.head->place), density);
}

/// FACTOR of *FIXED MASS SCALING, by which all masses are larger than those of the materials.
double mass_factor(AbaqusData& data) {
  const AbaqusBlock* block = data.last("FIXEDMASSSCALING");
  if (block == nullptr || !block->has("FACTOR")) return 1;
  const double factor = block->number("FACTOR", 1.0);
  if (!(factor > 0)) fail_at(block->place, "*FIXED MASS SCALING: FACTOR: expected more than 0");
  if (factor == 1) return 1;
  if (data.whole_bodies(block->value("ELSET").value_or(""), block->place).size() != data.bodies.size())
    data.report.reject(block->place, "*FIXED MASS SCALING, FACTOR of some elements");
  if (!data.rigid.empty()) data.report.reject(block->place, "*FIXED MASS SCALING, FACTOR beside rigid bodies");
  data.report.understood(
      fmt::format("*FIXED MASS SCALING ({}): densities are {:.6g} times those of the materials, also "
                  "where gravity acts",
                  block->place.text(), factor));
  return factor;
}

void write_material(AbaqusData& data, const WrittenMaterial& material, DeckScene& scene) {
  const DataLine card = only_card(required(material.deck, "DENSITY", "*DENSITY"), "the density");
  const double density = DataFields(card).number(0, "density");
  const AbaqusBlock *plastic = material.deck.option("PLASTIC"), *soil = material.deck.option("DRUCKERPRAGER");
  auto keys = scene.entry<Material>("material", {"*MATERIAL", material.deck.head->place});
  keys.set("name", data.material_name(material.key));
  keys.set("model", plastic != nullptr || soil != nullptr ? "von_mises" : "elastic");
  keys.from({"*DENSITY", card.place});
  keys.set("density", material.mass_factor * density);
  if (soil != nullptr) {
    set_drucker_prager(data, material, *soil, keys);
    tell_heat(data, material, density);
    return;
  }
  set_elasticity(data, material, density, keys);
  if (plastic != nullptr) {
    keys.from(card_of(*plastic, plastic->place));
    set_plasticity(data, material, keys);
  }
  tell_heat(data, material, density);
}

/// Of bodies of rigid elements, whose masses are given: as light as the lightest and as stiff as the stiffest material.
void write_rigid_elements(const AbaqusData& data, const DeckCard& card, DeckScene& scene) {
  double density = 0, modulus = 0;
  for (const auto& [key, value] : abaqus_densities(data.deck)) density = density > 0 ? std::min(density, value) : value;
  for (const auto& [key, value] : abaqus_moduli(data.deck)) modulus = std::max(modulus, value);
  const auto keys = scene.entry<Material>("material", card);
  keys.set("name", data.material_name(""));
  keys.set("model", "elastic");
  keys.set("density", density > 0 ? density : 1.0);
  keys.set("young_modulus", modulus > 0 ? modulus : 1.0);
  keys.set("poisson_ratio", 0.3);
}

/// ALPHA of all materials, which has to be one.
void write_damping(AbaqusData& data, const std::map<std::string, AbaqusMaterial>& materials, DeckScene& scene) {
  std::set<double> factors;
  const AbaqusBlock* last = nullptr;
  for (const AbaqusBody& body : data.bodies) {
    if (body.is_rigid_elements()) continue;
    const AbaqusBlock* damping = materials.at(body.material).option("DAMPING");
    factors.insert(damping == nullptr ? 0.0 : damping->number("ALPHA", 0.0));
    if (damping == nullptr) continue;
    last = damping;
  }
  if (factors.size() > 1) data.report.reject(last->place, "*DAMPING, ALPHA of some materials alone");
  if (last == nullptr || *factors.begin() == 0) return;
  const auto keys = scene.table<DampingSettings>("damping", card_of(*last, last->place));
  keys.comment("");
  keys.set("mass", *factors.begin());
}

/// Materials of no section, with their options.
void tell_unused(AbaqusData& data, const std::map<std::string, AbaqusMaterial>& materials) {
  std::set<std::string> used;
  for (const AbaqusBody& body : data.bodies) used.insert(body.material);
  for (const auto& [key, material] : materials) {
    if (used.contains(key)) continue;
    data.report.unused(material.head->place, fmt::format("*MATERIAL {}, which no section with elements has", key));
    for (const AbaqusBlock* block : material.options) {
      if (block->log != nullptr) block->log->done(block);
    }
  }
}

/// The first number of an option, of each material that has it, by its key.
std::map<std::string, double> first_numbers(const AbaqusDeck& deck, const char* option, const char* what) {
  std::map<std::string, double> numbers;
  for (const auto& [key, material] : materials_of(deck)) {
    if (const AbaqusBlock* block = material.option(option))
      numbers[key] = DataFields(only_card(*block, what)).number(0, what);
  }
  return numbers;
}

}  // namespace

std::map<std::string, double> abaqus_densities(const AbaqusDeck& deck) {
  return first_numbers(deck, "DENSITY", "the density");
}

std::vector<double> abaqus_densities_of_parts(const AbaqusData& data) {
  const std::map<std::string, double> densities = abaqus_densities(data.deck);
  std::vector<double> of_parts(data.mesh.file.parts.size(), 0.0);
  for (const AbaqusBody& body : data.bodies) {
    const auto found = densities.find(body.material);
    if (found != densities.end()) of_parts[body.section] = found->second;
  }
  return of_parts;
}

std::map<std::string, double> abaqus_moduli(const AbaqusDeck& deck) {
  std::map<std::string, double> moduli = first_numbers(deck, "ELASTIC", "Young's modulus");
  for (const auto& [key, material] : materials_of(deck)) {
    for (const char* name : {"HYPERELASTIC", "HYPERFOAM"}) {
      if (const AbaqusBlock* rubber = material.option(name)) moduli[key] = abaqus_rubber(*rubber).young_modulus();
    }
  }
  return moduli;
}

void translate_abaqus_materials(AbaqusData& data, DeckScene& scene) {
  const std::map<std::string, AbaqusMaterial> materials = materials_of(data.deck);
  std::set<std::string> written, orthotropic;
  for (const AbaqusBody& body : data.bodies) {
    if (body.is_rigid_elements()) continue;
    const auto found = materials.find(body.material);
    const AbaqusBlock& section = *data.mesh.sections[body.section].block;
    if (found == materials.end())
      fail_at(section.place, fmt::format("there is no *MATERIAL {}", section.require("MATERIAL")));
  }
  tell_unused(data, materials);
  write_damping(data, materials, scene);
  const double factor = mass_factor(data);
  for (const AbaqusBody& body : data.bodies) {
    if (!written.insert(body.material).second) continue;
    if (body.is_rigid_elements()) {
      const AbaqusBlock& rigid = *data.mesh.sections[body.section].block;
      write_rigid_elements(data, card_of(rigid, rigid.place), scene);
      continue;
    }
    const AbaqusMaterial& material = materials.at(body.material);
    if (const AbaqusBlock* elastic = material.option("ELASTIC"); elastic != nullptr && is_orthotropic(*elastic))
      orthotropic.insert(body.material);
    const bool warms = is_adiabatic(data.deck) && material.option("PLASTIC") != nullptr;
    write_material(data, {material, body.material, factor, warms}, scene);
  }
  tell_unused_orientations(data, orthotropic);
  tell_unused_temperatures(data);
}

}  // namespace pinball
