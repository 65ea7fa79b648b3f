#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <solver/model/model.hpp>

namespace pinball {

/// Volumes of tetrahedra averaged over their nodes (kernels/element/tetrahedron_step.hpp), before the elements of a
/// step are worked. Around each node those of one part are averaged: materials do not share theirs. Eroded elements do
/// not count. Sums have one order, that of the elements: the same bits for any number of threads.
template <class S>
class NodalVolumes {
 public:
  /// Undeformed is what the model is now.
  explicit NodalVolumes(const Model<S>& model);

  bool any() const { return !slots_.empty(); }
  /// Gives the elements their ratios of the positions that nodes have, and keeps those of the step before.
  void average(Model<S>& model);
  std::size_t bytes() const;

 private:
  template <class E>
  void average_in(Model<S>& model, E* ratios);

  std::vector<std::int64_t> slots_;                  ///< of the tetrahedra, ascending
  std::vector<std::array<std::int32_t, 4>> nodes_;   ///< of each
  std::vector<std::array<std::int32_t, 4>> groups_;  ///< of each: places of its nodes, with its part, in `first_`
  std::vector<S> undeformed_, volume_;               ///< of each [length^3]
  std::vector<std::int32_t> first_, around_;         ///< per node with a part: its tetrahedra, by their places
  std::vector<S> ratio_;                             ///< per node with a part [-]
};

}  // namespace pinball
