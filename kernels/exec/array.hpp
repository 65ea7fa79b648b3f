#pragma once

#include <cstddef>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include "error_text.hpp"
#include "host_space.hpp"

namespace pinball {

/// Array of plain numbers that lies in one memory, aligned to 64 bytes (on devices 256) and padded to whole lines
/// of 64. A kernel gets data(); only in the host's memory can elements be named one by one. From one memory to another:
/// deep_copy.
template <class T, class Memory = HostSpace>
class Array {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  using value_type = T;
  using memory_space = Memory;

  Array() = default;
  /// Elements are zero; so is the padding behind them.
  explicit Array(std::size_t size) { reset(size); }
  ~Array() { release(); }
  Array(Array&& other) noexcept
      : data_(std::exchange(other.data_, nullptr)),
        size_(std::exchange(other.size_, 0)),
        capacity_(std::exchange(other.capacity_, 0)) {}
  Array& operator=(Array&& other) noexcept {
    if (this == &other) return *this;
    release();
    data_ = std::exchange(other.data_, nullptr);
    size_ = std::exchange(other.size_, 0);
    capacity_ = std::exchange(other.capacity_, 0);
    return *this;
  }

  /// As a new array of this size, in the memory of the old one where that suffices: arrays that are made anew again and
  /// again would otherwise wait for the pages that the system has just been given back.
  void reset(std::size_t size) {
    const bool is_new = provide(size);
    if (data_ != nullptr && !(is_new && begins_as_zero(capacity_))) Memory::zero(data_, padded_bytes());
  }
  /// The same for an array that is to be written as a whole: elements are anything, the padding behind them is zero.
  void renew(std::size_t size) {
    provide(size);
    if (padded_bytes() > bytes()) Memory::zero(data_ + size_, padded_bytes() - bytes());
  }

  std::size_t size() const { return size_; }
  std::size_t bytes() const { return size_ * sizeof(T); }
  bool empty() const { return size_ == 0; }
  T* data() { return data_; }
  const T* data() const { return data_; }
  T& operator[](std::size_t i) requires(std::is_same_v<Memory, HostSpace>) { return data_[i]; }
  const T& operator[](std::size_t i) const requires(std::is_same_v<Memory, HostSpace>) { return data_[i]; }

 private:
  static constexpr std::size_t line = 64;
  std::size_t padded_bytes() const { return (size_ * sizeof(T) + line - 1) / line * line; }

  static bool begins_as_zero(std::size_t room) {
    if constexpr (requires { Memory::begins_as_zero(room); }) return Memory::begins_as_zero(room);
    return false;
  }
  /// Returns whether the memory is new.
  bool provide(std::size_t size) {
    const bool is_new = size * sizeof(T) > capacity_;
    if (is_new) {
      release();  // not both at a time
      const std::size_t room = Memory::room(size * sizeof(T));
      data_ = static_cast<T*>(Memory::allocate(room));
      capacity_ = room;
    }
    size_ = size;
    return is_new;
  }
  void release() noexcept {
    if (data_ != nullptr) Memory::release(data_, capacity_);
    data_ = nullptr;
    size_ = capacity_ = 0;
  }

  T* data_ = nullptr;
  std::size_t size_ = 0;
  std::size_t capacity_ = 0;  ///< [bytes]
};

inline void require_equal_sizes(std::size_t to, std::size_t from) {
  if (to != from) {
    throw std::invalid_argument((ErrorText() << "deep_copy of " << from << " elements to " << to).c_str());
  }
}

/// Copies an array, from any memory to any other, when all work on its device is done; returns when it is copied.
/// Throws std::invalid_argument where sizes differ, and what the memory's device has to say.
template <class T, class A, class B>
void deep_copy(Array<T, A>& to, const Array<T, B>& from) {
  require_equal_sizes(to.size(), from.size());
  if (from.empty()) return;
  if constexpr (std::is_same_v<A, B>) {
    A::copy(to.data(), from.data(), from.bytes());
  } else if constexpr (std::is_same_v<B, HostSpace>) {
    A::copy_from_host(to.data(), from.data(), from.bytes());
  } else if constexpr (std::is_same_v<A, HostSpace>) {
    B::copy_to_host(to.data(), from.data(), from.bytes());
  } else {
    Array<T> host;
    host.renew(from.size());
    deep_copy(host, from);
    deep_copy(to, host);
  }
}

/// from: of the host, `size` elements.
template <class T, class A>
void deep_copy(Array<T, A>& to, const std::type_identity_t<T>* from, std::size_t size) {
  require_equal_sizes(to.size(), size);
  if (size > 0) A::copy_from_host(to.data(), from, to.bytes());
}

/// to: of the host, as many elements as the array has.
template <class T, class A>
void deep_copy(std::type_identity_t<T>* to, const Array<T, A>& from) {
  if (!from.empty()) A::copy_to_host(to, from.data(), from.bytes());
}

/// An array on the host of the same size, zero.
template <class T, class A>
Array<T> create_mirror(const Array<T, A>& array) {
  return Array<T>(array.size());
}

}  // namespace pinball
