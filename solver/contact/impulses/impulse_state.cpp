#include <cstring>

#include "impulse_solver.hpp"

/// What impulses keep from step to step, in checkpoints and in memory.
namespace pinball {

/// Rows, their pairs and nodes are for the report of forces alone.
template <class S>
void ImpulseSolver<S>::persist(StateArchive& archive, const SurfaceSource<S>& source) {
  archive(memory_, pending_, taken_, rows_.rows, rows_.node, rows_.weight, pairs_, node_);
  if (!archive.reads()) return;
  check(archive, source.node_count);
  node_place_.assign(source.node_count, no_place);
  name_memory();
}

/// Of rows and pairs that were read.
template <class S>
void ImpulseSolver<S>::check(const StateArchive& archive, std::int32_t node_count) const {
  const auto is_sound = [](const PairMemory& memory) {
    std::uint8_t slides = 0;
    std::memcpy(&slides, &memory.slides, 1);  // other values are none of a bool
    return slides <= 1;
  };
  for (const PairMemory& memory : memory_) archive.require(is_sound(memory));
  for (const Pair& pair : pairs_) archive.require(is_sound(pair.memory));
  archive.require_all(node_, 0, node_count);
  const std::size_t entries = rows_.node.size();
  archive.require_all(rows_.node, 0, node_.size());
  archive.require(rows_.weight.size() == entries && pairs_.size() == rows_.size());
  for (const ImpulseRow& row : rows_.rows) {
    archive.require(row.first <= entries && row.nodes >= 0 &&
                    static_cast<std::size_t>(row.nodes) <= entries - row.first);
  }
}

template <class S>
std::size_t ImpulseSolver<S>::bytes() const {
  const auto of = [](const auto& v) { return v.capacity() * sizeof(v[0]); };
  return rows_.bytes() + system_.bytes() + iterations_.bytes() + velocity_.bytes() + row_vector_.bytes() +
         of(frictions_) + of(bound_friction_) + of(bounded_) + of(slid_) + of(most_friction_) + of(pairs_) +
         of(active_) + of(nodes_) + of(node_) + of(last_entry_) + of(memory_) + of(release_share_) + of(opens_) +
         arm_.bytes() + way_.bytes() + of(rigid_release_share_) + names_.bytes() + of(node_place_) + held_.bytes();
}

#define PINBALL_INSTANTIATE(S)                                                     \
  template void ImpulseSolver<S>::persist(StateArchive&, const SurfaceSource<S>&); \
  template std::size_t ImpulseSolver<S>::bytes() const;
PINBALL_INSTANTIATE(double)
PINBALL_INSTANTIATE(float)
#undef PINBALL_INSTANTIATE

}  // namespace pinball
