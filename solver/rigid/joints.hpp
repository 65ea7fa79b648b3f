#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <solver/base/state_archive.hpp>
#include <solver/results.hpp>
#include <solver/scene_rigid.hpp>

#include "joint_rows.hpp"
#include "joint_system.hpp"
#include "rigid_body_motion.hpp"

namespace pinball {

/// A rigid body in a step, as its joints see it.
struct JointedBody {
  const RigidBodyMotion* motion;  ///< since begin(), or load()
  const GivenMotion* given;
  Wrench acting;  ///< of all but joints
};

/// The joints of the rigid bodies of a scene (joint_rows.hpp). In a step their impulses P along the gradients G_n of
/// their rows at t_n are sought such that, after the bodies have moved as they do by themselves, all rows are kept:
///
///     v_(n+1/2) = v_(n-1/2) + h M^-1 f_n + M^-1 G_n^T P ,      g(x_(n+1)) = 0 ,
///
/// by P <- P - K^+ g/dt, K = G_n M^-1 G_n^T, of all joints that hang together at once; K^+ is the pseudo-inverse, which
/// leaves alone what several rows keep already. That is SHAKE (Ryckaert, Ciccotti and Berendsen, J. Comput. Phys. 23,
/// 327-341, 1977) with free rotation for straight flight: of second order, and without drift of joints and of energy.
/// In a step without length, which only completes the velocities, the rates G v are what vanishes.
class Joints {
 public:
  /// motions: of the bodies, at the start.
  Joints(const std::vector<Joint>& joints, const std::vector<RigidBody>& bodies,
         const std::vector<const RigidBodyMotion*>& motions);

  /// Wrenches of the joints on bodies that are acted on as given. Throws RunError where no impulses keep the rows.
  void solve(std::span<const JointedBody> bodies, const StepLengths& step);
  const Wrench& wrench(std::size_t body) const { return wrench_[body]; }  ///< of solve()
  /// Works of the joints in a step, before its bodies move.
  void book(std::span<const JointedBody> bodies, const StepLengths& step);

  /// Changes of the velocities of bodies after which the rates of all rows are 0, the least in the norm of the mass.
  std::vector<Twist> corrections(std::span<const JointedBody> bodies);
  /// Throws InputError where changes at the start are more than rounding of what was given.
  void check_start(std::span<const JointedBody> bodies, const std::vector<Twist>& changes) const;

  /// At the present places, as contact sees it: what hangs together, and the sides of its bodies.
  void set_mobility(std::span<const JointedBody> bodies, RigidSides& sides);

  std::vector<JointResult> results() const;
  void persist(StateArchive& archive);

 private:
  struct JointSide {
    std::int32_t body = -1;  ///< of the scene; -1: the ground
    Eigen::Vector3d arm = Eigen::Vector3d::Zero();
  };
  struct State {
    Wrench reaction;  ///< on the first body, about the place of the joint, in the step just made
    ExternalWork last;
    double done = 0;     ///< work of all steps before the last [energy]
    double opening = 0;  ///< [-]
  };
  struct One {
    Joint joint;
    JointSide first, second;
    std::vector<JointRow> rows;
    State state;
  };
  /// Joints and bodies that hang together.
  struct Group {
    std::vector<std::size_t> joints, bodies;
    double size = 0;  ///< of the bodies, and of their joints from their centres [length]
  };

  void find_groups(std::size_t bodies);
  void place(std::span<const JointedBody> bodies);
  JointGeometry geometry(const One& one, std::span<const BodyPlace> places) const;
  JointSystem system(const Group& group, std::span<const JointedBody> bodies) const;
  Eigen::VectorXd values(const Group& group, std::span<const BodyPlace> places) const;
  static RigidBodyMotion loaded(const JointedBody& body, const Wrench& of_joints, const StepLengths& step);
  void close(const Group& group, const JointSystem& system, std::span<const JointedBody> bodies,
             const StepLengths& step, Eigen::VectorXd& impulses);
  void stop(const Group& group, const JointSystem& system, std::span<const JointedBody> bodies, const StepLengths& step,
            Eigen::VectorXd& impulses) const;
  RigidMechanism mechanism(const Group& group, std::span<const JointedBody> bodies) const;
  void keep(const Group& group, const JointSystem& system, const Eigen::VectorXd& impulses, double velocity_step);

  std::vector<One> joints_;
  std::vector<Group> groups_;
  std::vector<Wrench> wrench_;     ///< per body
  std::vector<BodyPlace> places_;  ///< per body, at t_n
};

}  // namespace pinball
