#pragma once

#include <cstdint>
#include <memory>
#include <type_traits>
#include <vector>

#include <kernels/exec.hpp>
#include <kernels/exec/pieces.hpp>
#include <solver/parallel/shared_nodes.hpp>

#include "sums_in_packs.hpp"

/// What loops of boundary conditions have in common.
namespace pinball {

template <class Space>
inline constexpr bool on_host = std::is_same_v<typename Space::memory_space, HostSpace>;

/// A list of the host in the memory of a space.
template <class Space, class T>
Array<T, typename Space::memory_space> list_in(const std::vector<T>& list) {
  Array<T, typename Space::memory_space> array;
  array.renew(list.size());
  deep_copy(array, list.data(), list.size());
  return array;
}

/// Which pieces of the sums over a list are whose, where several ranks share the nodes; else null.
using SharedList = std::shared_ptr<const SharedBlocks>;

/// node(i): the node that the i-th of a list is about. sharing: null on a process that is alone.
template <class Node>
SharedList shared_list(SharedNodes* sharing, std::int64_t count, const Node& node) {
  if (sharing == nullptr) return nullptr;
  const std::int64_t pieces = sum_pieces(count);
  return sharing->blocks(pieces, [count, pieces, node](std::int64_t p, const auto& take) {
    const SumPiece piece = sum_piece(count, p, pieces);
    for (std::int64_t i = piece.begin; i < piece.end; ++i) take(node(i));
  });
}

/// Of each number of an array of the space, what its owner has goes to all ranks; owner: of each.
template <class T, class Memory>
void share_array(SharedNodes& sharing, const std::vector<std::int32_t>& owner, Array<T, Memory>& of) {
  if constexpr (std::is_same_v<Memory, HostSpace>) {
    sharing.share(owner, of.data());
  } else {
    std::vector<T> numbers(owner.size());
    deep_copy(numbers.data(), of);
    sharing.share(owner, numbers.data());
    deep_copy(of, numbers.data(), numbers.size());
  }
}

/// Calls functor(i) for i below count. Threads of the host are not called together for a few nodes. shared: leaves out
/// pieces whose nodes are all of other ranks.
template <class Space, class Functor>
void for_each(const char* name, std::int64_t count, const Functor& functor, const SharedList& shared = nullptr) {
  constexpr std::int64_t few = 512;
  if (on_host<Space> && count < few) {
    for (std::int64_t i = 0; i < count; ++i) functor(i);
  } else if (shared == nullptr) {
    parallel_for(name, RangePolicy<Space>{0, count}, functor);
  } else {
    for (const SharedBlocks::Run& run : shared->worked()) {
      const std::int64_t begin = sum_piece(count, run.begin, shared->count()).begin;
      const std::int64_t end = sum_piece(count, run.end - 1, shared->count()).end;
      parallel_for(name, RangePolicy<Space>{begin, end}, functor);
    }
  }
}

/// Adds to `sum` what functor(i, partial) adds up for i below count; over all ranks the same bits as by one.
template <class Space, class Functor, class Value>
void add_sum(const char* name, std::int64_t count, const Functor& functor, Value& sum,
             const SharedList& shared = nullptr) {
  Value own{};
  if constexpr (on_host<Space>) {
    const std::int64_t pieces = sum_pieces(count);
    Array<Value> partial;
    partial.reset(pieces);
    const SumsOfHost<Value, Functor> sums{0, count, pieces, partial.data(), functor};
    if (shared == nullptr) {
      parallel_for(name, RangePolicy<Space>{0, pieces}, sums);
    } else {
      for (const SharedBlocks::Run& run : shared->worked())
        parallel_for(name, RangePolicy<Space>{run.begin, run.end}, sums);
      shared->gather(partial.data());
    }
    own = sum_of_piece<Value>({0, pieces}, [&](std::int64_t p, Value& whole) { join_to(whole, partial[p]); });
  } else if (shared == nullptr) {
    parallel_reduce(name, RangePolicy<Space>{0, count}, functor, own);
  } else {
    std::vector<Value> partial(shared->count());
    for (const SharedBlocks::Run& run : shared->worked())
      reduce_pieces(name, RangePolicy<Space>{0, count}, {run.begin, run.end}, functor, partial.data());
    shared->gather(partial.data());
    own = join_pieces(partial.data(), shared->count());
  }
  join_to(sum, own);
}

}  // namespace pinball
