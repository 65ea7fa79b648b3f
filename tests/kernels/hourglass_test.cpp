#include <kernels/hourglass.hpp>
#include <tests/support/support.hpp>

namespace pinball::hourglass_test {
namespace {

using namespace test;

/// Independent scalar implementation: the vectors gamma_aI = G_aI - 1/V B_jI (x_jJ G_aJ), corner by corner.
struct Gamma {
  double value[4][8];
  explicit Gamma(const Corners& x) {
    const QuadratureGradient exact = quadrature_gradient(x);
    for (int a = 0; a < 4; ++a) {
      Vec3<double> mode{0, 0, 0};
      for (std::size_t i = 0; i < 8; ++i) mode = mode + hourglass_value(a, int(i)) * x[i];
      for (std::size_t i = 0; i < 8; ++i) {
        value[a][i] = hourglass_value(a, int(i)) - dot(exact.b[i], mode) / exact.volume;
      }
    }
  }
};

using Forces = std::array<Vec3<double>, 4>;  ///< Q_1..4

/// The kernel seen from outside: rates qdot_a = 8 sqrt3 h_a of a velocity field, nodal forces of given Q_a = P_a /
/// sqrt3.
struct Element {
  HexahedronModes<double> x;
  UniformGradient<double> b;
  double volume;
  explicit Element(const Corners& corner)
      : x(modes<double>(corner)), b(uniform_gradient(x)), volume(hexahedron_volume(b, x)) {}

  std::array<Vec3<double>, 4> rates(const Corners& velocity) const {
    const HexahedronModes<double> v = modes<double>(velocity);
    const Tensor<double> gradient = velocity_gradient(b, v, 1 / volume);
    std::array<Vec3<double>, 4> rate;
    for (int a = 0; a < 4; ++a) rate[std::size_t(a)] = (8 * std::sqrt(3.0)) * hourglass_rate(gradient, x, v, a);
    return rate;
  }
  Corners forces(const Forces& q) const {
    HourglassForce<double> force;
    for (std::size_t a = 0; a < 4; ++a) force.p[a] = std::sqrt(3.0) * q[a];
    const Tensor<double> acting = hourglass_stress(force, x, 1 / volume);
    Vec3<double> linear[3], hourglass[4], corner[8];
    for (int m = 0; m < 3; ++m) linear[m] = acting * b.linear[m], hourglass[m] = acting * b.hourglass[m] + force.p[m];
    hourglass[3] = force.p[3];
    from_modes(linear, hourglass, corner);
    Corners f;
    for (std::size_t i = 0; i < 8; ++i) f[i] = corner[i];
    return f;
  }
};

Forces random_forces(Random& random) {
  Forces q;
  for (Vec3<double>& force : q) force = random_vector(random);
  return q;
}

TEST(HourglassRate, VanishesForEveryLinearField) {
  Random random(11);
  for (int trial = 0; trial < 100; ++trial) {
    const Corners x = random_hexahedron(random);
    const Corners v = linear_field(random_vector(random), random_tensor(random), x);
    for (const Vec3<double>& rate : Element(x).rates(v)) EXPECT_VECTOR_NEAR(rate, (Vec3<double>{0, 0, 0}), 5e-14);
  }
}

TEST(HourglassRate, EqualsTheSumOverCorners) {
  Random random(12);
  for (int trial = 0; trial < 100; ++trial) {
    const Corners x = random_hexahedron(random);
    Corners v;
    for (Vec3<double>& value : v) value = random_vector(random);
    const Gamma gamma(x);
    const std::array<Vec3<double>, 4> rate = Element(x).rates(v);
    for (std::size_t a = 0; a < 4; ++a) {
      Vec3<double> sum{0, 0, 0};
      for (std::size_t i = 0; i < 8; ++i) sum = sum + gamma.value[a][i] * v[i];
      EXPECT_VECTOR_NEAR(rate[a], sum, 5e-14);
    }
  }
}

TEST(HourglassForces, EqualTheSumOverModes) {
  Random random(13);
  for (int trial = 0; trial < 100; ++trial) {
    const Corners x = random_hexahedron(random);
    const Forces q = random_forces(random);
    const Gamma gamma(x);
    const Corners f = Element(x).forces(q);
    for (std::size_t i = 0; i < 8; ++i) {
      Vec3<double> sum{0, 0, 0};
      for (std::size_t a = 0; a < 4; ++a) sum = sum + gamma.value[a][i] * q[a];
      EXPECT_VECTOR_NEAR(f[i], sum, 1e-14);
    }
  }
}

TEST(HourglassForces, DoTheWorkOfTheirRates) {  // f . v = Q . qdot
  Random random(15);
  for (int trial = 0; trial < 100; ++trial) {
    const Corners x = random_hexahedron(random);
    Corners v;
    for (Vec3<double>& value : v) value = random_vector(random);
    const Forces q = random_forces(random);
    const Element element(x);
    const Corners f = element.forces(q);
    const std::array<Vec3<double>, 4> rate = element.rates(v);
    double nodal = 0, modal = 0;
    for (std::size_t i = 0; i < 8; ++i) nodal += dot(f[i], v[i]);
    for (std::size_t a = 0; a < 4; ++a) modal += dot(q[a], rate[a]);
    EXPECT_NEAR(nodal, modal, 5e-14);
  }
}

TEST(HourglassForces, KeepLinearAndAngularMomentum) {
  Random random(16);
  for (int trial = 0; trial < 100; ++trial) {
    const Corners x = random_hexahedron(random);
    const Corners f = Element(x).forces(random_forces(random));
    Vec3<double> force{0, 0, 0}, torque{0, 0, 0};
    for (std::size_t i = 0; i < 8; ++i) force = force + f[i], torque = torque + cross(x[i], f[i]);
    EXPECT_VECTOR_NEAR(force, (Vec3<double>{0, 0, 0}), 1e-14);
    EXPECT_VECTOR_NEAR(torque, (Vec3<double>{0, 0, 0}), 2e-14);
  }
}

TEST(HourglassStiffness, CountsLambdaUpToTwiceMu) {  // a Poisson ratio of 1/3
  EXPECT_EQ(hourglass_modulus(1.5, 1.0), 3.5);
  EXPECT_EQ(hourglass_modulus(499.0, 1.0), 4.0);
  EXPECT_EQ(hourglass_modulus(-0.5, 1.0), 1.5);
}

TEST(HourglassStiffness, AreaOfHalfAStepEarlierIsThatOfTheMiddle) {
  Random random(18);
  for (int trial = 0; trial < 100; ++trial) {
    const Corners x = random_hexahedron(random);
    const Tensor<double> gradient = random_tensor(random);
    const auto area_after = [&](double time) {  // of a linear motion for this time
      const Corners velocity = linear_field({0, 0, 0}, gradient, x);
      Corners moved;
      for (std::size_t i = 0; i < 8; ++i) moved[i] = x[i] + time * velocity[i];
      return face_area(trace(gradient_square(Element(moved).b)));
    };
    const Symmetric<double> square = gradient_square(Element(x).b);
    double error[2];
    for (const int k : {0, 1}) {
      const double dt = 0.01 / (1 << k);
      error[k] = half_a_step_earlier(area_after(0), square, trace(square), dt * symmetric_part(gradient)) -
                 area_after(-0.5 * dt);
    }
    EXPECT_LT(std::abs(error[0]), 1e-3);
    EXPECT_LT(std::abs(error[1]), 0.3 * std::abs(error[0]) + 1e-8);  // second order
  }
}

TEST(HourglassStiffness, OfACubeGivesItsHighestMaterialFrequency) {  // omega^2 = 4 (lambda + 2 mu) / (rho h^2)
  const double h = 0.7, lambda = 3, mu = 2, rho = 5;
  const Element cube(box(h, h, h));
  // P = s h with P = sqrt3 Q and qdot = 8 sqrt3 h is Q = s/24 qdot
  // P = 3/2 M A^2/V_0 h
  const double area = face_area(trace(gradient_square(cube.b)));
  const double stiffness = 1.5 * hourglass_modulus(lambda, mu) * area * area / cube.volume / 24;
  for (int a = 0; a < 4; ++a) {
    Corners u;
    for (std::size_t i = 0; i < 8; ++i) u[i] = {0, hourglass_value(a, int(i)), 0};
    const std::array<Vec3<double>, 4> rate = cube.rates(u);
    Forces q;
    for (std::size_t c = 0; c < 4; ++c) q[c] = stiffness * rate[c];
    const Corners f = cube.forces(q);
    const double omega2 = 4 * (lambda + 2 * mu) / (rho * h * h);
    for (std::size_t i = 0; i < 8; ++i) {  // an eigenvector: f = omega^2 (m / 8) u
      EXPECT_VECTOR_NEAR(f[i], (omega2 * rho * h * h * h / 8) * u[i], 1e-13);
    }
  }
}

TEST(HourglassViscosity, OfACubeIsImpedanceTimesItsFace) {
  const Element cube(box(0.7, 0.7, 0.7));
  EXPECT_NEAR(hourglass_viscosity(3.0, face_area(trace(gradient_square(cube.b)))) / 24, 3 * 0.49, 1e-14);
}

template <class T>
class HourglassPack : public ::testing::Test {};
TYPED_TEST_SUITE(HourglassPack, NumberTypes);

TYPED_TEST(HourglassPack, EqualsTheScalarKernelLaneByLane) {
  using T = TypeParam;
  using S = ScalarOf<T>;
  Random random(17);
  std::vector<Corners> x, v;
  std::vector<Forces> force;
  for (int i = 0; i < width_of<T>; ++i) {
    x.push_back(random_hexahedron(random));
    v.push_back(random_hexahedron(random));
    force.push_back(random_forces(random));
  }
  const HexahedronModes<T> m = modes_from_lanes<T>(x), velocity = modes_from_lanes<T>(v);
  const UniformGradient<T> b = uniform_gradient(m);
  const T inverse_volume = T(1) / hexahedron_volume(b, m), b_b = trace(gradient_square(b));
  const Tensor<T> gradient = velocity_gradient(b, velocity, inverse_volume);
  const T viscosity = hourglass_viscosity(T(2), face_area(b_b));
  HourglassForce<T> p;
  for (std::size_t a = 0; a < 4; ++a) {
    p.p[a] = vector_from_lanes<T>([&](int i) { return force[std::size_t(i)][a]; });
  }
  const Tensor<T> acting = hourglass_stress(p, m, inverse_volume);
  const double tolerance = 32 * epsilon<S>;
  for (int i = 0; i < width_of<T>; ++i) {
    const HexahedronModes<S> m1 = lane_of(m, i), v1 = lane_of(velocity, i);
    const UniformGradient<S> b1 = uniform_gradient(m1);
    const S inverse1 = S(1) / hexahedron_volume(b1, m1), b_b1 = trace(gradient_square(b1));
    const Tensor<S> gradient1 = velocity_gradient(b1, v1, inverse1);
    EXPECT_NEAR(lane(viscosity, i), hourglass_viscosity(S(2), face_area(b_b1)), 24 * tolerance);
    HourglassForce<S> p1;
    for (int a = 0; a < 4; ++a) {
      EXPECT_VECTOR_NEAR(lane_of(hourglass_rate(gradient, m, velocity, a), i), hourglass_rate(gradient1, m1, v1, a),
                         2 * tolerance);
      p1.p[a] = lane_of(p.p[a], i);
    }
    const Tensor<S> found = lane_of(acting, i), expected = hourglass_stress(p1, m1, inverse1);
    EXPECT_VECTOR_NEAR(found.row_x, expected.row_x, tolerance);
    EXPECT_VECTOR_NEAR(found.row_y, expected.row_y, tolerance);
    EXPECT_VECTOR_NEAR(found.row_z, expected.row_z, tolerance);
  }
}

}  // namespace
}  // namespace pinball::hourglass_test
