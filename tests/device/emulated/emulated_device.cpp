#include "emulated_device.hpp"

#include <setjmp.h>
#include <sys/mman.h>
#include <ucontext.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <mutex>
#include <new>
#include <numeric>
#include <random>
#include <vector>

#include <kernels/exec/mock_space.hpp>

namespace pinball::emulated {

Coordinates coordinates{};

namespace {

[[noreturn]] void stop(const char* what) {
  std::fprintf(stderr, "emulated device: %s\n", what);
  std::abort();
}

constexpr std::size_t page = 4096;
std::size_t whole_pages(std::size_t bytes) { return (std::max<std::size_t>(bytes, 1) + page - 1) / page * page; }

void* map_pages(std::size_t bytes) {
  void* const memory =
      mmap(nullptr, whole_pages(bytes), PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (memory == MAP_FAILED) throw std::bad_alloc();
  return memory;
}

/// The threads of a block: each has a stack of its own, and goes on where it waited.
class Threads {
 public:
  static Threads& instance() {
    static Threads& threads = *new Threads;
    return threads;
  }
  Threads() {
    const char* const asked = std::getenv("PINBALL_EMULATED_ORDER");
    if (asked == nullptr || std::strcmp(asked, "forward") == 0) return;
    const bool reverse = std::strcmp(asked, "reverse") == 0;
    set_order(reverse ? Order::reverse : Order::shuffled, static_cast<std::uint32_t>(std::atoi(asked)));
  }

  void run_block(unsigned threads, Kernel kernel, const void* parameters) {
    grow(threads);
    kernel_ = kernel;
    parameters_ = parameters;
    for (unsigned t = 0; t < threads; ++t) fibers_[t]->done = false;
    std::vector<unsigned> turns(threads);
    for (unsigned left = threads; left > 0;) {
      order_turns(turns);
      unsigned waiting = 0;
      for (const unsigned t : turns) {
        if (fibers_[t]->done) continue;
        resume(t);
        if (fibers_[t]->done) {
          --left;
        } else {
          ++waiting;
        }
      }
      if (waiting > 0 && waiting < threads) stop("a barrier that not all threads of a block reach");
    }
  }

  /// By the thread that runs.
  static void wait_for_others() {
    Threads& self = *running_;
    Fiber& fiber = *self.fibers_[self.current_];
    if (_setjmp(fiber.place) == 0) _longjmp(self.host_, 1);
  }

  template <class Number>
  void order_turns(std::vector<Number>& turns) {
    std::iota(turns.begin(), turns.end(), Number(0));
    if (order_ == Order::reverse) std::reverse(turns.begin(), turns.end());
    if (order_ == Order::shuffled) std::shuffle(turns.begin(), turns.end(), random_);
  }
  void set_order(Order order, std::uint32_t seed) {
    order_ = order;
    random_.seed(seed);
  }

 private:
  struct Fiber {
    jmp_buf place;
    ucontext_t start;
    bool begun = false, done = false;
  };
  static constexpr std::size_t stack = std::size_t(256) << 10;

  void grow(unsigned threads) {
    while (fibers_.size() < threads) fibers_.push_back(new Fiber);
  }

  static void fiber_main() {
    for (;;) {
      Threads& self = *running_;
      self.kernel_(self.parameters_);
      Fiber& fiber = *self.fibers_[self.current_];
      fiber.done = true;
      if (_setjmp(fiber.place) == 0) _longjmp(self.host_, 1);
    }
  }

  void resume(unsigned t) {
    running_ = this;
    current_ = t;
    coordinates.thread = {t, 0, 0};
    Fiber& fiber = *fibers_[t];
    if (_setjmp(host_) != 0) return;
    if (fiber.begun) _longjmp(fiber.place, 1);
    fiber.begun = true;
    getcontext(&fiber.start);
    fiber.start.uc_stack.ss_sp = map_pages(stack);
    fiber.start.uc_stack.ss_size = stack;
    fiber.start.uc_link = nullptr;
    makecontext(&fiber.start, fiber_main, 0);
    setcontext(&fiber.start);
  }

  inline static Threads* running_ = nullptr;
  std::vector<Fiber*> fibers_;
  jmp_buf host_;
  unsigned current_ = 0;
  Kernel kernel_ = nullptr;
  const void* parameters_ = nullptr;
  Order order_ = Order::forward;
  std::mt19937 random_;
};

struct Launch {
  unsigned blocks, threads;
  Kernel kernel;
  const void* parameters;
};

/// Memory that is given out: bytes by first address.
class Pieces {
 public:
  void add(const void* memory, std::size_t bytes) {
    bytes_[address_of(memory)] = bytes;
    lowest_ = std::min(lowest_, address_of(memory));
    highest_ = std::max(highest_, address_of(memory) + bytes);
  }
  std::size_t take(const void* memory) {
    const auto piece = bytes_.find(address_of(memory));
    if (piece == bytes_.end()) stop("memory is released that is not given out");
    const std::size_t bytes = piece->second;
    bytes_.erase(piece);
    return bytes;
  }
  /// Whether an address lies between what was given out, or at its end.
  bool spans(const void* memory) const { return lowest_ <= address_of(memory) && address_of(memory) <= highest_; }
  bool have(const void* memory, std::size_t bytes) const {
    const auto after = bytes_.upper_bound(address_of(memory));
    return after != bytes_.begin() && address_of(memory) + bytes <= std::prev(after)->first + std::prev(after)->second;
  }

 private:
  static std::uintptr_t address_of(const void* memory) { return reinterpret_cast<std::uintptr_t>(memory); }
  std::map<std::uintptr_t, std::size_t> bytes_;
  std::uintptr_t lowest_ = UINTPTR_MAX, highest_ = 0;
};

/// What waits to be run, and memory that is given out.
struct Device {
  static constexpr std::size_t parameter_room = std::size_t(1) << 20;
  std::vector<Launch> launches;
  char* parameters = static_cast<char*>(map_pages(parameter_room));
  std::size_t parameters_used = 0;
  Pieces memory, pinned;
  std::recursive_mutex turn;

  static Device& instance() {
    static Device& device = *new Device;  // arrays with static lifetime may be gone last
    return device;
  }
};

/// Whether a number is an address of something of the host: of a page that is there and is none of the device's. No
/// number of a kernel is taken for one: as a double it is denormal, as two integers the second is one of 32 thousand or
/// less and the first happens to complete it.
bool is_address_of_host(const void* word) {
  const auto address = reinterpret_cast<std::uintptr_t>(word);
  if (address < std::uintptr_t(1) << 32 || address >= std::uintptr_t(1) << 47) return false;
  const Device& device = Device::instance();
  if (device.memory.spans(word) || device.pinned.have(word, 0)) return false;
  unsigned char is_in_memory = 0;
  return mincore(reinterpret_cast<void*>(address / page * page), page, &is_in_memory) == 0;
}

void run(const Launch& launch) {
  const MockMemory::OpenHere while_it_runs;
  coordinates.threads = {launch.threads, 1, 1};
  coordinates.blocks = {launch.blocks, 1, 1};
  std::vector<unsigned> blocks(launch.blocks);
  Threads::instance().order_turns(blocks);
  for (const unsigned block : blocks) {
    coordinates.block = {block, 0, 0};
    Threads::instance().run_block(launch.threads, launch.kernel, launch.parameters);
  }
}

Counts& counts_here() {
  static thread_local Counts counts;
  return counts;
}

void run_all() {
  Device& device = Device::instance();
  std::vector<Launch> launches;
  std::swap(launches, device.launches);
  for (const Launch& launch : launches) run(launch);
  device.parameters_used = 0;
}

}  // namespace

void set_order(Order order, std::uint32_t seed) {
  const Turn turn;
  run_all();
  Threads::instance().set_order(order, seed);
}

void* parameters_of_launch(std::size_t bytes) {
  Device& device = Device::instance();
  const std::size_t room = (bytes + 63) / 64 * 64;
  if (device.parameters_used + room > Device::parameter_room) run_all();
  void* const memory = device.parameters + device.parameters_used;
  device.parameters_used += room;
  return memory;
}

void check_parameter(const void* parameter, std::size_t bytes) {
  for (std::size_t at = 0; at + sizeof(void*) <= bytes; at += sizeof(void*)) {
    const void* word = nullptr;
    std::memcpy(&word, static_cast<const char*>(parameter) + at, sizeof(void*));
    if (is_address_of_host(word)) stop("a kernel is given an address of the host");
  }
}

void launch(unsigned blocks, unsigned threads, Kernel kernel, const void* parameters) {
  if (blocks == 0 || threads == 0) stop("a launch of no threads");
  Device::instance().launches.push_back({blocks, threads, kernel, parameters});
  ++counts_here().launches;
}

void barrier() { Threads::wait_for_others(); }

void wait() {
  const Turn turn;
  run_all();
  ++counts_here().waits;
}

Counts counts() { return counts_here(); }

Turn::Turn() { Device::instance().turn.lock(); }
Turn::~Turn() { Device::instance().turn.unlock(); }

void* allocate(std::size_t bytes) {
  const Turn turn;
  const std::size_t room = whole_pages(bytes);
  void* const memory = MockSpace::allocate(room);
  const MockMemory::OpenHere while_it_is_filled;
  std::memset(memory, 0xff, room);
  Device::instance().memory.add(memory, room);
  return memory;
}

void release(void* memory) {
  if (memory == nullptr) return;
  const Turn turn;
  run_all();
  MockSpace::release(memory, Device::instance().memory.take(memory));
}

void copy(void* to, const void* from, std::size_t bytes, Copy kind) {
  const Turn turn;
  run_all();
  Device& device = Device::instance();
  if (bytes == 0) return;
  ++counts_here().waits;
  if (kind == Copy::host_to_device) counts_here().to_device += static_cast<std::int64_t>(bytes);
  if (kind == Copy::device_to_host) counts_here().to_host += static_cast<std::int64_t>(bytes);
  if (device.memory.have(to, bytes) != (kind != Copy::device_to_host) ||
      device.memory.have(from, bytes) != (kind != Copy::host_to_device)) {
    stop("a copy of the wrong kind, or beyond the end of memory");
  }
  const MockMemory::OpenHere while_it_copies;
  std::memcpy(to, from, bytes);
}

void set(void* to, int byte, std::size_t bytes) {
  const Turn turn;
  run_all();
  if (bytes == 0) return;
  if (!Device::instance().memory.have(to, bytes)) stop("memory is set that the device has not given out");
  const MockMemory::OpenHere while_it_is_set;
  std::memset(to, byte, bytes);
}

void* allocate_pinned(std::size_t bytes) {
  const Turn turn;
  void* const memory = map_pages(bytes);
  std::memset(memory, 0xff, whole_pages(bytes));
  Device::instance().pinned.add(memory, whole_pages(bytes));
  return memory;
}

void release_pinned(void* memory) {
  if (memory == nullptr) return;
  const Turn turn;
  run_all();
  munmap(memory, Device::instance().pinned.take(memory));
}

}  // namespace pinball::emulated
