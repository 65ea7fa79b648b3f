#pragma once

#include <barrier>
#include <cstring>
#include <memory>
#include <thread>
#include <vector>

#include <kernels/exec.hpp>
#include <solver/parallel/ranks.hpp>
#include <solver/step/report.hpp>

namespace pinball::test {

/// Ranks that are threads of one process: what messages carry, without a library of messages.
class ThreadRanks final : public Ranks {
 public:
  /// What all of them see of each other.
  struct Team {
    explicit Team(int size) : members(size), barrier(size) {}
    bool reaches_cuda = false;  ///< as a library of messages that begins and ends them in the memory of GPUs
    std::vector<ThreadRanks*> members;
    std::barrier<> barrier;
  };
  ThreadRanks(Team& team, int number, const Partition& given) : team_(team), number_(number) {
    partition = given;
    team_.members[number] = this;
    team_.barrier.arrive_and_wait();
  }
  /// One that fails lets the others go on to where they see it.
  ~ThreadRanks() override { team_.barrier.arrive_and_drop(); }

  int number() const override { return number_; }
  int count() const override { return static_cast<int>(team_.members.size()); }
  std::uint64_t program() const override { return program_; }
  void set_program(std::uint64_t program) { program_ = program; }
  bool reaches_cuda() const override { return team_.reaches_cuda; }
  /// Bytes that this one has given away, as a library of messages would count them.
  std::int64_t sent = 0;

  void broadcast(std::span<std::byte> bytes) override {
    own_ = bytes;
    all_are_here();
    if (number_ > 0) copy(team_.members[0]->own_, bytes);
    all_are_here();
  }
  void gather(std::span<const std::byte> own, const std::vector<std::size_t>& bytes_of, std::span<std::byte> all,
              bool to_all) override {
    own_ = own;
    sent += std::ssize(own);
    all_are_here();
    for (std::size_t r = 0, place = 0; (to_all || number_ == 0) && r < bytes_of.size(); place += bytes_of[r++])
      copy(team_.members[r]->own_, all.subspan(place, bytes_of[r]));
    all_are_here();
  }
  void exchange(std::span<const RankMessage> messages) override {
    messages_ = messages;
    all_are_here();
    for (const RankMessage& mine : messages) {
      sent += std::ssize(mine.sent);
      for (const RankMessage& theirs : team_.members[mine.rank]->messages_) {
        if (theirs.rank == number_) copy(theirs.sent, mine.received);
      }
    }
    all_are_here();
  }
  std::vector<std::int32_t> cut(const TileGraph& tiles) const override {  // as bad as can be: one after the other
    std::vector<std::int32_t> part;
    for (std::size_t t = 0; t < tiles.work.size(); ++t) part.push_back(static_cast<std::int32_t>(t) % count());
    return part;
  }

 private:
  void all_are_here() { team_.barrier.arrive_and_wait(); }
  void copy(std::span<const std::byte> from, std::span<std::byte> to) const {
    if (from.size() != to.size()) throw std::logic_error("a message of another length than expected");
    if (to.empty()) return;
    if (team_.reaches_cuda) {
      MockSpace::copy(to.data(), from.data(), to.size());
    } else {
      std::memcpy(to.data(), from.data(), to.size());
    }
  }

  Team& team_;
  int number_;
  std::uint64_t program_ = 1;
  std::span<const std::byte> own_;
  std::span<const RankMessage> messages_;
};

/// Runs use(ranks) of rank 0 on this thread, and others(ranks) of the others, each on one.
template <class Use, class Others>
auto on_ranks(int count, const Partition& partition, const Use& use, const Others& others, bool reaches_cuda = false) {
  ThreadRanks::Team team(count);
  team.reaches_cuda = reaches_cuda;
  std::vector<std::jthread> threads;
  for (int rank = 1; rank < count; ++rank) {
    threads.emplace_back([&, rank] {
      ThreadRanks ranks(team, rank, partition);
      others(ranks);
    });
  }
  ThreadRanks first(team, 0, partition);
  return use(first);
}

/// use(solver) of rank 0, which the others follow. read: a state that all begin with; empty: none; worth: numbers from
/// which on loops of contact are shared, where nothing is said all of them.
template <class S, class Use>
auto solved_on(int count, const Partition& partition, const Scene& scene, const Use& use,
               const StateBytes& read = StateBytes(), std::int64_t worth = 0) {
  const auto begin = [&](Solver<S>& solver) {
    if (read.empty()) return;
    StateArchive archive = StateArchive::reading({read.data(), read.size()});
    solver.persist(archive);
  };
  return on_ranks(
      count, partition,
      [&](ThreadRanks& ranks) {
        ranks.worth_a_message = worth;
        Solver<S> solver(scene, &ranks);
        begin(solver);
        return use(solver);
      },
      [&](ThreadRanks& ranks) {
        DefaultExecutionSpace::set_concurrency(1);
        ranks.worth_a_message = worth;
        Solver<S> solver(scene, &ranks);
        begin(solver);
        solver.follow_rank_0();
      });
}

}  // namespace pinball::test
