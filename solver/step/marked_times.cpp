#include "marked_times.hpp"

#include <algorithm>
#include <cmath>

namespace pinball {

std::vector<double> marked_times(const Scene& scene) {
  std::vector<double> times;
  const auto take = [&times](double start, double end) {
    for (const double time : {start, end}) {
      if (time > 0 && std::isfinite(time)) times.push_back(time);
    }
  };
  for (const FixedConstraint& one : scene.fixed_constraints) take(one.when.start, one.when.end);
  for (const PrescribedVelocity& one : scene.prescribed_velocities) take(one.when.start, one.when.end);
  for (const RigidMotion& one : scene.rigid_motions) take(one.when.start, one.when.end);
  for (const RigidWall& one : scene.rigid_walls) take(one.when.start, one.when.end);
  for (const Pressure& one : scene.pressures) take(one.start, 0);
  for (const ContactPair& one : scene.contact_pairs) take(one.start, one.end);
  for (const TiedContact& one : scene.tied_contacts) take(one.start, one.end);
  for (const Material& one : scene.materials) {
    if (one.erosion) take(0, one.erosion->time);
  }
  std::ranges::sort(times);
  return times;
}

}  // namespace pinball
