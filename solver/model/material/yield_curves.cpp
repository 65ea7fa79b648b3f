#include "yield_curves.hpp"

#include <algorithm>
#include <cmath>

namespace pinball {

namespace {

/// Y = Y_0 + beta H e up to the ultimate stress.
YieldCurve linear_hardening(const Material& m) {
  YieldCurve curve{0.0, {0.0}, {m.yield_stress}};
  const double modulus = m.isotropic_share * m.plastic_modulus;
  if (!(modulus > 0)) return curve;
  const bool ends = m.ultimate_stress > 0 && std::isfinite(m.ultimate_stress);
  const double last = ends ? (m.ultimate_stress - m.yield_stress) / modulus : 1.0;
  if (last > 0) {
    curve.plastic_strain.push_back(last);
    curve.stress.push_back(ends ? m.ultimate_stress : m.yield_stress + modulus);
  }
  if (ends) {  // what goes on is flat
    curve.plastic_strain.push_back(last + 1.0);
    curve.stress.push_back(m.ultimate_stress);
  }
  return curve;
}

std::vector<YieldCurve> given_curves(const Material& m) {
  if (m.crushable_foam) return {{0.0, m.crushable_foam->compaction, m.crushable_foam->yield_stress}};
  return m.yield_curves.empty() ? std::vector<YieldCurve>{linear_hardening(m)} : m.yield_curves;
}

/// Of the piece that begins at point k; beyond the last point that before it, where it does not fall.
double slope_from(const YieldCurve& curve, std::size_t k) {
  const auto& e = curve.plastic_strain;
  const auto& y = curve.stress;
  if (k + 1 < e.size()) return (y[k + 1] - y[k]) / (e[k + 1] - e[k]);
  return k > 0 ? std::max(0.0, (y[k] - y[k - 1]) / (e[k] - e[k - 1])) : 0.0;
}

/// Number of the last point at or before a plastic strain.
std::size_t point_before(const YieldCurve& curve, double strain) {
  const auto& e = curve.plastic_strain;
  return std::max<std::ptrdiff_t>(0, std::upper_bound(e.begin(), e.end(), strain) - e.begin() - 1);
}

std::vector<double> all_strains(const std::vector<YieldCurve>& curves) {
  std::vector<double> strains;
  for (const YieldCurve& curve : curves) {
    strains.insert(strains.end(), curve.plastic_strain.begin(), curve.plastic_strain.end());
  }
  std::sort(strains.begin(), strains.end());
  strains.erase(std::unique(strains.begin(), strains.end()), strains.end());
  return strains;
}

}  // namespace

bool has_general_yield(const Material& m) {
  if (m.erosion || ((m.mooney_rivlin || m.ogden || m.orthotropic) && !m.plastic)) return true;
  return m.plastic &&
         (m.isotropic_share < 1 || m.rate_constant > 0 || !m.yield_curves.empty() || m.power_hardening ||
          m.johnson_cook || m.johnson_holmquist || m.drucker_prager || m.crushable_foam || m.equation_of_state);
}

StrainRateMeasure strain_rate_measure(StrainRate rate) {
  return rate == StrainRate::total        ? StrainRateMeasure::total
         : rate == StrainRate::deviatoric ? StrainRateMeasure::deviatoric
                                          : StrainRateMeasure::plastic;
}

template <class S>
YieldCurves<S> yield_curves(const Material& material) {
  const std::vector<YieldCurve> given = given_curves(material);
  const bool logarithmic = material.rate_interpolation == RateInterpolation::logarithmic;
  const std::vector<double> strains = all_strains(given);
  YieldCurves<S> curves;
  for (const double strain : strains) curves.strain.push_back(static_cast<S>(strain));
  for (const YieldCurve& curve : given) {
    curves.rate.push_back(static_cast<S>(logarithmic && given.size() > 1 ? std::log(curve.rate) : curve.rate));
    for (const double strain : strains) {
      const std::size_t k = point_before(curve, strain);
      const double slope = slope_from(curve, k);
      curves.stress.push_back(static_cast<S>(curve.stress[k] + slope * (strain - curve.plastic_strain[k])));
      curves.slope.push_back(static_cast<S>(slope));
    }
  }
  return curves;
}

template <class S>
HardeningConstants<S> hardening_constants(const Material& m, const YieldCurves<S>& curves) {
  HardeningConstants<S> h{};
  h.kinematic_modulus = static_cast<S>((1 - m.isotropic_share) * m.plastic_modulus);
  h.points = curves.strain.size();
  h.curves = curves.rate.size();
  h.strain = curves.strain.data();
  h.stress = curves.stress.data();
  h.slope = curves.slope.data();
  h.rate = curves.rate.data();
  h.logarithmic = m.rate_interpolation == RateInterpolation::logarithmic;
  const bool depends = m.rate_constant > 0 || h.curves > 1;
  h.measure = depends ? strain_rate_measure(m.strain_rate) : StrainRateMeasure::total;
  h.rate_constant = static_cast<S>(m.rate_constant);
  h.rate_exponent = static_cast<S>(m.rate_exponent);
  h.rate_share = m.rate_stress > 0 ? S(0) : S(1);
  h.rate_stress = static_cast<S>(m.rate_stress);
  if (m.power_hardening) {
    const auto& [coefficient, exponent] = *m.power_hardening;
    h.power_coefficient = static_cast<S>(coefficient);
    h.power_exponent = static_cast<S>(exponent);
    h.power_strain = static_cast<S>(std::pow(m.yield_stress / coefficient, 1 / exponent));
  }
  return h;
}

template YieldCurves<double> yield_curves<double>(const Material&);
template YieldCurves<float> yield_curves<float>(const Material&);
template HardeningConstants<double> hardening_constants(const Material&, const YieldCurves<double>&);
template HardeningConstants<float> hardening_constants(const Material&, const YieldCurves<float>&);

}  // namespace pinball
