#pragma once

#include <vector>

#include <solver/boundary/space/loops.hpp>

#include "device_resting.hpp"

/// Tiles at rest on an execution space: as RestingTiles on the host, of the same tiles, so that they wake in the same
/// step.
namespace pinball {

/// moved[i]: whether nodes of piece i have another velocity than the others of their tile, or one that is not a number.
template <class S>
struct ComparesVelocities {
  const RestingPiece* pieces;
  const std::int32_t *tile, *record;
  const std::uint8_t* rests;
  const S* velocity;
  std::uint8_t* moved;

  PINBALL_FUNCTION void operator()(std::int64_t i) const {
    const RestingPiece piece = pieces[i];
    if (rests[tile[piece.tile]] == TileWork::awake) return;
    const std::int64_t first = record[piece.tile];
    const S* const expected = velocity + 4 * first;
    bool other = false;
    for (std::int64_t n = piece.first; n < piece.end; ++n) {
      const S* const v = velocity + 4 * n;
      other = other || v[0] != expected[0] || v[1] != expected[1] || v[2] != expected[2];
    }
    moved[i] = other ? 1 : 0;
  }
};

/// Wakes the tiles of which a piece has moved.
template <class S>
struct WakesTiles {
  const std::int32_t *tile, *elements, *first_piece;
  const std::uint8_t* moved;
  const S* time_step;
  std::uint8_t* rests;

  PINBALL_FUNCTION void operator()(std::int64_t i, RestingTotals<S>& totals) const {
    if (rests[tile[i]] == TileWork::awake) return;
    for (std::int32_t p = first_piece[i]; p < first_piece[i + 1]; ++p) {
      if (moved[p] == 0) continue;
      rests[tile[i]] = TileWork::awake;
      return;
    }
    totals.join({time_step[i], static_cast<std::int32_t>(i), elements[i]});
  }
};

template <class S, class Space>
class SpaceResting {
  using Memory = typename Space::memory_space;

 public:
  /// tiles: of the model. shared: with other ranks (TileWork).
  void set(const DeviceResting<S>& resting, std::int32_t tiles, bool shared) {
    shared_ = shared;
    count_ = resting.tile.size();
    updated_ = resting.updated;
    tile_ = list_in<Space>(resting.tile);
    elements_ = list_in<Space>(resting.elements);
    record_ = list_in<Space>(resting.record);
    time_step_ = list_in<Space>(resting.time_step);
    first_piece_ = list_in<Space>(resting.first_piece);
    pieces_ = list_in<Space>(resting.pieces);
    moved_.reset(resting.pieces.size());
    std::vector<std::uint8_t> rests(tiles, TileWork::awake);
    for (const std::int32_t tile : resting.tile) rests[tile] = TileWork::rests;
    rests.push_back(TileWork::for_sums);
    rests.push_back(TileWork::none);
    rests_ = list_in<Space>(rests);
  }
  /// Wakes the tiles whose nodes no longer have one velocity.
  RestingTotals<S> wake(const S* velocity) {
    RestingTotals<S> totals;
    if (count_ == 0) return totals;
    parallel_for(
        "tiles at rest", RangePolicy<Space>{0, std::ssize(pieces_)},
        ComparesVelocities<S>{pieces_.data(), tile_.data(), record_.data(), rests_.data(), velocity, moved_.data()});
    parallel_reduce("tiles at rest", RangePolicy<Space>{0, count_},
                    WakesTiles<S>{tile_.data(), elements_.data(), first_piece_.data(), moved_.data(), time_step_.data(),
                                  rests_.data()},
                    totals);
    if (totals.elements == 0) count_ = 0;
    return totals;
  }
  /// Null: all tiles are worked, and nothing rests.
  const std::uint8_t* rests() const { return count_ > 0 || shared_ ? rests_.data() : nullptr; }
  bool updated() const { return updated_; }
  /// Per tile of the model: whether it rests.
  std::vector<std::uint8_t> read() const {
    std::vector<std::uint8_t> rests(rests_.size());
    deep_copy(rests.data(), rests_);
    rests.resize(rests.size() - TileWork::numbers);
    return rests;
  }
  std::size_t bytes() const {
    return tile_.bytes() + elements_.bytes() + record_.bytes() + time_step_.bytes() + first_piece_.bytes() +
           pieces_.bytes() + moved_.bytes() + rests_.bytes();
  }

 private:
  std::int64_t count_ = 0;  ///< of the list
  bool updated_ = false, shared_ = false;
  Array<std::int32_t, Memory> tile_, elements_, record_, first_piece_;
  Array<S, Memory> time_step_;
  Array<RestingPiece, Memory> pieces_;
  Array<std::uint8_t, Memory> moved_;  ///< per piece
  Array<std::uint8_t, Memory> rests_;  ///< per tile of the model, and of the numbers behind them: TileWork
};

}  // namespace pinball
