#pragma once

#include <cstddef>
#include <cstring>
#include <type_traits>
#include <vector>

#include <kernels/exec.hpp>

#include "staging_memory.hpp"

namespace pinball {

/// An array of PackedArrays, by its place there.
template <class T>
struct PackedArray {
  std::size_t offset = 0;  ///< [bytes]
};

/// Arrays of the host in the memory of a space, one behind the other: all of them go there in one copy, and those that
/// the host wants back come in one. Each copy of its own would be waited for.
template <class Space>
class PackedArrays {
  using Memory = typename Space::memory_space;

 public:
  /// Arrays of before are gone. What is added has to stay good until send(), what comes back as long as it may.
  void clear() {
    parts_.clear();
    end_ = sent_ = 0;
  }
  /// numbers: `count` of the host.
  template <class T>
  PackedArray<std::remove_const_t<T>> add(const T* numbers, std::size_t count) {
    return added<T>({numbers, nullptr, end_, count * sizeof(T)});
  }
  template <class Numbers>
  auto add(const Numbers& numbers) {
    return add(numbers.data(), numbers.size());
  }
  /// The same, and bring_back() brings what becomes of them. Before others: the copy back is of all between them.
  template <class T>
  PackedArray<T> add_for_both(T* numbers, std::size_t count) {
    return added<T>({numbers, numbers, end_, count * sizeof(T)});
  }
  /// Of the space alone, and then anything. After others: it would be sent with them.
  template <class T>
  PackedArray<T> add_room(std::size_t count) {
    const PackedArray<T> array{end_};
    end_ = end_of(count * sizeof(T));
    return array;
  }

  void send() {
    there_.renew(end_);
    if (sent_ == 0) return;
    here_.renew(sent_);
    for (const Part& part : parts_) copy_bytes(here_.data() + part.offset, part.from, part.bytes);
    Memory::copy_from_host(there_.data(), here_.data(), sent_);
  }
  /// After send().
  void bring_back() {
    std::size_t begin = sent_, end = 0;
    for (const Part& part : parts_) {
      if (part.back == nullptr) continue;
      begin = part.offset < begin ? part.offset : begin;
      end = part.offset + part.bytes > end ? part.offset + part.bytes : end;
    }
    if (begin >= end) return;
    Memory::copy_to_host(here_.data() + begin, there_.data() + begin, end - begin);
    for (const Part& part : parts_) {
      if (part.back != nullptr) copy_bytes(part.back, here_.data() + part.offset, part.bytes);
    }
  }

  /// In the memory of the space, after send().
  template <class T>
  T* data(PackedArray<T> array) {
    return reinterpret_cast<T*>(there_.data() + array.offset);
  }
  std::size_t bytes() const { return there_.bytes() + here_.bytes(); }

 private:
  struct Part {
    const void* from;
    void* back;  ///< the same, or null
    std::size_t offset, bytes;
  };
  static constexpr std::size_t alignment = 256;  ///< of each array (Array)

  std::size_t end_of(std::size_t bytes) const { return (end_ + bytes + alignment - 1) / alignment * alignment; }
  template <class T>
  PackedArray<std::remove_const_t<T>> added(const Part& part) {
    static_assert(std::is_trivially_copyable_v<T> && alignof(T) <= alignment);
    parts_.push_back(part);
    end_ = sent_ = end_of(part.bytes);
    return {part.offset};
  }
  static void copy_bytes(void* to, const void* from, std::size_t bytes) {
    if (bytes > 0) std::memcpy(to, from, bytes);
  }

  std::vector<Part> parts_;
  std::size_t end_ = 0, sent_ = 0;  ///< of all, and of what is sent [bytes]
  Array<std::byte, Memory> there_;
  Array<std::byte, StagingMemory<Memory>> here_;
};

}  // namespace pinball
