// The stages of the step alone, from the timers of the step: two plates of two layers of elements, all of them at a
// surface, pressed on each other while one slides over the other, so that the pinballs or slave nodes between the
// plates are in the lists and in contact, and the lists have to be built anew every few steps. The same program built
// with other presets gives the speed-up over one lane. Arguments: elements along a side of the plates, threads.

#include <benchmark/benchmark.h>
#include <fmt/core.h>
#include <omp.h>

#include <array>
#include <cmath>
#include <string>

#include <solver/contact/slideline/slideline_algorithm.hpp>
#include <solver/step/report.hpp>

#include "ceilings_context.hpp"
#include "sliding_plates.hpp"
#include "traffic.hpp"

namespace pinball::bench {

namespace {

using benchmark::Counter;
using S = double;

/// What each stage has to do and moves at least, and how full its packs are. The search is two stages: whether the
/// lists still hold is looked at in every step; building them is told for one search.
void count_work(benchmark::State& state, const Solver<S>& solver, ContactMethod method) {
  const Model<S>& model = solver.model();
  const auto elements = static_cast<double>(model.element_count());
  const auto nodes = static_cast<double>(model.nodes.count);
  const double touched_nodes = nodes * 2 / 3;  // of the layers of elements that face the other plate
  const auto surface = static_cast<double>(solver.contact()->surface_elements());
  const ListSize listed = solver.contact()->listed();
  const auto owners = static_cast<double>(listed.owners);
  const auto entries = static_cast<double>(listed.entries), places = static_cast<double>(listed.places);
  const auto faces = static_cast<double>(exposed_faces(model));
  const auto count = [&state](const std::string& name, double items, double bytes, double lanes) {
    state.counters["items_" + name] = Counter(items);
    state.counters["bytes_" + name] = Counter(bytes);
    if (lanes > 0) state.counters["lanes_" + name] = Counter(lanes);
  };
  const auto full = [](double items) {  // packs of consecutive items
    const double width = native_width<S>;
    return items / (std::ceil(items / width) * width);
  };
  count("internal_forces", elements, element_traffic(model), elements / static_cast<double>(model.elements.slots));
  count("integration", nodes, integration_traffic(model), 0);
  if (method == ContactMethod::pinball) {
    // Every element of the plates has a pinball, so that all nodes are watched.
    count("list_check", nodes, watching_traffic<S>(nodes), full(nodes));
    count("list_building", surface, pinball_search_traffic<S>(surface, nodes, owners, places), 0);
    count("pinballs", owners, pinball_traffic<S>(owners, touched_nodes), full(owners));
    count("contact_forces", entries, pair_traffic<S>(places, owners), entries / places);
    count("contact_scatter", owners, scatter_traffic<S>(owners, touched_nodes), 0);
  } else {
    count("list_building", owners, slideline_search_traffic<S>(faces, owners, entries), 0);
    const auto& slideline = static_cast<const SlidelineAlgorithm<S>&>(*solver.contact());
    const auto segments = static_cast<double>(slideline.updated_segments());
    count("pinballs", segments, segment_traffic<S>(segments, segments), 1);  // a surface has as many nodes
    count("contact_forces", entries, narrow_traffic<S>(entries, segments, owners), 0);
  }
  state.counters["surface_elements"] = Counter(surface);
  state.counters["listed"] = Counter(owners);
  state.counters["pairs_in_contact"] = Counter(static_cast<double>(solver.counts().pairs()));
}

void stages(benchmark::State& state, ContactMethod method) {
  const auto per_side = static_cast<int>(state.range(0));
  omp_set_num_threads(static_cast<int>(state.range(1)));
  Solver<S> solver(sliding_plates(per_side, method));
  for (int i = 0; i < 4; ++i) solver.step();
  std::array<double, phase_names.size()> before{};
  const auto seconds = [&solver](std::size_t p) { return solver.timers().seconds(static_cast<Phase>(p)); };
  for (std::size_t p = 0; p < before.size(); ++p) before[p] = seconds(p);
  const auto search = static_cast<std::size_t>(Phase::contact_search);
  double building = 0, checking = 0;
  std::int64_t searches = 0;
  for (auto _ : state) {
    const std::int64_t searches_before = solver.contact()->searches();
    const double search_before = seconds(search);
    solver.step();
    const bool built = solver.contact()->searches() != searches_before;
    (built ? building : checking) += seconds(search) - search_before;
    searches += built ? 1 : 0;
  }
  const auto steps = static_cast<double>(state.iterations()), made = static_cast<double>(searches);
  for (std::size_t p = 0; p < before.size(); ++p) {
    state.counters[fmt::format("seconds_{}", phase_names[p])] = Counter((seconds(p) - before[p]) / steps);
  }
  state.counters["searches"] = Counter(made);
  state.counters["seconds_list_building"] = Counter(made > 0 ? building / made : 0);
  state.counters["seconds_list_check"] = Counter(steps > made ? checking / (steps - made) : 0);
  count_work(state, solver, method);
}

void arguments(benchmark::internal::Benchmark* b) {
  b->ArgNames({"per_side", "threads"})->Unit(benchmark::kMillisecond)->UseRealTime();
  b->Iterations(42);  // lists last for 20 steps at most: two searches at least
}

// 236: 222,784 pinballs, half of them between the plates. The slideline takes many times as long.
BENCHMARK_CAPTURE(stages, pinball, ContactMethod::pinball)->Apply(arguments)->Args({30, 1})->Args({236, 1});
BENCHMARK_CAPTURE(stages, slideline, ContactMethod::slideline)->Apply(arguments)->Args({30, 1})->Args({120, 1});

}  // namespace

}  // namespace pinball::bench

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  pinball::bench::add_ceilings_to_context({1});
  benchmark::AddCustomContext("simd_width", std::to_string(pinball::native_width<double>));
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
