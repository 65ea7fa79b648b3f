#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <type_traits>
#include <vector>

namespace pinball {

/// Processes that have the same numbers and work loops over them together: each works some pieces of a loop, and what
/// it finds there goes to all. All of them call the same members in the same order.
class Sharers {
 public:
  virtual ~Sharers() = default;
  virtual int count() const = 0;
  virtual int number() const = 0;  ///< of this process
  /// Numbers that a loop has to look at for messages to be worth it; the same for all.
  virtual std::int64_t worth_a_message() const = 0;
  /// What each of them has, by their numbers; valid until the next call. own: of this process.
  virtual std::vector<std::span<const std::byte>> to_all(std::span<const std::byte> own) = 0;
};

/// The pieces of a loop that this process works: all, where it shares them with no one.
class PieceShare {
 public:
  PieceShare() = default;
  /// Pieces in turn. sharers: null: there are none; numbers: that all pieces together look at. Where these are few each
  /// process works all pieces.
  PieceShare(Sharers* sharers, std::int64_t pieces, std::int64_t numbers);
  /// Each about as many numbers. numbers_of: of each piece.
  PieceShare(Sharers* sharers, const std::vector<std::int64_t>& numbers_of);

  bool is_shared() const { return sharers_ != nullptr; }
  bool is_own(std::int64_t piece) const { return !is_shared() || owner_[piece] == sharers_->number(); }
  /// Calls take(bytes) with what each of the others has found in its pieces. own: what this one has.
  template <class Take>
  void to_all(std::span<const std::byte> own, const Take& take) const {
    if (!is_shared()) return;
    const std::vector<std::span<const std::byte>> all = sharers_->to_all(own);
    for (int process = 0; process < sharers_->count(); ++process) {
      if (process != sharers_->number()) take(all[process]);
    }
  }

 private:
  Sharers* sharers_ = nullptr;
  std::vector<std::int32_t> owner_;  ///< per piece; empty: all are this one's
};

/// Adds plain values to a message.
template <class T>
void put(std::vector<std::byte>& message, std::span<const T> values) {
  static_assert(std::is_trivially_copyable_v<T>);
  const auto bytes = std::as_bytes(values);
  message.insert(message.end(), bytes.begin(), bytes.end());
}
inline void put_count(std::vector<std::byte>& message, std::uint64_t count) {
  put<std::uint64_t>(message, {&count, 1});
}

/// Takes them from where a message goes on.
template <class T>
void get(std::span<const std::byte>& message, std::span<T> values) {
  static_assert(std::is_trivially_copyable_v<T>);
  const std::span<const std::byte> bytes = message.first(values.size_bytes());
  if (!bytes.empty()) std::memcpy(values.data(), bytes.data(), bytes.size());
  message = message.subspan(bytes.size());
}
inline std::uint64_t get_count(std::span<const std::byte>& message) {
  std::uint64_t count = 0;
  get<std::uint64_t>(message, {&count, 1});
  return count;
}

/// A list, with its length before it.
template <class T>
void put_list(std::vector<std::byte>& message, const std::vector<T>& list) {
  put_count(message, list.size());
  put(message, std::span(list));
}
/// Adds what such a list has to another one.
template <class T>
void add_list(std::span<const std::byte>& message, std::vector<T>& list) {
  const std::uint64_t more = get_count(message);
  list.resize(list.size() + more);
  get(message, std::span(list).last(more));
}

}  // namespace pinball
