#pragma once

#include <algorithm>
#include <vector>

#include <kernels/material/general_yield.hpp>
#include <tests/support/support.hpp>

/// Materials of HardeningConstants with their arrays, and one point of such a material.
namespace pinball::test {

inline constexpr double case_mu = 80;

struct HardeningCase {
  MaterialConstants<double> material{};
  HardeningConstants<double> constants{};
  std::vector<double> strain, stress, slope, rate{0};

  /// Points to its own arrays.
  void connect() {
    constants.points = static_cast<int>(strain.size());
    constants.curves = static_cast<int>(rate.size());
    constants.strain = strain.data();
    constants.stress = stress.data();
    constants.slope = slope.data();
    constants.rate = rate.data();
  }
  HardeningCase() = default;
  HardeningCase(HardeningCase&& other) = default;  // vectors keep their places
  HardeningCase(const HardeningCase&) = delete;
};

/// Lambda 150, mu 80, without hardening.
inline HardeningCase plastic_case(std::vector<double> strain, std::vector<double> stress, std::vector<double> slope,
                                  std::vector<double> rate = {0}) {
  HardeningCase c;
  c.material.lambda = 150, c.material.mu = case_mu, c.material.density = 3;
  c.material.sound_speed = std::sqrt(310.0 / 3);
  c.constants.rate_share = 1;
  c.constants.rate_exponent = 1;
  c.strain = std::move(strain), c.stress = std::move(stress), c.slope = std::move(slope), c.rate = std::move(rate);
  c.connect();
  return c;
}

/// Y = yield + isotropic e, up to an ultimate stress; the back stress hardens by `kinematic`.
inline HardeningCase linear_case(double yield, double isotropic, double kinematic, double ultimate = 0) {
  HardeningCase c = ultimate > 0 ? plastic_case({0, (ultimate - yield) / isotropic}, {yield, ultimate}, {isotropic, 0})
                                 : plastic_case({0}, {yield}, {isotropic});
  c.constants.kinematic_modulus = kinematic;
  return c;
}

/// One curve through points; the last slope goes on.
inline HardeningCase curve_case(const std::vector<double>& strain, const std::vector<double>& stress) {
  std::vector<double> slope;
  for (std::size_t k = 0; k + 1 < strain.size(); ++k) {
    slope.push_back((stress[k + 1] - stress[k]) / (strain[k + 1] - strain[k]));
  }
  slope.push_back(slope.back());
  return plastic_case(strain, stress, slope);
}

/// Without rotation and without hourglass stresses.
struct MaterialPoint {
  Symmetric<double> stress{0, 0, 0, 0, 0, 0}, back{0, 0, 0, 0, 0, 0};
  double plastic_strain = 0;

  /// Over a time dt; returns the work, of the mean stress.
  double strain_by(const HardeningCase& c, const Symmetric<double>& strain, double dt = 1) {
    const Symmetric<double> before = stress;
    stress = stress + elastic_increment(c.material.lambda, c.material.mu, strain);
    GeneralYield<double> law(c.material, c.constants, (1 / dt) * strain, dt);
    KeptHourglass<double, HourglassKind::none> nothing;
    LostHourglassEnergy<double> lost{0, 0};
    return_generally(law, nothing, stress, back, plastic_strain, lost);
    return 0.5 * contract(before + stress, strain);
  }
};

}  // namespace pinball::test
