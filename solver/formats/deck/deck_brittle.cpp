#include "deck_brittle.hpp"

namespace pinball {

InnerKeys<JohnsonHolmquistSettings> DeckBrittle::keys() const {
  InnerKeys<JohnsonHolmquistSettings> law;
  law.set("intact_strength", intact.factor);
  law.set("intact_exponent", intact.exponent);
  if (fractured.factor != 0) {
    law.set("fractured_strength", fractured.factor);
    law.set("fractured_exponent", fractured.exponent);
    if (most_fractured > 0) law.set("most_fractured", most_fractured);
  }
  if (rate_coefficient != 0) {
    law.set("rate_coefficient", rate_coefficient);
    law.set("reference_rate", reference_rate);
  }
  law.set("tensile_strength", tensile_strength);
  law.set("elastic_limit", limit);
  law.set("elastic_limit_pressure", limit_pressure);
  if (damage.factor != 0) {
    law.set("damage_coefficient", damage.factor);
    law.set("damage_exponent", damage.exponent);
  }
  if (quadratic != 0) law.set("quadratic_modulus", quadratic);
  if (cubic != 0) law.set("cubic_modulus", cubic);
  if (bulking != 0) law.set("bulking", bulking);
  if (erodes) law.set("erodes", true);
  return law;
}

std::vector<DeckBrittle::WithoutEffect> DeckBrittle::without_effect(const std::array<std::string, 4>& names) const {
  std::vector<WithoutEffect> unused;
  if (rate_coefficient == 0 && reference_rate != 0) unused.push_back({names[0], "C is 0"});
  if (fractured.factor == 0 && fractured.exponent != 0) unused.push_back({names[1], "B is 0"});
  if (fractured.factor == 0 && most_fractured != 0) unused.push_back({names[2], "B is 0"});
  if (damage.factor == 0 && damage.exponent != 0) unused.push_back({names[3], "D1 is 0"});
  return unused;
}

}  // namespace pinball
