#include <kernels/assumed_strain.hpp>
#include <tests/support/support.hpp>

namespace pinball {
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
  return assumed_strain_force(assumed_strain_moduli(lambda, mu, 1.0), half_edges(x, true), h, volume / 8);
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

TEST(AssumedStrain, OfAnElementWithoutVolumeIsZero) {
  const HexahedronModes<double> flat = modes<double>(box(1, 1, 0)), cube = modes<double>(box(1, 1, 1));
  for (const HalfEdges<double>& half : {half_edges(flat, true), half_edges(cube, false)}) {
    const Vec3<double> h[4] = {{1, 2, 3}, {3, 2, 1}, {1, 1, 1}, {2, 0, 1}};
    const HourglassForce<double> force = assumed_strain_force(assumed_strain_moduli(2.0, 1.0, 1.0), half, h, 0.1);
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
  const HourglassForce<T> force = assumed_strain_force(moduli, half_edges(x, MaskOf<T>(true)), h, T(S(0.125)));
  for (int i = 0; i < width_of<T>; ++i) {
    Vec3<S> one[4];
    for (int a = 0; a < 4; ++a) one[a] = lane_of(h[a], i);
    const HourglassForce<S> expected = assumed_strain_force(moduli, half_edges(lane_of(x, i), true), one, S(0.125));
    for (int a = 0; a < 4; ++a) EXPECT_VECTOR_NEAR(lane_of(force.p[a], i), expected.p[a], 64 * epsilon<S>);
  }
}

}  // namespace
}  // namespace pinball
