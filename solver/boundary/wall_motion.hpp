#pragma once

#include <kernels/boundary/external_work.hpp>
#include <kernels/boundary/rigid_wall.hpp>
#include <solver/scene_boundary.hpp>

namespace pinball {

/// How a rigid wall moves along its normal: not at all, as given, or pushed by the nodes.
///
/// A wall of mass M has with the reactions N_i of the nodes, each a function of where the wall ends up,
///
///     M (V_(n+1/2) - V_(n-1/2)) + dt_n sum N_i(V_(n+1/2)) = 0 ,   N_i = max(0, -(g_i - dt_(n+1/2) V_(n+1/2)) / m_i') ,
///
/// which is convex and grows with V: Newton's iterations from above end at the only root after as many turns as other
/// nodes come to touch. Nodes and wall then have one velocity, as in a plastic impact of both.
class WallMotion {
 public:
  WallMotion() = default;
  explicit WallMotion(const RigidWall& given) : mass_(given.mass), speed_(given.speed), table_(given.table) {}

  bool moves() const { return mass_ > 0 || speed_ != 0; }
  bool is_pushed() const { return mass_ > 0; }

  /// Velocity over the coming step of a wall that moves as given: the mean of what is prescribed [length/time].
  double given_velocity(double time, const StepLengths& step) const {
    if (!(step.after > 0)) return speed_ * table_.value(time);
    return speed_ * (table_.integral(time + step.after) - table_.integral(time)) / step.after;
  }
  /// Velocity over the coming step of a wall that is pushed; before: that of the step before. push: of a velocity.
  template <class Push>
  double pushed_velocity(double before, double velocity_step, const Push& push) const {
    double velocity = before;
    constexpr int most = 100;
    for (int turn = 0; turn < most; ++turn) {
      const WallPush present = push(velocity);
      const double excess = mass_ * (velocity - before) + velocity_step * present.force;
      const double next = velocity - excess / (mass_ + velocity_step * present.slope);
      if (!(next < velocity)) break;  // the root, or round-off below it
      velocity = next;
    }
    return velocity;
  }

  /// What a wall has after the step: as given, or what it had without the impulse on it.
  double velocity_after(double before, double given, double impulse) const {
    return is_pushed() ? before - impulse / mass_ : given;
  }

 private:
  double mass_ = 0, speed_ = 0;
  TimeTable table_;
};

}  // namespace pinball
