#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstring>

#include <solver/base/state_archive.hpp>

namespace pinball::test {

/// The state of something that persists.
template <class Persistent>
StateBytes saved(Persistent& from) {
  StateBytes bytes;
  StateArchive::save(bytes, [&](StateArchive& archive) { from.persist(archive); });
  return bytes;
}

/// Reads a state, which may be a wrong one, saves what was read, reads that, and saves it once more. Returns how many
/// bytes were left unread.
template <class Persistent>
std::size_t load_any(Persistent& into, const StateBytes& bytes, StateBytes& again) {
  StateArchive archive = StateArchive::reading({bytes.data(), bytes.size()});
  into.persist(archive);
  again = saved(into);
  StateArchive second = StateArchive::reading({again.data(), again.size()});
  into.persist(second);
  saved(into);
  return archive.left() + second.left();
}

/// The same of a state that was saved: a run that goes on saves before its first step and whenever it likes, and
/// neither may be told from a run without a break. So what it saves is what it has read, to the byte.
template <class Persistent>
std::size_t load(Persistent& into, const StateBytes& bytes) {
  StateBytes again;
  const std::size_t left = load_any(into, bytes, again);
  const std::size_t read = bytes.size() - std::min(left, bytes.size());
  EXPECT_TRUE(again.size() == read && (read == 0 || std::memcmp(again.data(), bytes.data(), read) == 0))
      << "what was read is saved otherwise";
  return left;
}

}  // namespace pinball::test
