#include <kernels/stable_time_step.hpp>
#include <kernels/tetrahedron.hpp>
#include <tests/support/support.hpp>

/// The tetrahedron's formulas against those of the hexahedron that is collapsed to it, which know nothing of them.
namespace pinball::tetrahedron_test {
namespace {

using namespace test;

using Nodes = std::array<Vec3<double>, 4>;

Corners collapsed(const Nodes& n) { return {n[0], n[0], n[1], n[1], n[2], n[3], n[3], n[2]}; }

Nodes random_nodes(Random& random) {
  Nodes nodes{Vec3<double>{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (Vec3<double>& node : nodes) node = node + 0.2 * random_vector(random);
  return nodes;
}

TetrahedronEdges<double> edges(const Nodes& n) {
  Vec3<double> value[8];
  const Corners corners = collapsed(n);
  std::copy(corners.begin(), corners.end(), value);
  return tetrahedron_edges(value);
}

TEST(Tetrahedron, VolumeAndGradientAreThoseOfTheCollapsedHexahedron) {
  Random random(1);
  for (int trial = 0; trial < 50; ++trial) {
    const Nodes nodes = random_nodes(random), velocities = random_nodes(random);
    const TetrahedronEdges<double> x = edges(nodes), v = edges(velocities);
    const TetrahedronGradient<double> b = uniform_gradient(x);
    const HexahedronModes<double> modes_x = modes<double>(collapsed(nodes)),
                                  modes_v = modes<double>(collapsed(velocities));
    const UniformGradient<double> of_hexahedron = uniform_gradient(modes_x);
    const double volume = tetrahedron_volume(b, x);
    ASSERT_GT(volume, 0);
    EXPECT_NEAR(volume, hexahedron_volume(of_hexahedron, modes_x), 1e-15);
    const Tensor<double> found = velocity_gradient(b, v, 1 / volume);
    const Tensor<double> expected = velocity_gradient(of_hexahedron, modes_v, 1 / volume);
    EXPECT_VECTOR_NEAR(found.row_x, expected.row_x, 1e-12);
    EXPECT_VECTOR_NEAR(found.row_y, expected.row_y, 1e-12);
    EXPECT_VECTOR_NEAR(found.row_z, expected.row_z, 1e-12);
  }
}

/// With lumped masses the frequencies of a free tetrahedron are eigenvalues of 4/m V B^T C B: of a motion v their
/// quotient is 4/m V (lambda tr^2 + 2 mu D : D)/(v . v).
TEST(Tetrahedron, NoMotionIsFasterThanTheBoundOnItsStep) {
  Random random(2);
  const double mass = 3, lambda = 1.7, mu = 0.6;
  for (int trial = 0; trial < 20; ++trial) {
    const Nodes nodes = random_nodes(random);
    const TetrahedronEdges<double> x = edges(nodes);
    const TetrahedronGradient<double> b = uniform_gradient(x);
    const double volume = tetrahedron_volume(b, x), inverse_square = 1 / (volume * volume);
    const Symmetric<double> square = gradient_square(b);
    const double rate = element_stable_rate(inverse_square * largest_principal_value(square),
                                            inverse_square * trace(square), volume, 1 / mass, lambda, mu, 0.0);
    double largest = 0;
    // By power iteration, from several starts, on what the element makes of velocities.
    for (int start = 0; start < 4; ++start) {
      Nodes v = random_nodes(random);
      for (int i = 0; i < 200; ++i) {
        const Tensor<double> l = velocity_gradient(b, edges(v), 1 / volume);
        const Symmetric<double> d = symmetric_part(l);
        Symmetric<double> stress = (2 * mu) * d;
        stress.xx += lambda * trace(d);
        stress.yy += lambda * trace(d);
        stress.zz += lambda * trace(d);
        const Tensor<double> acting = to_tensor(stress);
        Vec3<double> sum{0, 0, 0};
        double length = 0, before = 0;
        for (const Vec3<double>& of : v) before += dot(of, of);
        for (std::size_t k = 0; k < 3; ++k) {
          v[k + 1] = (4 / mass) * (acting * b.of[k]);
          sum = sum + v[k + 1];
        }
        v[0] = -1.0 * sum;
        for (const Vec3<double>& of : v) length += dot(of, of);
        largest = std::max(largest, std::sqrt(length / before));
        for (Vec3<double>& of : v) of = (1 / std::sqrt(length)) * of;
      }
    }
    EXPECT_LE(std::sqrt(largest), rate * (1 + 1e-9));
    EXPECT_GT(std::sqrt(largest), 0.7 * rate);  // and it is of use
  }
}

TEST(Tetrahedron, GradientSquareIsHalfOfTheSumOverItsNodes) {
  Random random(3);
  const Nodes nodes = random_nodes(random);
  const TetrahedronGradient<double> b = uniform_gradient(edges(nodes));
  const Vec3<double> of_a = -1.0 * (b.of[0] + b.of[1] + b.of[2]);
  double xy = 0, zz = 0;
  for (const Vec3<double>& of : {of_a, b.of[0], b.of[1], b.of[2]}) {
    xy += of.x * of.y;
    zz += of.z * of.z;
  }
  EXPECT_NEAR(gradient_square(b).xy, 0.5 * xy, 1e-15);
  EXPECT_NEAR(gradient_square(b).zz, 0.5 * zz, 1e-15);
}

}  // namespace
}  // namespace pinball::tetrahedron_test
