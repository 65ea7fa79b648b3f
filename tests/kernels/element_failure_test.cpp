#include "element_fixture.hpp"

/// Limits beyond which an element fails (kernels/material/failure.hpp): a unit cube under a given motion, against the
/// step in which a closed form reaches the limit.
namespace pinball::element_failure_test {
namespace {

using namespace test;

constexpr ElementFeatures general{true, true, true, HourglassKind::assumed_strain, YieldLaw::general};
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double lambda = 150, mu = 80, bulk = lambda + 2.0 / 3 * mu;

/// Elastic by a rate law, which a yield stress out of reach keeps.
ElementConstants<double> constants_with(const FailureLimits<double>& limits) {
  ElementConstants<double> c = element_constants();
  c.specific_volume = 1.0 / 3;
  c.material.yield_stress = 1e6;
  c.johnson_cook.used = true;
  c.places.damage = c.places.hardening = -1;
  c.failure.limits = limits;
  c.failure.limits.any = true;
  return c;
}

/// A cube of density 3 whose corners are F times those of the unit cube.
class MovedCube {
 public:
  explicit MovedCube(const ElementConstants<double>& constants) {
    state_.mass = 3;
    scene_.constants = constants;
    x_ = box(1, 1, 1);
  }
  /// A step; whether it has failed by then.
  bool move_to(const Tensor<double>& f, double dt) {
    const Corners unit = box(1, 1, 1), before = x_;
    Corners v;
    for (std::size_t i = 0; i < 8; ++i) {
      x_[i] = f * unit[i];
      v[i] = (1 / dt) * (x_[i] - before[i]);
    }
    ElementScene step;
    step.constants = scene_.constants;
    step.dt = dt;
    step.time = time_ += dt;
    step.add(x_, v, state_);
    const ElementOutcome out = advance<double, general>(step);
    state_ = out.element[0];
    internal_ += out.internal + out.hourglass;
    eroded_ += out.eroded;
    time_step_ = out.time_step;
    return out.eroded_count > 0;
  }
  const ElementState& state() const { return state_; }
  double internal() const { return internal_; }
  double eroded() const { return eroded_; }
  double time_step() const { return time_step_; }

 private:
  ElementScene scene_;
  ElementState state_;
  Corners x_;
  double time_ = 0, internal_ = 0, eroded_ = 0, time_step_ = 0;
};

Tensor<double> diagonal(double x, double y, double z) { return {{x, 0, 0}, {0, y, 0}, {0, 0, z}}; }

/// Steps of 1e-3 of logarithmic strain along x, y and z, until it fails; 1000: it does not.
int steps_until_failure(MovedCube& cube, const Vec3<double>& direction) {
  for (int n = 1; n < 1000; ++n) {
    const double e = 1e-3 * n;
    if (cube.move_to(diagonal(std::exp(e * direction.x), std::exp(e * direction.y), std::exp(e * direction.z)), 1e-3)) {
      return n;
    }
  }
  return 1000;
}
int steps_until_failure(const FailureLimits<double>& limits, const Vec3<double>& direction) {
  MovedCube cube(constants_with(limits));
  return steps_until_failure(cube, direction);
}

constexpr Vec3<double> stretched{1, 0, 0}, squeezed{-1, 0, 0};
constexpr double at_step_201 = 0.2005;  // of the strain: beyond it from the 201st step on

TEST(ElementLimits, OfTheMeanStress) {
  EXPECT_EQ(steps_until_failure({.tension = bulk * at_step_201}, stretched), 201);
  EXPECT_EQ(steps_until_failure({.tension = bulk * at_step_201}, squeezed), 1000);
  EXPECT_EQ(steps_until_failure({.compression = bulk * at_step_201}, squeezed), 201);
  EXPECT_EQ(steps_until_failure({.compression = bulk * at_step_201}, stretched), 1000);
}

TEST(ElementLimits, OfTheLargestPrincipalStress) {
  EXPECT_EQ(steps_until_failure({.principal_stress = (lambda + 2 * mu) * at_step_201}, stretched), 201);
  // Squeezed along x and stretched along y: sigma_y = 2 mu e
  EXPECT_EQ(steps_until_failure({.principal_stress = 2 * mu * at_step_201}, {-1, 1, 0}), 201);
  EXPECT_EQ(steps_until_failure({.principal_stress = 1}, squeezed), 1000);
}

TEST(ElementLimits, OfTheEffectiveStress) {
  EXPECT_EQ(steps_until_failure({.effective_stress = 2 * mu * at_step_201}, stretched), 201);
  EXPECT_EQ(steps_until_failure({.effective_stress = 2 * mu * at_step_201}, squeezed), 201);
  EXPECT_EQ(steps_until_failure({.effective_stress = 1}, {1, 1, 1}), 1000);
}

TEST(ElementLimits, OfPrincipalStrains) {
  EXPECT_EQ(steps_until_failure({.principal_strain = at_step_201}, stretched), 201);
  EXPECT_EQ(steps_until_failure({.principal_strain = at_step_201}, squeezed), 1000);
  EXPECT_EQ(steps_until_failure({.shear_strain = 0.5 * at_step_201}, squeezed), 201);
  EXPECT_EQ(steps_until_failure({.shear_strain = at_step_201}, {-1, 1, 0}), 201);
}

/// Stretched along x, turned by a right angle about z, and stretched along y, where its x has gone.
TEST(ElementLimits, OfStrainsGoByTheMaterial) {
  MovedCube cube(constants_with({.principal_strain = 0.2495}));
  for (int n = 1; n <= 200; ++n) EXPECT_FALSE(cube.move_to(diagonal(std::exp(1e-3 * n), 1, 1), 1e-3));
  const double pi = std::acos(-1.0);
  for (int n = 1; n <= 400; ++n) {
    const double a = pi / 2 * n / 400, l = std::exp(0.2);
    EXPECT_FALSE(
        cube.move_to({{l * std::cos(a), -std::sin(a), 0}, {l * std::sin(a), std::cos(a), 0}, {0, 0, 1}}, 1e-3));
  }
  int failed = 0;
  for (int n = 1; n <= 100 && failed == 0; ++n) {
    if (cube.move_to({{0, -1, 0}, {std::exp(0.2 + 1e-3 * n), 0, 0}, {0, 0, 1}}, 1e-3)) failed = n;
  }
  EXPECT_EQ(failed, 50);
}

TEST(ElementLimits, OfTheTime) {
  EXPECT_EQ(steps_until_failure({.time = at_step_201}, stretched), 201);
  EXPECT_EQ(steps_until_failure({.time = at_step_201}, {0, 0, 0}), 201);
}

TEST(ElementLimits, OfTheStableStep) {
  MovedCube free(constants_with({.smallest_step = 1e-9}));
  std::vector<double> steps{infinity};
  for (int n = 1; n <= 300; ++n) {
    EXPECT_FALSE(free.move_to(diagonal(std::exp(-1e-3 * n), 1, 1), 1e-3));
    steps.push_back(free.time_step());
  }
  EXPECT_LT(steps[201], steps[200]);
  EXPECT_EQ(steps_until_failure({.smallest_step = 0.5 * (steps[200] + steps[201])}, squeezed), 201);
}

TEST(ElementLimits, EachCountsByItself) {
  const FailureLimits<double> both{.tension = bulk * 0.3005, .principal_strain = 0.1005, .time = 0.2005};
  EXPECT_EQ(steps_until_failure(both, stretched), 101);
  EXPECT_EQ(steps_until_failure(both, squeezed), 201);
}

TEST(ElementLimits, TakeTheEnergyOfTheElementAlong) {
  MovedCube cube(constants_with({.principal_stress = (lambda + 2 * mu) * at_step_201}));
  EXPECT_EQ(steps_until_failure(cube, stretched), 201);
  EXPECT_EQ(cube.state().mass, 0);
  EXPECT_GT(cube.eroded(), 0);
  EXPECT_NEAR(cube.eroded(), cube.internal(), 1e-12 * cube.eroded());
}

/// What never yields follows its energy: (lambda + 2 mu) sinh(e) in uniaxial strain.
TEST(ElementLimits, OfElasticMaterialsAreOnTheirStress) {
  ElementConstants<double> c = constants_with({.principal_stress = (lambda + 2 * mu) * std::sinh(0.4005)});
  c.johnson_cook.used = false;
  c.never_yields = true;
  c.places.temperature = c.places.energy = c.places.back_stress = -1;
  MovedCube cube(c);
  EXPECT_EQ(steps_until_failure(cube, stretched), 401);
}

/// Packs: some lanes fail, others do not.
TEST(ElementLimits, OfPacksAreThoseOfTheirLanes) {
  ElementScene scene = random_element_scene();
  scene.constants.johnson_cook.used = true;
  scene.constants.places.damage = scene.constants.places.hardening = -1;
  scene.time = 1;
  Random random(7);
  for (ElementState& state : scene.element) {
    if (state.mass == 0) continue;
    for (int c = 0; c < 6; ++c) {
      state.material[static_cast<std::size_t>(material_places.strain + c)] = uniform(random, -0.1, 0.1);
    }
  }
  for (const FailureLimits<double>& limits :
       {FailureLimits<double>{.tension = 1.5}, FailureLimits<double>{.compression = 1.5},
        FailureLimits<double>{.principal_stress = 3}, FailureLimits<double>{.effective_stress = 3.9},
        FailureLimits<double>{.principal_strain = 0.1}, FailureLimits<double>{.shear_strain = 0.1},
        FailureLimits<double>{.smallest_step = 0.05}}) {
    scene.constants.failure.limits = limits;
    scene.constants.failure.limits.any = true;
    const ElementOutcome expected = advance<double, general>(scene);
    const ElementOutcome found = advance<Pack<double, 8>, general>(scene);
    EXPECT_EQ(found.eroded_count, expected.eroded_count);
    EXPECT_NEAR(found.eroded, expected.eroded, 1e-12 * std::abs(expected.eroded));
    for (std::size_t e = 0; e < expected.element.size(); ++e) {
      EXPECT_EQ(found.element[e].mass > 0, expected.element[e].mass > 0) << e;
    }
  }
}

}  // namespace
}  // namespace pinball::element_failure_test
