#pragma once

#include <cstddef>

#include <solver/base/state_archive.hpp>

namespace pinball::test {

/// The state of something that persists.
template <class Persistent>
StateBytes saved(Persistent& from) {
  StateBytes bytes;
  StateArchive::save(bytes, [&](StateArchive& archive) { from.persist(archive); });
  return bytes;
}

/// Reads a state, saves what was read, reads that, and saves it once more: a run that goes on saves before its first
/// step and whenever it likes, and neither may be told from a run without a break. Returns how many bytes were left
/// unread.
template <class Persistent>
std::size_t load(Persistent& into, const StateBytes& bytes) {
  StateArchive archive = StateArchive::reading({bytes.data(), bytes.size()});
  into.persist(archive);
  const StateBytes again = saved(into);
  StateArchive second = StateArchive::reading({again.data(), again.size()});
  into.persist(second);
  saved(into);
  return archive.left() + second.left();
}

}  // namespace pinball::test
