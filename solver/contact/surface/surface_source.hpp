#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <span>
#include <vector>

#include <kernels/simd.hpp>
#include <solver/base/colouring.hpp>
#include <solver/base/packs.hpp>
#include <solver/base/piece_share.hpp>
#include <solver/base/point.hpp>
#include <solver/base/records.hpp>

#include "contact_pairs.hpp"
#include "held_directions.hpp"
#include "surface_nodes.hpp"

namespace pinball {

/// What contact asks about an element when it takes it in: what does not change from step to step. A rigid sphere is an
/// element whose corners are all the same node, with all its faces, which have no area, exposed.
struct ContactElement {
  std::array<std::int32_t, 8> corners;  ///< node numbers
  std::array<Point, 8> reference;       ///< places of the corners in the undeformed mesh [length]
  std::int32_t body;
  double mass;          ///< [mass]
  double volume;        ///< of the undeformed element [length^3]
  double radius;        ///< of the ball of this volume [length]
  double bulk_modulus;  ///< [stress]
  bool sphere = false;
  bool rigid = false;  ///< of a body that moves as one, and never touches itself

  /// Mean of the corners, undeformed [length].
  Point centre() const {
    Point mean{};
    for (const Point& corner : reference) {
      for (std::size_t k = 0; k < 3; ++k) mean[k] += corner[k] / 8;
    }
    return mean;
  }
};

/// Whether two elements have a corner in common.
inline bool share_corner(const std::array<std::int32_t, 8>& a, const std::array<std::int32_t, 8>& b) {
  // The compilers' vector type: of loops they make scalar code.
  using Corners = std::int32_t __attribute__((vector_size(32)));
  Corners of_a, equal{};
  std::memcpy(&of_a, a.data(), sizeof of_a);
  for (const std::int32_t n : b) equal |= of_a == n;
  std::uint64_t part[4];
  std::memcpy(part, &equal, sizeof part);
  return (part[0] | part[1] | part[2] | part[3]) != 0;
}

/// All that contact sees of whoever owns nodes and elements, a solver or a host: pointers to their arrays, for one
/// call; nothing is kept from call to call. Elements have "slots": places in packs of `width`, some of them padding, in
/// tiles of whole packs.
template <class S>
class SurfaceSource : public NodeRecords<S> {
 public:
  static constexpr int width = native_width<S>;

  bool lists_last = true;  ///< lists of what may touch serve more than one step

  std::int32_t node_count = 0;
  const S* inverse_mass = nullptr;  ///< one per node [1/mass]

  std::int64_t slots = 0;
  std::span<const std::int64_t> tile_packs;  ///< first pack of each tile; tiles + 1 entries
  int tile_pack_width = width;               ///< of these packs: whole ones of `width`
  const Colouring* tile_colours = nullptr;

  /// Processes that all have this surface and work its contact together; null: this one is alone.
  Sharers* sharers = nullptr;

  /// Whether a number is the slot of an element, eroded or not, and not of padding.
  virtual bool is_element(std::int64_t slot) const = 0;
  /// slot: one that is not padding.
  virtual ContactElement element(std::int64_t slot) const = 0;
  /// Whether an element of the surface may soon erode. A guess, for lists that are to last over erosions: what lies
  /// behind such elements is taken in beforehand. If it fails, what is exposed is taken in then, and lists are built
  /// anew.
  virtual bool may_soon_erode(std::int64_t slot) const = 0;
  /// Called before lists are built on the motion of all nodes of the surface: a host may not have looked at all until
  /// then. What it throws leaves contact as it was.
  virtual void before_search() const {}
  /// Called before lists are followed on the motion of all nodes of the surface.
  virtual void before_following() const {}
  /// Called before lists are built on the motion of nodes, all of those with which the surface moves: of some of them
  /// nothing was read before. nodes: some perhaps several times.
  virtual void before_motion(std::span<const std::int32_t> /*nodes*/) const {}
  /// The nodes for loops over them that run where the state of a step is (PinballKernels): these, or those of a device.
  /// loads: they add forces.
  virtual SurfaceNodes<S> nodes(bool /*loads*/) const {
    return {this->position, this->velocity, this->force, inverse_mass};
  }

 protected:
  ~SurfaceSource() = default;
};

/// How the elements lie to each other when contact begins; per slot.
struct SurfaceTopology {
  std::vector<std::uint8_t> alive;                     ///< 0 for padding
  std::vector<std::uint8_t> exposed;                   ///< bit f is set where face f is on the surface
  std::vector<std::array<std::int32_t, 6>> neighbour;  ///< slot across each face, negative: none

  explicit SurfaceTopology(std::int64_t slots)
      : alive(slots, 0), exposed(alive.size(), 0), neighbour(alive.size(), {-1, -1, -1, -1, -1, -1}) {}
};

/// What contact is given once, to keep.
struct InitialSurface {
  SurfaceTopology topology;
  HeldDirections held;                    ///< asked for by impulses only: empty for penalty contact
  std::unique_ptr<ContactPairs> pairs{};  ///< what may touch what; none: all may touch all
};

}  // namespace pinball
