#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include <solver/formats/deck/given_once.hpp>

#include "abaqus_parts.hpp"

namespace pinball {

namespace {

struct Curve {
  double rate = 0;
  std::vector<double> strain, stress;
  DeckPlace place{};
};

/// *MATERIAL and what belongs to it, up to the next one.
struct AbaqusMaterial {
  const AbaqusBlock* head = nullptr;
  std::vector<const AbaqusBlock*> options;
  GivenOnce given{};

  /// Options of a material stand once, but for *PLASTIC at another rate.
  void add(const AbaqusBlock& block) {
    static const std::set<std::string> once{"DENSITY",      "ELASTIC", "PLASTIC",  "RATEDEPENDENT",
                                            "SHEARFAILURE", "DAMPING", "EXPANSION"};
    const std::string rate = block.name == "PLASTIC" ? fmt::format(" at the rate {}", block.number("RATE", 0.0)) : "";
    if (!once.contains(block.name)) return;
    given.add(block.star_name() + rate + " of one material", block.place);
    options.push_back(&block);
  }
  const AbaqusBlock* option(const char* name) const {
    const AbaqusBlock* found = nullptr;
    for (const AbaqusBlock* block : options) {
      if (block->name == name) found = block;
    }
    return found;
  }
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

/// The one line of constants.
DataLine only_card(const AbaqusBlock& block, const char* what) {
  DataLines lines(block);
  return lines.require(what);
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

using MaterialKeys = DeckKeys<Material>;

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

/// Of one or two points as a line that ends, of more as a curve.
void set_curve(const Curve& curve, const MaterialKeys& keys) {
  if (curve.stress.size() > 2) {
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

bool is_adiabatic(const AbaqusData& data) {
  return std::ranges::any_of(
      data.deck.blocks, [](const AbaqusBlock& block) { return block.name == "DYNAMIC" && block.has("ADIABATIC"); });
}

/// A, B, n, and how it softens: not at all, where temperatures stay at 0, below that at which it begins.
InnerKeys<JohnsonCookSettings> johnson_cook_strength(AbaqusData& data, const AbaqusBlock& plastic,
                                                     const MaterialKeys& keys) {
  const DataLine card = only_card(plastic, "A, B, n");
  const DataFields f(card);
  keys.set("yield_stress", f.number(0, "A"), "A");
  InnerKeys<JohnsonCookSettings> law;
  law.set("hardening_coefficient", f.number(1, "B", 0.0));
  law.set("hardening_exponent", f.number(2, "n", 1.0));
  const double m = f.number(3, "m", 0.0), melting = f.number(4, "melting temperature", 0.0),
               transition = f.number(5, "transition temperature", 0.0);
  if (melting != 0 && (is_adiabatic(data) || transition < 0))
    data.report.reject(card.place, "*PLASTIC, HARDENING=JOHNSON COOK that softens with its temperature",
                       "temperatures are not computed: leave its melting temperature out");
  if (m != 0 || melting != 0 || transition != 0)
    data.report.unused(card.place, "*PLASTIC, HARDENING=JOHNSON COOK: m and its temperatures",
                       is_adiabatic(data) ? "its melting temperature is 0" : "without ADIABATIC nothing becomes warm");
  return law;
}

/// HARDENING=JOHNSON COOK, also with the rate of the same law, which is that of the plastic strain.
void set_johnson_cook(AbaqusData& data, const AbaqusMaterial& material, const MaterialKeys& keys) {
  InnerKeys<JohnsonCookSettings> law = johnson_cook_strength(data, *material.option("PLASTIC"), keys);
  if (const AbaqusBlock* rate = material.option("RATEDEPENDENT")) {
    if (rate->option("TYPE") != "JOHNSONCOOK")
      data.report.reject(rate->place, "*RATE DEPENDENT beside HARDENING=JOHNSON COOK", "give TYPE=JOHNSON COOK");
    const DataLine card = only_card(*rate, "C and the rate of reference");
    const DataFields f(card);
    law.set("rate_coefficient", f.number(0, "C"));
    law.set("reference_rate", f.number(1, "rate of reference"));
    keys.set("strain_rate", "plastic");
  }
  keys.set("johnson_cook", law.value());
}

void set_strength(AbaqusData& data, const AbaqusMaterial& material, const MaterialKeys& keys) {
  if (material.option("PLASTIC")->option("HARDENING") == "JOHNSONCOOK") {
    set_johnson_cook(data, material, keys);
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

void set_plasticity(AbaqusData& data, const AbaqusMaterial& material, MaterialKeys keys) {
  set_strength(data, material, keys);
  if (const AbaqusBlock* failure = material.option("SHEARFAILURE")) {
    const DataLine card = only_card(*failure, "the plastic strain at failure");
    keys.from(card_of(*failure, card.place));
    keys.set("erosion_strain", DataFields(card).number(0, "plastic strain at failure"));
  }
}

/// Where the heat of plastic work stays, it expands the material: the one thing that would need temperatures here.
void require_no_expansion(AbaqusData& data, const AbaqusMaterial& material) {
  const AbaqusBlock* expansion = material.option("EXPANSION");
  if (expansion == nullptr || !is_adiabatic(data) || material.option("PLASTIC") == nullptr) return;
  data.report.reject(expansion->place, "*EXPANSION of a plastic material in an ADIABATIC step",
                     "leave one of the two out: temperatures are not computed");
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

void write_material(AbaqusData& data, const std::string& key, const AbaqusMaterial& material, double mass_factor,
                    DeckScene& scene) {
  const DataLine density = only_card(required(material, "DENSITY", "*DENSITY"), "the density"),
                 elastic = only_card(required(material, "ELASTIC", "*ELASTIC"), "Young's modulus and Poisson's ratio");
  const DataFields of_density(density), f(elastic);
  const bool plastic = material.option("PLASTIC") != nullptr;
  auto keys = scene.entry<Material>("material", {"*MATERIAL", material.head->place});
  keys.set("name", data.material_name(key));
  keys.set("model", plastic ? "von_mises" : "elastic");
  keys.from({"*DENSITY", density.place});
  keys.set("density", mass_factor * of_density.number(0, "density"));
  keys.from({"*ELASTIC", elastic.place});
  keys.set("young_modulus", f.number(0, "Young's modulus"));
  keys.set("poisson_ratio", f.number(1, "Poisson's ratio", 0.0));
  require_no_expansion(data, material);
  if (!plastic) return;
  keys.from(card_of(*material.option("PLASTIC"), material.option("PLASTIC")->place));
  set_plasticity(data, material, keys);
}

/// ALPHA of all materials, which has to be one.
void write_damping(AbaqusData& data, const std::map<std::string, AbaqusMaterial>& materials, DeckScene& scene) {
  std::set<double> factors;
  const AbaqusBlock* last = nullptr;
  for (const AbaqusBody& body : data.bodies) {
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

std::map<std::string, double> abaqus_moduli(const AbaqusDeck& deck) {
  return first_numbers(deck, "ELASTIC", "Young's modulus");
}

void translate_abaqus_materials(AbaqusData& data, DeckScene& scene) {
  const std::map<std::string, AbaqusMaterial> materials = materials_of(data.deck);
  std::set<std::string> written;
  for (const AbaqusBody& body : data.bodies) {
    const auto found = materials.find(body.material);
    const AbaqusBlock& section = *data.mesh.sections[body.section].block;
    if (found == materials.end())
      fail_at(section.place, fmt::format("there is no *MATERIAL {}", section.require("MATERIAL")));
  }
  tell_unused(data, materials);
  write_damping(data, materials, scene);
  const double factor = mass_factor(data);
  for (const AbaqusBody& body : data.bodies) {
    if (written.insert(body.material).second)
      write_material(data, body.material, materials.at(body.material), factor, scene);
  }
}

}  // namespace pinball
