#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <kernels/exec/array.hpp>
#include <solver/base/state_archive.hpp>
#include <solver/model/model.hpp>
#include <solver/results.hpp>

#include "rigid_body_motion.hpp"
#include "slender_inertia.hpp"

namespace pinball {

class Joints;
struct JointedBody;

/// How a body moves: its nodes have a velocity, but for the spread [length/time].
struct BodySpeed {
  Point velocity{};
  double spread = 0;
};

/// The rigid bodies of a scene in a step. All that acts on them acts on their nodes: forces of the nodes are summed up,
/// and what then stands in their place are those of the motion that they give to all nodes together, m (A + a x r). So
/// contact by impulses sees the velocities that it has to change, and integration and energies need not know of rigid
/// bodies. Then the nodes are put where the body has gone, so that its shape stays.
///
/// Sums are taken in fixed pieces, bodies one after the other: the same bits for any number of threads.
template <class S>
class RigidBodies {
 public:
  /// Takes the velocities of the nodes. model: has to stay where it is. Throws InputError where those at the start are
  /// no motion of a rigid body, and for given motions that are not at right angles.
  explicit RigidBodies(Model<S>& model);
  ~RigidBodies();
  RigidBodies(const RigidBodies&) = delete;
  RigidBodies& operator=(const RigidBodies&) = delete;

  bool any() const { return !bodies_.empty(); }
  /// Whether elements that deform have nodes of them.
  bool has_common_nodes() const {
    return std::ranges::any_of(bodies_, [](const Body& body) { return !body.common.empty(); });
  }
  /// Longest step that turns no body by more than a hundredth of a radian; where nothing of a scene deforms also a
  /// thousandth of the run, and with contact by springs the step that the elements would need [time].
  double longest_step() const;
  /// Whether some body has so small a given inertia that springs on its nodes turn it faster than the nodes' masses
  /// tell.
  bool any_light() const {
    return std::ranges::any_of(bodies_, [](const Body& body) { return body.lightness > 1; });
  }
  /// By what the square of the frequency of springs is more, at most, than the masses of the nodes tell on which they
  /// act: by the bodies on which some act in this step. Forces: with stiffnesses, of all contact by springs [-].
  double lightness_in_springs(const Model<S>& model) const;
  /// The fastest that a node of a body moves beside one of another, or beside what deforms, now or when given motions
  /// have changed it by at most `leap`; 0 where that is no more than `least`. others: bodies that deform [length/time].
  double relative_speed(const std::vector<BodySpeed>& others, double leap, double least) const;
  /// The same bodies for contact, from begin_step() on.
  const RigidSides& sides() const { return sides_; }

  // In a step, in this order. time: of the forces.

  /// While elements that deform are updated, those of their nodes that are of bodies have the velocities of their ways
  /// from t_(n-1) to t_n, over dt: else these elements would strain as their bodies turn.
  void put_ways(Model<S>& model, double dt) const;
  /// And then again those at t_n.
  void put_velocities(Model<S>& model) const;
  /// dt: the step just made.
  void begin_step(double time, double dt);
  /// Largest change of velocity that what holds and moves bodies gives to their nodes in the step from `later` on: from
  /// the velocities that they have, of accelerations by as much as these change from the step before `time`
  /// [length/time].
  double leap(double time, double later, const StepLengths& step) const;
  /// Forces of all on the nodes become those of the common motion; once more where contact has added some since.
  void share_forces(Model<S>& model, double time, const StepLengths& step);
  /// After the integration: puts the nodes where their bodies go.
  void move(Model<S>& model, const StepLengths& step);

  /// Of what holds and moves them, up to the time of the forces [energy].
  double work() const { return done_ + last_.now; }
  /// What the kinetic energy is above that of the nodes at the time of the forces: of bodies with a given inertia and
  /// centre [energy].
  double kinetic_beside(const StepLengths& step) const;
  /// What the momentum is above that of the nodes: of bodies with a given centre [mass length/time].
  Point momentum_beside() const;
  /// To be called when velocities of nodes were changed by others: bodies take the momenta that they have.
  void take_velocities(Model<S>& model);

  /// Of the body of a node at the time of the forces, for output: where the nodes were. positions: per node of the
  /// store.
  void put_positions_of_forces(std::vector<Point>& positions) const;
  /// The same of one node of the store; none: it is of no body.
  std::optional<Point> position_of_forces(std::int32_t node) const;
  std::vector<RigidBodyResult> results() const;
  std::vector<JointResult> joint_results() const;
  void persist(StateArchive& archive);
  std::size_t bytes() const;

 private:
  struct Body {
    std::string name;
    std::vector<std::int32_t> nodes;      ///< of the store, ascending
    std::vector<std::int32_t> common;     ///< places in `nodes` of those of elements that deform
    Array<double> arm;                    ///< records: from the centre to the nodes at the start [length]
    double radius = 0;                    ///< of the longest arm [length]
    GivenMotion held;                     ///< at all times
    std::vector<std::size_t> motions;     ///< of the scene, that move it
    GivenMotion given;                    ///< in this step
    std::vector<std::size_t> given_by;    ///< motions of `given`, those along directions and then those about axes
    std::array<Point, 3> more_inertia{};  ///< inertia less that of the nodes, at the start [mass length^2]
    bool has_own_inertia = false;         ///< it is given
    /// Largest factor by which the energy of the nodes' masses is more than that of the body in the same motion, which
    /// is that of squares of frequencies of springs on its nodes (Rayleigh's quotient) [-].
    double lightness = 1;
    SlenderInertia slender;          ///< of nodes on one line without a given one
    Point offset{};                  ///< of the centre of its nodes' masses from a given one, at the start [length]
    std::vector<Gravity> gravities;  ///< that act on it, where there is an offset
    Point moment_beside{};           ///< of gravity in this step, above that on the nodes [force length]
    bool shared = false;             ///< the forces of its nodes are those of load()
    Wrench acting;                   ///< of all that acts on it in this step but joints
    Point change_of_spin{};          ///< by others since the last step [1/time]
    RigidBodyMotion motion;
  };
  void find_common_nodes(const Model<S>& model);
  // scene_node: number in the scene per node of the store.
  void add_body(const Model<S>& model, std::size_t number, const std::vector<std::int32_t>& scene_node);
  void check_motions(const Scene& scene) const;
  void check_slender(const Scene& scene, const Body& body) const;
  void take_velocities(Model<S>& model, std::size_t number, const std::vector<std::int32_t>& scene_node, bool of_start);
  void set_offset(const Point& offset, Body& body) const;
  void take_gravities(const Scene& scene, const RigidBody& given, Body& body) const;
  Point gravity_beside(const Body& body, double time, const StepLengths& step) const;
  void choose_given(Body& body, double time) const;
  void keep_joints(Model<S>& model);
  std::vector<JointedBody> jointed() const;
  RowTensor way_ahead(const Body& body, const StepLengths& step) const;
  double given_speed(const Body& body, const RigidMotion& motion, double time, double later,
                     const StepLengths& step) const;
  void set_speeds(Body& body, double time, const StepLengths& step) const;
  void sum_forces(const Model<S>& model, Body& body) const;
  void put_forces(Model<S>& model, const Body& body) const;
  void put_nodes(Model<S>& model, const Body& body) const;
  // rotation: of the body of this number then; i: of its nodes.
  Point position_of_forces(std::size_t body, std::size_t i, const std::array<Point, 3>& rotation) const;

  std::vector<RigidMotion> motions_;
  std::vector<Body> bodies_;
  std::unique_ptr<Joints> joints_;  ///< null: there are none
  std::vector<RigidState> before_;  ///< per body, at the time of the forces
  RigidSides sides_;
  bool by_impulses_ = false;  ///< contact asks for mobilities, and for the ways of nodes
  double of_run_ = 0;         ///< longest step by the length of the run, or infinite [time]
  double done_ = 0;           ///< work of all steps before the last [energy]
  ExternalWork last_;
};

}  // namespace pinball
