#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "cases.hpp"
#include "solver_run.hpp"

/// cyclic_shear: how materials harden, in a motion whose stress is one number.
namespace pinball {

namespace {

/// Pure shear: stretched along x by the logarithmic strain k, pressed along y by as much. With E = 2 k/sqrt3, the
/// effective strain, and the stress q = sqrt3 sigma_xx, signed, q' = 3 G (E' - dl/dt sign). Exact along a straight way.
class ShearAnswer {
 public:
  explicit ShearAnswer(const Material& m) : material_(m) {}

  void move_to(double strain) {
    const double three_g = 3 * material_.shear_modulus, direction = strain > strain_ ? 1 : -1;
    const double trial = stress_ + three_g * (strain - strain_);
    const double kinematic = (1 - material_.isotropic_share) * material_.plastic_modulus;
    // The yield stress is met on the first of its pieces on which it is met at all: bisection knows no pieces.
    const double relative = direction * (trial - back_);
    double low = 0, high = std::max(0.0, relative) / three_g;
    for (int i = 0; i < 200 && relative > yield(plastic_strain); ++i) {
      const double middle = 0.5 * (low + high);
      ((three_g + kinematic) * middle < relative - yield(plastic_strain + middle) ? low : high) = middle;
    }
    stress_ = trial - direction * three_g * low;
    back_ += direction * kinematic * low;
    plastic_strain += low;
    strain_ = strain;
  }
  double stress() const { return stress_; }

  double plastic_strain = 0;

 private:
  double yield(double e) const {
    if (material_.yield_curves.empty()) {
      return material_.yield_stress + material_.isotropic_share * material_.plastic_modulus * e;
    }
    const YieldCurve& c = material_.yield_curves.at(0);
    std::size_t k = 1;
    while (k + 1 < c.plastic_strain.size() && c.plastic_strain[k] < e) ++k;
    const double slope = (c.stress[k] - c.stress[k - 1]) / (c.plastic_strain[k] - c.plastic_strain[k - 1]);
    const bool goes_on = e <= c.plastic_strain[k] || slope > 0;
    return goes_on ? c.stress[k] + slope * (e - c.plastic_strain[k]) : c.stress[k];
  }

  const Material& material_;
  double strain_ = 0, stress_ = 0, back_ = 0;
};

/// k over the time: to 0.02, to -0.02 and again to 0.02, at one speed.
class Shear {
 public:
  explicit Shear(double end) : speed_(0.1 / end) {}

  double strain(double t) const {
    const double way = speed_ * t;
    return way < 0.02 ? way : way < 0.06 ? 0.04 - way : way - 0.08;
  }
  double first_turn() const { return 0.02 / speed_; }
  double speed() const { return speed_; }

 private:
  double speed_;
};

}  // namespace

std::vector<VerificationRow> verify_cyclic_shear(const Scene& scene) {
  constexpr std::size_t followed = 4;  // elements whose stress does not depend on the rate, in the order of the scene
  constexpr std::size_t total = 4, plastic = 5;
  const double to_effective = 2 / std::sqrt(3.0);
  Solver<double> solver(scene);
  const Model<double>& model = std::as_const(solver).model();
  const Shear shear(scene.time.end);
  PrescribedMotion motion(solver, [&shear](const Point& x, double t) {
    const double k = shear.strain(t);
    return Point{std::exp(k) * x[0], std::exp(-k) * x[1], x[2]};
  });
  const auto signed_stress = [&](std::size_t e) {
    return 0.5 * std::sqrt(3.0) * (stress_of(solver, e)[0] - stress_of(solver, e)[1]);
  };

  std::vector<ShearAnswer> answers;
  for (std::size_t e = 0; e < followed; ++e) answers.emplace_back(scene.materials[e]);
  std::vector<double> worst(followed, 0.0);
  double worst_strain = 0, turn = 0, turn_stress[2] = {0, 0}, turn_plastic_strain = 0;
  const auto check = [&] {
    const double k = shear.strain(solver.force_time());
    for (std::size_t e = 0; e < followed; ++e) {
      answers[e].move_to(to_effective * k);
      worst[e] = std::max(worst[e], std::abs(signed_stress(e) - answers[e].stress()));
      const double strain = model.elements.plastic_strain[model.slot_of_element[e]];
      worst_strain = std::max(worst_strain, std::abs(strain - answers[e].plastic_strain));
    }
    if (solver.force_time() > shear.first_turn()) return;
    turn = to_effective * k;
    turn_stress[0] = signed_stress(total), turn_stress[1] = signed_stress(plastic);
    turn_plastic_strain = model.elements.plastic_strain[model.slot_of_element[total]];
  };
  while (!solver.at_end()) {
    motion.step();
    check();
  }
  motion.step();  // of no length
  check();

  // Strain increments of the middle of a step add up to the logarithm but for a part (dk)^2/12; the margin of 4 is for
  // steps that are unequal. What errs is the elastic stress of the way, 3 G times it, five times 0.02.
  const double increment = 0.1 / solver.steps();
  const double relative = 4 * increment * increment / 12, way = to_effective * 0.1;
  const Material& m = scene.materials[0];
  const double deviation = relative * way * 3 * m.shear_modulus / m.yield_stress;
  const std::string source = "closed form in the logarithmic strain";
  std::vector<VerificationRow> rows;
  for (std::size_t e = 0; e < followed; ++e) {
    rows.push_back(
        compare_with_zero(fmt::format("largest deviation of stress / yield stress, {}", scene.bodies[e].name),
                          worst[e] / m.yield_stress, deviation, source));
  }
  rows.push_back(
      compare_with_zero("largest deviation of plastic strain of these", worst_strain, relative * way, source));

  // Rate of the whole strain: known, and the same on all of the way. The rate of a step is tanh(dk/2)/(dk/2) of it.
  const Material& t = scene.materials[total];
  const double factor = 1 + std::pow(std::sqrt(2.0) * shear.speed() / t.rate_constant, 1 / t.rate_exponent);
  const double strain =
      (3 * t.shear_modulus * turn - factor * t.yield_stress) / (3 * t.shear_modulus + factor * t.plastic_modulus);
  rows.push_back(compare("stress at the first turn, total_rate [kg/(m s^2)]", turn_stress[0],
                         factor * (t.yield_stress + t.plastic_modulus * strain), relative, source));
  rows.push_back(
      compare("plastic strain at the first turn, total_rate", turn_plastic_strain, strain, relative, source));
  // Rate of the plastic strain: without hardening it ends at that of the strain. What is left of the way there falls to
  // 1/e in a strain of 2.4e-4, the slope of the stress over the rate, Y (rate/C)^(1/p)/p, over 3 G: a hundredth of the
  // strain at the turn.
  const Material& p = scene.materials[plastic];
  const double steady =
      p.yield_stress * (1 + std::pow(to_effective * shear.speed() / p.rate_constant, 1 / p.rate_exponent));
  rows.push_back(compare("stress at the first turn, plastic_rate [kg/(m s^2)]", turn_stress[1], steady, relative,
                         "steady state, Y (1 + (E'/C)^(1/p))"));
  return rows;
}

}  // namespace pinball
