#include "ranks.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstring>

#include <solver/base/error.hpp>

namespace pinball {

namespace {

/// RankReady in one piece of memory.
struct ReadyBytes {
  std::int32_t status = 0, simd_width = 0;
  std::uint64_t fingerprint = 0, program = 0;
  std::array<char, 1000> error{};
};

[[noreturn]] void fail(int status, const std::string& what) {
  if (status == 2) throw InputError(what);
  throw RunError(what);
}

/// Throws where a rank is not ready to run with rank 0.
void compare(int rank, const ReadyBytes& own, const ReadyBytes& first) {
  if (own.status != 0) fail(own.status, fmt::format("rank {}: {}", rank, own.error.data()));
  if (own.simd_width != first.simd_width) {
    fail(2, fmt::format("rank {} has packs of {}, rank 0 of {}: expected one kind of processors, or a build for the "
                        "least of them",
                        rank, own.simd_width, first.simd_width));
  }
  if (own.program != first.program) {
    fail(2, fmt::format("rank {} runs another program than rank 0: expected the same file on all machines", rank));
  }
  if (own.fingerprint != first.fingerprint) {
    fail(2, fmt::format("rank {} has made another mesh of the scene than rank 0: expected the same files on all "
                        "machines",
                        rank));
  }
}

}  // namespace

void agree(Ranks& ranks, const RankReady& own) {
  ReadyBytes ready;
  ready.status = own.status;
  ready.simd_width = own.simd_width;
  ready.fingerprint = own.fingerprint;
  ready.program = ranks.program();
  std::memcpy(ready.error.data(), own.error.data(), std::min(own.error.size(), ready.error.size() - 1));
  std::vector<ReadyBytes> all(ranks.count());
  ranks.gather(std::as_bytes(std::span(&ready, 1)), std::vector<std::size_t>(all.size(), sizeof ready),
               std::as_writable_bytes(std::span(all)), true);
  ranks.agreed = true;
  if (own.status != 0) return;
  if (all[0].status != 0) fail(all[0].status, all[0].error.data());
  for (int rank = 1; rank < ranks.count(); ++rank) compare(rank, all[rank], all[0]);
  ranks.running = true;
}

}  // namespace pinball
