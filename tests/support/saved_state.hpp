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

/// Returns how many bytes it has left unread.
template <class Persistent>
std::size_t load(Persistent& into, const StateBytes& bytes) {
  StateArchive archive = StateArchive::reading({bytes.data(), bytes.size()});
  into.persist(archive);
  return archive.left();
}

}  // namespace pinball::test
