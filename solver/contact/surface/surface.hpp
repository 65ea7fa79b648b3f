#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include <solver/base/state_archive.hpp>

#include "surface_source.hpp"

namespace pinball {

/// Which faces of which elements are exposed: decided by topology, never by a tolerance on a normal. Erosion exposes
/// the faces of the neighbours of an eroded element. Indexed by slot of the element store.
class Surface {
 public:
  explicit Surface(SurfaceTopology topology);

  /// Takes elements (slots, ascending) out of the surface, unless they are out already, and exposes what lay behind
  /// them. Returns whether anything changed.
  bool remove_eroded(const std::vector<std::int64_t>& slots);

  /// Elements that the last remove_eroded has brought to the surface; some may have eroded in the same step.
  const std::vector<std::int32_t>& uncovered() const { return uncovered_; }
  /// Elements of which it has changed the exposed faces: the eroded ones, and what lies behind them, some several
  /// times.
  const std::vector<std::int32_t>& rearranged() const { return rearranged_; }
  std::int32_t exposed_count() const { return exposed_count_; }  ///< elements with an exposed face
  std::int64_t exposed_faces() const { return exposed_faces_; }  ///< of all elements

  bool alive(std::int64_t slot) const { return alive_[slot] != 0; }
  /// Bit f is set where face f (xi-, xi+, eta-, eta+, zeta-, zeta+) of a living element is exposed.
  std::uint8_t exposed(std::int64_t slot) const { return exposed_[slot]; }
  /// Calls work(slot, face) for every face of a living element that the erosion of an element exposes.
  template <class Work>
  void for_each_face_behind(std::int64_t slot, const Work& work) const {
    for (const std::int32_t behind : neighbour_[slot]) {
      if (behind < 0 || !alive(behind)) continue;
      for (unsigned f = 0; f < 6; ++f) {
        if (neighbour_[behind][f] == slot) work(behind, f);
      }
    }
  }
  template <class Source>
  void persist(StateArchive& archive, const Source& source) {
    archive.of_fixed_size(alive_);
    archive.of_fixed_size(exposed_);
    archive(exposed_count_, exposed_faces_);
    if (archive.reads()) check(archive, [&source](std::int64_t slot) { return source.is_element(slot); });
  }
  std::int64_t slots() const { return alive_.size(); }
  std::size_t bytes() const { return alive_.capacity() * (2 + sizeof(neighbour_[0])); }

 private:
  void erode(std::int64_t slot);
  template <class IsElement>
  void check(const StateArchive& archive, const IsElement& is_element) const {
    std::int64_t count = 0, faces = 0;
    for (std::int64_t slot = 0; slot < slots(); ++slot) {
      const std::uint8_t exposed = exposed_[slot];
      archive.require(alive_[slot] <= 1 && exposed < 64 && (is_element(slot) || (alive_[slot] | exposed) == 0));
      count += exposed != 0 ? 1 : 0;
      faces += std::popcount(exposed);
    }
    archive.require(count == exposed_count_ && faces == exposed_faces_);
  }

  std::vector<std::uint8_t> alive_;
  std::vector<std::uint8_t> exposed_;
  std::vector<std::array<std::int32_t, 6>> neighbour_;  ///< slot across each face, -1: none
  std::vector<std::int32_t> uncovered_, rearranged_;
  std::int32_t exposed_count_ = 0;
  std::int64_t exposed_faces_ = 0;
};

}  // namespace pinball
