#include "orthotropic_moduli.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <solver/base/point.hpp>

namespace pinball {

namespace {

using Axes = std::array<Point, 3>;

/// a, b, c of unit length.
Axes axes_of(const OrthotropicSettings& law) {
  const auto unit = [](Point p) {
    const double length = std::hypot(p[0], p[1], p[2]);
    for (double& component : p) component /= length;
    return p;
  };
  const Point a = unit(law.first_axis), c = unit(cross(a, law.second_axis));
  return {a, cross(c, a), c};
}

/// 1 - nu_ab nu_ba - nu_bc nu_cb - nu_ac nu_ca - 2 nu_ab nu_bc nu_ca: positive where every strain has an energy.
double determinant(const OrthotropicSettings& law) {
  const auto& [ea, eb, ec] = law.young_moduli;
  const auto& [ab, ac, bc] = law.poisson_ratios;
  return 1 - ab * ab * eb / ea - bc * bc * ec / eb - ac * ac * ec / ea - 2 * ab * bc * ac * ec / ea;
}

}  // namespace

ElasticMatrix moduli_along_axes(const OrthotropicSettings& law) {
  const auto& [ea, eb, ec] = law.young_moduli;
  const auto& [ab, ac, bc] = law.poisson_ratios;
  const double ba = ab * eb / ea, ca = ac * ec / ea, cb = bc * ec / eb, d = determinant(law);
  ElasticMatrix c{};
  c[0][0] = ea * (1 - bc * cb) / d;
  c[1][1] = eb * (1 - ac * ca) / d;
  c[2][2] = ec * (1 - ab * ba) / d;
  c[0][1] = c[1][0] = eb * (ab + ac * cb) / d;
  c[0][2] = c[2][0] = ec * (ac + ab * bc) / d;
  c[1][2] = c[2][1] = ec * (bc + ac * ba) / d;
  c[3][3] = law.shear_moduli[0];
  c[4][4] = law.shear_moduli[2];
  c[5][5] = law.shear_moduli[1];
  return c;
}

ElasticMatrix moduli_in_scene(const OrthotropicSettings& law) {
  const ElasticMatrix along = moduli_along_axes(law);
  const Axes axes = axes_of(law);
  constexpr std::array<std::array<std::size_t, 2>, 6> pair{{{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {2, 0}}};
  // Strain along the axes is N times that in the scene, both with engineering shears: C <- N^T C N.
  ElasticMatrix n{}, moduli{};
  for (std::size_t i = 0; i < 6; ++i) {
    const Point &p = axes[pair[i][0]], &q = axes[pair[i][1]];
    const double twice = i < 3 ? 1 : 2;
    for (std::size_t j = 0; j < 6; ++j) {
      const auto [k, l] = pair[j];
      n[i][j] = twice * (k == l ? p[k] * q[k] : 0.5 * (p[k] * q[l] + p[l] * q[k]));
    }
  }
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      double sum = 0;
      for (std::size_t k = 0; k < 6; ++k) {
        for (std::size_t l = 0; l < 6; ++l) sum += n[k][i] * along[k][l] * n[l][j];
      }
      moduli[i][j] = moduli[j][i] = sum;
    }
  }
  return moduli;
}

IsotropicModuli mean_moduli(const OrthotropicSettings& law) {
  const ElasticMatrix c = moduli_along_axes(law);
  const double ends = c[0][0] + c[1][1] + c[2][2], between = c[0][1] + c[0][2] + c[1][2];
  return {(ends + 2 * between) / 9, (ends - between + 3 * (c[3][3] + c[4][4] + c[5][5])) / 15};
}

std::optional<Problem> problem_of(const OrthotropicSettings& law) {
  for (const auto& [key, values] :
       {std::pair{"young_moduli", &law.young_moduli}, std::pair{"shear_moduli", &law.shear_moduli}}) {
    for (const double value : *values) {
      if (!(value > 0) || !std::isfinite(value)) {
        return Problem{key, fmt::format("expected three numbers > 0, got {}", value)};
      }
    }
  }
  // Two directions by themselves, and all three: E : C : E > 0 for every strain.
  struct Two {
    const char* name;
    double ratio, first, second;
  };
  const auto& [ea, eb, ec] = law.young_moduli;
  const auto& [ab, ac, bc] = law.poisson_ratios;
  for (const auto& [name, ratio, first, second] :
       {Two{"ab", ab, ea, eb}, Two{"ac", ac, ea, ec}, Two{"bc", bc, eb, ec}}) {
    if (ratio * ratio * second < first) continue;
    return Problem{"poisson_ratios", fmt::format("expected |nu_{0}| < sqrt(E_{1}/E_{2}) = {3:.6g}, got {4}: else a "
                                                 "strain has a negative energy",
                                                 name, name[0], name[1], std::sqrt(first / second), ratio)};
  }
  if (const double d = determinant(law); !(d > 1e-6)) {
    return Problem{"poisson_ratios",
                   fmt::format("expected 1 - nu_ab nu_ba - nu_bc nu_cb - nu_ac nu_ca - 2 nu_ab nu_bc nu_ca > 0, that "
                               "every strain has an energy, got {:.6g}",
                               d)};
  }
  const Point& a = law.first_axis;
  const Point normal = cross(a, law.second_axis);
  const double length = std::hypot(a[0], a[1], a[2]);
  if (!(length > 0) || !std::isfinite(length)) return Problem{"first_axis", "expected a direction, not zero"};
  const Point& b = law.second_axis;
  if (!(std::hypot(normal[0], normal[1], normal[2]) > 1e-6 * length * std::hypot(b[0], b[1], b[2]))) {
    return Problem{"second_axis", "expected a direction that is not along first_axis"};
  }
  return {};
}

}  // namespace pinball
