#pragma once

#include <array>
#include <cstdint>
#include <pinball/kernels/spatial_hash.hpp>
#include <pinball/solver/slideline_surface.hpp>
#include <vector>

namespace pinball {

/// For each slave node the master segments that it may touch before something has moved too far: cells by the spatial
/// hash that pinballs use too, lists with a skin.
template <class S>
class SlidelineSearch {
 public:
  explicit SlidelineSearch(const Model<S>& model);

  /// Builds the lists from nothing. skin: how much nearer a node may come before the lists end [length].
  void build(const Model<S>& model, const SlidelineSurface<S>& surface, S skin);
  /// True while no node can have come nearer to a segment by more than the skin.
  bool holds(const Model<S>& model, const SlidelineSurface<S>& surface) const;
  void invalidate() { valid_ = false; }

  const std::int32_t* candidates(std::size_t slave) const { return candidate_.data() + start_[slave]; }
  std::int64_t count(std::size_t slave) const { return start_[slave + 1] - start_[slave]; }
  std::int64_t pairs() const { return static_cast<std::int64_t>(candidate_.size()); }
  std::size_t bytes() const;

 private:
  bool may_touch(const SlidelineSurface<S>& surface, std::size_t slave, std::size_t segment) const;

  bool self_;
  std::vector<std::array<float, 3>> reference_node_;    ///< per node of the store, undeformed [length]
  std::vector<std::array<float, 3>> reference_centre_;  ///< per slot, undeformed [length]
  bool valid_ = false;
  S skin_ = 0;
  std::vector<std::int64_t> start_;      ///< per slave and one more: into candidate_
  std::vector<std::int32_t> candidate_;  ///< segments
  std::vector<S> node_at_;               ///< positions of the slaves when the lists were built, records of three
  std::vector<S> reach_at_;              ///< reach of the segments then
  std::vector<std::int32_t> bucket_start_, entry_point_;
  std::vector<std::uint64_t> entry_cell_, cell_;
  std::vector<S> entry_record_;
};

}  // namespace pinball
