#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "cases.hpp"
#include "solver_run.hpp"

/// material_laws: an element of each law, and of each limit at which elements fail, in a motion that is known.
namespace pinball {

namespace {

constexpr double largest_strain = 0.25;
constexpr double element_edge = 0.01;  // of each element [length]

/// Where f, which rises, becomes 0 between 0 and `end`.
double root(double end, const std::function<double(double)>& f) {
  double low = 0, high = end;
  for (int i = 0; i < 200; ++i) {
    const double middle = 0.5 * (low + high);
    (f(middle) < 0 ? low : high) = middle;
  }
  return low;
}

/// Cauchy stress of a neo-Hookean material in pure shear by the logarithmic strain k: J is 1, and zz of it 0.
struct ElasticShear {
  double xx, yy;

  ElasticShear(const Material& m, double k)
      : xx(m.shear_modulus * std::expm1(2 * k)), yy(m.shear_modulus * std::expm1(-2 * k)) {}
  double effective() const { return std::sqrt(0.5 * ((xx - yy) * (xx - yy) + xx * xx + yy * yy)); }
  double mean() const { return (xx + yy) / 3; }
};

/// Pressure of a neo-Hookean material that is pressed along z by the logarithmic strain k.
double elastic_pressure(const Material& m, double k) {
  const double lambda = m.bulk_modulus - 2 * m.shear_modulus / 3, j = std::exp(-k);
  return -(m.shear_modulus * (j - 1 / j) / 3 + 0.5 * lambda * (j - 1 / j));
}

/// 2/dt of the largest stable step of a cube of edge h that is pressed along z by the logarithmic strain k and gives
/// way sideways, with its volume: sqrt(8 V/m (2 mu s_z + lambda tr s)), s = 1/(2 l^2) along an edge l.
double stable_rate(const Material& m, double h, double k) {
  const double lambda = m.bulk_modulus - 2 * m.shear_modulus / 3, pressed = std::exp(2 * k), wide = std::exp(-k);
  return std::sqrt(8 / m.density * (2 * m.shear_modulus * pressed + lambda * (pressed + 2 * wide)) / (2 * h * h));
}

/// s_xx - s_yy of F = diag(e^k, e^-k, 1), which keeps the volume: sum of m (l^a - l^-a), l = e^k.
double drawn_by_powers(const OgdenSettings& law, double k) {
  double sum = 0;
  for (std::size_t p = 0; p < law.moduli.size(); ++p) sum += law.moduli[p] * 2 * std::sinh(law.exponents[p] * k);
  return sum;
}

/// s_xx - s_yy of F = diag(e^k, e^-k, 1), of a material whose axes are along y, z, x: sigma = F S F^T of the S for
/// which the compliance of the engineering constants gives Green's strain.
double orthotropic_shear(const OrthotropicSettings& law, double k) {
  const auto& [ea, eb, ec] = law.young_moduli;
  const auto& [ab, ac, bc] = law.poisson_ratios;
  const double a = 0.5 * std::expm1(-2 * k), c = 0.5 * std::expm1(2 * k);  // along y and x; b is 0
  const double compliance[3][3] = {
      {1 / ea, -ab / ea, -ac / ea}, {-ab / ea, 1 / eb, -bc / eb}, {-ac / ea, -bc / eb, 1 / ec}};
  const auto determinant = [](const double(&m)[3][3]) {
    return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
           m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
  };
  const auto stress = [&](int axis) {  // Cramer's rule
    double replaced[3][3];
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) replaced[i][j] = j == axis ? (i == 0 ? a : i == 2 ? c : 0) : compliance[i][j];
    }
    return determinant(replaced) / determinant(compliance);
  };
  return std::exp(2 * k) * stress(2) - std::exp(-2 * k) * stress(0);
}

/// Effective stress after Johnson and Cook at the effective strain `end`, from rest at one rate: 3 G (E - e) = Y(e, T),
/// rho c dT = Y de, in so many pieces, by bisection.
struct JohnsonCookShear {
  double stress = 0, homologous = 0;

  JohnsonCookShear(const Material& m, double end, double rate) {
    constexpr int pieces = 20'000;
    const JohnsonCookSettings& law = m.johnson_cook.value();
    const double factor = 1 + law.rate_coefficient * std::log(std::max(1.0, rate / law.reference_rate));
    const double range = law.melting_temperature - law.room_temperature;
    double plastic = 0;
    for (int i = 1; i <= pieces; ++i) {
      const double strain = end * i / pieces, before = stress;
      const auto heated = [&](double de) {
        const double mean = 0.5 * (before + 3 * m.shear_modulus * (strain - plastic - de));
        return homologous + law.heat_share * mean * de / (m.density * law.specific_heat * range);
      };
      const auto over = [&](double de) {
        const double hardened = law.hardening_coefficient * std::pow(plastic + de, law.hardening_exponent);
        const double softened = 1 - std::pow(heated(de), law.softening_exponent);
        return (m.yield_stress + hardened) * factor * softened - 3 * m.shear_modulus * (strain - plastic - de);
      };
      const double de = over(0) < 0 ? root(strain - plastic, over) : 0;
      homologous = heated(de);
      plastic += de;
      stress = 3 * m.shear_modulus * (strain - plastic);
    }
  }
};

/// Yield stress after Johnson and Holmquist at the logarithmic strain -k along z, at one rate, where nothing or all is
/// broken, without bulking.
double brittle_strength(const Material& m, double k, double speed, bool broken) {
  const JohnsonHolmquistSettings& law = m.johnson_holmquist.value();
  const double mu = std::expm1(k);
  const double over =
      mu * (m.bulk_modulus + mu * (law.quadratic_modulus + mu * law.cubic_modulus)) / law.elastic_limit_pressure;
  const double factor = 1 + law.rate_coefficient * std::log(2.0 / 3 * speed / law.reference_rate);
  const double intact = factor * law.intact_strength *
                        std::pow(over + law.tensile_strength / law.elastic_limit_pressure, law.intact_exponent);
  const double fragments =
      std::min(law.most_fractured, factor * law.fractured_strength * std::pow(over, law.fractured_exponent));
  return 1.5 * (law.elastic_limit - law.elastic_limit_pressure) * (broken ? fragments : intact);
}

/// Pressure at the logarithmic strain -k along z of a table, on its curve, whose strains fall.
double pressure_on_curve(const EquationOfStateSettings& eos, double k) {
  std::size_t i = 1;
  while (i + 1 < eos.volume_strain.size() && -k < eos.volume_strain[i]) ++i;
  const double slope = (eos.pressure[i] - eos.pressure[i - 1]) / (eos.volume_strain[i] - eos.volume_strain[i - 1]);
  return eos.pressure[i] + slope * (-k - eos.volume_strain[i]);
}

/// Yield stress and pressure of the air of a foam that is pressed along z by the logarithmic strain k.
struct FoamPressed {
  double yield, air;

  FoamPressed(const CrushableFoamSettings& law, double k) {
    const double x = -std::expm1(-k);
    std::size_t i = 1;
    while (i + 1 < law.compaction.size() && x > law.compaction[i]) ++i;
    const double part = (x - law.compaction[i - 1]) / (law.compaction[i] - law.compaction[i - 1]);
    yield = law.yield_stress[i - 1] + part * (law.yield_stress[i] - law.yield_stress[i - 1]);
    air = law.air_pressure * x / (1 - law.solid_share - x);
  }
};

/// Bodies of the scene by their names, which have an element each.
class Bodies {
 public:
  explicit Bodies(const Scene& scene) : scene_(scene), materials_(material_of_bodies(scene)) {}

  std::size_t number(const std::string& name) const { return number_of_body(scene_, name); }
  const Material& material(const std::string& body) const { return scene_.materials[materials_[number(body)]]; }

 private:
  const Scene& scene_;
  std::vector<std::size_t> materials_;
};

/// The logarithmic strain at which each limit is met.
std::vector<std::pair<std::string, double>> failures(const Bodies& bodies, double speed) {
  const double to_effective = 2 / std::sqrt(3.0);
  const auto of = [&](const char* name) -> const Material& { return bodies.material(name); };
  const auto elastic_root = [&](const char* name, const std::function<double(const ElasticShear&)>& over) {
    return root(largest_strain, [&](double k) { return over(ElasticShear(of(name), k)); });
  };
  const Material &strain = of("plastic_strain"), &damage = of("damage");
  const std::vector<double>& d = damage.johnson_cook.value().failure;
  const double rate = to_effective * speed / damage.johnson_cook.value().reference_rate;
  const double ductility = (d.at(0) + d.at(1)) * (1 + d.at(3) * std::log(rate));  // without a mean stress
  const auto with_elastic = [&](double plastic, const Material& m) {
    return (plastic + m.yield_stress / (3 * m.shear_modulus)) / to_effective;
  };
  const Material &pressed = of("compression"), &flat = of("smallest_step");
  return {
      {"plastic_strain", with_elastic(strain.erosion_strain, strain)},
      {"damage", with_elastic(ductility, damage)},
      {"principal_strain", of("principal_strain").erosion.value().principal_strain},
      {"shear_strain", of("shear_strain").erosion.value().shear_strain},
      {"principal_stress", elastic_root("principal_stress",
                                        [&](const ElasticShear& s) {
                                          return s.xx - of("principal_stress").erosion.value().principal_stress;
                                        })},
      {"effective_stress", elastic_root("effective_stress",
                                        [&](const ElasticShear& s) {
                                          return s.effective() -
                                                 of("effective_stress").erosion.value().effective_stress;
                                        })},
      {"tension",
       elastic_root("tension",
                    [&](const ElasticShear& s) { return s.mean() - of("tension").erosion.value().tension; })},
      {"time", of("time").erosion.value().time * speed},
      {"compression",
       root(largest_strain,
            [&](double k) { return elastic_pressure(pressed, k) - pressed.erosion.value().compression; })},
      {"smallest_step",
       root(largest_strain,
            [&](double k) { return stable_rate(flat, element_edge, k) - 2 / flat.erosion.value().smallest_step; })},
  };
}

/// What elements of laws have at the end, beside what they should. step: the largest logarithmic strain of one.
std::vector<VerificationRow> rows_of_laws(const Solver<double>& solver, const Bodies& bodies, double speed,
                                          double step) {
  const double k = largest_strain, to_effective = 2 / std::sqrt(3.0), of_increments = 4 * step * step / 12;
  const auto difference = [&](const char* name) {
    const std::array<double, 6> s = stress_of(solver, bodies.number(name));
    return s[0] - s[1];
  };
  const auto compared = [](const char* name, double found, double exact, double tolerance, const char* source) {
    return compare(fmt::format("difference of principal stresses at the end [Pa], {}", name), found, exact, tolerance,
                   source);
  };
  const auto row = [&](const char* name, double exact, double tolerance, const char* source) {
    return compared(name, difference(name), exact, tolerance, source);
  };
  const auto brittle = [&](const char* name, bool broken) {
    const std::array<double, 6> s = stress_of(solver, bodies.number(name));
    return compared(name, s[0] - s[2], brittle_strength(bodies.material(name), k, speed, broken), of_increments,
                    "strength of the pressure at the end");
  };
  const std::array<double, 6> of_soil = stress_of(solver, bodies.number("soil"));
  const Material& soil = bodies.material("soil");
  const double crushed = pressure_on_curve(soil.equation_of_state.value(), k);
  const DruckerPragerSettings& sand = soil.drucker_prager.value();
  const std::array<double, 6> of_foam = stress_of(solver, bodies.number("foam"));
  const FoamPressed foam(bodies.material("foam").crushable_foam.value(), k);
  const Material &power = bodies.material("power"), &rubber = bodies.material("mooney_rivlin"),
                 &fluid = bodies.material("fluid"), &copper = bodies.material("johnson_cook");
  const PowerHardeningSettings& law = power.power_hardening.value();
  const double begin = std::pow(power.yield_stress / law.coefficient, 1 / law.exponent), strain = to_effective * k;
  const double plastic = root(strain, [&](double e) {
    return law.coefficient * std::pow(begin + e, law.exponent) - 3 * power.shear_modulus * (strain - e);
  });
  // sigma = 2/J (p I + (A + B tr b - 2 B) b - B b^2) where J = 1
  const double a = std::exp(2 * k), b = 1 / a, trace = a + b + 1;
  const MooneyRivlinSettings& mooney = rubber.mooney_rivlin.value();
  const double drawn = 2 * ((mooney.a + mooney.b * trace) * (a - b) - mooney.b * (a * a - b * b));
  const JohnsonCookShear heated(copper, strain, to_effective * speed);
  const JohnsonCookSettings& jc = copper.johnson_cook.value();
  const double of_heat = heated.stress * to_effective * step /
                         (copper.density * jc.specific_heat * (jc.melting_temperature - jc.room_temperature));
  const double slope = jc.softening_exponent * std::pow(heated.homologous, jc.softening_exponent - 1) /
                       (1 - std::pow(heated.homologous, jc.softening_exponent));
  return {
      row("power", to_effective * law.coefficient * std::pow(begin + plastic, law.exponent), of_increments,
          "K (e_0 + e)^n, by bisection"),
      // The temperature is that of the beginning of a step.
      row("johnson_cook", to_effective * heated.stress, of_increments + slope * of_heat,
          "3 G (E - e) = Y(e, T), rho c dT = Y de in 20,000 pieces"),
      row("mooney_rivlin", drawn, 1e-11, "closed form in the deformation gradient"),
      row("ogden", drawn_by_powers(bodies.material("ogden").ogden.value(), k), 1e-11, "closed form in the stretches"),
      row("ogden_foam", drawn_by_powers(bodies.material("ogden_foam").ogden.value(), k), 1e-11,
          "closed form in the stretches"),
      row("orthotropic", orthotropic_shear(bodies.material("orthotropic").orthotropic.value(), k), 1e-11,
          "F (C : E) F^T, by the compliance"),
      brittle("brittle_intact", false),
      brittle("brittle_fragments", true),
      compare("pressure at the end [Pa], soil", -(of_soil[0] + of_soil[1] + of_soil[2]) / 3, crushed, 1e-11,
              "its curve of compaction"),
      compared("soil", of_soil[0] - of_soil[2],
               std::sqrt(3 * (sand.constant + sand.linear * crushed + sand.quadratic * crushed * crushed)), 1e-11,
               "sqrt(3 (a0 + a1 p + a2 p^2)) at that pressure"),
      compared("foam", of_foam[0] - of_foam[2], foam.yield, 1e-11, "its curve of compaction"),
      compare("stress across at the end [Pa], foam", of_foam[0], -foam.air, 1e-11, "P_0 x/(1 - phi - x) of its air"),
      row("fluid", 4 * fluid.fluid.value().viscosity * speed, of_increments, "2 eta D"),
  };
}

}  // namespace

std::vector<VerificationRow> verify_material_laws(const Scene& scene) {
  const Bodies bodies(scene);
  const double speed = largest_strain / scene.time.end;
  const auto from = [&](const char* name) {
    return scene.bodies[bodies.number(name)].position[0] - 0.5 * element_edge;
  };
  const double pressed_from = from("compression"), flattened_from = from("smallest_step");
  Solver<double> solver(scene);
  PrescribedMotion motion(solver, [=](const Point& x, double t) {
    const double k = speed * t;
    if (x[0] > flattened_from) return Point{std::exp(k / 2) * x[0], std::exp(k / 2) * x[1], std::exp(-k) * x[2]};
    if (x[0] > pressed_from) return Point{x[0], x[1], std::exp(-k) * x[2]};
    return Point{std::exp(k) * x[0], std::exp(-k) * x[1], x[2]};
  });
  const Model<double>& model = std::as_const(solver).model();
  const auto limits = failures(bodies, speed);
  std::vector<double> failed(limits.size(), 0.0), steps(limits.size(), 1.0);
  double before = 0, largest_step = 0;
  const auto check = [&] {
    const double k = speed * solver.force_time();
    for (std::size_t i = 0; i < limits.size(); ++i) {
      const std::int64_t slot = model.slot_of_element[bodies.number(limits[i].first)];
      if (failed[i] > 0 || model.elements.alive(slot)) continue;
      failed[i] = k;
      steps[i] = k - before;
    }
    largest_step = std::max(largest_step, k - before);
    before = k;
  };
  while (!solver.at_end()) {
    motion.step();
    check();
  }
  motion.step();  // of no length
  check();

  std::vector<VerificationRow> rows = rows_of_laws(solver, bodies, speed, largest_step);
  for (std::size_t i = 0; i < limits.size(); ++i) {  // it is seen at the end of a step that it is passed in
    rows.push_back(compare(fmt::format("strain at failure, {}", limits[i].first), failed[i], limits[i].second,
                           steps[i] / limits[i].second + 1e-6, "closed form, the step in which it is passed"));
  }
  return rows;
}

}  // namespace pinball
