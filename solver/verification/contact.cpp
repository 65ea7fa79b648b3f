#include <algorithm>
#include <cmath>
#include <utility>

#include <solver/base/point.hpp>

#include "cases.hpp"
#include "solver_run.hpp"

/// Verification of contact and erosion, with everything else at work.
namespace pinball {

namespace {

/// Volume of a trilinear hexahedron by 2 x 2 x 2 Gauss points, which integrate its Jacobian exactly: independent of the
/// closed form of the solver.
double gauss_volume(const ModelMesh& mesh, std::size_t element) {
  static constexpr int sign[8][3] = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1},
                                     {-1, -1, 1},  {1, -1, 1},  {1, 1, 1},  {-1, 1, 1}};
  const double g = 1 / std::sqrt(3.0);
  double volume = 0;
  for (const auto& p : sign) {
    double j[3][3] = {};
    for (int i = 0; i < 8; ++i) {
      const Point& x = mesh.corner(element, i);
      double f[3];
      for (int a = 0; a < 3; ++a) f[a] = 1 + sign[i][a] * p[a] * g;
      const double d[3] = {sign[i][0] * f[1] * f[2] / 8, sign[i][1] * f[2] * f[0] / 8, sign[i][2] * f[0] * f[1] / 8};
      for (std::size_t r = 0; r < 3; ++r) {
        for (int c = 0; c < 3; ++c) j[r][c] += x[r] * d[c];
      }
    }
    volume += j[0][0] * (j[1][1] * j[2][2] - j[1][2] * j[2][1]) - j[0][1] * (j[1][0] * j[2][2] - j[1][2] * j[2][0]) +
              j[0][2] * (j[1][0] * j[2][1] - j[1][1] * j[2][0]);
  }
  return volume;
}

double mesh_mass(const Solver<double>& solver, std::size_t body, double density) {
  double volume = 0;
  const ModelMesh& mesh = solver.mesh();
  for (std::size_t e = 0; e < mesh.hexahedra.size(); ++e) {
    if (mesh.body[e] == static_cast<std::int32_t>(body)) volume += gauss_volume(mesh, e);
  }
  return density * volume;
}

/// Sum over the bodies of |mass velocity|: what a drift of momentum is measured by where the total is zero.
double momentum_scale(const HistoryRow& row) {
  double scale = 0;
  for (const BodyResult& b : row.bodies) scale += b.mass_initial * norm(b.velocity);
  return scale;
}

/// The scene's blocks as bars of 1 x 1 x n cubic elements without Poisson effect: a one-dimensional impact. The gap is
/// just open: balls of cubic elements of size h touch at 2 R - h = 0.2407 h.
Scene bars(const Scene& blocks, int n) {
  Scene scene = blocks;
  Material& m = scene.materials[0];
  const double young = 9 * m.bulk_modulus * m.shear_modulus / (3 * m.bulk_modulus + m.shear_modulus);
  m.bulk_modulus = young / 3;
  m.shear_modulus = young / 2;
  const double length = std::get<BlockMesh>(scene.bodies[0].mesh).size[2], h = length / n;
  for (Body& body : scene.bodies) body.mesh = BlockMesh{{h, h, length}, {1, 1, n}};
  scene.bodies[1].position = {0, 0, length + 0.2407 * h + 0.01 * h};
  scene.time.end = 4 * length / std::sqrt(young / m.density);  // twice the duration of contact, 2 L / c
  return scene;
}

struct Impact {
  double balance_error = 0;      ///< largest
  double momentum_drift = 0;     ///< relative to the momenta of the bodies
  double restitution = 0;        ///< velocity of separation over velocity of approach, of the centres of mass
  double sum_of_velocities = 0;  ///< relative to the velocity
  double spring_energy = 0;      ///< left at the end, relative to the initial energy
};

Impact run_impact(const Scene& scene) {
  Solver<double> solver(scene);
  const HistoryRow start = history_row(solver);
  Impact impact;
  run_to_end(solver, [&] { impact.balance_error = std::max(impact.balance_error, std::abs(solver.balance_error())); });
  const HistoryRow end = history_row(solver);
  const double approach = start.bodies[0].velocity[2] - start.bodies[1].velocity[2];
  for (std::size_t k = 0; k < 3; ++k) {
    impact.momentum_drift =
        std::max(impact.momentum_drift, std::abs(end.momentum[k] - start.momentum[k]) / momentum_scale(start));
  }
  impact.restitution = (end.bodies[1].velocity[2] - end.bodies[0].velocity[2]) / approach;
  impact.sum_of_velocities = (end.bodies[0].velocity[2] + end.bodies[1].velocity[2]) / approach;
  impact.spring_energy = end.energy.contact_stored / solver.initial_energy();
  return impact;
}

}  // namespace

std::vector<VerificationRow> verify_two_blocks(const Scene& scene) {
  const Impact impact = run_impact(scene);
  Scene fine = scene;
  fine.time.cfl = 0.1;
  const Impact fine_impact = run_impact(fine);
  const Impact coarse_bars = run_impact(bars(scene, 20)), fine_bars = run_impact(bars(scene, 80));
  return {
      compare_with_zero("drift of momentum / momenta of the blocks", impact.momentum_drift, 1e-12, "conservation"),
      compare_with_zero("sum of the velocities / velocity", impact.sum_of_velocities, 1e-12, "mirror symmetry"),
      compare_with_zero("spring energy left at the end / initial energy", impact.spring_energy, 0,
                        "the blocks separate"),
      // What the vibration of the blocks keeps has no closed form; more than nothing it must be.
      compare_with_zero("restitution above 1", std::max(0.0, impact.restitution - 1), 0, "conservation"),
      // The contact lasts about 15 steps. Its first and last forces work over a whole step each, of which the balls
      // overlap for a part: second order in the step, and first order in the damping that begins at once.
      compare_with_zero("largest error of the energy balance", impact.balance_error, 3e-2, "conservation"),
      compare_with_zero("largest error of the energy balance, time.cfl = 0.1", fine_impact.balance_error, 2e-3,
                        "conservation"),
      // Equal elastic bars exchange their velocities after 2 L/c and are then free of stress. The soft contact and its
      // damping, spread over the first elements, keep a part that falls with their size.
      compare("restitution of bars of 20 elements", coarse_bars.restitution, 1.0, 5e-2, "one-dimensional waves"),
      compare("restitution of bars of 80 elements", fine_bars.restitution, 1.0, 2e-2, "one-dimensional waves"),
  };
}

namespace {

/// What has to hold whatever the contact; name: put before each quantity.
std::vector<VerificationRow> compare_invariants(Solver<double>& solver, const std::string& name) {
  const Point before = solver.momentum();
  double worst = 0;
  run_to_end(solver, [&] { worst = std::max(worst, std::abs(solver.balance_error())); });
  const Point after = solver.momentum();

  // The plane of symmetry is y = 0, the bodies lie at y >= 0.
  const ModelMesh& mesh = solver.mesh();
  double deepest = 0;
  std::int64_t not_finite = 0;
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
    const Point x = position_of(solver, n), v = velocity_of(solver, n);
    deepest = std::max(deepest, -x[1]);
    for (std::size_t k = 0; k < 3; ++k) not_finite += !std::isfinite(x[k]) || !std::isfinite(v[k]);
  }
  return {
      compare(name + "momentum along x at the end [lbf s]", after[0], before[0], 1e-10, "conservation"),
      compare(name + "momentum along z at the end [lbf s]", after[2], before[2], 1e-10, "conservation"),
      compare_with_zero(name + "largest error of the energy balance", worst, 1e-2, "conservation"),
      compare_with_zero(name + "deepest node beyond the plane of symmetry [in]", deepest, 1e-9, "symmetry"),
      compare_with_zero(name + "coordinates that are not finite", not_finite, 0, "stability"),
  };
}

}  // namespace

std::vector<VerificationRow> verify_rod_plate(const Scene& scene) {
  Solver<double> solver(scene);
  const HistoryRow start = history_row(solver);
  std::vector<VerificationRow> rows{
      compare("elements of the rod", start.bodies[0].elements, 414, 0, "report, figure 9"),
      compare("elements of the plate", start.bodies[1].elements, 1428, 0, "report, figure 9"),
      compare("mass of the rod [lbf s^2/in]", start.bodies[0].mass_initial,
              mesh_mass(solver, 0, scene.materials[0].density), 1e-12, "Gauss quadrature of the mesh"),
      compare("mass of the plate [lbf s^2/in]", start.bodies[1].mass_initial,
              scene.materials[1].density * 7.9 * 3.95 * 0.375, 1e-12, "length x width x thickness"),
  };
  const auto add = [&rows](const std::vector<VerificationRow>& more) {
    rows.insert(rows.end(), more.begin(), more.end());
  };
  add(compare_invariants(solver, ""));
  for (const Enforcement enforcement : {Enforcement::penalty, Enforcement::projection, Enforcement::lagrange}) {
    Scene slideline = scene;
    slideline.contact.method = ContactMethod::slideline;
    slideline.contact.enforcement = enforcement;
    Solver<double> old(slideline);
    add(compare_invariants(old, std::string("slideline, ") + enforcement_name(enforcement) + ": "));
  }
  return rows;
}

}  // namespace pinball
