#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <solver/base/error.hpp>

#include "cases.hpp"
#include "solver_run.hpp"

/// Longitudinal impact of two elastic bars (report, figures 5 to 8), against the exact solution of the wave equation.
namespace pinball {

namespace {

constexpr double contact_time = 5;  ///< of the scene: gap over velocity
constexpr double duration = 3;      ///< of the comparison, in transits of a wave through a bar

/// Velocity over v0 of two equal bars at x = 5, 10, 10.5 and 15.5; tau: time since they met, in transits.
double exact_velocity(std::size_t station, double tau) {
  const bool first_bar = station < 2;
  const double start = first_bar ? 1 : 0, end = first_bar ? 0 : 1;
  const bool face = station == 1 || station == 2;
  const double meets = face ? 0.0 : 0.5, leaves = face ? 2.0 : 1.5;
  return tau < meets ? start : tau < leaves ? 0.5 : end;
}

struct BarImpact {
  double middle = 0, interface = 0;  ///< mean |v - exact| / v0 over the duration, the worse of the two bars
  double largest = 0;                ///< largest |v - exact| / v0 at any station and time
  double momentum_drift = 0;         ///< over m v0
  double impulse = 0;                ///< taken by the second bar, over m v0
  double balance_error = 0;
};

/// The scene's bars with n elements each, in the linear limit that the exact solution is of: at the scene's velocity
/// the strain of 0.5 % changes the wave speed by 0.25 %. The bars meet at x = 0, where coordinates resolve the small
/// gap.
Scene bars(const Scene& scene, ContactMethod method, Enforcement enforcement, int elements, double velocity) {
  Scene s = scene;
  s.contact.method = method;
  s.contact.enforcement = enforcement;
  s.contact.gap = enforcement == Enforcement::penalty ? ContactGap::pinball : ContactGap::face;
  const double h = 10.0 / elements;
  for (Body& body : s.bodies) body.mesh = BlockMesh{{10, h, h}, {elements, 1, 1}};
  s.bodies[0].position = {-10, 0, 0};
  s.bodies[0].velocity = {velocity, 0, 0};
  s.bodies[1].position = {contact_time * velocity, 0, 0};
  for (PlaneConstraint& plane : s.constraints) {
    for (std::size_t k = 1; k < 3; ++k) plane.point[k] *= h;
  }
  // dt = 0.9 h/c: the solver takes the bulk viscosity for that of a free cube, whose dilatation it damps three times as
  // much as it damps a bar between planes (xi = 3 b1 without Poisson effect).
  const double xi = 3 * s.element.linear_viscosity;
  s.time.cfl = 0.9 / (std::sqrt(1 + xi * xi) - xi);
  return s;
}

std::size_t node_at(const ModelMesh& mesh, double x, std::int32_t body) {
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
    const Point& p = mesh.nodes[n];
    if (mesh.body_of_node[n] == body && std::abs(p[0] - x) < 1e-9 && p[1] == 0 && p[2] == 0) return n;
  }
  throw RunError("two_bars: no node at a station");
}

BarImpact run_bars(const Scene& scene) {
  Solver<double> solver(scene);
  const ModelMesh& mesh = solver.mesh();
  const double face2 = scene.bodies[1].position[0];
  const std::size_t nodes[4] = {node_at(mesh, -5, 0), node_at(mesh, 0, 0), node_at(mesh, face2, 1),
                                node_at(mesh, face2 + 5, 1)};
  const double v0 = scene.bodies[0].velocity[0], transit = 1.0;  // 10 long, wave speed 10
  const double initial_momentum = solver.momentum()[0];
  BarImpact result;
  double sum[4] = {}, time = 0;
  run_to_end(solver, [&] {
    result.balance_error = std::max(result.balance_error, std::abs(solver.balance_error()));
    result.momentum_drift =
        std::max(result.momentum_drift, std::abs(solver.momentum()[0] - initial_momentum) / std::abs(initial_momentum));
    const double tau = (solver.time() - 0.5 * solver.dt() - contact_time) / transit;  // of the velocities
    if (tau < 0 || tau > duration) return;
    time += solver.dt();
    for (std::size_t i = 0; i < 4; ++i) {
      const double error = std::abs(velocity_of(solver, nodes[i])[0] / v0 - exact_velocity(i, tau));
      sum[i] += error * solver.dt();
      result.largest = std::max(result.largest, error);
    }
  });
  result.middle = std::max(sum[0], sum[3]) / time;
  result.interface = std::max(sum[1], sum[2]) / time;
  result.impulse = history_row(solver).bodies[1].velocity[0] / v0;
  return result;
}

/// Mean velocity of both faces over v0 while a bar presses on one of four times its density and 0.8 of its length.
/// Impedances are as 1 to 2; the waves return to the faces after 1.6 transits. The second bar has another mesh, too,
/// but for the balls of the penalty: those of flat elements reach far out of the face.
double velocity_of_unequal_faces(const Scene& equal) {
  Scene scene = equal;
  scene.materials.push_back(scene.materials[0]);
  scene.materials[1].name = "heavy";
  scene.materials[1].density *= 4;
  scene.bodies[1].material = "heavy";
  const bool balls = scene.contact.method == ContactMethod::pinball && scene.contact.gap == ContactGap::pinball;
  scene.bodies[1].mesh = BlockMesh{{8, 1, 1}, {balls ? 8 : 20, 1, 1}};
  scene.time.cfl = 0.9;
  Solver<double> solver(scene);
  const ModelMesh& mesh = solver.mesh();
  const std::size_t faces[2] = {node_at(mesh, 0, 0), node_at(mesh, scene.bodies[1].position[0], 1)};
  double sum = 0, time = 0;
  run_to_end(solver, [&] {
    const double tau = solver.time() - 0.5 * solver.dt() - contact_time;
    if (tau < 0.5 || tau > 1.4) return;
    time += solver.dt();
    for (const std::size_t n : faces) sum += 0.5 * solver.dt() * velocity_of(solver, n)[0];
  });
  return sum / (time * scene.bodies[0].velocity[0]);
}

}  // namespace

std::vector<VerificationRow> verify_two_bars(const Scene& scene) {
  std::vector<VerificationRow> rows;
  const std::string exact = "exact solution of the wave equation";
  for (const ContactMethod method : {ContactMethod::pinball, ContactMethod::slideline}) {
    for (const Enforcement enforcement : {Enforcement::penalty, Enforcement::projection, Enforcement::lagrange}) {
      const std::string name =
          std::string(method == ContactMethod::slideline ? "slideline, " : "") + enforcement_name(enforcement);
      const BarImpact coarse = run_bars(bars(scene, method, enforcement, 10, 1e-3));
      const BarImpact fine = run_bars(bars(scene, method, enforcement, 40, 1e-3));
      // The error of the middles is the element's: the wave spreads over a few elements. Aims: 0.04 and 0.02; penalty
      // at its stiffness begins and ends the contact late. How the impact falls between two steps moves all by +-0.005.
      // Springs on the nodes of the faces, which have half the mass of others, ring: an independent one-dimensional
      // program gives 0.054 and 0.183 for such springs of E A/h, here of beta = 3.
      const bool penalty = enforcement == Enforcement::penalty;
      const bool on_nodes = penalty && method == ContactMethod::slideline;
      const auto error = [&](const std::string& what, double value, double aim) {
        const std::string quantity = fmt::format("{}: mean error of the velocity at the {}", name, what);
        rows.push_back(compare_with_zero(quantity, value, aim, exact));
      };
      error("middles / v0, 10 elements", coarse.middle, on_nodes ? 0.05 : penalty ? 0.045 : 0.04);
      error("middles / v0, 40 elements", fine.middle, 0.02);
      error("faces / v0, 10 elements", coarse.interface, on_nodes ? 0.05 : penalty ? 0.035 : 0.015);
      error("faces / v0, 40 elements", fine.interface, on_nodes ? 0.025 : penalty ? 0.015 : 0.0075);
      rows.push_back(compare(name + ": impulse / m v0, 10 elements", coarse.impulse, 1.0, 0.05, exact));
      rows.push_back(compare(name + ": impulse / m v0, 40 elements", fine.impulse, 1.0, 0.025, exact));
      rows.push_back(compare_with_zero(name + ": drift of momentum",
                                       std::max(coarse.momentum_drift, fine.momentum_drift), 1e-12, "conservation"));
      rows.push_back(compare(name + ": velocity of the faces of unequal bars / v0",
                             velocity_of_unequal_faces(bars(scene, method, enforcement, 10, 1e-3)), 1.0 / 3, 0.02,
                             "impedances 1 to 2, exact"));
    }
  }
  // With steps of h/c a wave moves by one element per step, and the nodes have the exact velocities. 1e-3: the bound on
  // the step of a cube is 3e-5 short, and the division of the time into equal steps would take one more.
  for (const ContactMethod method : {ContactMethod::pinball, ContactMethod::slideline}) {
    Scene characteristic = bars(scene, method, Enforcement::lagrange, 10, 1e-9);
    characteristic.element.bulk_viscosity = false;
    characteristic.time.cfl = 1.001;
    const std::string name = method == ContactMethod::slideline ? "slideline, lagrange" : "lagrange";
    rows.push_back(compare_with_zero(name + ": largest error of the velocity / v0, dt = h/c, no viscosity",
                                     run_bars(characteristic).largest, 1e-9, exact));
  }
  return rows;
}

}  // namespace pinball
