#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <solver/base/point.hpp>
#include <solver/scene/material/orthotropic_moduli.hpp>
#include <solver/scene_rules.hpp>

namespace pinball {

void complete(ElementSettings& element) {
  if (element.hourglass_coefficient < 0) {
    element.hourglass_coefficient = default_hourglass_coefficient(element.hourglass);
  }
}

void complete(Material& material) {
  if (const auto& rubber = material.mooney_rivlin; rubber && !material.plastic) {
    const double nu = rubber->poisson_ratio;
    material.shear_modulus = 2 * (rubber->a + rubber->b);
    material.bulk_modulus = material.shear_modulus * 2 * (1 + nu) / (3 * (1 - 2 * nu));
  }
  if (const auto& law = material.ogden; law && !material.plastic && !problem_of(*law)) {
    const double nu = law->poisson_ratio;
    material.shear_modulus = shear_modulus_of(*law);
    material.bulk_modulus = material.shear_modulus * 2 * (1 + nu) / (3 * (1 - 2 * nu));
  }
  if (const auto& law = material.orthotropic; law && !material.plastic && !problem_of(*law)) {
    const IsotropicModuli mean = mean_moduli(*law);
    material.bulk_modulus = mean.bulk;
    material.shear_modulus = mean.shear;
  }
  if (const auto& eos = material.equation_of_state)
    material.bulk_modulus = bulk_modulus_at_rest(*eos, material.density);
  if (material.yield_curves.empty() || material.yield_curves.front().stress.empty()) return;
  material.yield_stress = material.yield_curves.front().stress.front();
}

namespace {

/// A vector that is one to round-off stays as it is, bit by bit.
void make_unit(Point& vector) {
  const double length = std::hypot(vector[0], vector[1], vector[2]);
  if (!(length > 0) || !std::isfinite(length) || std::abs(length - 1) < 1e-14) return;
  for (double& component : vector) component /= length;
}

void make_unit(NodeSelection& nodes) {
  if (nodes.plane) make_unit(nodes.plane->normal);
  if (nodes.line) make_unit(nodes.line->direction);
}

}  // namespace

void complete_scene(Scene& scene) {
  complete(scene.element);
  complete(scene.contact);
  const bool any_pair = !scene.contact_pairs.empty();
  if (any_pair && scene.contact.method == ContactMethod::not_set) scene.contact.method = ContactMethod::pinball;
  for (std::size_t p = 0; p < scene.contact_pairs.size(); ++p) {
    ContactPair& pair = scene.contact_pairs[p];
    complete(pair, scene.contact);
    if (pair.name.empty()) pair.name = fmt::format("pair_{}", p);
  }
  for (std::size_t t = 0; t < scene.tied_contacts.size(); ++t) {
    if (scene.tied_contacts[t].name.empty()) scene.tied_contacts[t].name = fmt::format("tied_{}", t);
  }
  for (Material& material : scene.materials) complete(material);
  for (Body& body : scene.bodies) {
    if (body.axis) make_unit(*body.axis);
    if (body.element) complete(*body.element);
  }
  for (RigidBody& rigid : scene.rigid_bodies) {
    for (Point& direction : rigid.held) make_unit(direction);
    for (Point& direction : rigid.held_rotations) make_unit(direction);
    if (rigid.name.empty() && !rigid.bodies.empty()) rigid.name = rigid.bodies.front();
  }
  for (AttachedNodes& attached : scene.attached_nodes) make_unit(attached.nodes);
  for (RigidMotion& motion : scene.rigid_motions) {
    if (motion.direction) make_unit(*motion.direction);
    if (motion.axis) make_unit(*motion.axis);
  }
  for (std::size_t j = 0; j < scene.joints.size(); ++j) {
    Joint& joint = scene.joints[j];
    if (joint.axis) make_unit(*joint.axis);
    if (joint.second_axis) make_unit(*joint.second_axis);
    if (joint.name.empty()) joint.name = fmt::format("joint_{}", j);
  }
  for (PlaneConstraint& plane : scene.constraints) make_unit(plane.normal);
  for (FixedConstraint& fixed : scene.fixed_constraints) {
    make_unit(fixed.nodes);
    make_unit(fixed.axis.direction);
    for (Point& direction : fixed.directions) make_unit(direction);
  }
  for (EquationTerm& term : scene.equation_terms) {
    make_unit(term.nodes);
    make_unit(term.direction);
  }
  for (std::size_t w = 0; w < scene.rigid_walls.size(); ++w) {
    make_unit(scene.rigid_walls[w].plane.normal);
    make_unit(scene.rigid_walls[w].nodes);
    if (scene.rigid_walls[w].edge) make_unit(*scene.rigid_walls[w].edge);
    if (scene.rigid_walls[w].name.empty()) scene.rigid_walls[w].name = fmt::format("wall_{}", w);
  }
  for (PrescribedVelocity& given : scene.prescribed_velocities) {
    make_unit(given.nodes);
    if (given.direction) make_unit(*given.direction);
  }
  for (NodalLoad& load : scene.loads) make_unit(load.nodes);
  for (std::size_t p = 0; p < scene.pressures.size(); ++p) {
    make_unit(scene.pressures[p].faces);
    if (scene.pressures[p].name.empty()) scene.pressures[p].name = fmt::format("pressure_{}", p);
  }
  for (PointMass& point : scene.point_masses) make_unit(point.nodes);
  for (InitialVelocity& given : scene.initial_velocities) make_unit(given.nodes);
  for (InitialStress& given : scene.initial_stresses) make_unit(given.nodes);
  for (Probe& probe : scene.probes) {
    if (probe.quantities.empty()) probe.quantities = probe_quantities(probe.kind);
  }
}

std::optional<Problem> problem_of(const TimeSettings& time) {
  if (time.steps == 0) return Problem{"steps", "expected an integer >= 1, or -1 for no limit, got 0"};
  return {};
}

std::optional<Problem> problem_of(const EquationTerm& term) {
  if (term.factor == 0) return Problem{"factor", "expected a number that is not 0, got 0"};
  return {};
}

std::optional<Problem> problem_of(const TimeTable& table) {
  if (table.times.size() != table.factors.size()) {
    return Problem{"factors", fmt::format("expected one number for each of the {} times, got {}", table.times.size(),
                                          table.factors.size())};
  }
  for (std::size_t i = 1; i < table.times.size(); ++i) {
    if (table.times[i] > table.times[i - 1]) continue;
    return Problem{"times",
                   fmt::format("expected increasing times, got {} after {}", table.times[i], table.times[i - 1])};
  }
  return {};
}

std::optional<Problem> problem_of(const TimeSpan& when) {
  if (when.end > when.start && when.end > 0) return {};
  return Problem{"end", fmt::format("expected a time > start and > 0, got {}", when.end)};
}

/// What goes together; its numbers and its span of time are checked by themselves.
std::optional<Problem> problem_of(const RigidWall& wall) {
  if (wall.mass > 0 && !wall.table.times.empty())
    return Problem{"times", "a wall with a mass moves as it is pushed, expected either mass or times"};
  if (!wall.sliding && wall.friction > 0)
    return Problem{"friction", "expected either friction or sliding = false, got both"};
  const bool finite = wall.size[0] > 0 || wall.size[1] > 0;
  if (finite && !wall.edge) return Problem{"edge", "missing, expected the direction of the first side beside size"};
  if (!wall.edge) return {};
  if (!finite) return Problem{"size", "expected two lengths beside edge, at least one of them > 0"};
  Point inside = *wall.edge;
  if (make_orthogonal(inside, {wall.plane.normal}) > 1e-6 * norm(*wall.edge)) return {};
  return Problem{"edge", "expected a direction across the normal, got one along it"};
}

std::optional<Problem> problem_of(const Box& box) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (box.low[k] <= box.high[k]) continue;
    return Problem{"high", fmt::format("expected numbers >= low, got {} < {}", box.high[k], box.low[k])};
  }
  return {};
}

std::optional<Problem> name_problem(const std::string& name) {
  const bool plain = std::all_of(name.begin(), name.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  });
  if (plain && !name.empty()) return {};
  return Problem{"name", fmt::format("expected a name of letters, digits, \"_\" and \"-\", got \"{}\"", name)};
}

std::optional<Problem> direction_problem(std::string_view key, const Point& vector) {
  const double length = std::hypot(vector[0], vector[1], vector[2]);
  if (length > 0.0 && std::isfinite(length)) return {};
  return Problem{std::string(key), fmt::format("expected a vector of non-zero, finite length, got [{}, {}, {}]",
                                               vector[0], vector[1], vector[2])};
}

}  // namespace pinball
