#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include <kernels/pinball_geometry.hpp>
#include <kernels/pinball_sums.hpp>
#include <kernels/straying.hpp>
#include <solver/contact/surface/surface_nodes.hpp>

namespace pinball {

/// Part of a list: consecutive pinballs, and the pairs of which they are the first.
struct PairPiece {
  std::int64_t begin = 0, end = 0;                    ///< places of pairs
  std::int32_t pinballs_begin = 0, pinballs_end = 0;  ///< listed
};

/// What loops over pinballs work on, as the host has made it: plain arrays that say nothing of the width of its packs
/// but a number, so that sources of a device's compiler may include them.
template <class S>
struct PinballArrays {
  std::int32_t pinballs = 0;                     ///< listed
  PinballGeometryView<S> geometry{};             ///< of these
  S* force = nullptr;                            ///< records: F, sum of p2
  ListedPairs<S> pairs;                          ///< by their first pinballs, and then by their second
  std::span<const PairPiece> pieces;             ///< of pairs; each begins at a whole pack
  std::span<const std::int32_t> nodes;           ///< corners of the listed pinballs, ascending
  std::int32_t node_count = 0;                   ///< of the store
  ExpectedNodes<S> expected;                     ///< nodes of all pinballs
  std::int32_t balls = 0;                        ///< all pinballs, where radii change; else none
  const std::int32_t* corner = nullptr;          ///< eight of each of these
  const S* radius = nullptr;                     ///< when the list was made [length]
  std::span<const std::int32_t> tile_first;      ///< first listed pinball of each tile of elements, and one more
  std::span<const std::int32_t> colour_offsets;  ///< of tiles (Colouring)
  std::span<const std::int32_t> tiles;           ///< by colour

  std::int64_t packs() const { return (pinballs + geometry.row - 1) / geometry.row; }
};

/// The loops of a step over pinballs, their pairs and nodes, in the memory of an execution space. Lists come from the
/// host when it has made them; in a step that they last for, what crosses over is what the loops return.
template <class S>
class PinballKernels {
 public:
  virtual ~PinballKernels() = default;
  /// Works on these from now on, with the numbers that they have now. Pointers have to stay good until the next call.
  virtual void take(const PinballArrays<S>& arrays) = 0;
  /// Brings what the loops have changed of the pairs, and the records of the pinballs that the host reads (centre,
  /// outward and force), up to date in the arrays taken.
  virtual void bring_back() = 0;

  /// Centres, velocities, normals and (on demand) radii of the listed pinballs.
  virtual void update_geometry(const SurfaceNodes<S>& nodes, bool radii) = 0;
  /// Whether a node of any pinball has strayed too far, or a ball has grown beyond this times its radius [-].
  virtual bool any_strays(const SurfaceNodes<S>& nodes, S elapsed) = 0;
  virtual bool any_grows(const SurfaceNodes<S>& nodes, S most) = 0;
  /// Forces of the pairs, and of them of the pinballs. dt: the step just made.
  virtual PairSums<S> find_forces(const PenaltyConstants<S>& constants, S dt) = 0;
  /// Adds the last forces to the nodes.
  virtual void add_forces(const SurfaceNodes<S>& nodes) = 0;
  /// Largest contact_row of the nodes, after add_forces [1/time^2].
  virtual S largest_row(const SurfaceNodes<S>& nodes) = 0;
  virtual std::size_t bytes() const = 0;
};

}  // namespace pinball
