#include <algorithm>
#include <cmath>

#include "abaqus_material.hpp"
#include "abaqus_parts.hpp"

namespace pinball {

namespace {

/// sqrt(3 J2) <= d + p tan(beta)
struct LinearCone {
  double cohesion = 0, slope = 0;
};

/// Of the yield stress of a test: TYPE of its hardening.
double cohesion_of(const AbaqusBlock& hardening, double stress, double slope) {
  const std::string type = hardening.option("TYPE");
  if (type == "SHEAR") return std::sqrt(3.0) * stress;
  return (type == "TENSION" ? 1 + slope / 3 : 1 - slope / 3) * stress;
}

/// The one yield stress; what hardens is refused.
double yield_stress_of(AbaqusData& data, const AbaqusBlock& hardening) {
  DataLines lines(hardening);
  const DataLine first = lines.require("a yield stress");
  const double stress = DataFields(first).number(0, "yield stress");
  while (const auto line = lines.next()) {
    if (DataFields(*line).number(0, "yield stress") != stress)
      data.report.reject(line->place, "*DRUCKER PRAGER HARDENING of several stresses", "give one: it does not harden");
  }
  return stress;
}

LinearCone cone_of(AbaqusData& data, const AbaqusMaterial& material, const AbaqusBlock& block) {
  const DataLine card = only_card(block, "the angle of friction");
  const DataFields f(card);
  const double friction = f.number(0, "angle of friction"), ratio = f.number(1, "K", 0.0),
               dilation = f.number(2, "dilation angle", 0.0);
  if (!(friction >= 0 && friction < 71.5))
    fail_at(card.place, fmt::format("*DRUCKER PRAGER: angle of friction: expected 0 to 71.5, got {}", friction));
  if (ratio != 0 && ratio != 1)
    data.report.reject(card.place, "*DRUCKER PRAGER with K other than 1",
                       "give 1: tension is as strong as pressure at the same mean stress");
  if (dilation != 0)
    data.report.reject(card.place, "*DRUCKER PRAGER with a dilation angle", "give 0: flow does not dilate");
  const AbaqusBlock* hardening = material.option("DRUCKERPRAGERHARDENING");
  if (hardening == nullptr) fail_at(block.place, "*DRUCKER PRAGER: expected *DRUCKER PRAGER HARDENING");
  const double slope = std::tan(friction * std::acos(-1.0) / 180);
  return {cohesion_of(*hardening, yield_stress_of(data, *hardening), slope), slope};
}

}  // namespace

void set_drucker_prager(AbaqusData& data, const WrittenMaterial& material, const AbaqusBlock& block,
                        MaterialKeys keys) {
  if (const AbaqusBlock* plastic = material.deck.option("PLASTIC"))
    data.report.reject(plastic->place, "*PLASTIC beside *DRUCKER PRAGER", "give one of both");
  const AbaqusBlock* elastic = material.deck.option("ELASTIC");
  if (elastic == nullptr) fail_at(block.place, "*DRUCKER PRAGER: expected *ELASTIC");
  if (is_orthotropic(*elastic))
    data.report.reject(elastic->place, "*ELASTIC along axes beside *DRUCKER PRAGER", "what yields is isotropic");
  const LinearCone cone = cone_of(data, material.deck, block);
  const DataLine card = only_card(*elastic, "Young's modulus and Poisson's ratio");
  const DataFields f(card);
  const double young = f.number(0, "Young's modulus"), poisson = f.number(1, "Poisson's ratio", 0.0);
  if (!(poisson > -1 && poisson < 0.5))
    fail_at(card.place,
            fmt::format("*ELASTIC: Poisson's ratio: expected more than -1 and less than 0.5, got {}", poisson));
  keys.from({"*ELASTIC", card.place});
  keys.set("shear_modulus", young / (2 * (1 + poisson)));
  InnerKeys<EquationOfStateSettings> pressure;
  pressure.set("form", "polynomial");
  pressure.set("coefficients", std::vector{0.0, young / (3 * (1 - 2 * poisson)), 0.0, 0.0, 0.0, 0.0, 0.0});
  if (cone.slope > 0) {  // to the apex of the cone
    if (cone.cohesion > 0) {
      pressure.set("tension_limit", cone.cohesion / cone.slope);
    } else {
      pressure.set("bears_tension", false);
    }
  }
  keys.set("equation_of_state", pressure.value());
  keys.from({"*DRUCKER PRAGER", block.place});
  InnerKeys<DruckerPragerSettings> strength;
  strength.set("constant", cone.cohesion * cone.cohesion / 3);
  strength.set("linear", 2 * cone.cohesion * cone.slope / 3);
  strength.set("quadratic", cone.slope * cone.slope / 3);
  keys.set("drucker_prager", strength.value());
}

}  // namespace pinball
