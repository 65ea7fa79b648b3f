#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <solver/model/model.hpp>
#include <solver/parallel/subdomain.hpp>

namespace pinball {

/// first ... end - 1
struct NodeRange {
  std::int32_t first, end;
};

/// Tiles without any stress whose nodes all have one velocity: at rest or in free uniform flight. The Walsh sums of
/// equal numbers vanish exactly (hexahedron.hpp), and with them strain and hourglass rates; so do stresses, forces and
/// work, to the bit, whatever the geometry. Working such a tile changes nothing.
///
/// Tiles of a material that fails at a time do not rest: nothing would tell them. Nor do those of elements whose
/// stress comes of volumes around them, too.
///
/// Whatever reaches a tile (a wave, contact, a load, a rigid wall) gives some of its nodes another velocity than the
/// others. From then on the tile is updated, for good.
template <class S>
class RestingTiles {
 public:
  /// The tiles that rest now. They are to be updated once, in the geometry in which they are found at rest: from then
  /// on they keep the stable step of that, because round-off of positions in flight would change its last bits.
  /// domain: of several ranks, which look at their own tiles each, and tell of others (set_other); null: one has all.
  explicit RestingTiles(const Model<S>& model, const Subdomain<S>* domain = nullptr);

  /// The tiles that rested when a state was saved; rests: as of flags().
  RestingTiles(const Model<S>& model, const std::vector<std::uint8_t>& rests, const Subdomain<S>* domain = nullptr);

  /// A tile that another rank works.
  void set_other(std::int32_t tile, bool rests) { rests_[tile] = rests ? 1 : 0; }

  /// Drops the tiles whose nodes no longer have one velocity. Returns whether there were any.
  bool wake(const NodeStore<S>& nodes);

  /// A tile that rests.
  struct Tile {
    std::int32_t number = 0;
    std::int32_t elements = 0;
    std::vector<NodeRange> nodes;  ///< few: nodes are in the order of their elements
  };
  const std::vector<Tile>& tiles() const { return tiles_; }  ///< ascending
  bool rests(std::int32_t tile) const { return rests_[tile] != 0; }
  const std::vector<std::uint8_t>& flags() const { return rests_; }  ///< per tile of the model: whether it rests
  std::int64_t elements() const { return elements_; }                ///< of the tiles that rest
  std::size_t bytes() const;

 private:
  void drop_awake();

  std::vector<Tile> tiles_;
  std::vector<std::uint8_t> rests_;  ///< per tile of the model
  std::int64_t elements_ = 0;
};

}  // namespace pinball
