#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <utility>

#include <solver/base/point.hpp>
#include <solver/mesh/quality.hpp>

#include "cases.hpp"
#include "solver_run.hpp"

/// Verification of the element and the material, without contact.
namespace pinball {

namespace {

using Stress = std::array<double, 6>;

double largest_of(const Stress& s) {
  double largest = 0;
  for (const double c : s) largest = std::max(largest, std::abs(c));
  return largest;
}

double young_modulus_of(const Material& m) {
  return 9 * m.bulk_modulus * m.shear_modulus / (3 * m.bulk_modulus + m.shear_modulus);
}

}  // namespace

std::vector<VerificationRow> verify_patch_test(const Scene& scene) {
  Solver<double> solver(scene);
  Model<double>& model = solver.change_model();  // the inner nodes are displaced below
  const std::array<Point, 3>& g = scene.bodies[0].velocity_gradient;
  const auto move = [&g](const Point& start, double time) {
    Point x = start;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) x[i] += time * g[i][j] * (start[j] - 0.5);
    }
    return x;
  };

  // Nodes on the faces of the cube are moved; the others are displaced first, by up to a quarter of an element.
  const double h = std::get<BlockMesh>(scene.bodies[0].mesh).size[0] / 3;
  std::mt19937_64 random(1985);
  std::vector<std::int32_t> outer;
  std::vector<std::size_t> inner;
  for (std::size_t n = 0; n < model.mesh.nodes.size(); ++n) {
    Point& x = model.mesh.nodes[n];
    if (std::any_of(x.begin(), x.end(), [h](double c) { return c < 0.5 * h || c > 2.5 * h; })) {
      outer.push_back(n);
      continue;
    }
    inner.push_back(n);
    const std::int32_t place = model.node_of_scene_node[n];
    double *position = model.nodes.position_of(place), *velocity = model.nodes.velocity_of(place);
    for (std::size_t k = 0; k < 3; ++k) {
      x[k] += 0.25 * h * (2 * ((random() >> 11) * 0x1p-53) - 1);
      position[k] = x[k];
    }
    for (std::size_t k = 0; k < 3; ++k) velocity[k] = move(x, 1)[k] - x[k];
  }
  // What an element weighs says what volume it has without stress.
  for (std::size_t e = 0; e < model.mesh.hexahedra.size(); ++e) {
    model.elements.mass[model.slot_of_element[e]] =
        scene.materials[0].density * volume_by_quadrature(model.mesh.corners(e));
  }

  PrescribedMotion motion(solver, move, outer);
  double largest_force = 0;
  while (!solver.at_end()) {
    std::vector<Point> before;
    for (const std::size_t n : inner) before.push_back(velocity_of(solver, n));
    const double dt_before = solver.dt();
    motion.step();
    for (std::size_t i = 0; i < inner.size(); ++i) {
      const double mass = model.node_mass[model.node_of_scene_node[inner[i]]];
      const Point after = velocity_of(solver, inner[i]);
      for (std::size_t k = 0; k < 3; ++k) {
        const double acceleration = (after[k] - before[i][k]) / (0.5 * (dt_before + solver.dt()));
        largest_force = std::max(largest_force, mass * std::abs(acceleration));
      }
    }
  }
  solver.finish();

  double worst_position = 0;
  for (const std::size_t n : inner) {
    const Point exact = move(model.mesh.nodes[n], scene.time.end), x = position_of(solver, n);
    for (std::size_t k = 0; k < 3; ++k) worst_position = std::max(worst_position, std::abs(x[k] - exact[k]));
  }

  // Stress of the neo-Hookean solid: principal stretches are 1 + 2e-3 along (1, 1, 1) and 1 + 0.5e-3 across, taken here
  // by what they are more than one.
  const double shear_strain = g[0][1] * scene.time.end;
  const double across = g[0][0] * scene.time.end - shear_strain, along = across + 3 * shear_strain;
  const double more = (1 + across) * (1 + across) * (1 + along), by_along = along * (2 + along);  // J, squares less one
  const double by_across = across * (2 + across), log_volume = std::log1p(along) + 2 * std::log1p(across);
  const Material& m = scene.materials[0];
  const double lambda = m.bulk_modulus - 2 * m.shear_modulus / 3;
  const double normal = m.shear_modulus / more * (by_along + 2 * by_across) / 3 + lambda * std::sinh(log_volume);
  const double shear = m.shear_modulus / more * (by_along - by_across) / 3;
  const Stress exact{normal, normal, normal, shear, shear, shear};
  double worst_stress = 0;
  Stress mean{};
  for (std::size_t e = 0; e < model.mesh.hexahedra.size(); ++e) {
    const Stress s = stress_of(solver, e);
    for (std::size_t c = 0; c < 6; ++c) {
      worst_stress = std::max(worst_stress, std::abs(s[c] - exact[c]));
      mean[c] += s[c] / model.mesh.hexahedra.size();
    }
  }
  const std::string paper = "MacNeal & Harder 1985, small strain";
  return {
      compare_with_zero("largest stress deviation / stress", worst_stress / normal, 1e-11,
                        "closed form, neo-Hookean, of the boundary's strain"),
      // A force of round-off, summed over 8 elements and taken from a velocity of 16 digits, is 1e-14 of the reaction.
      compare_with_zero("largest force on a free node / (stress h^2)", largest_force / (normal * h * h), 1e-11,
                        "equilibrium of uniform stress"),
      compare_with_zero("largest distance of a free node from its path / h", worst_position / h, 1e-12,
                        "the motion of the boundary, continued inwards"),
      // Strains of 2e-3 make the stress differ from that of small strains by about as much.
      compare("direct stress [kg/(m s^2)]", mean[0], 2000.0, 2e-3, paper),
      compare("shear stress [kg/(m s^2)]", mean[3], 400.0, 2e-3, paper),
  };
}

std::vector<VerificationRow> verify_uniaxial_strain(const Scene& scene) {
  Solver<double> solver(scene);
  const Model<double>& model = std::as_const(solver).model();
  const Material& m = scene.materials[0];
  // Stretch of the x direction: to 1.1 over the first half of the time, then back to 1.05.
  const double largest = 0.1, last = 0.05, half = 0.5 * scene.time.end;
  const auto stretch = [&](double t) {
    return t < half ? 1 + largest * t / half : 1 + largest + (last - largest) * (t - half) / half;
  };
  PrescribedMotion motion(solver, [&stretch](const Point& x, double t) {
    return Point{stretch(t) * x[0], x[1], x[2]};
  });

  // q = sigma_xx - sigma_yy = 2 G strain - 3 G plastic_strain on the way out; the yield stress is Y + H plastic_strain
  // up to the ultimate stress. On the way back q falls from the ultimate stress to its negative, and stays there.
  const double two_g = 2 * m.shear_modulus, three_g = 3 * m.shear_modulus;
  struct Answer {
    double xx = 0, yy = 0, plastic = 0;
  };
  const auto closed_form = [&](double strain, double turn) {
    const double outwards = std::max(strain, turn);
    const double hardening = (two_g * outwards - m.yield_stress) / (three_g + m.plastic_modulus);
    const double perfect = (two_g * outwards - m.ultimate_stress) / three_g;
    double plastic = std::max({0.0, hardening, perfect});
    const double elastic = two_g * strain - three_g * plastic;
    const double q = std::max(elastic, -m.ultimate_stress);  // reached only on the way back, after the ultimate stress
    plastic += (q - elastic) / three_g;
    return Answer{m.bulk_modulus * strain + 2 * q / 3, m.bulk_modulus * strain - q / 3, plastic};
  };

  Answer worst_out, worst_back, exact_turn, exact_end;
  double xx_turn = 0, xx_end = 0, turn = 0;
  const auto check = [&] {
    // The way turns at the largest strain that a step has reached, which is just short of that of the path.
    const bool out = solver.force_time() <= half;
    const double strain = std::log(stretch(solver.force_time()));
    turn = std::max(turn, strain);
    const Answer exact = closed_form(strain, turn);
    Answer& worst = out ? worst_out : worst_back;
    for (std::size_t e = 0; e < model.mesh.hexahedra.size(); ++e) {
      const Stress s = stress_of(solver, e);
      const double plastic_strain = model.elements.plastic_strain[model.slot_of_element[e]];
      worst.xx = std::max(worst.xx, std::abs(s[0] - exact.xx));
      worst.yy = std::max({worst.yy, std::abs(s[1] - exact.yy), std::abs(s[2] - exact.yy)});
      worst.plastic = std::max(worst.plastic, std::abs(plastic_strain - exact.plastic));
    }
    (out ? xx_turn : xx_end) = stress_of(solver, 0)[0];
    (out ? exact_turn : exact_end) = exact;
  };
  while (!solver.at_end()) {
    motion.step();
    check();
  }
  motion.step();  // of no length: the stress at the end
  check();

  // Mid-step strain increments e add up to the logarithm but for a part e^2/12; the margin of 4 is for their being
  // unequal. Deviations of stress are measured by the yield stress, a thousandth of the bulk modulus.
  const double increment = turn / (0.5 * solver.steps());
  const double relative = 4 * increment * increment / 12;
  const double deviation = relative * turn * m.bulk_modulus / m.yield_stress;
  const std::string source = "closed form in the logarithmic strain";
  return {
      compare("axial stress at the largest strain [kg/(m s^2)]", xx_turn, exact_turn.xx, relative, source),
      compare("axial stress at the end [kg/(m s^2)]", xx_end, exact_end.xx, 2 * relative, source),
      compare_with_zero("largest deviation of axial stress, out / yield stress", worst_out.xx / m.yield_stress,
                        deviation, source),
      compare_with_zero("largest deviation of axial stress, back / yield stress", worst_back.xx / m.yield_stress,
                        deviation, source),
      compare_with_zero("largest deviation of lateral stress / yield stress",
                        std::max(worst_out.yy, worst_back.yy) / m.yield_stress, deviation, source),
      compare_with_zero("largest deviation of plastic strain", std::max(worst_out.plastic, worst_back.plastic),
                        relative * turn, source),
  };
}

std::vector<VerificationRow> verify_spinning_block(const Scene& scene) {
  const Material& m = scene.materials[0];
  const double spin = scene.bodies[0].angular_velocity[2], modulus = young_modulus_of(m);
  const BlockMesh& mesh = std::get<BlockMesh>(scene.bodies[0].mesh);
  const double half_length = 0.5 * mesh.size[0];
  std::vector<VerificationRow> rows;

  // Rigid rotation, prescribed: no strain whatever, however large the turn of one step.
  {
    Scene rigid = scene;
    rigid.guard.energy_error = 1e30;  // the work of the prescribed motion is in no energy
    Solver<double> solver(rigid);
    PrescribedMotion motion(solver, [spin](const Point& x, double t) {
      const double c = std::cos(spin * t), s = std::sin(spin * t);
      return Point{c * x[0] - s * x[1], s * x[0] + c * x[1], x[2]};
    });
    while (!solver.at_end()) motion.step();
    motion.step();
    double largest = 0;
    const std::size_t count = solver.mesh().hexahedra.size();
    for (std::size_t e = 0; e < count; ++e) {
      largest = std::max(largest, largest_of(stress_of(solver, e)));
    }
    // Round-off of positions is 1e-15 of an element's size in each of 2e4 steps.
    rows.push_back(compare_with_zero("stress of ten prescribed rigid turns / Young's modulus", largest / modulus, 1e-10,
                                     "a rigid motion has no strain"));
  }

  // Free: the centripetal stress builds up from nothing and swings about its steady state.
  Solver<double> solver(scene);
  const Point before = angular_momentum(solver);
  const std::size_t elements = mesh.elements[0];
  const std::size_t middle = elements / 2;  // first element right of the centre, in the first row of elements
  const std::size_t outer = elements * 3 / 4;
  double middle_sum = 0, outer_sum = 0, worst_balance = 0, time_before = 0;
  run_to_end(solver, [&] {
    // Direction of the bar: along one of its edges.
    const Point a = position_of(solver, 0), b = position_of(solver, elements);
    Point axis = minus(b, a);
    const double length = norm(axis);
    for (double& c : axis) c /= length;
    const auto axial = [&](std::size_t element) {
      const Stress s = stress_of(solver, element);
      return s[0] * axis[0] * axis[0] + s[1] * axis[1] * axis[1] + s[2] * axis[2] * axis[2] +
             2 * (s[3] * axis[0] * axis[1] + s[4] * axis[1] * axis[2] + s[5] * axis[2] * axis[0]);
    };
    const double dt = solver.force_time() - time_before;
    time_before = solver.force_time();
    middle_sum += axial(middle) * dt;
    outer_sum += axial(outer) * dt;
    worst_balance = std::max(worst_balance, std::abs(solver.balance_error()));
  });
  const Point after = angular_momentum(solver);
  const double h = mesh.size[0] / elements;
  const auto exact = [&](std::size_t element) {
    const double x = (element + 0.5) * h - half_length;
    return 0.5 * m.density * spin * spin * (half_length * half_length - x * x);
  };
  const std::string steady = "steady state, rho w^2 (l^2 - x^2)/2";
  // All natural periods divide that of the first mode, 2 L/c, of which the run has 541: what the mean keeps of the
  // swing is below 1e-3. The mesh adds h^2/(4 l^2) = 0.25 %, the growth of the bar by 0.03 % slows the spin: 0.13 %.
  rows.push_back(
      compare("mean axial stress near the centre [kg/(m s^2)]", middle_sum / time_before, exact(middle), 5e-3, steady));
  // The same absolute parts, relative to a stress of 0.7 times that of the centre.
  rows.push_back(compare("mean axial stress at half the half-length [kg/(m s^2)]", outer_sum / time_before,
                         exact(outer), 7e-3, steady));
  // Symmetric stresses and orthogonal hourglass forces have no moment: round-off of 2e4 steps.
  rows.push_back(compare("angular momentum after ten turns [kg m^2/s]", after[2], before[2], 1e-10, "conservation"));
  // The kinetic energy of central differences, m/2 v_(n-1/2).v_(n+1/2), is smaller than that of the start by half the
  // square of the turn in a step; the work of a step errs by as much.
  RunSummary summary;
  fill_summary(solver, summary);
  const double turn = spin * summary.dt_max;
  rows.push_back(
      compare_with_zero("largest error of the energy balance", worst_balance, 2 * turn * turn, "conservation"));
  return rows;
}

std::vector<VerificationRow> verify_block(const Scene& scene) {
  // Coarser than the scene, which is made to measure speed; the strain that it reaches per element is the same.
  Scene coarse = scene;
  std::get<BlockMesh>(coarse.bodies[0].mesh).elements = {20, 20, 20};
  Solver<double> solver(coarse);
  double worst = 0;
  run_to_end(solver, [&] { worst = std::max(worst, std::abs(solver.balance_error())); });
  RunSummary summary;
  fill_summary(solver, summary);
  double drift = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    drift = std::max(drift, std::abs(summary.momentum_final[k] - summary.momentum_initial[k]));
  }
  const double mass = summary.bodies[0].mass_initial, speed = std::sqrt(2 * summary.initial_total / mass);
  return {
      // The noise has no mean of zero, so that the block drifts; what is compared is the change.
      compare_with_zero("drift of momentum / (mass x speed)", drift / (mass * speed), 1e-13, "conservation"),
      // Work of nodal forces against that of stresses: second order in the rotation and the strain of a step, 5e-4.
      compare_with_zero("largest error of the energy balance", worst, 1e-3, "conservation"),
      // Hourglass control is to stop what the mesh cannot resolve, not to resist the flow.
      compare_with_zero("hourglass energy / internal energy", summary.energy.hourglass / summary.energy.internal, 0.05,
                        "accepted bound for hourglass control"),
  };
}

}  // namespace pinball
