#include <kernels/assumed_strain.hpp>
#include <kernels/material/von_mises.hpp>
#include <tests/support/support.hpp>

namespace pinball::assumed_strain_test {
namespace {

using namespace test;

using Modes = std::array<Vec3<double>, 4>;  ///< h_1..4

Modes random_modes(Random& random) {
  Modes h;
  for (Vec3<double>& value : h) value = random_vector(random);
  return h;
}

HourglassForce<double> force_of(const Corners& corner, const Modes& modes, double lambda, double mu) {
  const HexahedronModes<double> x = test::modes<double>(corner);
  const double volume = hexahedron_volume(uniform_gradient(x), x);
  const Vec3<double> h[4] = {modes[0], modes[1], modes[2], modes[3]};
  const ElementEdges<double> edges = edges_of(x, true);
  return assumed_strain_force(edges, assumed_stress(assumed_strain_moduli(lambda, mu, 1.0), assumed_strain(edges, h)),
                              volume / 8);
}

double energy_of(const HourglassForce<double>& force, const Modes& h) {
  double sum = 0;
  for (std::size_t a = 0; a < 4; ++a) sum += 4 * dot(force.p[a], h[a]);  // 1/2 f.u = 1/2 8 sum_a P_a.h_a
  return sum;
}

/// Independent: the strains of the paper's "ASQBI" at the points of a 2 x 2 x 2 Gauss rule of a box, and Hooke's law.
/// X_a, Y_a, Z_a: the displacements of mode a (1..4) differentiated by x, y, z.
double energy_by_quadrature(const Vec3<double>& half, const Modes& h, double lambda, double mu) {
  const double nu = lambda / (2 * (lambda + mu)), bar = nu / (1 - nu), root3 = std::sqrt(3.0);
  const double volume = 8 * half.x * half.y * half.z;
  double energy = 0;
  for (const auto& corner : parent) {
    const double xi = corner[0] / root3, eta = corner[1] / root3, zeta = corner[2] / root3;
    const double dx[4] = {0, zeta, eta, eta * zeta}, dy[4] = {zeta, 0, xi, zeta * xi}, dz[4] = {eta, xi, 0, xi * eta};
    double x[4][3], y[4][3], z[4][3];  // [mode][component]
    for (std::size_t a = 0; a < 4; ++a) {
      const double u[3] = {h[a].x, h[a].y, h[a].z};
      for (std::size_t c = 0; c < 3; ++c) {
        x[a][c] = root3 * dx[a] / half.x * u[c];
        y[a][c] = root3 * dy[a] / half.y * u[c];
        z[a][c] = root3 * dz[a] / half.z * u[c];
      }
    }
    const double xx = x[1][0] + x[2][0] + x[3][0] - bar * y[2][1] - nu * y[3][1] - bar * z[1][2] - nu * z[3][2];
    const double yy = -bar * x[2][0] - nu * x[3][0] + y[0][1] + y[2][1] + y[3][1] - bar * z[0][2] - nu * z[3][2];
    const double zz = -bar * x[1][0] - nu * x[3][0] - bar * y[0][1] - nu * y[3][1] + z[0][2] + z[1][2] + z[3][2];
    const double xy = y[0][0] + x[1][1], yz = z[1][1] + y[2][2], zx = z[0][0] + x[2][2];
    const double trace = xx + yy + zz;
    energy +=
        volume / 8 *
        (0.5 * lambda * trace * trace + mu * (xx * xx + yy * yy + zz * zz) + 0.5 * mu * (xy * xy + yz * yz + zx * zx));
  }
  return energy;
}

TEST(AssumedStrain, HasTheEnergyOfTheAssumedStrainsOfABox) {
  Random random(21);
  for (int trial = 0; trial < 100; ++trial) {
    const Vec3<double> size{uniform(random, 0.3, 3), uniform(random, 0.3, 3), uniform(random, 0.3, 3)};
    const double lambda = uniform(random, 0, 50), mu = uniform(random, 0.5, 2);
    const Modes h = random_modes(random);
    const double expected = energy_by_quadrature(0.5 * size, h, lambda, mu);
    EXPECT_NEAR(energy_of(force_of(box(size.x, size.y, size.z), h, lambda, mu), h), expected, 1e-12 * expected);
  }
}

TEST(AssumedStrain, IsSymmetricAndPositiveForDistortedElements) {
  Random random(22);
  for (int trial = 0; trial < 100; ++trial) {
    const Corners x = random_hexahedron(random);
    const Modes h = random_modes(random), k = random_modes(random);
    const HourglassForce<double> of_h = force_of(x, h, 2, 1), of_k = force_of(x, k, 2, 1);
    double one = 0, other = 0;
    for (std::size_t a = 0; a < 4; ++a) one += dot(of_h.p[a], k[a]), other += dot(of_k.p[a], h[a]);
    EXPECT_NEAR(one, other, 1e-13);
    EXPECT_GT(energy_of(of_h, h), 0);
  }
}

TEST(AssumedStrain, TurnsWithTheElement) {
  Random random(23);
  for (int trial = 0; trial < 100; ++trial) {
    const Corners x = random_hexahedron(random);
    const Modes h = random_modes(random);
    const Tensor<double> r = rotation_matrix(random_direction(random), uniform(random, 0, 3));
    Modes turned;
    for (std::size_t a = 0; a < 4; ++a) turned[a] = r * h[a];
    const HourglassForce<double> here = force_of(x, h, 2, 1), there = force_of(mapped(r, x), turned, 2, 1);
    for (int a = 0; a < 4; ++a) EXPECT_VECTOR_NEAR(there.p[a], r * here.p[a], 1e-14);
  }
}

TEST(AssumedStrain, StoresTheEnergyOfItsForces) {  // also of a softer element, and of one without stiffness
  Random random(25);
  for (const double factor : {1.0, 0.5, 0.0}) {
    const Corners corner = random_hexahedron(random);
    const HexahedronModes<double> x = modes<double>(corner);
    const double volume = hexahedron_volume(uniform_gradient(x), x);
    const auto moduli = assumed_strain_moduli(2.0, 1.0, factor);
    const Modes h = random_modes(random);
    const Vec3<double> displaced[4] = {h[0], h[1], h[2], h[3]};
    const ElementEdges<double> edges = edges_of(x, true);
    const AssumedField<double> stress = assumed_stress(moduli, assumed_strain(edges, displaced));
    const double energy = energy_of(assumed_strain_force(edges, stress, volume / 8), h);
    EXPECT_NEAR(0.5 * volume * compliance_product(moduli, stress, stress), energy, 1e-13);
    EXPECT_NEAR(0.5 * volume * contract(stress, assumed_strain(edges, displaced)), energy, 1e-13);
  }
}

TEST(AssumedStrain, EdgesHalfAStepLaterAreThoseOfTheEnd) {
  Random random(26);
  for (int trial = 0; trial < 100; ++trial) {
    const Corners x = random_hexahedron(random), velocity = linear_field({0, 0, 0}, random_tensor(random), x);
    double error[2] = {0, 0};
    for (const int k : {0, 1}) {
      Corners later;
      for (std::size_t i = 0; i < 8; ++i) later[i] = x[i] + 0.01 / (1 << k) * velocity[i];
      const ElementEdges<double> found = edges_later(modes<double>(later), edges_of(modes<double>(x), true)),
                                 exact = edges_of(modes<double>(later), true);
      for (int c = 0; c < 3; ++c) {
        error[k] += std::abs(found.inverse_square[c] / exact.inverse_square[c] - 1) +
                    std::abs(found.inverse_product[c] / exact.inverse_product[c] - 1);
        EXPECT_NEAR(exact.inverse_product[c] * norm(exact.edge[(c + 1) % 3]) * norm(exact.edge[(c + 2) % 3]), 1, 1e-14);
      }
    }
    EXPECT_LT(error[0], 1e-2);
    EXPECT_LT(error[1], 0.3 * error[0]);  // second order
  }
}

TEST(AssumedStrain, EdgesOfTwiceTheLengthResistNoMore) {
  const ElementEdges<double> edges =
      edges_later(modes<double>(box(2, 1, 1)), edges_of(modes<double>(box(1, 1, 1)), true));
  EXPECT_EQ(edges.inverse_square[0], 0);
  EXPECT_NEAR(edges.inverse_square[1], 4, 1e-14);
}

Symmetric<double> tensor_of(const ElementEdges<double>& edges, const AssumedField<double>& s, int c) {
  const int m = (c + 1) % 3, k = (c + 2) % 3;
  const Vec3<double> a = (1 / norm(edges.edge[m])) * edges.edge[m], b = (1 / norm(edges.edge[k])) * edges.edge[k];
  const std::size_t first = std::size_t(3 * c);
  const auto outer = [](const Vec3<double>& u, const Vec3<double>& v) {
    return Symmetric<double>{u.x * v.x,
                             u.y * v.y,
                             u.z * v.z,
                             0.5 * (u.x * v.y + u.y * v.x),
                             0.5 * (u.y * v.z + u.z * v.y),
                             0.5 * (u.z * v.x + u.x * v.z)};
  };
  return s.c[first] * outer(a, a) + s.c[first + 1] * outer(b, b) + (2 * s.c[first + 2]) * outer(a, b);
}

TEST(AssumedStrain, HasInCommonWithTheStressWhatTheirTensorsHave) {  // of a turned box
  Random random(27);
  for (int trial = 0; trial < 100; ++trial) {
    const Tensor<double> r = rotation_matrix(random_direction(random), uniform(random, 0, 3));
    const HexahedronModes<double> x =
        modes<double>(mapped(r, box(uniform(random, 0.3, 3), uniform(random, 0.3, 3), uniform(random, 0.3, 3))));
    const ElementEdges<double> edges = edges_of(x, true);
    AssumedField<double> s;
    for (double& value : s.c) value = uniform(random, -1, 1);
    const Symmetric<double> deviator = deviator_of(random_symmetric(random, 2));
    const CommonStress<double> common = common_stress(edges, deviator, s, 3.0);
    double squares = 0, product[3], mean_square = 0;
    for (int c = 0; c < 3; ++c) {
      const Symmetric<double> tensor = tensor_of(edges, s, c);
      product[c] = 1.5 * contract(deviator, tensor);
      squares += product[c] * product[c];
      mean_square += effective_square(deviator_of(tensor)) + s.c[9 + c] * s.c[9 + c];
    }
    EXPECT_NEAR(effective_square(s), mean_square, 1e-13);
    EXPECT_NEAR(common.alignment, std::sqrt(squares), 1e-13);
    Symmetric<double> sum{0, 0, 0, 0, 0, 0};
    AssumedField<double> of_mean{};
    for (std::size_t i = 0; i < 9; ++i) of_mean.c[i] = common.of_mean[i];
    for (int c = 0; c < 3; ++c) {
      EXPECT_NEAR(common.share[c], product[c] / std::sqrt(squares), 1e-13);
      sum = sum + common.share[c] * tensor_of(edges, s, c);
      // A plane stress across c that works on the stresses across c as the deviator does.
      const Symmetric<double> plane = tensor_of(edges, of_mean, c);
      EXPECT_NEAR(1.5 * contract(deviator_of(plane), tensor_of(edges, s, c)), common.share[c] * product[c], 1e-13);
    }
    EXPECT_SYMMETRIC_NEAR(deviator_of_shares(edges, s, common.share), deviator_of(sum), 1e-13);
  }
}

TEST(AssumedStrain, OfAnElementWithoutVolumeIsZero) {
  const HexahedronModes<double> flat = modes<double>(box(1, 1, 0)), cube = modes<double>(box(1, 1, 1));
  for (const ElementEdges<double>& edges : {edges_of(flat, true), edges_of(cube, false)}) {
    const Vec3<double> h[4] = {{1, 2, 3}, {3, 2, 1}, {1, 1, 1}, {2, 0, 1}};
    for (const double strain : assumed_strain(edges, h).c) EXPECT_EQ(strain, 0);
    const AssumedField<double> stress{{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}};
    const HourglassForce<double> force = assumed_strain_force(edges, stress, 0.1);
    for (const Vec3<double>& p : force.p) EXPECT_VECTOR_NEAR(p, (Vec3<double>{0, 0, 0}), 0);
  }
}

template <class T>
class AssumedStrainPack : public ::testing::Test {};
TYPED_TEST_SUITE(AssumedStrainPack, NumberTypes);

TYPED_TEST(AssumedStrainPack, EqualsTheScalarKernelLaneByLane) {
  using T = TypeParam;
  using S = ScalarOf<T>;
  Random random(24);
  std::vector<Corners> corners;
  std::vector<Modes> displaced;
  for (int i = 0; i < width_of<T>; ++i) {
    corners.push_back(random_hexahedron(random));
    displaced.push_back(random_modes(random));
  }
  const HexahedronModes<T> x = modes_from_lanes<T>(corners);
  Vec3<T> h[4];
  for (std::size_t a = 0; a < 4; ++a) {
    h[a] = vector_from_lanes<T>([&](int i) { return displaced[std::size_t(i)][a]; });
  }
  const auto moduli = assumed_strain_moduli<S>(2, 1, 1);
  const ElementEdges<T> edges = edges_of(x, MaskOf<T>(true));
  const HourglassForce<T> force =
      assumed_strain_force(edges, assumed_stress(moduli, assumed_strain(edges, h)), T(S(0.125)));
  for (int i = 0; i < width_of<T>; ++i) {
    Vec3<S> one[4];
    for (int a = 0; a < 4; ++a) one[a] = lane_of(h[a], i);
    const ElementEdges<S> edges1 = edges_of(lane_of(x, i), true);
    const HourglassForce<S> expected =
        assumed_strain_force(edges1, assumed_stress(moduli, assumed_strain(edges1, one)), S(0.125));
    for (int a = 0; a < 4; ++a) EXPECT_VECTOR_NEAR(lane_of(force.p[a], i), expected.p[a], 64 * epsilon<S>);
  }
}

}  // namespace
}  // namespace pinball::assumed_strain_test
