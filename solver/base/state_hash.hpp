#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <type_traits>

namespace pinball {

/// 64-bit hash of a sequence of bytes, to tell whether two runs ended in bitwise the same state.
///
/// One lane of the xxHash64 scheme. For each 8-byte word w of the sequence
///   h <- rotl(h xor (rotl(w P2, 31) P1), 27) P1 + P4,
/// a last partial word is filled with zeros and the length is mixed in, then h is avalanched with xor-shifts and
/// multiplications. (Plain FNV-1a on words was not taken: two flipped sign bits cancel each other in it.)
/// The value depends on the order of the bytes, and on nothing else: not on how they were cut into calls of add(), not
/// on alignment or on the number of threads. +0 and -0 differ, and so do two NaN of different bits. Words are read in
/// the byte order of the machine. Not for security.
class StateHash {
 public:
  void add(const void* data, std::size_t bytes) {
    const auto* from = static_cast<const unsigned char*>(data);
    length_ += bytes;
    while (bytes > 0 && (filled_ > 0 || bytes < sizeof(std::uint64_t))) {  // the word between two calls
      pending_[filled_++] = *from++;
      --bytes;
      if (filled_ == sizeof(std::uint64_t)) {
        hash_ = mix(hash_, load(pending_));
        filled_ = 0;
      } else if (bytes == 0) {
        return;
      }
    }
    for (; bytes >= sizeof(std::uint64_t); bytes -= sizeof(std::uint64_t), from += sizeof(std::uint64_t)) {
      hash_ = mix(hash_, load(from));
    }
    for (; bytes > 0; --bytes) pending_[filled_++] = *from++;
  }

  /// The bytes of an array of numbers (types with padding bytes are rejected, whose values are not defined).
  template <class T>
  void add(std::span<const T> values) {
    static_assert(std::is_arithmetic_v<T>, "hash plain numbers, one array at a time");
    add(values.data(), values.size_bytes());
  }

  /// Hash of all bytes so far; more may be added afterwards.
  std::uint64_t value() const {
    std::uint64_t h = hash_;
    if (filled_ > 0) {
      unsigned char word[sizeof(std::uint64_t)] = {};
      std::memcpy(word, pending_, filled_);
      h = mix(h, load(word));
    }
    h = mix(h, length_);
    h = (h ^ (h >> 33)) * prime2;
    h = (h ^ (h >> 29)) * prime3;
    return h ^ (h >> 32);
  }

 private:
  static constexpr std::uint64_t prime1 = 0x9E3779B185EBCA87, prime2 = 0xC2B2AE3D27D4EB4F, prime3 = 0x165667B19E3779F9,
                                 prime4 = 0x85EBCA77C2B2AE63;

  static std::uint64_t load(const unsigned char* from) {
    std::uint64_t word;
    std::memcpy(&word, from, sizeof word);
    return word;
  }

  static std::uint64_t mix(std::uint64_t h, std::uint64_t word) {
    h ^= std::rotl(word * prime2, 31) * prime1;
    return std::rotl(h, 27) * prime1 + prime4;
  }

  std::uint64_t hash_ = prime3;
  std::uint64_t length_ = 0;
  unsigned char pending_[sizeof(std::uint64_t)] = {};
  std::size_t filled_ = 0;
};

}  // namespace pinball
