// Contact search and contact forces alone, on pinballs in the order of a mesh cut into tiles, as the solver has them.
// Arguments: pinballs per side of the packing, or of each layer; threads. `per_pinball` and `per_pair` are seconds per
// pinball and per listed pair; `neighbours` is the mean number per pinball, as a check, `in_contact` the part of the
// listed pairs that are in contact.

#include <benchmark/benchmark.h>
#include <omp.h>

#include <cmath>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

#include <solver/base/tile_size.hpp>
#include <solver/contact/pinball/pair_forces.hpp>
#include <solver/contact/pinball/pair_list.hpp>
#include <solver/model/ordering.hpp>

#ifdef PINBALL_HAS_NANOFLANN
#include "nanoflann_pairs.hpp"
#endif

namespace pinball::bench {

namespace {

using S = double;

struct Cloud {
  std::vector<Point> centres;
  std::vector<int> body;
  double radius;
  Point extent;  ///< of an element
};

/// Close-packed balls that touch, each moved by up to 0.1 along each axis; every one is a body of its own.
Cloud close_packed(int side) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> jitter(-0.1, 0.1);
  Cloud cloud{{}, {}, 0.5, {1, std::sqrt(0.75), std::sqrt(2.0 / 3.0)}};
  for (int k = 0; k < side; ++k) {
    for (int j = 0; j < side; ++j) {
      for (int i = 0; i < side; ++i) {
        const double x = i + 0.5 * ((j + k) % 2), y = std::sqrt(0.75) * (j + (k % 2) / 3.0),
                     z = std::sqrt(2.0 / 3.0) * k;
        cloud.centres.push_back({x + jitter(random), y + jitter(random), z + jitter(random)});
        cloud.body.push_back(static_cast<int>(cloud.body.size()));
      }
    }
  }
  return cloud;
}

/// Two layers of unit elements, two bodies, whose centres lie in planes 0.5 apart.
Cloud facing_layers(int side) {
  Cloud cloud{{}, {}, 0.69, {1, 1, 1}};
  for (int layer = 0; layer < 2; ++layer) {
    for (int j = 0; j < side; ++j) {
      for (int i = 0; i < side; ++i) {
        cloud.centres.push_back({i + 0.5 * layer, j + 0.5 * layer, 0.5 * layer});
        cloud.body.push_back(layer);
      }
    }
  }
  return cloud;
}

/// The order in which a model has elements: in tiles. The layers come one after the other, as bodies of two materials.
std::vector<std::int32_t> order_of(const Cloud& cloud) {
  const std::vector<Point> extents(cloud.centres.size(), cloud.extent);
  const auto count = static_cast<std::int32_t>(cloud.centres.size());
  const bool layers = cloud.body.back() == 1;
  const std::int64_t size = tile_size(count);
  std::vector<std::int32_t> order;
  for (std::int32_t begin = 0; begin < count;) {
    const std::int32_t end = layers ? begin + count / 2 : count;
    std::vector<std::int32_t> elements(static_cast<std::size_t>(end - begin));
    std::iota(elements.begin(), elements.end(), begin);
    const TileOrder tiles = compact_tiles(cloud.centres, extents, std::move(elements), size, native_width<S>);
    order.insert(order.end(), tiles.order.begin(), tiles.order.end());
    begin = end;
  }
  return order;
}

struct Pinballs {
  SurfacePinballs<S> all;
  MovingBalls<S> balls;
  std::vector<Point> centres;

  explicit Pinballs(const Cloud& cloud) : balls(static_cast<std::int32_t>(cloud.centres.size())) {
    all.count = balls.count();
    for (const std::int32_t i : order_of(cloud)) {
      const Point& c = cloud.centres[static_cast<std::size_t>(i)];
      const auto p = static_cast<std::int32_t>(centres.size());
      centres.push_back(c);
      all.slot.push_back(p);
      all.body.push_back(cloud.body[static_cast<std::size_t>(i)]);
      std::array<std::int32_t, 8> corners{};
      for (int n = 0; n < 8; ++n) corners[static_cast<std::size_t>(n)] = 8 * i + n;
      all.corners.push_back(corners);
      all.reference.push_back({static_cast<float>(c[0]), static_cast<float>(c[1]), static_cast<float>(c[2]),
                               static_cast<float>(cloud.radius)});
      all.radius.push_back(cloud.radius);
      balls.set(p, c, {0, 0, 0}, cloud.radius);
    }
  }
};

/// Records of the pinballs that have neighbours; without normals, so that the line of centres decides.
struct Records {
  Array<S> centre, velocity, outward, two_sided;

  Records(const Pinballs& pinballs, const std::vector<std::int32_t>& listed)
      : centre(4 * listed.size()), velocity(centre.size()), outward(centre.size()), two_sided(centre.size()) {
    for (std::size_t p = 0; p < listed.size(); ++p) {
      const auto i = static_cast<std::size_t>(listed[p]);
      for (std::size_t k = 0; k < 3; ++k) centre[4 * p + k] = pinballs.centres[i][k];
      centre[4 * p + 3] = pinballs.all.radius[i];
      velocity[4 * p + 3] = 1;
      outward[4 * p + 3] = 1;
    }
  }
};

using benchmark::Counter;

/// Seconds per item of one iteration.
Counter each(double items) { return {items, Counter::kIsIterationInvariantRate | Counter::kInvert}; }

void count_neighbours(benchmark::State& state, const PairList<S>& list, double pinballs) {
  state.counters["pinballs"] = pinballs;
  state.counters["neighbours"] = 2.0 * static_cast<double>(list.pairs()) / pinballs;
}

void list_by(ContactSearch how, benchmark::State& state, Cloud (*cloud)(int)) {
  omp_set_num_threads(static_cast<int>(state.range(1)));
  const Pinballs pinballs(cloud(static_cast<int>(state.range(0))));
  PairList<S> list;
  for (auto _ : state) list.build(pinballs.all, pinballs.balls, true, how);
  count_neighbours(state, list, pinballs.all.count);
  state.counters["per_pinball"] = each(pinballs.all.count);
}

void list_from_nothing(benchmark::State& state, Cloud (*cloud)(int)) { list_by(ContactSearch::tree, state, cloud); }
void list_by_hash(benchmark::State& state, Cloud (*cloud)(int)) { list_by(ContactSearch::hash, state, cloud); }

#ifdef PINBALL_HAS_NANOFLANN
/// The same pairs by k-d trees, again for balls at rest and of one size. Third argument: points in a leaf.
void list_by_nanoflann(benchmark::State& state, Cloud (*cloud)(int)) {
  const auto threads = static_cast<int>(state.range(1));
  omp_set_num_threads(threads);
  const Cloud balls = cloud(static_cast<int>(state.range(0)));
  const Pinballs pinballs(balls);
  NanoflannPairs pairs(pinballs.centres, pinballs.all.body, static_cast<int>(state.range(2)));
  for (auto _ : state) pairs.build(2 * balls.radius, threads);
  PairList<S> list;
  list.build(pinballs.all, pinballs.balls, true);
  if (list.pairs() != pairs.pairs()) state.SkipWithError("its pairs are not those of the list");
  count_neighbours(state, list, pinballs.all.count);
  state.counters["per_pinball"] = each(pinballs.all.count);
}
#endif

/// radius: part of that for which the list is built that the balls have.
void forces_of_part(benchmark::State& state, Cloud (*cloud)(int), double radius) {
  omp_set_num_threads(static_cast<int>(state.range(1)));
  const Pinballs pinballs(cloud(static_cast<int>(state.range(0))));
  PairList<S> list;
  list.build(pinballs.all, pinballs.balls, true);
  Records records(pinballs, list.listed());
  for (std::size_t r = 3; r < records.centre.size(); r += 4) records.centre[r] *= radius;
  const PinballView<S> view{records.centre.data(), records.velocity.data(), records.outward.data(),
                            records.two_sided.data()};
  Array<S> force(4 * static_cast<std::size_t>(list.size()));
  PairForces<S> pair_forces;
  PairSums<S> sums;
  for (auto _ : state)
    sums = pair_forces.compute(view, {1.0, 0.1}, {list.listed_pairs(), list.pieces()}, S(1e-3), force.data());
  state.counters["in_contact"] = static_cast<double>(sums.pairs) / static_cast<double>(list.pairs());
  count_neighbours(state, list, pinballs.all.count);
  state.counters["per_pair"] = each(static_cast<double>(list.pairs()));
}

void forces(benchmark::State& state, Cloud (*cloud)(int)) { forces_of_part(state, cloud, 1); }
/// As in a scene, whose lists are for a time to come: about a tenth of the pairs are in contact.
void forces_of_tenth(benchmark::State& state, Cloud (*cloud)(int)) { forces_of_part(state, cloud, 0.87); }

void sizes(benchmark::internal::Benchmark* b, int large) {
  b->ArgNames({"per_side", "threads"})->Unit(benchmark::kMillisecond)->UseRealTime();
  for (const int per_side : {30, large}) {
    for (const int threads : {1, 2}) b->Args({per_side, threads});
  }
}
void packing(benchmark::internal::Benchmark* b) { sizes(b, 100); }
void layers(benchmark::internal::Benchmark* b) { sizes(b, 707); }

BENCHMARK_CAPTURE(list_from_nothing, close_packed, close_packed)->Apply(packing);
BENCHMARK_CAPTURE(list_from_nothing, facing_layers, facing_layers)->Apply(layers);
BENCHMARK_CAPTURE(list_by_hash, close_packed, close_packed)->Apply(packing);
BENCHMARK_CAPTURE(list_by_hash, facing_layers, facing_layers)->Apply(layers);
#ifdef PINBALL_HAS_NANOFLANN
void nanoflann_sizes(benchmark::internal::Benchmark* b, int large) {
  b->ArgNames({"per_side", "threads", "leaf"})->Unit(benchmark::kMillisecond)->UseRealTime();
  b->ArgsProduct({{30, large}, {1, 2}, {5, 10, 20, 40}});  // 10 is the library's own choice
}
BENCHMARK_CAPTURE(list_by_nanoflann, close_packed, close_packed)->Apply([](auto* b) { nanoflann_sizes(b, 100); });
BENCHMARK_CAPTURE(list_by_nanoflann, facing_layers, facing_layers)->Apply([](auto* b) { nanoflann_sizes(b, 707); });
#endif
BENCHMARK_CAPTURE(forces, close_packed, close_packed)->Apply(packing);
BENCHMARK_CAPTURE(forces, facing_layers, facing_layers)->Apply(layers);
BENCHMARK_CAPTURE(forces_of_tenth, close_packed, close_packed)->Apply(packing);

}  // namespace

}  // namespace pinball::bench

BENCHMARK_MAIN();
