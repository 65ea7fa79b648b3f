// The search for pairs of moving boxes alone, by a tree and by a hash, on scenes of one size of boxes, of graded sizes
// and mixed. Arguments: elements per side; threads; how: 0 for what suits the scene, 1 for the tree, 2 for the hash.
// `per_box` is seconds per box; `pairs` those found per box, as a check.

#include <benchmark/benchmark.h>
#include <omp.h>

#include <solver/contact/search/box_pairs.hpp>

#include "search_scenes.hpp"

namespace pinball::bench {

namespace {

void find_pairs(benchmark::State& state, BoxScene (*make)(int)) {
  omp_set_num_threads(static_cast<int>(state.range(1)));
  const BoxScene scene = make(static_cast<int>(state.range(0)));
  MovingBoxes<double> boxes(scene.count());
  for (std::int32_t i = 0; i < scene.count(); ++i) boxes.set(i, scene.boxes[static_cast<std::size_t>(i)]);
  const auto how = static_cast<ContactSearch>(state.range(2));
  const auto wanted = [&scene](std::int32_t first, std::int32_t second) { return scene.wants(first, second); };
  BoxPairs<double> list;
  for (auto _ : state) list.find(boxes, how, wanted);
  const double count = scene.count();
  state.counters["boxes"] = count;
  state.counters["pairs"] = static_cast<double>(list.pairs()) / count;
  using benchmark::Counter;
  state.counters["per_box"] = Counter(count, Counter::kIsIterationInvariantRate | Counter::kInvert);
}

void sizes(benchmark::internal::Benchmark* b) {
  b->ArgNames({"per_side", "threads", "how"})->Unit(benchmark::kMillisecond)->UseRealTime();
  b->ArgsProduct({{30, 200}, {1, 2}, {0, 1, 2}});
}

BENCHMARK_CAPTURE(find_pairs, two_blocks, two_blocks)->Apply(sizes);
BENCHMARK_CAPTURE(find_pairs, two_fast_blocks, two_fast_blocks)->Apply(sizes);
BENCHMARK_CAPTURE(find_pairs, two_flat_blocks, two_flat_blocks)->Apply(sizes);
BENCHMARK_CAPTURE(find_pairs, mixed_blocks, mixed_blocks)->Apply(sizes);
BENCHMARK_CAPTURE(find_pairs, graded, graded)->Apply(sizes);
BENCHMARK_CAPTURE(find_pairs, sorted_cloud, sorted_cloud)->Apply(sizes);
BENCHMARK_CAPTURE(find_pairs, shuffled_cloud, shuffled_cloud)->Apply(sizes);

}  // namespace

}  // namespace pinball::bench

BENCHMARK_MAIN();
