#pragma once

// For hosts that have Kokkos 4 or later, and call Kokkos::initialize themselves; exec.hpp does not include it.
#if __has_include(<Kokkos_Core.hpp>)

#include <Kokkos_Core.hpp>
#include <cstddef>
#include <cstdint>
#include <new>
#include <type_traits>

#include "sums.hpp"

namespace pinball {

/// The memory of Kokkos' default execution space. A raw pointer in it is the data() of an unmanaged View.
struct KokkosMemory {
  using Space = Kokkos::DefaultExecutionSpace::memory_space;
  static constexpr std::size_t alignment = 64;

  static std::size_t room(std::size_t bytes) { return (bytes + alignment - 1) / alignment * alignment; }
  static void* allocate(std::size_t room) {
    void* const memory = Kokkos::kokkos_malloc<Space>("pinball", room);
    if (memory == nullptr) throw std::bad_alloc();
    return memory;
  }
  static void release(void* memory, std::size_t /*room*/) noexcept { Kokkos::kokkos_free<Space>(memory); }

  static void zero(void* to, std::size_t bytes) {
    Kokkos::deep_copy(Bytes<char, Space>(static_cast<char*>(to), bytes), 0);
  }
  static void copy(void* to, const void* from, std::size_t bytes) { transfer<Space, Space>(to, from, bytes); }
  static void copy_from_host(void* to, const void* from, std::size_t bytes) {
    transfer<Space, Kokkos::HostSpace>(to, from, bytes);
  }
  static void copy_to_host(void* to, const void* from, std::size_t bytes) {
    transfer<Kokkos::HostSpace, Space>(to, from, bytes);
  }

 private:
  template <class Byte, class Of>
  using Bytes = Kokkos::View<Byte*, Of, Kokkos::MemoryTraits<Kokkos::Unmanaged>>;

  template <class To, class From>
  static void transfer(void* to, const void* from, std::size_t bytes) {
    Kokkos::deep_copy(Bytes<char, To>(static_cast<char*>(to), bytes),
                      Bytes<const char, From>(static_cast<const char*>(from), bytes));
  }
};

/// Kokkos' default execution space, as a space of this library. A body must not throw.
struct KokkosDefault {
  using memory_space = KokkosMemory;
  using Policy = Kokkos::RangePolicy<Kokkos::DefaultExecutionSpace, Kokkos::IndexType<std::int64_t>>;
  static int concurrency() { return Kokkos::DefaultExecutionSpace().concurrency(); }
  static void wait() { Kokkos::fence("pinball"); }
};

template <class Functor>
void parallel_for(const char* name, RangePolicy<KokkosDefault> range, const Functor& functor) {
  static_assert(std::is_trivially_copyable_v<Functor>);
  if (range.begin < range.end) Kokkos::parallel_for(name, KokkosDefault::Policy(range.begin, range.end), functor);
}

/// What the lanes of all pieces add up (sums.hpp), each by itself: lane l of piece p is at 128 p + l.
template <class Value, class Functor>
struct KokkosLanes {
  std::int64_t begin, count, pieces;
  Value* lane;
  Functor functor;
  PINBALL_FUNCTION void operator()(std::int64_t number) const {
    const SumPiece piece = sum_piece(count, number / sum_lanes, pieces);
    Value sum{};
    for (std::int64_t i = piece.begin + number % sum_lanes; i < piece.end; i += sum_lanes) functor(begin + i, sum);
    lane[number] = sum;
  }
};

/// Joins the lanes of a piece in pairs, in their own place.
template <class Value>
struct KokkosPieces {
  Value* lane;
  PINBALL_FUNCTION void operator()(std::int64_t p) const {
    Value* const of_piece = lane + sum_lanes * p;
    for (int width = sum_lanes / 2; width > 0; width /= 2) {
      for (int l = 0; l < width; ++l) join_to(of_piece[l], of_piece[l + width]);
    }
  }
};

/// Not Kokkos' own reduction, whose order is that of its threads: the order of all spaces.
template <class Functor, class Value>
void parallel_reduce(const char* name, RangePolicy<KokkosDefault> range, const Functor& functor, Value& result) {
  static_assert(std::is_trivially_copyable_v<Value> && std::is_trivially_copyable_v<Functor>);
  const std::int64_t count = range.end - range.begin, pieces = sum_pieces(count);
  Array<Value, KokkosMemory> lanes;
  lanes.renew(pieces * sum_lanes);
  const KokkosLanes<Value, Functor> sums{range.begin, count, pieces, lanes.data(), functor};
  parallel_for(name, RangePolicy<KokkosDefault>{0, pieces * sum_lanes}, sums);
  parallel_for(name, RangePolicy<KokkosDefault>{0, pieces}, KokkosPieces<Value>{lanes.data()});
  Array<Value> on_host;
  on_host.renew(lanes.size());
  KokkosDefault::wait();
  deep_copy(on_host, lanes);
  result = sum_of_piece<Value>({0, pieces}, [&](std::int64_t p, Value& sum) { join_to(sum, on_host[sum_lanes * p]); });
}

template <class Value, class Functor>
struct KokkosScan {
  using value_type = Value;
  Functor functor;
  PINBALL_FUNCTION void operator()(std::int64_t i, Value& update, bool final) const { functor(i, update, final); }
};

template <class Functor, class Value>
void parallel_scan(const char* name, RangePolicy<KokkosDefault> range, const Functor& functor, Value& total) {
  static_assert(std::is_arithmetic_v<Value> && std::is_trivially_copyable_v<Functor>);
  total = 0;
  if (range.begin >= range.end) return;
  Kokkos::parallel_scan(name, KokkosDefault::Policy(range.begin, range.end), KokkosScan<Value, Functor>{functor},
                        total);
}

}  // namespace pinball

#endif
