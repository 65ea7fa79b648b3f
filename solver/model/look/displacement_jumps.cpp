#include "displacement_jumps.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace pinball {

namespace {

/// Empty: it begins with 0, or where another one ends. size: of what its factors multiply.
template <class Motion>
std::string sentence(const std::vector<Motion>& all, const Motion& given, double size, const std::string& where) {
  if (given.quantity != MotionQuantity::displacement) return "";
  const double start = std::max(0.0, given.when.start);
  const double jump = size * std::abs(given.table.value(start));
  if (!(jump > 0)) return "";
  if (std::ranges::any_of(all, [start](const Motion& other) { return other.when.end <= start; })) return "";
  return fmt::format(
      "{}: its displacement is {:.4g} where it begins, at time {:.4g}: nothing leaps, it counts from there", where,
      jump, start);
}

}  // namespace

std::vector<std::string> displacement_jumps(const Scene& scene) {
  std::vector<std::string> all;
  const auto add = [&all](std::string found) {
    if (!found.empty()) all.push_back(std::move(found));
  };
  for (const PrescribedVelocity& given : scene.prescribed_velocities)
    add(sentence(scene.prescribed_velocities, given, norm(given.velocity), given.nodes.where));
  for (const RigidMotion& given : scene.rigid_motions)
    add(sentence(scene.rigid_motions, given, std::abs(given.axis ? given.angular_speed : given.speed), given.where));
  return all;
}

}  // namespace pinball
