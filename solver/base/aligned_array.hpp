#pragma once

#include <sys/mman.h>

#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <new>
#include <type_traits>

namespace pinball {

/// Array of plain numbers, aligned to 64 bytes (a cache line, the widest pack) and padded to whole lines.
/// Large arrays lie on huge pages where the system grants them on request: a step of 216,000 elements is 12 % faster.
template <class T>
class AlignedArray {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  AlignedArray() = default;
  /// Elements are zero; so is the padding behind them.
  explicit AlignedArray(std::size_t size) { reset(size); }
  /// As a new array of this size, in the memory of the old one where that suffices: arrays that are made anew again and
  /// again would otherwise wait for the pages that the system has just been given back.
  void reset(std::size_t size) {
    renew(size);
    if (data_) std::memset(static_cast<void*>(data_.get()), 0, padded_bytes());
  }
  /// The same for an array that is to be written as a whole: elements are anything, the padding behind them is zero.
  void renew(std::size_t size) {
    size_ = size;
    if (size * sizeof(T) > (data_ ? capacity_ : 0)) {  // what was moved away has left its capacity
      const std::size_t place = size * sizeof(T) >= huge_page ? huge_page : alignment;
      capacity_ = (size * sizeof(T) + place - 1) / place * place;
      data_.reset();  // not both at a time
      data_.reset(static_cast<T*>(std::aligned_alloc(place, capacity_)));
      if (!data_) throw std::bad_alloc();
#if defined(MADV_HUGEPAGE)
      if (place == huge_page) madvise(data_.get(), capacity_, MADV_HUGEPAGE);  // advice: a refusal changes nothing
#endif
    }
    if (data_) std::memset(static_cast<void*>(data_.get() + size_), 0, padded_bytes() - bytes());
  }

  std::size_t size() const { return size_; }
  std::size_t bytes() const { return size_ * sizeof(T); }
  bool empty() const { return size_ == 0; }
  T* data() { return data_.get(); }
  const T* data() const { return data_.get(); }
  T& operator[](std::size_t i) { return data_.get()[i]; }
  const T& operator[](std::size_t i) const { return data_.get()[i]; }

 private:
  static constexpr std::size_t alignment = 64;
  static constexpr std::size_t huge_page = std::size_t(2) << 20;
  std::size_t padded_bytes() const { return (size_ * sizeof(T) + alignment - 1) / alignment * alignment; }
  struct Free {
    void operator()(T* p) const { std::free(p); }
  };
  std::unique_ptr<T, Free> data_;
  std::size_t size_ = 0;
  std::size_t capacity_ = 0;  ///< [bytes]
};

}  // namespace pinball
