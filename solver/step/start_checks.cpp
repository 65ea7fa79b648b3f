#include "start_checks.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <kernels/bulk_viscosity.hpp>
#include <kernels/stable_time_step.hpp>
#include <solver/base/error.hpp>
#include <solver/base/hexahedron_of_points.hpp>

namespace pinball {

namespace {

/// An element at the start.
struct Element {
  double volume, face_area, sound_speed;
  double stable_step;  ///< with linear bulk viscosity, as the kernel finds it at rest [time]
};

Element element_of(const ModelMesh& mesh, std::int64_t e, const Material& material, const ElementSettings& settings) {
  const HexahedronModes<double> x = modes_of(mesh.corners(e));
  const UniformGradient<double> b = uniform_gradient(x);
  const Symmetric<double> b_b = gradient_square(b);
  Element element{};
  element.volume = hexahedron_volume(b, x);
  element.face_area = face_area(trace(b_b));
  const double lambda = material.bulk_modulus - 2.0 / 3.0 * material.shear_modulus, mu = material.shear_modulus;
  element.sound_speed = std::sqrt((lambda + 2 * mu) / material.density);
  const double viscosity = settings.bulk_viscosity
                               ? bulk_viscosity(settings.linear_viscosity, 0.0, material.density, element.sound_speed,
                                                element.volume / element.face_area, 0.0)
                               : 0.0;
  const double inverse_square = 1 / (element.volume * element.volume);
  element.stable_step =
      2 / element_stable_rate(inverse_square * largest_principal_value(b_b), inverse_square * trace(b_b),
                              element.volume, 1 / (material.density * element.volume), lambda, mu, viscosity);
  return element;
}

template <class Visit>
void for_each_element(const Scene& scene, const ModelMesh& mesh, const Visit& visit) {
  const std::vector<std::size_t> materials = material_of_bodies(scene);
  for (std::int64_t e = 0; e < mesh.element_count(); ++e) {
    const auto body = static_cast<std::size_t>(mesh.body[static_cast<std::size_t>(e)]);
    visit(e, element_of(mesh, e, scene.materials[materials[body]], scene.element));
  }
}

struct SmallestStep {
  double step = std::numeric_limits<double>::infinity();
  std::int64_t element = 0;
};

SmallestStep smallest_step(const Scene& scene, const ModelMesh& mesh) {
  SmallestStep smallest;
  for_each_element(scene, mesh, [&smallest](std::int64_t e, const Element& element) {
    if (element.stable_step < smallest.step) smallest = {element.stable_step, e};
  });
  return smallest;
}

std::string name_of(const ModelMesh& mesh, std::int64_t element) {
  return fmt::format("element {} of body {}", element, mesh.body_of_element(element));
}

std::string viscous_sentence(const Scene& scene, const ModelMesh& mesh) {
  const double k = scene.element.hourglass_coefficient;
  const double least = smallest_step(scene, mesh).step;
  double most = std::numeric_limits<double>::infinity();
  std::int64_t worst = 0;
  for_each_element(scene, mesh, [&](std::int64_t e, const Element& element) {
    const double step = scene.time.cfl * (scene.time.subcycling ? element.stable_step : least);
    const double bound = element.volume / (32 * element.sound_speed * element.face_area * step);
    if (bound < most) {
      most = bound;
      worst = e;
    }
  });
  if (!(k > most)) return "";
  return fmt::format(
      "element.hourglass_coefficient = {:.4g} is beyond {:.3g}, up to which viscous hourglass forces are stable in {} "
      "with time.cfl = {:.4g}: where the number is the QH of another code, give QH/4, which is {:.4g}",
      k, most, name_of(mesh, worst), scene.time.cfl, k / 4);
}

}  // namespace

void check_against_steps(const Scene& scene, const ModelMesh& mesh, double longest_impact_step) {
  const SmallestStep smallest = smallest_step(scene, mesh);
  const double stable = scene.time.cfl * smallest.step, step = std::min(stable, longest_impact_step);
  const double end = scene.time.end;
  const std::string at = name_of(mesh, smallest.element);
  if (!(stable > 0) || !std::isfinite(stable)) {
    throw InputError(
        fmt::format("{}the stable step of {} is {:.3g}: expected a number > 0, look at its material and "
                    "at the units",
                    message_head(scene), at, smallest.step));
  }
  if (scene.time.steps < 0 && !(end + step > end)) {
    throw InputError(
        fmt::format("{}time.end: expected at most {:.3g}, which steps of {:.3g} can reach (set by {}), or "
                    "time.steps beside it, got {:.9g}",
                    message_head(scene), step / std::numeric_limits<double>::epsilon(), step,
                    step < stable ? "the speed of impact" : at, end));
  }
  if (scene.damping.mass * smallest.step > 2) {
    throw InputError(
        fmt::format("{}damping.mass: expected at most {:.4g}, 2 over the stable step of {}, got {:.9g}: "
                    "it would turn every motion round within one step",
                    message_head(scene), 2 / smallest.step, at, scene.damping.mass));
  }
}

std::string find_unstable_hourglass(const Scene& scene, const ModelMesh& mesh) {
  const ElementSettings& element = scene.element;
  if (element.hourglass == HourglassControl::none) return "";
  if (element.hourglass == HourglassControl::viscous) return viscous_sentence(scene, mesh);
  const double most = 1 / (scene.time.cfl * scene.time.cfl);
  if (!(element.hourglass_coefficient > std::max(1.0, most))) return "";
  return fmt::format(
      "element.hourglass_coefficient = {:.4g} is beyond {:.3g}, up to which {} are sure to be stable with time.cfl = "
      "{:.4g}: the default is {:.4g}",
      element.hourglass_coefficient, std::max(1.0, most),
      element.hourglass == HourglassControl::stiffness ? "hourglass forces of the stiffness form" : "assumed strains",
      scene.time.cfl, default_hourglass_coefficient(element.hourglass));
}

}  // namespace pinball
