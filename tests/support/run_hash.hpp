#pragma once

#include <cstdint>
#include <utility>

#include <solver/base/state_hash.hpp>

#include "solver_case.hpp"

namespace pinball::test {

/// The state that a scene ends in, by so many threads.
template <class S>
std::uint64_t hash_of(const Scene& scene, int threads = 1) {
  DefaultExecutionSpace::set_concurrency(threads);
  Solver<S> solver(scene);
  run(solver);
  DefaultExecutionSpace::set_concurrency(1);
  return state_hash(std::as_const(solver).model());
}

}  // namespace pinball::test
