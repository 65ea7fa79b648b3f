#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <string>

#include <solver/base/error.hpp>

#include "generators.hpp"
#include "section.hpp"

namespace pinball {
namespace {

void check(const CylinderMesh& settings) {
  const auto fail = [](const std::string& what) { throw InputError("cylinder mesh: " + what); };
  if (!std::isfinite(settings.radius) || settings.radius <= 0.0)
    fail(fmt::format("radius: expected a length > 0, got {}", settings.radius));
  if (!std::isfinite(settings.length) || settings.length <= 0.0)
    fail(fmt::format("length: expected a length > 0, got {}", settings.length));
  if (settings.layers < 1) fail(fmt::format("layers: expected an integer >= 1, got {}", settings.layers));
  double section_nodes = 0.0;
  if (settings.section == Section::wedge) {
    if (!(settings.angle > 0.0) || settings.angle > largest_wedge_angle)
      fail(fmt::format("angle: expected a number > 0 and <= {}, got {}", largest_wedge_angle, settings.angle));
    if (settings.radial < 1) fail(fmt::format("radial: expected an integer >= 1, got {}", settings.radial));
    section_nodes = 2.0 * settings.radial + 1.0;
  } else {
    if (settings.core < 1) fail(fmt::format("core: expected an integer >= 1, got {}", settings.core));
    if (settings.section != Section::full && settings.core % 2 != 0)
      fail(fmt::format("core: expected an even integer, since the section is cut through it, got {}", settings.core));
    if (settings.ring < 1) fail(fmt::format("ring: expected an integer >= 1, got {}", settings.ring));
    section_nodes = (settings.core + 1.0) * (settings.core + 1.0) + 4.0 * settings.core * settings.ring;
  }
  if (section_nodes * (settings.layers + 1.0) > std::numeric_limits<std::int32_t>::max())
    fail("core, ring, radial, layers: more than 2^31 - 1 nodes");
}

/// The plane of radius (first coordinate) and length, in equal rectangles.
SectionMesh rectangle(double radius, double length, int radial, int layers) {
  SectionMesh mesh;
  for (int k = 0; k <= layers; ++k)
    for (int i = 0; i <= radial; ++i)
      mesh.nodes.push_back({radius * (static_cast<double>(i) / radial), length * (static_cast<double>(k) / layers)});
  for (std::int32_t k = 0; k < layers; ++k)
    for (std::int32_t i = 0; i < radial; ++i) {
      const std::int32_t n = k * (radial + 1) + i;
      mesh.quadrilaterals.push_back({n, n + 1, n + radial + 2, n + radial + 1});
    }
  return mesh;
}

}  // namespace

Mesh generate_cylinder(const CylinderMesh& settings) {
  check(settings);
  if (settings.section == Section::wedge) {
    return turn_section(rectangle(settings.radius, settings.length, settings.radial, settings.layers), settings.angle);
  }
  const bool cut_x = settings.section == Section::quarter, cut_y = settings.section != Section::full;
  SectionMesh section = disc_section({settings.core, settings.core}, settings.ring, {cut_x, cut_y});
  for (auto& node : section.nodes)
    for (double& coordinate : node) coordinate *= settings.radius;
  return extrude_section(section, settings.length, settings.layers);
}

}  // namespace pinball
