#include "error_sources.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include <solver/base/error.hpp>
#include <solver/model/rigid/rigid_nodes.hpp>
#include <solver/scene/schema/choices.hpp>
#include <solver/scene_rules.hpp>

#include "mesh_factor.hpp"

namespace pinball {

namespace {

double speed_of(const Point& velocity) { return std::hypot(velocity[0], velocity[1], velocity[2]); }

double largest_factor(const TimeTable& table) {
  double largest = table.factors.empty() ? 1 : 0;
  for (const double factor : table.factors) largest = std::max(largest, std::abs(factor));
  return largest;
}

/// The largest that the scene gives to anything, else a thousandth of that of waves [length/time].
double noise_speed(const Scene& scene) {
  double largest = 0;
  for (const Body& body : scene.bodies) largest = std::max(largest, speed_of(body.velocity));
  for (const InitialVelocity& given : scene.initial_velocities) largest = std::max(largest, speed_of(given.velocity));
  for (const RigidBody& rigid : scene.rigid_bodies) {
    if (rigid.velocity) largest = std::max(largest, speed_of(*rigid.velocity));
  }
  for (const RigidWall& wall : scene.rigid_walls)
    largest = std::max(largest, largest_factor(wall.table) * std::abs(wall.speed));
  for (const PrescribedVelocity& given : scene.prescribed_velocities) {
    if (given.quantity == MotionQuantity::velocity)
      largest = std::max(largest, largest_factor(given.table) * speed_of(given.velocity));
  }
  for (const RigidMotion& given : scene.rigid_motions) {
    if (given.quantity == MotionQuantity::velocity)
      largest = std::max(largest, largest_factor(given.table) * std::abs(given.speed));
  }
  if (largest > 0) return largest;
  for (const Material& m : scene.materials) largest = std::max(largest, std::sqrt(m.bulk_modulus / m.density));
  return 1e-3 * largest;
}

/// With smallest_step halved as well, elements have the mass that they had.
SourceVariation half_step(const Scene& scene) {
  Scene half = scene;
  half.time.cfl /= 2;
  half.time.smallest_step /= 2;
  std::string what = fmt::format("time.cfl = {}", half.time.cfl);
  if (half.time.smallest_step > 0) what += fmt::format(", time.smallest_step = {}", half.time.smallest_step);
  return {ErrorSource::step, "time step", what, "half_step", {half}};
}

void add_precisions(const Scene& scene, std::vector<SourceVariation>& variations) {
  for (const auto& choice : schema::choices(schema::Of<Precision>{})) {
    const bool on_device = scene.device != Device::none && choice.value == Precision::mixed;  // it has none
    if (choice.value == scene.precision || on_device) continue;
    Scene other = scene;
    other.precision = choice.value;
    const std::string name = choice.name;
    variations.push_back({ErrorSource::precision, name, fmt::format("precision = \"{}\"", name), name, {other}});
  }
}

void set_hourglass(ElementSettings& element, HourglassControl control) {
  element.hourglass = control;
  element.hourglass_coefficient = default_hourglass_coefficient(control);
}

void add_hourglass(const Scene& scene, std::vector<SourceVariation>& variations) {
  for (const auto& choice : schema::choices(schema::Of<HourglassControl>{})) {
    if (choice.value == HourglassControl::none || choice.value == scene.element.hourglass) continue;
    Scene other = scene;
    set_hourglass(other.element, choice.value);
    for (Body& body : other.bodies) {
      if (body.element) set_hourglass(*body.element, choice.value);
    }
    variations.push_back({ErrorSource::hourglass,
                          fmt::format("hourglass {}", choice.name),
                          fmt::format("element.hourglass = \"{}\" with its default coefficient", choice.name),
                          fmt::format("hourglass_{}", choice.name),
                          {other}});
  }
}

void add_contact(const Scene& scene, std::vector<SourceVariation>& variations) {
  const ContactSettings& own = scene.contact;
  const auto add = [&](const char* name, const char* what, const char* folder, const ContactSettings& contact) {
    if (problem_of(contact)) return;
    Scene other = scene;
    other.contact = contact;
    variations.push_back({ErrorSource::contact, name, what, folder, {other}});
  };
  ContactSettings faces = own, slideline = own;
  faces.method = ContactMethod::pinball;
  faces.enforcement = Enforcement::lagrange;
  faces.gap = ContactGap::face;
  slideline.method = ContactMethod::slideline;
  const bool is_slideline = own.method == ContactMethod::slideline;
  if (is_slideline || own.enforcement != faces.enforcement || own.gap != faces.gap) {
    add("contact faces", R"(contact.method = "pinball", enforcement = "lagrange", gap = "face")", "contact_faces",
        faces);
  }
  if (!is_slideline) add("contact slideline", R"(contact.method = "slideline")", "contact_slideline", slideline);
}

void scale(Point& vector, double factor) {
  for (double& component : vector) component *= factor;
}

/// Bodies that are rigid know no noise: theirs are velocities of the same motion, a little faster.
void move_bodies(Scene& scene, double part, double speed) {
  const std::vector<std::int32_t> rigid = rigid_body_of_bodies(scene);
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    Body& body = scene.bodies[b];
    if (rigid[b] < 0) {
      body.velocity_noise += part * speed;
    } else {
      scale(body.velocity, 1 + part);
      scale(body.angular_velocity, 1 + part);
    }
  }
  for (InitialVelocity& given : scene.initial_velocities) {
    scale(given.velocity, 1 + part);
    scale(given.angular_velocity, 1 + part);
  }
  for (RigidBody& given : scene.rigid_bodies) {
    if (given.velocity) scale(*given.velocity, 1 + part);
    if (given.angular_velocity) scale(*given.angular_velocity, 1 + part);
  }
}

SourceVariation by_chance(const Scene& scene, int ensemble) {
  const double part = scene.precision == Precision::float32 ? 1e-5 : 1e-9, speed = noise_speed(scene);
  SourceVariation variation{ErrorSource::chance,
                            "chance",
                            fmt::format("{} runs beside the first, initial velocities moved by {:g} of {:.3g} and more",
                                        ensemble, part, speed),
                            "chance_",
                            {}};
  for (int k = 1; k <= ensemble; ++k) {
    Scene moved = scene;
    move_bodies(moved, k * part, speed);
    variation.scenes.push_back(std::move(moved));
  }
  return variation;
}

}  // namespace

std::vector<SourceVariation> vary_sources(const Scene& scene, const std::vector<ErrorSource>& sources, int ensemble) {
  const auto asked = [&sources](ErrorSource source) {
    return std::find(sources.begin(), sources.end(), source) != sources.end();
  };
  std::vector<SourceVariation> variations;
  if (asked(ErrorSource::step)) variations.push_back(half_step(scene));
  if (asked(ErrorSource::precision)) add_precisions(scene, variations);
  if (asked(ErrorSource::hourglass)) add_hourglass(scene, variations);
  if (asked(ErrorSource::contact)) add_contact(scene, variations);
  if (asked(ErrorSource::chance)) variations.push_back(by_chance(scene, ensemble));
  return variations;
}

std::string name_of(const RefinedBody& body) { return fmt::format("{} {} times finer", body.body, body.times); }

RefinedBody parse_refined_body(const std::string& text) {
  const std::size_t equals = std::min(text.find('='), text.size());
  int times = 0;
  const char* end = text.data() + text.size();
  const auto [rest, problem] = std::from_chars(std::min(text.data() + equals + 1, end), end, times);
  if (equals > 0 && problem == std::errc() && rest == end && times >= 2 && times <= 1000) {
    return {text.substr(0, equals), times};
  }
  throw InputError(fmt::format("--refine {}: expected a number, or BODY=K with K of 2 to 1000", text));
}

std::vector<SourceVariation> vary_bodies(const Scene& scene, const std::vector<RefinedBody>& bodies) {
  std::vector<SourceVariation> variations;
  for (const RefinedBody& refined : bodies) {
    const Scene finer = refined_body(scene, refined.body, {refined.times, 1});
    variations.push_back({ErrorSource::body,
                          name_of(refined),
                          element_counts(finer),
                          fmt::format("{}_{}", refined.body, refined.times),
                          {finer}});
  }
  return variations;
}

}  // namespace pinball
