// What the solver does beside what it could do instead, on the mesh of data/scenes/block.toml: how corner forces come
// to the nodes (coloured tiles, an array of corner forces that nodes gather from, atomic additions), and how element
// state lies in memory (a pack's components one after the other, or an array for each component). Only that part of a
// step: forces are made from the stresses by a few additions. Arguments: elements per side, threads.

#include <benchmark/benchmark.h>
#include <omp.h>

#include <cmath>

#include <kernels/exec.hpp>
#include <kernels/gather.hpp>
#include <solver/model/model.hpp>

#include "block_scene.hpp"

namespace pinball::bench {

namespace {

using S = double;
constexpr int W = native_width<S>;
using T = Pack<S, W>;

Model<S> block(int per_side) {
  Model<S> model = build_model<S>(block_scene(per_side));
  for (std::int64_t slot = 0; slot < model.elements.slots; ++slot) {
    if (model.element_of_slot[static_cast<std::size_t>(slot)] < 0) continue;  // padding has none
    for (int c = 0; c < 6; ++c) {
      model.elements.stress[model.elements.at(slot, c, 6)] = std::sin(static_cast<S>(slot % 1000 + c));
    }
  }
  return model;
}

/// Forces on the corners of a pack: no physics, but of all six stresses, and zero in sum.
void corner_forces(const Model<S>& model, std::int64_t pack, Vec3<T> (&force)[8]) {
  const S* stress = model.elements.stress.in<S>().data() + pack * 6 * W;
  const auto component = [stress](int c) { return load<T>(stress + c * W); };
  const Vec3<T> normal{component(0), component(1), component(2)}, shear{component(3), component(4), component(5)};
  for (int i = 0; i < 4; ++i) {
    force[i] = T(S(i + 1)) * normal + shear;
    force[7 - i] = T(-1) * force[i];
  }
}

/// Calls work(pack) for all packs, tiles of one colour side by side.
template <class Work>
void for_each_pack_coloured(const Model<S>& model, const Work& work) {
  const Colouring& colours = model.tile_colours;
  parallel_for_coloured("packs", DefaultExecutionSpace{}, colours.colour_offsets.data(),
                        static_cast<std::int32_t>(colours.colour_offsets.size()) - 1, colours.items.data(),
                        [&](std::int32_t tile) {
                          const auto t = static_cast<std::size_t>(tile);
                          for (std::int64_t p = model.tile_packs[t]; p < model.tile_packs[t + 1]; ++p) work(p);
                        });
}

/// The same without a care for colours.
template <class Work>
void for_each_pack(const Model<S>& model, const Work& work) {
  parallel_for("packs", RangePolicy<>{0, model.elements.slots / W}, work);
}

/// The way of the solver: lane after lane, no two threads at one node.
class Coloured {
 public:
  explicit Coloured(Model<S>& model) : model_(model) {}
  void assemble() {
    for_each_pack_coloured(model_, [&](std::int64_t pack) {
      Vec3<T> force[8];
      corner_forces(model_, pack, force);
      const std::int32_t* corner = model_.elements.corner.data() + pack * 8 * W;
      for (int i = 0; i < 8; ++i) {
        add_to_records(model_.nodes.force.data(), corner + i * W, force[i].x, force[i].y, force[i].z, T(0));
      }
    });
  }

 private:
  Model<S>& model_;
};

/// Corner forces into an array, from which each node sums up its own (LULESH does so with several threads).
class CornerGather {
 public:
  explicit CornerGather(Model<S>& model)
      : model_(model), corner_force_(24 * static_cast<std::size_t>(model.elements.slots)) {
    const auto slots = static_cast<std::size_t>(model.elements.slots);
    offsets_.assign(static_cast<std::size_t>(model.nodes.count) + 1, 0);
    const auto for_each_corner = [&](const auto& visit) {
      for (std::size_t slot = 0; slot < slots; ++slot) {
        if (model.element_of_slot[slot] < 0) continue;
        for (int i = 0; i < 8; ++i) {
          const auto s = static_cast<std::int64_t>(slot);
          visit(static_cast<std::size_t>(model.elements.corner[model.elements.at(s, i, 8)]),
                static_cast<std::int32_t>(model.elements.at(s, 3 * i, 24)));
        }
      }
    };
    for_each_corner([&](std::size_t node, std::int32_t) { ++offsets_[node + 1]; });
    for (std::size_t n = 0; n + 1 < offsets_.size(); ++n) offsets_[n + 1] += offsets_[n];
    places_.resize(static_cast<std::size_t>(offsets_.back()));
    std::vector<std::int32_t> next(offsets_.begin(), offsets_.end() - 1);
    for_each_corner(
        [&](std::size_t node, std::int32_t place) { places_[static_cast<std::size_t>(next[node]++)] = place; });
  }
  void assemble() {
    for_each_pack(model_, [&](std::int64_t pack) {
      Vec3<T> force[8];
      corner_forces(model_, pack, force);
      S* out = corner_force_.data() + pack * 24 * W;
      for (int i = 0; i < 8; ++i, out += 3 * W) {
        store(force[i].x, out);
        store(force[i].y, out + W);
        store(force[i].z, out + 2 * W);
      }
    });
    parallel_for("gather", RangePolicy<>{0, model_.nodes.count}, [&](std::int64_t n) {
      S sum[3] = {0, 0, 0};
      const auto node = static_cast<std::size_t>(n);
      for (std::int32_t i = offsets_[node]; i < offsets_[node + 1]; ++i) {
        const S* corner = corner_force_.data() + places_[static_cast<std::size_t>(i)];
        for (int k = 0; k < 3; ++k) sum[k] += corner[k * W];
      }
      for (int k = 0; k < 3; ++k) model_.nodes.force.data()[4 * n + k] += sum[k];
    });
  }

 private:
  Model<S>& model_;
  Array<S> corner_force_;                       ///< packs of 24 components
  std::vector<std::int32_t> offsets_, places_;  ///< of each node: its corners in corner_force_
};

class Atomic {
 public:
  explicit Atomic(Model<S>& model) : model_(model) {}
  void assemble() {
    for_each_pack(model_, [&](std::int64_t pack) {
      Vec3<T> force[8];
      corner_forces(model_, pack, force);
      const std::int32_t* corner = model_.elements.corner.data() + pack * 8 * W;
      for (int i = 0; i < 8; ++i) {
        for (int l = 0; l < W; ++l) {
          if (model_.element_of_slot[static_cast<std::size_t>(pack * W + l)] < 0) continue;
          S* f = model_.nodes.force.data() + 4 * static_cast<std::int64_t>(corner[i * W + l]);
          const S components[3] = {lane(force[i].x, l), lane(force[i].y, l), lane(force[i].z, l)};
          for (int k = 0; k < 3; ++k) {
#pragma omp atomic
            f[k] += components[k];
          }
        }
      }
    });
  }

 private:
  Model<S>& model_;
};

/// Sum of the absolute forces, as a check that all do the same.
double sum_of_forces(const Model<S>& model) {
  double sum = 0;
  for (std::size_t n = 0; n < static_cast<std::size_t>(model.nodes.count); ++n) {
    for (std::size_t k = 0; k < 3; ++k) sum += std::abs(model.nodes.force[4 * n + k]);
  }
  return sum;
}

template <class Method>
double forces_of(Model<S>& model) {
  model.nodes.force.reset(model.nodes.force.size());
  Method(model).assemble();
  return sum_of_forces(model);
}

template <class Method>
void assembly(benchmark::State& state) {
  omp_set_num_threads(static_cast<int>(state.range(1)));
  Model<S> model = block(static_cast<int>(state.range(0)));
  const double own = forces_of<Method>(model), coloured = forces_of<Coloured>(model);
  if (!(std::abs(own - coloured) <= 1e-12 * coloured)) state.SkipWithError("its forces are not those of the others");
  Method method(model);
  for (auto _ : state) method.assemble();
  state.counters["elements"] =
      benchmark::Counter(static_cast<double>(model.element_count()), benchmark::Counter::kIsIterationInvariantRate);
}

constexpr int components = 20;  // stress, plastic strain, hourglass forces, bulk viscosity

enum class Sweep {
  pack_after_pack,      ///< components of a pack lie one after the other
  streaming,            ///< the same, written past the caches
  array_per_component,  ///< arrays at different places of a page, so that they do not fight for one set of the cache
};

/// Reads and writes all components of all elements once.
template <Sweep sweep>
void state_sweep(benchmark::State& state) {
  omp_set_num_threads(static_cast<int>(state.range(1)));
  const std::int64_t side = state.range(0), packs = (side * side * side + W - 1) / W;
  const std::int64_t apart = packs * W + 17 * W;  // between two arrays
  constexpr bool together = sweep != Sweep::array_per_component;
  Array<S> array(static_cast<std::size_t>(components * apart));
  for (auto _ : state) {
    parallel_for("sweep", RangePolicy<>{0, packs}, [&](std::int64_t pack) {
      for (int c = 0; c < components; ++c) {
        S* place = array.data() + (together ? (pack * components + c) * W : c * apart + pack * W);
        const T value = T(S(0.5)) * load<T>(place) + T(S(c));
#if defined(__AVX512F__)
        if constexpr (sweep == Sweep::streaming) {
          _mm512_stream_pd(place, static_cast<__m512d>(value));
          continue;
        }
#endif
        store(value, place);
      }
    });
  }
  state.counters["elements"] =
      benchmark::Counter(static_cast<double>(packs * W), benchmark::Counter::kIsIterationInvariantRate);
}

void sizes(benchmark::internal::Benchmark* b) {
  b->ArgNames({"per_side", "threads"})->Unit(benchmark::kMillisecond)->UseRealTime();
  b->ArgsProduct({{30, 60, 120}, {1, 2}});
}

BENCHMARK_TEMPLATE(assembly, Coloured)->Apply(sizes);
BENCHMARK_TEMPLATE(assembly, CornerGather)->Apply(sizes);
BENCHMARK_TEMPLATE(assembly, Atomic)->Apply(sizes);
BENCHMARK_TEMPLATE(state_sweep, Sweep::pack_after_pack)->Apply(sizes);
#if defined(__AVX512F__)
BENCHMARK_TEMPLATE(state_sweep, Sweep::streaming)->Apply(sizes);
#endif
BENCHMARK_TEMPLATE(state_sweep, Sweep::array_per_component)->Apply(sizes);

}  // namespace

}  // namespace pinball::bench

BENCHMARK_MAIN();
