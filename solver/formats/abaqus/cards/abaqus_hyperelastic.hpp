#pragma once

#include <vector>

#include "abaqus_material.hpp"

namespace pinball {

/// *HYPERELASTIC of Mooney and Rivlin, of Hooke's kind (NEO HOOKE) or of powers of stretches (OGDEN, and polynomials
/// that are such sums), and *HYPERFOAM.
struct AbaqusRubber {
  double a = 0, b = 0;                        ///< C10, C01 [stress]
  std::vector<double> moduli{}, exponents{};  ///< of powers: m = 2 mu/alpha, alpha; else none [stress], [-]
  bool whole = false;                         ///< powers of whole stretches: *HYPERFOAM
  double poisson = 0;                         ///< of small strains, from D1 [-]

  double shear_modulus() const;
  double young_modulus() const { return 2 * (1 + poisson) * shear_modulus(); }
};

AbaqusRubber abaqus_rubber(const AbaqusBlock& block);
void set_hyperelasticity(AbaqusData& data, const WrittenMaterial& material, const AbaqusBlock& block,
                         MaterialKeys keys);

}  // namespace pinball
