#include <array>
#include <random>

#include "trial.hpp"
#include "turned_body.hpp"

/// A thousand impacts of two blocks in any attitude: faces, rims, edges and corners on each other.
namespace pinball::random_blocks_test {
namespace {

using namespace test;

Scene random_impact(std::uint64_t seed) {
  std::mt19937_64 generator(seed);
  const auto in = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(generator); };
  std::array<Body, 2> body;
  const double speed = in(10, 60);
  for (const double side : {-1.0, 1.0}) {
    const double h = in(0.05, 0.12);
    BlockMesh mesh;
    for (std::size_t k = 0; k < 3; ++k) {
      mesh.elements[k] = std::uniform_int_distribution<int>(1, 4)(generator);
      mesh.size[k] = mesh.elements[k] * h * in(0.6, 1.6);
    }
    const Matrix rotation = random_turn(generator);
    const double aside = side > 0 ? 0.5 : 0, reach = reach_down(mesh.size, rotation);
    Body& b = body[side > 0 ? 1 : 0];
    b.name = side > 0 ? "upper" : "lower";
    b.material = "steel";
    b.mesh = mesh;
    b = turned(b, rotation,
               {in(-aside, aside) * mesh.size[0], in(-aside, aside) * mesh.size[1], side * (reach + 0.0015)});
    b.velocity = {in(-0.3, 0.3) * speed, in(-0.3, 0.3) * speed, -side * speed};
  }
  return trial_scene({body[0], body[1]}, 0.1 / speed + 2e-4);
}

Point sum_of(const Point& a, const Point& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }

TEST(RandomBlocks, KeepMomentumAndAngularMomentum) {
  int touched = 0;
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    Solver<double> solver(random_impact(seed));
    const auto momentum = [&](std::int32_t body) { return motion_of_body(solver, body).momentum; };
    const auto angular = [&](std::int32_t body) { return angular_momentum_of_body(solver, body); };
    const Point before = sum_of(momentum(0), momentum(1)), angular_before = sum_of(angular(0), angular(1));
    Point last = momentum(1), angular_last = angular(1);
    double exchanged = 0, angular_exchanged = 0;
    const double speed = norm(motion_of_body(solver, 1).momentum);
    while (!solver.at_end()) {
      solver.step();
      const Point now = momentum(1), angular_now = angular(1);
      exchanged += norm(minus(now, last));
      angular_exchanged += norm(minus(angular_now, angular_last));
      last = now;
      angular_last = angular_now;
    }
    if (exchanged < 1e-3 * speed) continue;  // they have missed each other
    ++touched;
    EXPECT_LE(norm(minus(sum_of(momentum(0), momentum(1)), before)), 1e-9 * exchanged) << seed;
    EXPECT_LE(norm(minus(sum_of(angular(0), angular(1)), angular_before)), 1e-9 * angular_exchanged) << seed;
  }
  EXPECT_GT(touched, 900);
}

}  // namespace
}  // namespace pinball::random_blocks_test
