#include <vector>

#include "geometric_depth.hpp"
#include "trial.hpp"
#include "turned_body.hpp"

/// Bars that cross edge on edge.
namespace pinball::edge_trial_test {
namespace {

using namespace test;

class EdgeTrial : public TrialTest {};
INSTANTIATE_TEST_SUITE_P(All, EdgeTrial, testing::ValuesIn(variants), variant_name);

constexpr double h = 0.1;
constexpr int length = 10, width = 2;  ///< elements of a bar

struct Crossing {
  double energy = 0;    ///< kinetic and elastic at the end, over that at the start
  double depth = 0;     ///< largest of the edges that meet, over h
  double anywhere = 0;  ///< largest of any edge or node at the end, over h
  double momentum = 0;  ///< at the end, over that of one bar at the start
  double rebound = 0;   ///< relative velocity at the end over that at the start: below 0 for a rebound
};

/// Nodes of a body on its upper or lower edge.
std::vector<std::size_t> edge_nodes(const ModelMesh& mesh, std::int32_t body, double height) {
  std::vector<std::size_t> nodes;
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
    if (mesh.body_of_node[n] == body && std::abs(mesh.nodes[n][2] - height) < 1e-6 * h) nodes.push_back(n);
  }
  return nodes;
}

/// How far the edge of the lower bar, along x, is above that of the upper one where they cross, seen from above; the
/// nodes of both come in order.
double depth_of_edges(const Solver<double>& solver, const std::vector<std::size_t>& lower,
                      const std::vector<std::size_t>& upper) {
  double depth = 0;
  for (std::size_t i = 0; i + 1 < lower.size(); ++i) {
    for (std::size_t j = 0; j + 1 < upper.size(); ++j) {
      const Point a = position_of(solver, lower[i]), b = position_of(solver, upper[j]);
      const Point u = minus(position_of(solver, lower[i + 1]), a), v = minus(position_of(solver, upper[j + 1]), b);
      const Point d = minus(b, a);
      const double plane = u[0] * v[1] - u[1] * v[0];
      const double s = (d[0] * v[1] - d[1] * v[0]) / plane, t = (d[0] * u[1] - d[1] * u[0]) / plane;
      if (s >= 0 && s <= 1 && t >= 0 && t <= 1) depth = std::max(depth, a[2] + s * u[2] - b[2] - t * v[2]);
    }
  }
  return depth;
}

/// x, y: of the crossing, over h, from a node of each bar; angle: between them [degree].
Crossing cross_bars(double x, double y, double angle, const Variant& variant) {
  constexpr double speed = 10, gap = 0.05 * h;
  const double half = width * h / std::sqrt(2.0);
  const auto bar = [](const std::string& name) { return block(name, {length, width, width}, h, {}); };
  Body lower = turned(bar("lower"), turn(0, 45), {x * h, 0, -half});
  Body upper = turned(bar("upper"), times(turn(2, angle), turn(0, 45)), {0, y * h, half + gap});
  lower.velocity = {0, 0, speed};
  upper.velocity = {0, 0, -speed};
  Solver<double> solver(with_contact(trial_scene({lower, upper}, 8e-3), variant));
  const ModelMesh& mesh = solver.mesh();
  const auto top = edge_nodes(mesh, 0, 0), bottom = edge_nodes(mesh, 1, gap);
  const double momentum = norm(motion_of_body(solver, 0).momentum);
  Crossing result;
  run_to_end(solver, [&] { result.depth = std::max(result.depth, depth_of_edges(solver, top, bottom) / h); });
  const Energies& end = solver.energies();
  result.energy = (end.kinetic + end.internal + end.hourglass) / solver.initial_energy();
  const Point p0 = motion_of_body(solver, 0).momentum, p1 = motion_of_body(solver, 1).momentum;
  result.momentum = norm({p0[0] + p1[0], p0[1] + p1[1], p0[2] + p1[2]}) / momentum;
  result.rebound = (p0[2] - p1[2]) / (2 * momentum);
  GeometricDepth depth(mesh);
  depth.take([&](std::size_t n) { return position_of(solver, n); });
  result.anywhere = depth.deepest() / h;
  return result;
}

TEST_P(EdgeTrial, BarsThatCrossEdgeOnEdgeReboundWithTheirEnergy) {
  struct Case {
    const char* name;
    double x, y, angle;
  };
  for (const Case& c : {Case{"nodes", 0, 0, 90}, Case{"edges", 0.5, 0.5, 90}, Case{"edge, node", 0, 0.5, 90},
                        Case{"odd", 0.23, 0.41, 90}, Case{"odd, 50 degrees", 0.23, 0.41, 50}}) {
    const std::string trial = fmt::format("crossing bars, {}", c.name);
    const Crossing found = run_of(trial, [&] { return cross_bars(c.x, c.y, c.angle, GetParam()); });
    at_least(trial + ", energy", found.energy, 0.95);
    at_most(trial + ", energy made", found.energy, 1.001);
    at_most(trial + ", edges' depth/h", found.depth, 0.01);
    at_most(trial + ", depth/h at the end", found.anywhere, 0.01);
    at_most(trial + ", rebound", found.rebound, 0);
    at_most(trial + ", momentum", found.momentum, 1e-11);
  }
}

/// Two wedges, edge on edge.
struct Knives {
  double width;  ///< of each wedge over its height
  double shift;  ///< of the upper one along its edge [h]
  double tilt;   ///< of the upper one, by which an end of its edge is lower [degree]
  int elements;  ///< along each side
};

struct Kept {
  double energy = 0;  ///< kinetic and elastic at the end, over that at the start
  double depth = 0;   ///< the largest
};

Kept meet(const Knives& knives, double angle, const Variant& variant) {
  const double half = h / std::sqrt(2.0), gap = 0.003, speed = 10;
  const auto wedge = [&](const std::string& name) {
    const Body cube = block(name, {knives.elements, knives.elements, knives.elements}, h / knives.elements, {});
    return mapped(turned(cube, turn(0, 45), {}), [&](const Point& x) {
      return Point{x[0], x[1] * knives.width / 2, x[2]};
    });
  };
  const double tilt = knives.tilt * M_PI / 180, lower_end = half * std::cos(tilt) + h / 2 * std::sin(tilt);
  Body lower = turned(wedge("lower"), turn(2, 0), {0, 0, -half});
  Body upper =
      turned(wedge("upper"), times(turn(2, angle), turn(1, knives.tilt)), {knives.shift * h, 0, lower_end + gap});
  lower.velocity = {0, 0, speed};
  upper.velocity = {0, 0, -speed};
  Solver<double> solver(with_contact(trial_scene({lower, upper}, 5.5e-4), variant));
  run_to_end(solver, [] {});
  const Energies& end = solver.energies();
  return {(end.kinetic + end.internal + end.hourglass) / solver.initial_energy(),
          solver.counts().penetration_ratio_max()};
}

TEST_P(EdgeTrial, KnivesKeepTheirEnergyAtAnyAngle) {
  struct Case {
    const char* name;
    Knives knives;
    double least, most;
  };
  for (const Case& c : {Case{"sharp", {0.6, 0, 0, 1}, 0.735, 0.75}, Case{"right", {2, 0, 0, 1}, 0.735, 0.745},
                        Case{"sharp, of many elements, tilted", {0.6, 0, 0.3, 4}, 0.965, 1.001},
                        Case{"right, of many elements, tilted", {2, 0, 0.3, 4}, 0.965, 1.001},
                        Case{"sharp, of many elements, aside", {0.6, 0.2, 0, 4}, 0.965, 1.001}}) {
    for (const double angle : {0.0, 0.01, 0.1, 0.3, 0.7, 1.1, 1.2, 1.5, 2.0, 3.0, 5.0, 20.0, 90.0}) {
      const std::string trial = fmt::format("knives, {}, {} degrees", c.name, angle);
      const Kept found = run_of(trial, [&] { return meet(c.knives, angle, GetParam()); });
      at_least(trial + ", energy", found.energy, c.least);
      at_most(trial + ", energy made", found.energy, c.most);
      at_most(trial + ", depth", found.depth, 2e-3);
    }
  }
}

}  // namespace
}  // namespace pinball::edge_trial_test
