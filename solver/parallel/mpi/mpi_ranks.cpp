#include <solver/program/join_ranks.hpp>

#define OMPI_SKIP_MPICXX
#define MPICH_SKIP_MPICXX
#include <mpi.h>
#if defined(OPEN_MPI)
#include <mpi-ext.h>
#endif

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <vector>

#include <solver/base/state_hash.hpp>

#include "cut_graph.hpp"

namespace pinball {

namespace {

/// Counts of MPI are ints.
constexpr std::size_t most_bytes = std::size_t{1} << 30;

std::uint64_t hash_of_program() {
  std::ifstream file("/proc/self/exe", std::ios::binary);
  std::vector<char> part(1 << 20);
  StateHash hash;
  while (file.read(part.data(), static_cast<std::streamsize>(part.size())) || file.gcount() > 0)
    hash.add(part.data(), static_cast<std::size_t>(file.gcount()));
  return hash.value();
}

/// What starts ranks says so in the environment of each: Open MPI, MPICH, Intel MPI and what Slurm starts by PMI.
bool was_started_by_mpirun() {
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "PMIX_RANK", "PMI_RANK"}) {
    if (std::getenv(name) != nullptr) return true;
  }
  return false;
}

class MpiRanks final : public Ranks {
 public:
  MpiRanks() {
    int provided = 0;
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
    MPI_Comm_rank(MPI_COMM_WORLD, &number_);
    MPI_Comm_size(MPI_COMM_WORLD, &count_);
    MPI_Comm machine = MPI_COMM_NULL;
    MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, number_, MPI_INFO_NULL, &machine);
    MPI_Comm_rank(machine, &number_on_machine_);
    MPI_Comm_free(&machine);
  }
  /// Errors of messages end all ranks (MPI_ERRORS_ARE_FATAL, the default).
  ~MpiRanks() override {
    std::fflush(nullptr);
    if (gave_up_) MPI_Abort(MPI_COMM_WORLD, 1);
    MPI_Finalize();
  }
  int number() const override { return number_; }
  int count() const override { return count_; }
  int number_on_machine() const override { return number_on_machine_; }
  bool reaches_cuda() const override {
#if defined(MPIX_CUDA_AWARE_SUPPORT) && MPIX_CUDA_AWARE_SUPPORT
    return MPIX_Query_cuda_support() == 1;
#else
    return false;
#endif
  }
  std::uint64_t program() const override { return hash_of_program(); }

  void broadcast(std::span<std::byte> bytes) override { send_from(0, bytes); }

  void gather(std::span<const std::byte> own, const std::vector<std::size_t>& bytes_of, std::span<std::byte> all,
              bool to_all) override {
    std::vector<int> counts, places;
    std::size_t sum = 0;
    for (const std::size_t bytes : bytes_of) {
      counts.push_back(static_cast<int>(std::min(bytes, most_bytes)));
      places.push_back(static_cast<int>(std::min(sum, most_bytes)));
      sum += bytes;
    }
    if (sum > most_bytes) {
      gather_much(own, bytes_of, all, to_all);
    } else if (to_all) {
      MPI_Allgatherv(own.data(), counts[number_], MPI_BYTE, all.data(), counts.data(), places.data(), MPI_BYTE,
                     MPI_COMM_WORLD);
    } else {
      MPI_Gatherv(own.data(), counts[number_], MPI_BYTE, all.data(), counts.data(), places.data(), MPI_BYTE, 0,
                  MPI_COMM_WORLD);
    }
  }

  void exchange(std::span<const RankMessage> messages) override {
    std::vector<MPI_Request> requests;
    const auto in_parts = [&requests](std::size_t bytes, const auto& start) {
      for (std::size_t from = 0; from < bytes; from += most_bytes)
        start(from, static_cast<int>(std::min(most_bytes, bytes - from)), &requests.emplace_back());
    };
    for (const RankMessage& m : messages) {
      in_parts(m.received.size(), [&m](std::size_t from, int bytes, MPI_Request* request) {
        MPI_Irecv(m.received.data() + from, bytes, MPI_BYTE, m.rank, 0, MPI_COMM_WORLD, request);
      });
    }
    for (const RankMessage& m : messages) {
      in_parts(m.sent.size(), [&m](std::size_t from, int bytes, MPI_Request* request) {
        MPI_Isend(m.sent.data() + from, bytes, MPI_BYTE, m.rank, 0, MPI_COMM_WORLD, request);
      });
    }
    MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
  }

  std::vector<std::int32_t> cut(const TileGraph& tiles) const override { return cut_graph(tiles, count_); }

 private:
  void send_from(int rank, std::span<std::byte> bytes) const {
    for (std::size_t from = 0; from < bytes.size(); from += most_bytes) {
      MPI_Bcast(bytes.data() + from, static_cast<int>(std::min(most_bytes, bytes.size() - from)), MPI_BYTE, rank,
                MPI_COMM_WORLD);
    }
  }
  /// More than one call takes: rank after rank.
  void gather_much(std::span<const std::byte> own, const std::vector<std::size_t>& bytes_of, std::span<std::byte> all,
                   bool to_all) {
    std::size_t place = 0;
    for (int rank = 0; rank < count_; ++rank) {
      const bool gets = to_all || number_ == 0;
      const std::span<std::byte> part = gets ? all.subspan(place, bytes_of[rank]) : std::span<std::byte>();
      place += bytes_of[rank];
      if (rank == number_ && gets) std::copy(own.begin(), own.end(), part.begin());
      if (to_all) {
        send_from(rank, part);
      } else if (rank > 0 && number_ == 0) {
        const RankMessage message{rank, {}, part};
        exchange({&message, 1});
      } else if (rank > 0 && number_ == rank) {
        const RankMessage message{0, own, {}};
        exchange({&message, 1});
      }
    }
  }

  int number_ = 0, count_ = 1, number_on_machine_ = 0;
};

}  // namespace

bool has_ranks() { return true; }

std::unique_ptr<Ranks> join_ranks() { return was_started_by_mpirun() ? std::make_unique<MpiRanks>() : nullptr; }

}  // namespace pinball
