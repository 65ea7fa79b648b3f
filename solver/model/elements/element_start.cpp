#include "element_start.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <kernels/material/bulk_viscosity.hpp>
#include <kernels/material/fluid.hpp>
#include <kernels/stable_time_step.hpp>
#include <solver/base/hexahedron_of_points.hpp>
#include <solver/mesh/element_types.hpp>

namespace pinball {

/// 2/dt = d/2 + sqrt(d^2/4 + w^2) (stable_time_step.hpp), with d and w^2 over the factor.
double ElementStart::stable_step(double mass_factor) const {
  const double damping = half_damping / mass_factor;
  return 2 / (damping + std::sqrt(damping * damping + frequency2 / mass_factor));
}

/// The same as w^2 dt^2/4 + d dt/2 = 1.
double ElementStart::mass_factor(double stable_step) const {
  return stable_step * (0.25 * frequency2 * stable_step + half_damping);
}

ElementStart element_start(const ModelMesh& mesh, std::size_t element, const Material& material,
                           const ElementPart& part) {
  const auto [volume, b_b, area] = element_size(part.shape, mesh.corners(element));
  const ElementSettings& settings = part.settings;
  ElementStart start{};
  start.volume = volume;
  start.face_area = area;
  const double lambda = material.bulk_modulus - 2.0 / 3.0 * material.shear_modulus, mu = material.shear_modulus;
  start.sound_speed = std::sqrt((lambda + 2 * mu) / material.density);
  const double viscosity = settings.bulk_viscosity
                               ? bulk_viscosity(settings.linear_viscosity, 0.0, material.density, start.sound_speed,
                                                start.volume / start.face_area, 0.0)
                               : 0.0;
  const double inverse_square = 1 / (start.volume * start.volume), inverse_mass = 1 / (material.density * start.volume);
  const double largest = inverse_square * largest_principal_value(b_b), sum = inverse_square * trace(b_b);
  const double undamped = element_stable_rate(largest, sum, start.volume, inverse_mass, lambda, mu, 0.0);
  start.frequency2 = undamped * undamped;
  const double flowing =
      material.fluid ? damping_viscosity(FluidConstants<double>{true, material.fluid->viscosity}) : 0;
  start.half_damping = 4 * start.volume * inverse_mass * (viscosity + flowing) * sum;
  return start;
}

double smallest_stable_step(const Scene& scene, const ModelMesh& mesh, const ElementParts& parts,
                            const std::vector<double>& mass_factor) {
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t e = 0; e < mesh.hexahedra.size(); ++e) {
    const ElementPart& part = parts.parts[parts.part_of(mesh, e)];
    if (part.rigid) continue;
    const ElementStart start = element_start(mesh, e, scene.materials[part.material], part);
    smallest = std::min(smallest, start.stable_step(mass_factor.empty() ? 1.0 : mass_factor[e]));
  }
  return smallest;
}

}  // namespace pinball
