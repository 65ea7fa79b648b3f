#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "../../kernels/exec/array.hpp"
#include "error.hpp"
#include "real_array.hpp"

namespace pinball {

using StateBytes = Array<std::byte>;

/// The state of a run as bytes, in the layout of the machine. Each class that has some of it lists its members once, in
/// `void persist(StateArchive&)`, which measures, writes or reads them: what is saved and what is loaded cannot drift
/// apart. Reading throws InputError where the bytes end too early or are of other sizes than what they are to fill; no
/// size that was read is trusted before it is compared with the bytes that are left.
class StateArchive {
 public:
  /// Calls persist(archive) twice: to measure, and to write into the memory of `bytes`, which is used again.
  template <class Persist>
  static void save(StateBytes& bytes, const Persist& persist) {
    StateArchive measure(Direction::measure, nullptr, 0);
    persist(measure);
    bytes.renew(measure.place_);
    StateArchive write(Direction::write, bytes.data(), bytes.size());
    persist(write);
  }
  /// bytes: they have to outlive the archive.
  static StateArchive reading(std::span<const std::byte> bytes) {
    // Never written through in this direction.
    return {Direction::read, const_cast<std::byte*>(bytes.data()), bytes.size()};
  }

  bool reads() const { return direction_ == Direction::read; }
  std::size_t left() const { return size_ - place_; }
  /// Bytes that are left, and steps over them.
  std::span<const std::byte> rest() {
    const std::span<const std::byte> all{bytes_ + place_, left()};
    place_ = size_;
    return all;
  }

  template <class... Values>
  void operator()(Values&... values) {
    (value(values), ...);
  }
  /// An array whose size is that of the mesh: another one is an error.
  template <class Array>
  void of_fixed_size(Array& array) {
    if (count(array.size(), sizeof(array[0])) != array.size()) throw_foreign();
    raw(array.data(), array.size() * sizeof(array[0]));
  }
  void of_fixed_size(RealArray& array) {
    array.visit([this](auto& numbers) { of_fixed_size(numbers); });
  }
  /// What is read has to be so: a number that something is found by is never trusted.
  void require(bool so) const {
    if (reads() && !so) throw_foreign();
  }
  /// The same for all of several numbers: least, ..., end - 1.
  template <class Numbers>
  void require_all(const Numbers& numbers, std::int64_t least, std::int64_t end) const {
    if (!reads()) return;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      const std::int64_t number = numbers[i];
      if (number < least || number >= end) throw_foreign();
    }
  }
  [[noreturn]] static void throw_foreign() {
    throw InputError("the state does not fit the scene: it is damaged, or of another program");
  }

 private:
  enum class Direction { measure, write, read };

  StateArchive(Direction direction, std::byte* bytes, std::size_t size)
      : direction_(direction), bytes_(bytes), size_(size) {}

  template <class T>
  void value(T& one) {
    static_assert(std::is_trivially_copyable_v<T> && !std::is_pointer_v<T>);
    raw(&one, sizeof one);
  }
  void value(bool& one) {
    std::uint8_t there = one ? 1 : 0;
    value(there);
    require(there <= 1);
    one = there != 0;
  }
  template <class A, class B>
  void value(std::pair<A, B>& pair) {
    value(pair.first);
    value(pair.second);
  }
  template <class T>
  void value(std::optional<T>& maybe) {
    std::uint8_t there = maybe ? 1 : 0;
    value(there);
    if (there == 0) {
      maybe.reset();
      return;
    }
    if (!maybe) maybe.emplace();
    value(*maybe);
  }
  void value(std::string& text) {
    text.resize(count(text.size(), 1));
    raw(text.data(), text.size());
  }
  template <class T>
  void value(Array<T>& array) {
    const std::size_t size = count(array.size(), sizeof(T));
    if (reads()) array.reset(size);
    raw(array.data(), array.bytes());
  }
  template <class T>
  void value(std::vector<T>& list) {
    if constexpr (std::is_trivially_copyable_v<T>) {
      list.resize(count(list.size(), sizeof(T)));
      raw(list.data(), list.size() * sizeof(T));
    } else {
      list.resize(count(list.size(), 1));  // each of them takes a byte at the least
      for (T& item : list) value(item);
    }
  }

  /// Writes a number of things of this many bytes, or reads and checks it.
  std::size_t count(std::size_t present, std::size_t bytes_of_each) {
    std::uint64_t number = present;
    value(number);
    if (reads() && number > left() / bytes_of_each) throw_foreign();
    return number;
  }

  void raw(void* data, std::size_t bytes) {
    if (direction_ != Direction::measure) {
      if (bytes > left()) throw_foreign();
      if (bytes == 0) return;
      if (reads()) {
        copy(data, bytes_ + place_, bytes);
      } else {
        copy(bytes_ + place_, data, bytes);
      }
    }
    place_ += bytes;
  }

  /// By all threads, where that is worth it.
  static void copy(void* to, const void* from, std::size_t bytes);

  Direction direction_;
  std::byte* bytes_;
  std::size_t size_, place_ = 0;
};

}  // namespace pinball
