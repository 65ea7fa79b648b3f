#pragma once

#include "abaqus_material.hpp"

namespace pinball {

/// *HYPERELASTIC of Mooney and Rivlin, or of Hooke's kind (NEO HOOKE).
struct AbaqusRubber {
  double a = 0, b = 0;  ///< C10, C01 [stress]
  double poisson = 0;   ///< of small strains, from D1 [-]

  double young_modulus() const { return 4 * (1 + poisson) * (a + b); }
};

AbaqusRubber abaqus_rubber(const AbaqusBlock& block);
void set_hyperelasticity(AbaqusData& data, const WrittenMaterial& material, const AbaqusBlock& block,
                         MaterialKeys keys);

}  // namespace pinball
