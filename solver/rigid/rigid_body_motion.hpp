#pragma once

#include <array>
#include <vector>

#include <kernels/boundary/external_work.hpp>
#include <solver/base/point.hpp>
#include <solver/contact/surface/rigid_sides.hpp>

namespace pinball {

/// Force, and moment about the centre of a body.
struct Wrench {
  Point force{};   ///< [force]
  Point moment{};  ///< [force length]

  void join(const Wrench& other) {
    for (std::size_t k = 0; k < 3; ++k) {
      force[k] += other.force[k];
      moment[k] += other.moment[k];
    }
  }
};

/// What changes of a rigid body from step to step.
struct RigidState {
  Point centre{};                                 ///< at t_n [length]
  std::array<double, 4> orientation{1, 0, 0, 0};  ///< w, x, y, z of a unit quaternion: from the start to t_n
  Point velocity{};                               ///< of the centre, at t_(n-1/2) [length/time]
  Point angular_momentum{};                       ///< about the centre, at t_(n-1/2) [mass length^2/time]
  Wrench reaction;                                ///< of what held and moved it in the step just made, at t_n
};

/// Directions in which a rigid body moves with given velocities, whatever acts on it; orthonormal.
struct GivenMotion {
  std::vector<Point> along;            ///< of the centre
  std::vector<double> speeds;          ///< along them [length/time]
  std::vector<Point> about;            ///< of the rotation
  std::vector<double> angular_speeds;  ///< about them [1/time]
};

/// Motion of one rigid body by central differences. With the forces f_n on its nodes, their places r_n from its centre
/// and h = (dt_(n-1/2) + dt_(n+1/2))/2
///
///     M A = sum f_n ,           v_(n+1/2) = v_(n-1/2) + h A ,         c_(n+1) = c_n + dt v_(n+1/2)
///     I_n a = sum r_n x f_n ,   L_(n+1/2) = L_(n-1/2) + h I_n a ,     and with L_(n+1/2) it turns freely for dt
///
/// (rigid_rotation.hpp). Between two times at which forces act both momenta and the energy stay as they are. What the
/// nodes of a body have as velocities v_(n-1/2) are those at t_n, just before the forces act: v + w x r_n with
/// I_n w = L_(n-1/2). Then K_n of node_update.hpp, summed over the nodes, and works of forces on nodes
/// (external_work.hpp) balance to round-off.
class RigidBodyMotion {
 public:
  /// inertia: about the centre, at the start [mass length^2]
  RigidBodyMotion(double mass, const std::array<Point, 3>& inertia, const Point& centre);

  double mass() const { return mass_; }
  const RigidState& state() const { return state_; }
  RigidState& state() { return state_; }
  void set_velocities(const Point& velocity, const Point& angular_velocity);
  /// What is given has the velocities that it is given, by impulses of what gives them alone.
  void obey(const GivenMotion& given);

  // In a step, in this order.

  /// What belongs to the place at t_n; given: in the coming step, its speeds are not looked at yet.
  void begin(const GivenMotion& given);
  const RigidSide& side() const { return side_; }                      ///< since begin()
  const Point& angular_velocity() const { return angular_velocity_; }  ///< since begin(), before the forces act
  /// Accelerations by a wrench, with reactions that make the given speeds those after it.
  void load(const Wrench& wrench, const GivenMotion& given, double velocity_step);
  const Wrench& wrench() const { return wrench_; }                             ///< of load()
  const Point& acceleration() const { return acceleration_; }                  ///< A [length/time^2]
  const Point& angular_acceleration() const { return angular_acceleration_; }  ///< a [1/time^2]
  /// Moves the body. Returns the work of the reactions.
  ExternalWork move(const GivenMotion& given, const StepLengths& step);

  /// What the mean velocity of a point on its way from here to `other` within dt is more than w x r, per arm r of here;
  /// dt < 0: on its way from there. w: angular velocity.
  RowTensor way_beside(const RigidState& other, double dt, const Point& w) const;
  /// Place in space of what was at an arm from the centre at the start, as rows of a rotation.
  std::array<Point, 3> rotation() const;
  /// The inertia at the present orientation of a tensor at the start [mass length^2]
  std::array<Point, 3> turned(const std::array<Point, 3>& tensor) const;
  const std::array<Point, 3>& inertia() const { return inertia_; }  ///< at the start

 private:
  double mass_;
  std::array<Point, 3> inertia_;
  RigidState state_;
  RigidSide side_;
  std::array<Point, 3> now_{}, inverse_now_{};  ///< inertia in space at t_n, and its inverse
  Point angular_velocity_{}, acceleration_{}, angular_acceleration_{};
  Wrench wrench_;
  Wrench reaction_;  ///< of load(): what changes both momenta before the body moves
};

/// v + w x r of a point at r from the centre.
inline Point velocity_at(const Point& velocity, const Point& angular_velocity, const Point& r) {
  const Point spin = cross(angular_velocity, r);
  return {velocity[0] + spin[0], velocity[1] + spin[1], velocity[2] + spin[2]};
}

}  // namespace pinball
