#pragma once

#include <cmath>

#include "element_fixture.hpp"

namespace pinball::test {

/// A unit cube of density 3 that is strained by one rate, from the last step to the next; positions are those of the
/// end of the step.
class StrainedCube {
 public:
  static constexpr ElementFeatures features{true, true, true, HourglassKind::none, YieldLaw::general};

  explicit StrainedCube(const ElementConstants<double>& constants) : constants_(constants) { state_.mass = 3; }

  /// diagonal: logarithmic rates along the axes; shear: dv_x/dy.
  void strain(const Vec3<double>& diagonal, double shear, double dt) {
    ElementScene scene;
    scene.constants = constants_;
    scene.dt = dt;
    const Vec3<double> before = stretch_;
    const double sheared = shear_;
    stretch_ = {before.x * std::exp(diagonal.x * dt), before.y * std::exp(diagonal.y * dt),
                before.z * std::exp(diagonal.z * dt)};
    shear_ += shear * dt;
    Corners x, v;
    for (std::size_t i = 0; i < 8; ++i) {
      const Vec3<double> corner = unit_corner(i);
      x[i] = at(corner, stretch_, shear_);
      v[i] = (1 / dt) * (x[i] - at(corner, before, sheared));
    }
    scene.add(x, v, state_);
    const ElementOutcome out = advance<double, features>(scene);
    internal_ += out.internal;
    viscous_ += out.viscous;
    eroded_ += out.eroded_count;
    time_step_ = out.time_step;
    state_ = out.element[0];
  }
  const ElementState& state() const { return state_; }
  double internal() const { return internal_; }
  double viscous() const { return viscous_; }
  const Vec3<double>& stretch() const { return stretch_; }
  double volume() const { return stretch_.x * stretch_.y * stretch_.z; }
  double time_step() const { return time_step_; }
  int eroded() const { return eroded_; }
  double pressure() const { return -trace(state_.stress) / 3; }

 private:
  static Vec3<double> unit_corner(std::size_t i) {
    return {i == 1 || i == 2 || i == 5 || i == 6 ? 1.0 : 0.0, i == 2 || i == 3 || i == 6 || i == 7 ? 1.0 : 0.0,
            i > 3 ? 1.0 : 0.0};
  }
  static Vec3<double> at(const Vec3<double>& corner, const Vec3<double>& stretch, double shear) {
    return {stretch.x * corner.x + shear * corner.y, stretch.y * corner.y, stretch.z * corner.z};
  }

  ElementConstants<double> constants_;
  ElementState state_;
  Vec3<double> stretch_{1, 1, 1};
  double shear_ = 0, internal_ = 0, viscous_ = 0, time_step_ = 0;
  int eroded_ = 0;
};

}  // namespace pinball::test
