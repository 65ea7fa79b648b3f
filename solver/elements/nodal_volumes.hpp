#pragma once

#include <cstddef>
#include <vector>

#include <solver/model/model.hpp>
#include <solver/parallel/subdomain.hpp>

#include "volume_groups.hpp"

namespace pinball {

/// Volumes of tetrahedra and wedges averaged over their nodes (kernels/element/averaged_step.hpp), before
/// the elements of a step are worked. Around each node those of one material are averaged. Eroded elements do not
/// count. Sums have one order, that of the elements: the same bits for any number of threads and of ranks, which tell
/// each other the volumes of elements around nodes that they share.
template <class S>
class NodalVolumes {
 public:
  /// Undeformed is what the model is now. domain: of several ranks; null: one process has all.
  explicit NodalVolumes(const Model<S>& model, Subdomain<S>* domain = nullptr);

  /// Whether this rank averages, or counts what others send.
  bool any() const { return groups_.lists.elements() > 0 || groups_.sent_by_all > 0; }
  /// Gives the elements their ratios of the positions that nodes have, and keeps those of the step before. All ranks
  /// call it together.
  void average(Model<S>& model);
  std::size_t bytes() const;

 private:
  void exchange();
  template <class E>
  void average_in(Model<S>& model);

  Subdomain<S>* domain_;
  VolumeGroups<S> groups_;
  std::vector<std::vector<S>> sent_;  ///< to each neighbour
};

}  // namespace pinball
