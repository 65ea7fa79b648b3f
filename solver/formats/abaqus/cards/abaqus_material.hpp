#pragma once

#include <fmt/format.h>

#include <set>
#include <string>
#include <vector>

#include <solver/formats/deck/given_once.hpp>

#include "abaqus_heat.hpp"

namespace pinball {

/// *MATERIAL and what belongs to it, up to the next one.
struct AbaqusMaterial {
  const AbaqusBlock* head = nullptr;
  std::vector<const AbaqusBlock*> options;
  GivenOnce given{};

  /// Options of a material stand once, but for *PLASTIC at another rate.
  void add(const AbaqusBlock& block) {
    static const std::set<std::string> once{"DENSITY",
                                            "ELASTIC",
                                            "PLASTIC",
                                            "RATEDEPENDENT",
                                            "SHEARFAILURE",
                                            "HYPERELASTIC",
                                            "HYPERFOAM",
                                            "DAMPING",
                                            "EXPANSION",
                                            "SPECIFICHEAT",
                                            "INELASTICHEATFRACTION",
                                            "CONDUCTIVITY",
                                            "DRUCKERPRAGER",
                                            "DRUCKERPRAGERHARDENING"};
    const std::string rate = block.name == "PLASTIC" ? fmt::format(" at the rate {}", block.number("RATE", 0.0)) : "";
    if (!once.contains(block.name)) return;
    given.add(block.star_name() + rate + " of one material", block.place);
    options.push_back(&block);
  }
  /// The last of a name; null: none.
  const AbaqusBlock* option(const char* name) const {
    const AbaqusBlock* found = nullptr;
    for (const AbaqusBlock* block : options) {
      if (block->name == name) found = block;
    }
    return found;
  }
  AbaqusHeat heat() const {
    return {option("SPECIFICHEAT"), option("INELASTICHEATFRACTION"), option("EXPANSION"), option("CONDUCTIVITY")};
  }
};

/// A material as it is written: by its key, with a factor on its mass.
struct WrittenMaterial {
  const AbaqusMaterial& deck;
  std::string key;
  double mass_factor = 1;
  bool warms = false;  ///< by its plastic work: the step is ADIABATIC
};

using MaterialKeys = DeckKeys<Material>;

/// The one line of constants. Throws InputError naming what was expected where there is none.
inline DataLine only_card(const AbaqusBlock& block, const char* what) {
  DataLines lines(block);
  return lines.require(what);
}

/// Whether *ELASTIC has constants along three axes.
bool is_orthotropic(const AbaqusBlock& elastic);
/// Of such a one, with *ORIENTATION of its sections.
void set_orthotropic_elasticity(AbaqusData& data, const WrittenMaterial& material, const AbaqusBlock& block,
                                MaterialKeys keys);
/// orthotropic: keys of the materials that have axes.
void tell_unused_orientations(AbaqusData& data, const std::set<std::string>& orthotropic);

/// *DRUCKER PRAGER, with *ELASTIC beside it.
void set_drucker_prager(AbaqusData& data, const WrittenMaterial& material, const AbaqusBlock& block, MaterialKeys keys);

/// PLASTIC, HARDENING=JOHNSON COOK, with RATE DEPENDENT of the same law.
void set_johnson_cook(AbaqusData& data, const WrittenMaterial& material, const MaterialKeys& keys);

}  // namespace pinball
