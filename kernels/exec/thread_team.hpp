#pragma once

#include <omp.h>
#include <pthread.h>
#include <sched.h>

#include <atomic>
#include <cstdint>
#include <new>

#include "region_failure.hpp"

namespace pinball {

/// Part of the work on a range; `of` is what it is done with.
using RangeWork = void (*)(const void* of, std::int64_t begin, std::int64_t end);

/// Threads that help one thread with its ranges. A range is cut into pieces, of which each thread takes those of its
/// own share first and then what others have left: whoever has no processor at the moment is not waited for, unless it
/// is in the midst of a piece. What waits spins for some microseconds and then sleeps.
///
/// A helper reads the region's members between enter() and leave() alone; they are written while the gate is closed and
/// nobody is inside.
class ThreadCrew {
 public:
  ThreadCrew() = default;
  ~ThreadCrew() {
    ends_.store(true, std::memory_order_relaxed);
    call();
    while (helpers_ != nullptr) {
      Helper* const last = helpers_;
      pthread_join(last->thread, nullptr);
      helpers_ = last->before;
      delete last;
    }
    delete[] shares_;
  }
  ThreadCrew(const ThreadCrew&) = delete;
  ThreadCrew& operator=(const ThreadCrew&) = delete;

  /// Makes it as many threads, the calling one with them. Where the system has no more, fewer do the same work. False:
  /// there is no memory.
  bool grow(int threads) {
    if (threads <= wanted_) return true;
    auto* const shares = new (std::nothrow) Share[static_cast<std::size_t>(threads)];
    if (shares == nullptr) return false;
    delete[] shares_;
    shares_ = shares;
    int number = wanted_;  // where one could not be made before, no other is tried
    const bool complete = helpers_ == nullptr ? wanted_ == 1 : helpers_->number == wanted_ - 1;
    wanted_ = threads;
    while (complete && number < threads && add_helper(number)) ++number;
    return true;
  }

  /// threads: as many shares, no more than it has grown to.
  void run(int threads, std::int64_t begin, std::int64_t end, RangeWork work, const void* of) {
    set_out(threads, begin, end, work, of);
    gate_.store(open, std::memory_order_release);
    call();
    take_from(0);
    close();
    failure_.rethrow();
  }

 private:
  struct alignas(64) Share {
    std::atomic<std::int64_t> next{0};  ///< piece that nobody has taken
    std::int64_t end = 0;
  };
  struct Helper {
    ThreadCrew* crew;
    Helper* before;
    int number;
    std::uint32_t seen;  ///< of signal_
    pthread_t thread;
  };
  static constexpr std::int64_t most_pieces_of_share = 8;
  static constexpr int spins = 1000;  ///< some 10 to 50 microseconds
  static constexpr std::uint32_t open = 1U << 31;

  static void pause() {
#if defined(__x86_64__) || defined(__i386__)
    __builtin_ia32_pause();
#endif
  }
  template <class Done>
  static bool spin_until(const Done& done) {
    for (int i = 0; i < spins; ++i) {
      if (done()) return true;
      pause();
    }
    return false;
  }

  bool add_helper(int number) {
    auto* const helper = new (std::nothrow) Helper{this, helpers_, number, signal_.load(std::memory_order_relaxed), {}};
    if (helper == nullptr) return false;
    const auto main = [](void* given) -> void* {
      const Helper& self = *static_cast<const Helper*>(given);
      self.crew->help(self.number, self.seen);
      return nullptr;
    };
    pthread_attr_t attributes;
    pthread_attr_init(&attributes);
    choose_place(number, attributes);
    const bool made = pthread_create(&helper->thread, &attributes, main, helper) == 0;
    pthread_attr_destroy(&attributes);
    if (made) {
      helpers_ = helper;
    } else {
      delete helper;
    }
    return made;
  }

  /// Where OpenMP binds threads (OMP_PROC_BIND), the calling one is bound already, and helpers would be with it.
  static void choose_place(int number, pthread_attr_t& attributes) {
    if (omp_get_proc_bind() == omp_proc_bind_false || omp_get_num_places() < 1) return;
    const int place = (omp_get_place_num() + number) % omp_get_num_places();
    int processors[CPU_SETSIZE];
    if (place < 0 || omp_get_place_num_procs(place) > CPU_SETSIZE) return;
    omp_get_place_proc_ids(place, processors);
    cpu_set_t set;
    CPU_ZERO(&set);
    for (int i = 0; i < omp_get_place_num_procs(place); ++i) CPU_SET(static_cast<std::size_t>(processors[i]), &set);
    pthread_attr_setaffinity_np(&attributes, sizeof set, &set);
  }

  void set_out(int threads, std::int64_t begin, std::int64_t end, RangeWork work, const void* of) {
    work_ = work;
    of_ = of;
    begin_ = begin;
    count_ = end - begin;
    share_count_ = threads;
    const std::int64_t each = count_ / threads < most_pieces_of_share ? count_ / threads : most_pieces_of_share;
    pieces_ = each * threads;
    for (int s = 0; s < threads; ++s) {
      shares_[s].next.store(each * s, std::memory_order_relaxed);
      shares_[s].end = each * (s + 1);
    }
  }

  /// Tells helpers that there is something new.
  void call() {
    signal_.fetch_add(1, std::memory_order_seq_cst);
    if (sleepers_.load(std::memory_order_seq_cst) > 0) signal_.notify_all();
  }

  /// Waits for those who are inside.
  void close() {
    gate_.fetch_and(~open, std::memory_order_acq_rel);
    if (spin_until([this] { return gate_.load(std::memory_order_acquire) == 0; })) return;
    waits_.store(true, std::memory_order_seq_cst);
    for (std::uint32_t inside = 0; (inside = gate_.load(std::memory_order_seq_cst)) != 0;) gate_.wait(inside);
    waits_.store(false, std::memory_order_relaxed);
  }

  void help(int number, std::uint32_t seen) {
    inside_region() = true;
    for (;;) {
      seen = await_call(seen);
      if (ends_.load(std::memory_order_relaxed)) return;
      if (!enter()) continue;
      if (number < share_count_) take_from(number);
      leave();
    }
  }

  std::uint32_t await_call(std::uint32_t seen) {
    const auto called = [&] { return signal_.load(std::memory_order_acquire) != seen; };
    if (!spin_until(called)) {
      sleepers_.fetch_add(1, std::memory_order_seq_cst);
      while (signal_.load(std::memory_order_seq_cst) == seen) signal_.wait(seen);
      sleepers_.fetch_sub(1, std::memory_order_relaxed);
    }
    return signal_.load(std::memory_order_acquire);
  }

  bool enter() {
    std::uint32_t now = gate_.load(std::memory_order_relaxed);
    while ((now & open) != 0) {
      if (gate_.compare_exchange_weak(now, now + 1, std::memory_order_acq_rel, std::memory_order_relaxed)) return true;
    }
    return false;
  }
  void leave() {
    const bool last = gate_.fetch_sub(1, std::memory_order_seq_cst) == 1;
    if (last && waits_.load(std::memory_order_seq_cst)) gate_.notify_one();
  }

  void take_from(int own) {
    for (int i = 0; i < share_count_; ++i) take(shares_[(own + i) % share_count_]);
  }
  void take(Share& share) {
    while (share.next.load(std::memory_order_relaxed) < share.end) {
      const std::int64_t piece = share.next.fetch_add(1, std::memory_order_relaxed);
      if (piece >= share.end) return;
      failure_.guard(piece, [this, piece] {
        work_(of_, begin_ + count_ * piece / pieces_, begin_ + count_ * (piece + 1) / pieces_);
      });
    }
  }

  friend class ThreadTeam;
  /// Whether the calling thread is at work on a region: one within it is its own alone.
  static bool& inside_region() {
    static thread_local bool inside = false;
    return inside;
  }

  // The region
  RangeWork work_ = nullptr;
  const void* of_ = nullptr;
  std::int64_t begin_ = 0, count_ = 0, pieces_ = 0;
  int share_count_ = 0;
  Share* shares_ = nullptr;
  RegionFailure failure_;

  int wanted_ = 1;
  Helper* helpers_ = nullptr;                         ///< the last one made
  alignas(64) std::atomic<std::uint32_t> signal_{0};  ///< raised by each call
  std::atomic<std::int32_t> sleepers_{0};
  std::atomic<bool> ends_{false};
  alignas(64) std::atomic<std::uint32_t> gate_{0};  ///< helpers inside, and whether others may enter
  std::atomic<bool> waits_{false};                  ///< for the last one to leave
};

/// The crew of a thread, which lives as long as that thread. In a process that was forked off its threads are not
/// there: it gets others.
class ThreadTeam {
 public:
  static ThreadTeam& of_this_thread() {
    static thread_local ThreadTeam team;
    return team;
  }
  ~ThreadTeam() {
    if (forks_ == forks().load(std::memory_order_relaxed)) delete crew_;
    ThreadCrew::inside_region() = true;  // what is destroyed after it works alone
  }
  ThreadTeam(const ThreadTeam&) = delete;
  ThreadTeam& operator=(const ThreadTeam&) = delete;

  /// Calls work(of, ...) for pieces that make up the range, with up to so many threads, and returns when all is done.
  /// Throws what the piece that comes first in the range has thrown.
  [[gnu::noinline]] void run(int threads, std::int64_t begin, std::int64_t end, RangeWork work, const void* of) {
    if (threads > end - begin) threads = static_cast<int>(end - begin);
    bool& inside = ThreadCrew::inside_region();
    if (threads <= 1 || inside || !has_crew(threads)) {
      if (begin < end) work(of, begin, end);
      return;
    }
    const Inside while_it_lives(inside);
    crew_->run(threads, begin, end, work, of);
  }

 private:
  struct Inside {
    explicit Inside(bool& of) : inside(of) { inside = true; }
    ~Inside() { inside = false; }
    Inside(const Inside&) = delete;
    Inside& operator=(const Inside&) = delete;
    bool& inside;
  };

  ThreadTeam() = default;

  bool has_crew(int threads) {
    const std::uint32_t now = forks().load(std::memory_order_relaxed);
    if (forks_ != now) crew_ = nullptr;  // its memory stays: who knows what its threads were doing
    forks_ = now;
    if (crew_ == nullptr) crew_ = new (std::nothrow) ThreadCrew;
    return crew_ != nullptr && crew_->grow(threads);
  }

  /// How often this process and those before it have been forked off.
  static std::atomic<std::uint32_t>& forks() {
    static std::atomic<std::uint32_t> count{0};
    static const int counted =
        pthread_atfork(nullptr, nullptr, [] { forks().fetch_add(1, std::memory_order_relaxed); });
    (void)counted;
    return count;
  }

  ThreadCrew* crew_ = nullptr;
  std::uint32_t forks_ = forks().load(std::memory_order_relaxed);
};

}  // namespace pinball
