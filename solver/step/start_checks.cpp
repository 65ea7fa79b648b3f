#include "start_checks.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <kernels/exec.hpp>
#include <solver/base/counted.hpp>
#include <solver/base/error.hpp>
#include <solver/model/elements/element_start.hpp>
#include <solver/model/elements/mass_scaling.hpp>
#include <solver/model/place_names.hpp>

namespace pinball {

namespace {

/// Beyond this, somebody may have meant another time or other units.
constexpr double steps_to_warn_of = 1e6;

/// The elements of a mesh, each with its settings and the mass that is added to it.
class StartElements {
 public:
  StartElements(const Scene& scene, const ModelMesh& mesh)
      : scene_(scene),
        mesh_(mesh),
        parts_(element_parts(scene, mesh)),
        mass_factor_(mass_factors(scene, mesh, parts_)) {}

  const ElementSettings& settings(std::int64_t e) const { return part(e).settings; }
  std::size_t material(std::int64_t e) const { return part(e).material; }
  bool deforms(std::int64_t e) const { return !part(e).rigid; }
  bool has_hourglass_modes(std::int64_t e) const { return deforms(e) && part(e).shape != WorkedShape::tetrahedron; }
  bool any_deforms() const {
    for (std::int64_t e = 0; e < mesh_.element_count(); ++e) {
      if (deforms(e)) return true;
    }
    return false;
  }
  double mass_factor(std::int64_t e) const { return mass_factor_.empty() ? 1.0 : mass_factor_[e]; }
  ElementStart start(std::int64_t e) const {
    return element_start(mesh_, e, scene_.materials[part(e).material], part(e));
  }
  double stable_step(std::int64_t e) const { return start(e).stable_step(mass_factor(e)); }
  /// The viscosity eta = rho b2^2 L^2 |rate| (bulk_viscosity.hpp) with the rate of a speed over L raises 2/dt by at
  /// most its damping 8 V/m eta tr S (stable_time_step.hpp), where L^2 tr S = 3/2.
  double rate_of_closing(std::int64_t e) const {
    constexpr double stiffening = 0.7;  // as b2^2; by trial, for elements without viscosity, too
    const double b2 = settings(e).bulk_viscosity ? settings(e).quadratic_viscosity : 0.0;
    const ElementStart at = start(e);
    return 12 * (b2 * b2 + stiffening) * at.face_area / (at.volume * mass_factor(e));
  }

 private:
  const ElementPart& part(std::int64_t e) const { return parts_.parts[parts_.part_of(mesh_, e)]; }

  const Scene& scene_;
  const ModelMesh& mesh_;
  ElementParts parts_;
  std::vector<double> mass_factor_;
};

SmallestStep smallest_step(const StartElements& elements, const ModelMesh& mesh) {
  SmallestStep smallest;
  const auto take = [](SmallestStep& whole, const SmallestStep& other) {
    if (other.step < whole.step) {
      whole.step = other.step;
      whole.element = other.element;
    }
    whole.rate_of_closing = std::max(whole.rate_of_closing, other.rate_of_closing);
  };
  parallel_reduce(
      "stable steps", RangePolicy<>{0, mesh.element_count()}, smallest,
      [&](std::int64_t begin, std::int64_t end, SmallestStep& partial) {
        for (std::int64_t e = begin; e < end; ++e) {
          if (elements.deforms(e)) take(partial, {elements.stable_step(e), e, elements.rate_of_closing(e)});
        }
      },
      take);
  return smallest;
}

/// How a message names the settings of an element: those of its body, or of all.
std::string settings_of(const Scene& scene, const ModelMesh& mesh, std::int64_t element) {
  const std::size_t body = mesh.body[element];
  return scene.bodies[body].element ? fmt::format("body.{}.element", scene.bodies[body].name) : "element";
}

bool is_viscous(const ElementSettings& settings) { return settings.hourglass == HourglassControl::viscous; }

/// The element whose coefficient is furthest beyond its bound.
std::string viscous_sentence(const Scene& scene, const ModelMesh& mesh) {
  const StartElements elements(scene, mesh);
  const double least = smallest_step(elements, mesh).step;
  double most = 0, furthest = 1;
  std::int64_t worst = -1;
  for (std::int64_t e = 0; e < mesh.element_count(); ++e) {
    if (!is_viscous(elements.settings(e)) || !elements.has_hourglass_modes(e)) continue;
    const ElementStart element = elements.start(e);
    const double factor = elements.mass_factor(e);
    const double step = scene.time.cfl * (scene.time.subcycling ? element.stable_step(factor) : least);
    const double bound = factor * element.volume / (32 * element.sound_speed * element.face_area * step);
    const double beyond = elements.settings(e).hourglass_coefficient / bound;
    if (beyond > furthest) {
      furthest = beyond;
      most = bound;
      worst = e;
    }
  }
  if (worst < 0) return "";
  const double k = elements.settings(worst).hourglass_coefficient;
  return fmt::format(
      "{}.hourglass_coefficient = {:.4g} is beyond {:.3g}, up to which viscous hourglass forces are stable in {} "
      "with time.cfl = {:.4g}: where the number is the QH of another code, give QH/4, which is {:.4g}",
      settings_of(scene, mesh, worst), k, most, element_name(mesh, worst), scene.time.cfl, k / 4);
}

/// Of the other two forms; name: of the table that has the settings.
std::string stiff_sentence(const ElementSettings& element, const std::string& name, double cfl) {
  const double most = 1 / (cfl * cfl);
  if (element.hourglass == HourglassControl::none || is_viscous(element)) return "";
  if (!(element.hourglass_coefficient > std::max(1.0, most))) return "";
  return fmt::format(
      "{}.hourglass_coefficient = {:.4g} is beyond {:.3g}, up to which {} are sure to be stable with time.cfl = "
      "{:.4g}: the default is {:.4g}",
      name, element.hourglass_coefficient, std::max(1.0, most),
      element.hourglass == HourglassControl::stiffness ? "hourglass forces of the stiffness form" : "assumed strains",
      cfl, default_hourglass_coefficient(element.hourglass));
}

}  // namespace

SmallestStep check_against_steps(const Scene& scene, const ModelMesh& mesh, double longest_impact_step) {
  const StartElements elements(scene, mesh);
  const SmallestStep smallest = smallest_step(elements, mesh);
  if (!elements.any_deforms()) return smallest;
  const double stable = scene.time.cfl * smallest.step, step = std::min(stable, longest_impact_step);
  const double end = scene.time.end;
  const std::string at = element_name(mesh, smallest.element);
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
  return smallest;
}

std::string find_many_steps(const Scene& scene, const ModelMesh& mesh, const SmallestStep& smallest) {
  const double step = scene.time.cfl * smallest.step, all = scene.time.end / step;
  const double steps = scene.time.steps >= 0 ? std::min(all, static_cast<double>(scene.time.steps)) : all;
  if (!(steps >= steps_to_warn_of)) return "";
  const Point extent = element_extent(mesh, smallest.element);
  return fmt::format(
      "time.end = {:.6g} takes {:.3g} steps of {:.3g} or more, set by {}, which is {:.3g} x {:.3g} x {:.3g}: look at "
      "time.end and at units, or give such elements mass with time.smallest_step",
      scene.time.end, steps, step, element_name(mesh, smallest.element), extent[0], extent[1], extent[2]);
}

std::string find_eroded_at_start(const Scene& scene, const ModelMesh& mesh) {
  const auto limit_of = [&scene](std::size_t m) {
    const auto& erosion = scene.materials[m].erosion;
    return erosion ? erosion->smallest_step : 0.0;
  };
  struct Taken {
    std::int64_t elements = 0, all = 0;
    double longest = 0;  ///< stable step of those taken [time]
  };
  std::vector<Taken> of_material(scene.materials.size());
  bool any = false;
  for (std::size_t m = 0; m < of_material.size(); ++m) any = any || limit_of(m) > 0;
  if (!any) return "";
  const StartElements elements(scene, mesh);
  for (std::int64_t e = 0; e < mesh.element_count(); ++e) {
    const std::size_t m = elements.material(e);
    if (!(limit_of(m) > 0) || !elements.deforms(e)) continue;
    Taken& taken = of_material[m];
    ++taken.all;
    const double step = elements.stable_step(e);
    if (!(step < limit_of(m))) continue;
    ++taken.elements;
    taken.longest = std::max(taken.longest, step);
  }
  std::size_t worst = 0;
  for (std::size_t m = 0; m < of_material.size(); ++m) {
    if (of_material[m].elements > of_material[worst].elements) worst = m;
  }
  const Taken& most = of_material[worst];
  if (most.elements == 0) return "";
  return fmt::format(
      "material.{}.erosion.smallest_step = {:.4g} is above the stable step of {} at the start, up to {:.4g}: the "
      "first step erodes them",
      scene.materials[worst].name, limit_of(worst), counted_of(most.elements, most.all, "element"), most.longest);
}

std::string find_unstable_hourglass(const Scene& scene, const ModelMesh& mesh) {
  bool viscous = false;
  for (const Body& body : scene.bodies) {
    const ElementSettings& settings = body.element ? *body.element : scene.element;
    viscous = viscous || is_viscous(settings);
    const std::string name = body.element ? fmt::format("body.{}.element", body.name) : "element";
    const std::string sentence = stiff_sentence(settings, name, scene.time.cfl);
    if (!sentence.empty()) return sentence;
  }
  return viscous ? viscous_sentence(scene, mesh) : "";
}

}  // namespace pinball
