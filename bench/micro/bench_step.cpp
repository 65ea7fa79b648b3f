// Whole steps of data/scenes/block.toml: element steps per second, and what part that is of the bound that the memory
// bandwidth measured in the same run sets. Arguments: elements per side, threads. With --large also 200^3 elements,
// which need 4 GB.

#include <benchmark/benchmark.h>
#include <fmt/core.h>
#include <omp.h>

#include <map>
#include <string_view>

#include <solver/step/solver.hpp>

#include "block_scene.hpp"
#include "ceilings_context.hpp"
#include "traffic.hpp"

namespace pinball::bench {

namespace {

double bandwidth(int threads) {
  static std::map<int, double> measured;
  if (measured.count(threads) == 0) measured[threads] = memory_bandwidth(threads);
  return measured[threads];
}

template <class S>
void whole_steps(benchmark::State& state) {
  const auto per_side = static_cast<int>(state.range(0));
  const auto threads = static_cast<int>(state.range(1));
  omp_set_num_threads(threads);
  Solver<S> solver(block_scene(per_side));
  for (int i = 0; i < 3; ++i) solver.step();
  for (auto _ : state) solver.step();
  const auto elements = static_cast<double>(solver.element_count());
  // Node arrays are swept by the elements and again by the integration.
  const double bytes = element_traffic(solver.model()) + integration_traffic(solver.model());
  using benchmark::Counter;
  state.counters["element_steps"] = Counter(elements, Counter::kIsIterationInvariantRate);
  state.counters["bytes"] = Counter(bytes, Counter::kIsIterationInvariantRate);
  state.counters["bytes_per_element"] = Counter(bytes / elements);
  // Fraction of the bandwidth bound: bytes moved per second over what the triad of this run moves.
  state.counters["of_bandwidth"] = Counter(bytes / bandwidth(threads), Counter::kIsIterationInvariantRate);
}

void add_benchmark(const char* name, void (*run)(benchmark::State&), int per_side) {
  auto* added = benchmark::RegisterBenchmark(name, run);
  added->ArgNames({"per_side", "threads"})->Unit(benchmark::kMillisecond)->UseRealTime();
  for (const int threads : {1, 2}) added->Args({per_side, threads});
  // A large mesh takes as long to build as many of its steps: it is not built again to find out how many to time.
  constexpr int element_steps = 40'000'000;
  if (per_side > 100) added->Iterations(element_steps / (per_side * per_side * per_side));
}

void add_benchmarks(bool large) {
  for (const int per_side : {14, 30, 60, 120, 200}) {
    if (per_side == 200 && !large) continue;
    add_benchmark("whole_steps<double>", whole_steps<double>, per_side);
    add_benchmark("whole_steps<float>", whole_steps<float>, per_side);
  }
}

}  // namespace

}  // namespace pinball::bench

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  const bool large = argc == 2 && std::string_view(argv[1]) == "--large";
  if (large) argc = 1;
  pinball::bench::add_benchmarks(large);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  pinball::bench::add_ceilings_to_context({1, 2});
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
