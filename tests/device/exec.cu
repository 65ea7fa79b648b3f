// The execution layer on an accelerator: what tests of it on the host's spaces call (tests/exec), with the same functors.
// It is compiled with the kernels; as a program of its own it runs them and compares with Serial.
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <vector>

#include <kernels/exec.hpp>
#include <tests/support/record.hpp>

namespace {

using namespace pinball;
#if defined(__HIPCC__)
using Device = Hip;
#else
using Device = Cuda;
#endif
template <class T>
using DeviceArray = Array<T, Device::memory_space>;

/// Its sums have two blocks on a processor.
struct RecordInTwoBlocks : test::RecordOf {
  static constexpr int least_blocks = 2;
};

struct Fill {
  double* to;
  PINBALL_FUNCTION void operator()(std::int64_t i) const { to[i] = 1.0 / double(i * i % 1001 + 1) - 0.01; }
};

/// Sums of plain numbers, of 8 and of 4 bytes.
struct Adds {
  const double* value;
  PINBALL_FUNCTION void operator()(std::int64_t i, double& sum) const { sum += value[i]; }
};
struct Counts {
  const double* value;
  PINBALL_FUNCTION void operator()(std::int64_t i, std::int32_t& count) const { count += value[i] > 0 ? 1 : 0; }
};

struct Listed {
  const double* value;
  std::int32_t* list;
  PINBALL_FUNCTION void operator()(std::int64_t i, std::int32_t& update, bool final) const {
    if (!(value[i] > 0)) return;
    if (final) list[update] = static_cast<std::int32_t>(i);
    ++update;
  }
};

/// What a space makes of a range, on the host.
struct Found {
  std::vector<double> values;
  test::Record record;
  double sum = 0;
  std::int32_t positive = 0, total = 0;
  std::vector<std::int32_t> list;
  bool operator==(const Found&) const = default;
};

template <class Space>
Found found_by(std::int64_t count) {
  using Memory = typename Space::memory_space;
  const auto size = static_cast<std::size_t>(count);
  Array<double, Memory> values(size);
  Array<std::int32_t, Memory> list(size);
  Found found{std::vector<double>(size), {}, 0, 0, 0, std::vector<std::int32_t>(size)};
  parallel_for("fill", RangePolicy<Space>{0, count}, Fill{values.data()});
  fence<Space>();
  parallel_reduce("record", RangePolicy<Space>{0, count}, RecordInTwoBlocks{{values.data()}}, found.record);
  parallel_reduce("sum", RangePolicy<Space>{0, count}, Adds{values.data()}, found.sum);
  parallel_reduce("count", RangePolicy<Space>{0, count}, Counts{values.data()}, found.positive);
  parallel_scan("list", RangePolicy<Space>{0, count}, Listed{values.data(), list.data()}, found.total);
  deep_copy(found.values.data(), values);
  deep_copy(found.list.data(), list);
  return found;
}

bool copies_go_round() {
  Array<double> host(1000);
  for (std::size_t i = 0; i < 1000; ++i) host[i] = double(i);
  DeviceArray<double> first(1000), second(1000);
  Array<double, MockSpace> third(1000);
  deep_copy(first, host);
  deep_copy(second, first);
  deep_copy(third, second);
  Array<double> back = create_mirror(third);
  deep_copy(back, third);
  bool same = true;
  for (std::size_t i = 0; i < 1000; ++i) same = same && back[i] == host[i];
  return same;
}

}  // namespace

int main() {
  int wrong = 0;
  try {
    // The last: pieces of several rounds, not all of as many, and more threads than devices hold at a time.
    for (const std::int64_t count : {0, 1, 127, 128, 129, 5000, 131'072, 131'073, 700'001}) {
      const Found device = found_by<Device>(count);
      const bool same = device == found_by<Serial>(count), again = device == found_by<Device>(count);
      std::printf("%lld: %s the host, %s again\n", static_cast<long long>(count), same ? "as" : "NOT as",
                  again ? "the same" : "OTHER BITS");
      wrong += !same + !again;
    }
    const bool copied = copies_go_round();
    std::printf("copies: %s\n", copied ? "right" : "WRONG");
    wrong += !copied;
  } catch (const std::exception& error) {
    std::printf("%s\n", error.what());
    return 2;
  }
  return wrong == 0 ? 0 : 1;
}
