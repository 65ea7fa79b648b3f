#pragma once

#include <vector>

#include <solver/model/model.hpp>
#include <solver/rigid/rigid_bodies.hpp>

namespace pinball {

/// The longest step in which no body can jump over the surface elements of another: the smallest pinball radius over
/// the largest speed, relative to each other, that two bodies have at the start. Infinite where they have none.
///
/// The stable step is shorter for all impacts below about the wave speed, so that this limits only faster ones.
template <class S>
double longest_contact_step(const Model<S>& model);

/// The same of rigid bodies, with the speeds that they have now: where nothing deforms, steps are a part of the run,
/// and what gains speed on its way would jump over what it meets. Bodies that deform count with their velocities at the
/// start.
template <class S>
class RigidImpacts {
 public:
  /// Without contact, or without rigid bodies, nothing limits a step.
  RigidImpacts(const Model<S>& model, bool contact);

  /// leap: largest change of velocity that is about to be given to nodes of rigid bodies [length/time]; most: no longer
  /// step is asked for; infinite where such a one is short enough [time].
  double longest_step(const RigidBodies<S>& bodies, double leap, double most) const;

 private:
  double radius_ = 0;              ///< 0: nothing is limited [length]
  std::vector<BodySpeed> others_;  ///< bodies that deform
};

}  // namespace pinball
