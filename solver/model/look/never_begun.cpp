#include "never_begun.hpp"

#include <fmt/core.h>

namespace pinball {

std::vector<std::string> never_begun(const Scene& scene) {
  std::vector<std::string> found;
  const auto take = [&](double start, const std::string& where, const char* kind, std::size_t number) {
    if (!(start >= scene.time.end)) return;
    found.push_back(fmt::format("{}: it begins at {:.6g}, and the run ends at time.end = {:.6g}",
                                where.empty() ? fmt::format("{}.{}", kind, number) : where, start, scene.time.end));
  };
  for (const FixedConstraint& one : scene.fixed_constraints)
    take(one.when.start, one.nodes.where, "constraint", &one - scene.fixed_constraints.data());
  for (const PrescribedVelocity& one : scene.prescribed_velocities)
    take(one.when.start, one.nodes.where, "prescribed_velocity", &one - scene.prescribed_velocities.data());
  for (const RigidMotion& one : scene.rigid_motions)
    take(one.when.start, one.where, "rigid_motion", &one - scene.rigid_motions.data());
  for (const RigidWall& one : scene.rigid_walls)
    take(one.when.start, one.where, "rigid_wall", &one - scene.rigid_walls.data());
  for (const Pressure& one : scene.pressures)
    take(one.start, one.faces.where, "pressure", &one - scene.pressures.data());
  for (const ContactPair& one : scene.contact_pairs)
    take(one.start, one.where, "contact.pair", &one - scene.contact_pairs.data());
  for (const TiedContact& one : scene.tied_contacts)
    take(one.start, one.where, "contact.tied", &one - scene.tied_contacts.data());
  return found;
}

}  // namespace pinball
