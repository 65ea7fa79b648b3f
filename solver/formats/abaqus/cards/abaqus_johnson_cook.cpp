#include <fmt/format.h>

#include <cmath>

#include "abaqus_material.hpp"

namespace pinball {

namespace {

/// How a material of Johnson and Cook that plastic work warms softens from its temperature at the start on.
void set_softening(AbaqusData& data, const WrittenMaterial& material, const DataFields& f, const DeckPlace& place,
                   InnerKeys<JohnsonCookSettings>& law) {
  const double transition = f.number(5, "transition temperature", 0.0), start = initial_temperature(data, material.key);
  if (start != transition)
    data.report.reject(place,
                       fmt::format("*PLASTIC, HARDENING=JOHNSON COOK with a transition temperature of {} in an "
                                   "ADIABATIC step that begins at {}",
                                   transition, start),
                       "give the same in *INITIAL CONDITIONS, TYPE=TEMPERATURE");
  const HeatConstants heat = heat_constants(material.deck.heat(), material.deck.head->place);
  law.set("softening_exponent", f.number(3, "m", 0.0));
  law.set("melting_temperature", f.number(4, "melting temperature", 0.0));
  law.set("room_temperature", transition);
  law.set("specific_heat", heat.specific_heat / material.mass_factor);
  law.set("heat_share", heat.share);
}

/// What is left of the strength at the temperature of the start, which stays.
double strength_at_start(AbaqusData& data, const WrittenMaterial& material, const DataFields& f,
                         const DeckPlace& place) {
  const double m = f.number(3, "m", 0.0), melting = f.number(4, "melting temperature", 0.0),
               transition = f.number(5, "transition temperature", 0.0);
  const double start = melting == 0 ? transition : initial_temperature(data, material.key);
  if (start <= transition) {
    if (m != 0 || melting != 0 || transition != 0)
      data.report.unused(place, "*PLASTIC, HARDENING=JOHNSON COOK: m and its temperatures",
                         material.warms ? "its melting temperature is 0" : "without ADIABATIC nothing becomes warm");
    return 1;
  }
  if (!(start < melting)) fail_at(place, fmt::format("*PLASTIC, HARDENING=JOHNSON COOK: it has melted at {}", start));
  const double left = 1 - std::pow((start - transition) / (melting - transition), m);
  data.report.understood(
      fmt::format("*PLASTIC, HARDENING=JOHNSON COOK ({}): A and B times {:.6g}, for it is at {:.6g} "
                  "from the start on",
                  place.text(), left, start));
  return left;
}

/// A, B, n, and how it softens.
InnerKeys<JohnsonCookSettings> johnson_cook_strength(AbaqusData& data, const WrittenMaterial& material,
                                                     const MaterialKeys& keys) {
  const DataLine card = only_card(*material.deck.option("PLASTIC"), "A, B, n");
  const DataFields f(card);
  InnerKeys<JohnsonCookSettings> law;
  const bool softens = material.warms && f.number(4, "melting temperature", 0.0) != 0;
  const double left = softens ? 1 : strength_at_start(data, material, f, card.place);
  keys.set("yield_stress", left * f.number(0, "A"), "A");
  law.set("hardening_coefficient", left * f.number(1, "B", 0.0));
  law.set("hardening_exponent", f.number(2, "n", 1.0));
  if (softens) set_softening(data, material, f, card.place, law);
  return law;
}

}  // namespace

/// Its rate is that of the plastic strain.
void set_johnson_cook(AbaqusData& data, const WrittenMaterial& material, const MaterialKeys& keys) {
  InnerKeys<JohnsonCookSettings> law = johnson_cook_strength(data, material, keys);
  if (const AbaqusBlock* rate = material.deck.option("RATEDEPENDENT")) {
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

}  // namespace pinball
