#include "drift_energy.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace pinball {

namespace {

/// The directions that something outside tells from the others, orthonormal.
class HeldSpace {
 public:
  void add(Point direction) {
    constexpr double nothing = 1e-9;
    if (basis_.size() < 3 && make_orthogonal(direction, basis_) > nothing) basis_.push_back(direction);
  }
  void add_all() {
    for (std::size_t k = 0; k < 3; ++k) {
      Point unit{};
      unit[k] = 1;
      add(unit);
    }
  }
  double square_of_rest(Point vector) const {
    const double length = make_orthogonal(vector, basis_);
    return length * length;
  }

 private:
  std::vector<Point> basis_;
};

/// With the ground: those along its axis slide, all others hold a point.
void add_held_by(const Joint& joint, HeldSpace& held) {
  const bool slides = joint.kind == JointKind::cylindrical || joint.kind == JointKind::translational;
  if (!slides || !joint.axis) return held.add_all();
  for (std::size_t k = 0; k < 3; ++k) {
    Point across{};
    across[k] = 1;
    const double along = (*joint.axis)[k];
    for (std::size_t c = 0; c < 3; ++c) across[c] -= along * (*joint.axis)[c];
    held.add(across);
  }
}

/// Whether a law has a pressure of the present volume, not of increments: what is rounded of that presses.
bool sees_volumes(const Material& m) {
  return m.equation_of_state || m.johnson_holmquist || m.mooney_rivlin || m.ogden || m.crushable_foam;
}

template <class S>
double mass_of_nodes(const Model<S>& model) {
  double mass = 0;
  for (const double m : model.node_mass) mass += m;
  return mass;
}

/// What forces do over the lengths that places are rounded by, to which joints keep them: they do no work against it.
template <class S>
double work_over_rounding(const Model<S>& model) {
  const Scene& scene = model.scene;
  if (scene.joints.empty()) return 0;
  const auto most = [](const TimeTable& table) {
    double largest = table.factors.empty() ? 1.0 : 0.0;
    for (const double factor : table.factors) largest = std::max(largest, std::abs(factor));
    return largest;
  };
  double reach = 0, force = 0;
  for (const Point& node : model.mesh.nodes) reach = std::max(reach, norm(node));
  const double area = 24 * reach * reach;  // of a cube around all
  for (const Gravity& gravity : scene.gravities)
    force += most(gravity.table) * norm(gravity.acceleration) * mass_of_nodes(model);
  for (const NodalLoad& load : scene.loads)
    force += most(load.table) * norm(load.force) * (load.each ? static_cast<double>(model.mesh.nodes.size()) : 1.0);
  for (const Pressure& pressure : scene.pressures) force += most(pressure.table) * std::abs(pressure.pressure) * area;
  return 1e-13 * reach * force;
}

}  // namespace

template <class S>
double energy_at_rest(const Model<S>& model) {
  double fastest = 0;
  for (const ElementConstants<S>& c : model.constants)
    fastest = std::max(fastest, static_cast<double>(c.material.sound_speed));
  const auto energy = [](double mass, double share, double speed) {
    return 0.5 * mass * share * share * speed * speed;
  };
  double sum = energy(mass_of_nodes(model), 1e-13, fastest) + work_over_rounding(model);
  if (!has_single_elements(model.scene.precision)) return sum;
  const std::vector<std::size_t> material = material_of_bodies(model.scene);
  std::vector<double> speed(model.scene.materials.size(), 0.0);
  for (std::size_t p = 0; p < model.parts.size(); ++p) {
    double& largest = speed[static_cast<std::size_t>(model.parts[p].material)];
    largest = std::max(largest, static_cast<double>(model.constants[p].material.sound_speed));
  }
  for (std::size_t e = 0; e < model.element_mass.size(); ++e) {
    const std::size_t m = material[static_cast<std::size_t>(model.mesh.body[e])];
    if (sees_volumes(model.scene.materials[m])) sum += energy(model.element_mass[e], 1e-6, speed[m]);
  }
  return sum;
}

template <class S>
double drift_energy(const Model<S>& model, const Point& momentum) {
  const Scene& scene = model.scene;
  HeldSpace held;
  if (scene.damping.mass > 0) held.add_all();
  for (const RigidWall& wall : scene.rigid_walls) {
    held.add(wall.plane.normal);
    if (wall.friction > 0 || !wall.sliding) held.add_all();
  }
  const auto add = [&held](const auto& nodes) {  // of one direction of one node each
    for (const auto& node : nodes) {
      held.add({node.normal[0], node.normal[1], node.normal[2]});
    }
  };
  add(model.constraints);
  add(model.prescribed);
  for (const RigidNodes& rigid : model.rigid) {
    for (const Point& direction : rigid.held) held.add(direction);
  }
  for (const RigidMotion& motion : scene.rigid_motions) {
    if (motion.direction) held.add(*motion.direction);
  }
  for (const Joint& joint : scene.joints) {
    if (std::ranges::find(joint.bodies, ground) != joint.bodies.end()) add_held_by(joint, held);
  }
  const double mass = mass_of_nodes(model);
  if (!(mass > 0)) return 0;
  Point velocity = momentum;  // whose square overflows later than that of the momentum
  for (double& v : velocity) v /= mass;
  return 0.5 * mass * held.square_of_rest(velocity);
}

template double energy_at_rest(const Model<double>&);
template double energy_at_rest(const Model<float>&);
template double drift_energy(const Model<double>&, const Point&);
template double drift_energy(const Model<float>&, const Point&);

}  // namespace pinball
