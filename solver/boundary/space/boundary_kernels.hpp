#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include <kernels/boundary/held_nodes.hpp>
#include <kernels/boundary/node_arrays.hpp>
#include <kernels/boundary/rigid_wall.hpp>
#include <kernels/boundary/symmetry_wall.hpp>
#include <solver/model/node_spans.hpp>

/// The loops of boundary conditions over nodes and faces, in the memory of an execution space. Lists come from the host
/// once, and what goes there in a step are single numbers; what a step works on is NodeArrays of the space. A sum has
/// one order for any number of threads.
namespace pinball {

/// Forces on nodes (kernels/boundary/node_forces.hpp).
template <class S>
class NodeForceKernels {
 public:
  virtual ~NodeForceKernels() = default;
  /// Adds them to the forces of the nodes. vector: what they follow from; nothing, where they follow from none.
  virtual void add(const NodeArrays<S>& nodes, const std::array<double, 3>& vector = {}) = 0;
  /// Adds the work of what add() has added; to be called when all forces are known.
  virtual void add_work(const NodeArrays<S>& nodes, const StepLengths& step, ExternalWork& sum) const = 0;
  virtual std::size_t bytes() const = 0;
};

/// Constraints and prescribed velocities (kernels/boundary/held_nodes.hpp).
template <class S>
class HeldNodeKernels {
 public:
  virtual ~HeldNodeKernels() = default;
  /// Both in the order of nodes. keeps: also the forces of constraints, for force_of_constraint().
  virtual void set(const std::vector<NodeConstraint<S>>& constraints,
                   const std::vector<NodePrescription<S>>& prescribed, bool keeps) = 0;
  /// Reactions of prescriptions and forces of constraints.
  virtual void clear_forces() = 0;
  virtual void constrain(const NodeArrays<S>& nodes, double velocity_step, const DueSpans& due) = 0;
  /// factors: of each table, means over the coming step; velocity_step: over which forces change velocities [time].
  virtual void prescribe(const NodeArrays<S>& nodes, const std::vector<double>& factors, double velocity_step) = 0;
  /// Work of the reactions since clear_forces().
  virtual void add_work(const NodeArrays<S>& nodes, const StepLengths& step, ExternalWork& sum) const = 0;
  /// What constraints that begin to hold take from the nodes, before their first constrain() [energy].
  virtual double energy_along(const NodeArrays<S>& nodes, const StepLengths& step) const = 0;
  /// All ranks get what each has of the forces since clear_forces().
  virtual void share_forces() = 0;
  /// Of all constraints of one table, and of all prescriptions, since clear_forces().
  virtual VectorSum force_of_constraint(std::int32_t table) const = 0;
  virtual VectorSum force_of_prescribed(std::int32_t table) const = 0;
  virtual std::size_t bytes() const = 0;
};

/// Faces of elements, with the nodes at their corners; all by places of stores.
struct FaceList {
  std::vector<std::int64_t> element;  ///< per face
  std::vector<std::int32_t> corners;  ///< four per face, counterclockwise seen from outside
  std::vector<std::int32_t> nodes;    ///< of all faces, ascending
  std::vector<std::int32_t> first;    ///< per node and one more: its part of `places`
  std::vector<std::int32_t> places;   ///< numbers in `corners`
};

/// Pressure on faces (kernels/boundary/face_pressure.hpp).
template <class S>
class PressureKernels {
 public:
  virtual ~PressureKernels() = default;
  /// Adds the forces of the present places to those of the nodes, but for faces of eroded elements.
  virtual void add(const NodeArrays<S>& nodes, S pressure) = 0;
  /// Of what add() has added; when all forces are known.
  virtual void add_work(const NodeArrays<S>& nodes, const StepLengths& step, ExternalWork& sum) const = 0;
  virtual VectorSum force() const = 0;  ///< the sum of what add() has added
  virtual std::size_t bytes() const = 0;
};

/// The nodes of a rigid wall (kernels/boundary/rigid_wall.hpp).
template <class S>
class WallKernels {
 public:
  virtual ~WallKernels() = default;
  /// nodes: the last ones are held.
  virtual void set(const std::vector<std::int32_t>& nodes, const std::vector<WallHold<S>>& hold) = 0;
  virtual void clear_reactions() = 0;
  /// What the nodes do to the wall.
  virtual WallPush push(const NodeArrays<S>& nodes, const WallPlane<S>& wall, const WallStep<S>& step) = 0;
  /// Sets the reactions and adds them to the forces.
  virtual WallStop stop(const NodeArrays<S>& nodes, const WallPlane<S>& wall, const WallStep<S>& step) = 0;
  /// Adds the parts of the reactions that nodes which are held do not follow.
  virtual void push_held(const NodeArrays<S>& nodes, const WallPlane<S>& wall) = 0;
  /// Of the reactions, when all forces are known.
  virtual void add_work(const NodeArrays<S>& nodes, const WallPlane<S>& wall, const StepLengths& step,
                        ExternalWork& sum) = 0;
  virtual std::size_t bytes() const = 0;
};

/// The nodes that a plane of symmetry turns round (kernels/boundary/symmetry_wall.hpp).
template <class S>
class ReflectionKernels {
 public:
  virtual ~ReflectionKernels() = default;
  /// Keeps what elements have on the nodes across the plane, while there are no other forces.
  virtual void keep_forces(const NodeArrays<S>& nodes) = 0;
  /// position_step: that just made with the present velocities, as often as `due` says [time].
  virtual Reflection reflect(const NodeArrays<S>& nodes, S position_step, const DueSpans& due) const = 0;
  virtual std::size_t bytes() const = 0;
};

/// Sums over nodes for output: over all, or over those of a list.
template <class S>
class NodeMotionKernels {
 public:
  virtual ~NodeMotionKernels() = default;
  /// At the time of the forces, when all of them are known (node_update.hpp). energy_step: the step before [time].
  virtual double kinetic(const NodeArrays<S>& nodes, double energy_step) const = 0;
  /// [mass length/time]; of several ranks each adds up what it has.
  virtual VectorSum momentum(const NodeArrays<S>& nodes) const = 0;
  virtual std::size_t bytes() const = 0;
};

/// Makes all of them for one space.
template <class S>
class BoundaryKernels {
 public:
  virtual ~BoundaryKernels() = default;
  /// share: of each node [-].
  virtual std::unique_ptr<NodeForceKernels<S>> load(const std::vector<std::int32_t>& nodes,
                                                    const std::vector<S>& share) const = 0;
  /// The vector of both: the acceleration. mass: of each node what it acts on [mass].
  virtual std::unique_ptr<NodeForceKernels<S>> gravity(std::int32_t node_count) const = 0;
  virtual std::unique_ptr<NodeForceKernels<S>> gravity(const std::vector<std::int32_t>& nodes,
                                                       const std::vector<double>& mass) const = 0;
  virtual std::unique_ptr<NodeForceKernels<S>> damping(std::int32_t node_count, double rate) const = 0;
  /// forces: records of four of the host, which are read in every step.
  virtual std::unique_ptr<NodeForceKernels<S>> given_forces(std::int32_t node_count, const S* forces) const = 0;
  virtual std::unique_ptr<HeldNodeKernels<S>> held_nodes() const = 0;
  virtual std::unique_ptr<PressureKernels<S>> pressure(const FaceList& faces) const = 0;
  virtual std::unique_ptr<WallKernels<S>> wall(bool rubs) const = 0;
  /// inward: unit normal towards the bodies.
  virtual std::unique_ptr<ReflectionKernels<S>> reflection(const std::vector<std::int32_t>& nodes,
                                                           const std::array<double, 3>& point,
                                                           const std::array<double, 3>& inward) const = 0;
  /// Of all nodes with their masses.
  virtual std::unique_ptr<NodeMotionKernels<S>> motion(std::int32_t node_count) const = 0;
  /// share: of the mass of each node in the kinetic energy [-]; mass: of each in the momentum.
  virtual std::unique_ptr<NodeMotionKernels<S>> motion(const std::vector<std::int32_t>& nodes,
                                                       const std::vector<double>& share,
                                                       const std::vector<double>& mass) const = 0;
};

}  // namespace pinball
