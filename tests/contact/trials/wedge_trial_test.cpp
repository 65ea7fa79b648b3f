#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <deque>
#include <random>

#include "geometric_depth.hpp"
#include "trial.hpp"
#include "turned_body.hpp"

/// Bodies of small elements at sharp edges, and at rims of plates, of much larger ones.
namespace pinball::wedge_trial_test {
namespace {

using namespace test;

struct Throw {
  Scene scene;
  double speed = 0;
  double size = 0;  ///< of the small elements, or the thickness of the plate where that is less [length]
};

/// A block or a sphere of elements of 0.05 to 1 meets an edge of 20 to 150 degrees, or a rim, of elements of 1, from
/// anywhere in front of it.
Throw random_throw(std::uint64_t seed) {
  std::mt19937_64 generator(seed);
  const auto in = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(generator); };
  const double size = std::exp(in(std::log(0.05), 0)), angle = in(20, 150) * M_PI / 180;
  const double speed = std::exp(in(std::log(10.0), std::log(500.0)));
  const double friction = in(0, 1) < 0.5 ? 0.0 : in(0.1, 0.8);
  const bool is_held = in(0, 1) < 0.6;
  const int n = std::uniform_int_distribution<int>(1, 3)(generator);
  const bool is_sphere = in(0, 1) < 0.25, is_plate = in(0, 1) < 0.2;
  const double thickness = is_plate ? in(0.05, 0.3) : 1.0;

  Body target = block("target", {2, 2, is_plate ? 1 : 2}, 1, {});
  target.mesh = BlockMesh{{2, 2, is_plate ? thickness : 2.0}, {2, 2, is_plate ? 1 : 2}};
  target = mapped(target, [&](const Point& x) {
    if (is_plate) return Point{x[0], x[1] - 1, x[2]};
    return Point{x[0] + x[2] * std::cos(angle), x[1] - 1, x[2] * std::sin(angle)};
  });
  Body thrown = block("thrown", {n, n, n}, size, {});
  Point edges{n * size, n * size, n * size};
  if (is_sphere) {
    SphereMesh sphere;
    sphere.radius = 0.5 * size * n;
    sphere.core = {n, n};
    thrown.mesh = sphere;
  } else {
    for (double& edge : edges) edge *= in(0.6, 1.6);
    thrown.mesh = BlockMesh{edges, {n, n, n}};
  }
  const Matrix rotation = random_turn(generator);
  const double along = in(-0.7, 0.7), aside = in(-0.5, 0.5) * size * n;
  const double from = (is_plate ? M_PI / 4 : angle / 2) + in(-1.7, 1.7);
  Point way{std::cos(from), in(-0.5, 0.5), std::sin(from)};
  const double length = norm(way), reach = 0.51 * norm(edges);
  for (double& part : way) part /= length;
  thrown = turned(
      thrown, rotation,
      {-std::sin(from) * aside - way[0] * reach, along - way[1] * reach, std::cos(from) * aside - way[2] * reach});
  thrown.velocity = {speed * way[0], speed * way[1], speed * way[2]};
  Throw result{trial_scene({target, thrown}, 3 * reach / speed), speed, std::min(size, thickness)};
  result.scene.contact.friction = result.scene.contact.static_friction = friction;
  if (is_held) result.scene.fixed_constraints = {held("target")};
  return result;
}

/// What is so deep for a moment has come into a face that bends.
constexpr std::size_t moments = 3;

TEST(WedgeTrial, SmallBodiesStayOutsideOfSharpEdges) {
  int made = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const Throw thrown = random_throw(seed);
    Solver<double> solver(thrown.scene);
    GeometricDepth depth(solver.mesh());
    const auto deepest = [&] {
      depth.take([&](std::size_t n) { return position_of(solver, n); });
      return std::max({depth.deepest_node(0), depth.deepest_node(1), depth.deepest_edge(1)}) / thrown.size;
    };
    if (deepest() > 0) continue;  // they begin in each other
    ++made;
    std::deque<double> last;
    double stays = 0;
    int step = 0;
    run_to_end(solver, [&] {
      if (++step % 4 != 0) return;
      last.push_back(deepest());
      if (last.size() > moments) last.pop_front();
      if (last.size() == moments) stays = std::max(stays, *std::ranges::min_element(last));
    });
    EXPECT_LE(stays, thrown.speed < 100 ? 0.15 : 0.3) << seed << ", " << thrown.speed << " m/s";
    const Energies& end = solver.energies();
    EXPECT_LE(end.kinetic + end.internal + end.hourglass, 1.001 * solver.initial_energy()) << seed;
  }
  EXPECT_GT(made, 150);
}

}  // namespace
}  // namespace pinball::wedge_trial_test
