#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include <tests/support/solver_case.hpp>

/// Trials of contact: scenes whose answer geometry or mechanics gives exactly, run with each form of contact. A trial
/// prints a line per form, so that what a test program prints is a table of measured and exact figures.
namespace pinball::test {

/// A form of contact that the trials are run with.
struct Variant {
  const char* name;
  ContactMethod method;
  Enforcement enforcement;
  ContactGap gap;
};

inline void PrintTo(const Variant& variant, std::ostream* out) { *out << variant.name; }

/// The default comes first: every trial has to hold for it.
inline constexpr Variant variants[] = {
    {"pinball_lagrange_face", ContactMethod::pinball, Enforcement::lagrange, ContactGap::face},
    {"pinball_projection_face", ContactMethod::pinball, Enforcement::projection, ContactGap::face},
    {"pinball_penalty_balls", ContactMethod::pinball, Enforcement::penalty, ContactGap::pinball},
    {"slideline_penalty", ContactMethod::slideline, Enforcement::penalty, ContactGap::not_set},
    {"slideline_projection", ContactMethod::slideline, Enforcement::projection, ContactGap::not_set},
    {"slideline_lagrange", ContactMethod::slideline, Enforcement::lagrange, ContactGap::not_set},
};
inline constexpr const Variant& slideline_lagrange = variants[5];

inline std::string variant_name(const testing::TestParamInfo<Variant>& test) { return test.param.name; }

inline Scene with_contact(Scene scene, const Variant& variant) {
  scene.contact.method = variant.method;
  scene.contact.enforcement = variant.enforcement;
  scene.contact.gap = variant.gap;
  return scene;
}

/// Elastic steel, elements and contact at their default, but for the bulk viscosity, which is off: nothing but contact
/// may take energy.
inline Scene trial_scene(const std::vector<Body>& bodies, double end, double poisson_ratio = 0.3) {
  Scene scene = scene_of(bodies, end);
  scene.element = {};
  scene.element.bulk_viscosity = false;
  scene.contact = {};
  scene.materials = {elastic_material("steel", poisson_ratio)};
  scene.guard.energy_error = 1e6;  // a form that is wrong is to be measured, not to be stopped
  return scene;
}

/// A rigid floor below all, z = 0.
inline RigidWall floor_of(double friction) {
  RigidWall floor;
  floor.name = "floor";
  floor.plane = Plane{{0, 0, 0}, {0, 0, 1}};
  floor.friction = friction;
  return floor;
}

inline FixedConstraint held(const std::string& body) {
  FixedConstraint constraint;
  constraint.nodes.body = body;
  constraint.directions = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  return constraint;
}

/// The nodes of a body at a height z are held.
inline FixedConstraint held_at(const std::string& body, double z) {
  FixedConstraint constraint = held(body);
  constraint.nodes.plane = Plane{{0, 0, z}, {0, 0, 1}};
  return constraint;
}

/// A test of some trials, with one form of contact.
class TrialTest : public testing::TestWithParam<Variant> {
 protected:
  /// The forms that have to hold beside the default.
  void also_holds(std::initializer_list<std::string_view> names) { also_ = names; }

  /// Prints a line of the table. |measured - exact| has to be within the bound where the form has to hold.
  void compare(const std::string& trial, double measured, double exact, double bound) const {
    const bool right = std::abs(measured - exact) <= bound;
    print(trial, measured, fmt::format("{:.4g} +- {:.3g}", exact, bound), right);
    if (!must_hold()) return;
    EXPECT_TRUE(right) << trial << ": " << measured << " instead of " << exact << " +- " << bound;
  }
  void at_most(const std::string& trial, double measured, double bound) const {
    print(trial, measured, fmt::format("<= {:.4g}", bound), measured <= bound);
    if (!must_hold()) return;
    EXPECT_LE(measured, bound) << trial;
  }
  void at_least(const std::string& trial, double measured, double bound) const {
    print(trial, measured, fmt::format(">= {:.4g}", bound), measured >= bound);
    if (!must_hold()) return;
    EXPECT_GE(measured, bound) << trial;
  }

  /// What `measure` returns; a run that stops counts as a number that no trial takes for right.
  template <class Measure>
  auto run_of(const std::string& trial, const Measure& measure) const -> decltype(measure()) {
    try {
      return measure();
    } catch (const std::exception& error) {
      fmt::print("{:<52} {:<24} stopped: {}\n", trial, GetParam().name, error.what());
      if (must_hold()) ADD_FAILURE() << trial << ": " << error.what();
    }
    return {};
  }

 private:
  bool must_hold() const {
    const std::string_view name = GetParam().name;
    return name == variants[0].name || std::find(also_.begin(), also_.end(), name) != also_.end();
  }
  static void print(const std::string& trial, double measured, const std::string& expected, bool right) {
    fmt::print("{:<52} {:<24} {:>12.5g}   {:<20} {}\n", trial, GetParam().name, measured, expected,
               right ? "" : "MISSED");
  }

  std::vector<std::string_view> also_;
};

/// Mass and momentum of a body of the scene.
struct BodyMotion {
  double mass = 0;
  Point momentum{};
  Point velocity() const { return {momentum[0] / mass, momentum[1] / mass, momentum[2] / mass}; }
};

inline BodyMotion motion_of_body(const Solver<double>& solver, std::int32_t body) {
  BodyMotion motion;
  const Model<double>& model = solver.model();
  for (std::size_t n = 0; n < model.mesh.nodes.size(); ++n) {
    if (model.mesh.body_of_node[n] != body) continue;
    const double mass = model.node_mass[model.node_of_scene_node[n]];
    const Point v = velocity_of(solver, n);
    motion.mass += mass;
    for (std::size_t k = 0; k < 3; ++k) motion.momentum[k] += mass * v[k];
  }
  return motion;
}

/// Angular momentum of a body about the origin. That of positions at the end of a step and velocities in its middle is
/// exact: a node's own velocity has no moment about its way.
inline Point angular_momentum_of_body(const Solver<double>& solver, std::int32_t body) {
  Point sum{};
  const Model<double>& model = solver.model();
  for (std::size_t n = 0; n < model.mesh.nodes.size(); ++n) {
    if (model.mesh.body_of_node[n] != body) continue;
    const Point moment = cross(position_of(solver, n), velocity_of(solver, n));
    for (std::size_t k = 0; k < 3; ++k) sum[k] += model.node_mass[model.node_of_scene_node[n]] * moment[k];
  }
  return sum;
}

/// Tells when a body that flies freely feels its first force: its momentum changes then.
class FirstForce {
 public:
  FirstForce(const Solver<double>& solver, std::int32_t body)
      : solver_(solver), body_(body), before_(motion_of_body(solver, body).momentum) {}

  /// Whether the last step had a force on the body.
  bool felt() const { return norm(minus(motion_of_body(solver_, body_).momentum, before_)) > 1e-9 * norm(before_); }

 private:
  const Solver<double>& solver_;
  std::int32_t body_;
  Point before_;
};

}  // namespace pinball::test
