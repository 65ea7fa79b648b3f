#pragma once

#include <memory>

#include <solver/parallel/ranks.hpp>

/// Each program links one of two definitions of these: of parallel/mpi/, or program/alone/.
namespace pinball {

/// Whether the program can be one of several that mpirun starts.
bool has_ranks();

/// The ranks that mpirun, or srun, has started with this one; null: it was started by itself.
std::unique_ptr<Ranks> join_ranks();

}  // namespace pinball
