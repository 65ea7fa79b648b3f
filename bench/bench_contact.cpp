// Contact search and contact forces alone, on pinballs in the order of a space-filling curve, as the solver has them.
// Arguments: pinballs per side of the packing, or of each layer; threads. Times are per pinball and per listed pair
// (each pair counted once); `neighbours` is the mean number per pinball, as a check.

#include <benchmark/benchmark.h>
#include <omp.h>

#include <cmath>
#include <pinball/kernels/contact_force.hpp>
#include <pinball/kernels/exec.hpp>
#include <pinball/solver/neighbour_list.hpp>
#include <pinball/solver/ordering.hpp>
#include <random>
#include <vector>

namespace pinball::bench {

namespace {

using S = double;

struct Cloud {
  std::vector<Point> centres;
  std::vector<int> body;
  double radius;
};

/// Close-packed balls that touch, each moved by up to 0.1 along each axis; every one is a body of its own.
Cloud close_packed(int side) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> jitter(-0.1, 0.1);
  Cloud cloud{{}, {}, 0.5};
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
  Cloud cloud{{}, {}, 0.69};
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

struct Pinballs {
  SurfacePinballs<S> all;
  MovingBalls<S> balls;
  std::vector<Point> centres;

  explicit Pinballs(const Cloud& cloud) : balls(static_cast<std::int32_t>(cloud.centres.size())) {
    all.count = balls.count();
    for (const std::int32_t i : space_filling_order(cloud.centres)) {
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
  AlignedArray<S> centre, velocity, outward, two_sided;

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

void count_neighbours(benchmark::State& state, const NeighbourList<S>& list, double pinballs) {
  state.counters["pinballs"] = pinballs;
  state.counters["neighbours"] = 2.0 * static_cast<double>(list.pairs()) / pinballs;
}

void list_from_nothing(benchmark::State& state, Cloud (*cloud)(int)) {
  omp_set_num_threads(static_cast<int>(state.range(1)));
  const Pinballs pinballs(cloud(static_cast<int>(state.range(0))));
  NeighbourList<S> list;
  for (auto _ : state) list.build(pinballs.all, pinballs.balls, true);
  count_neighbours(state, list, pinballs.all.count);
  state.counters["per_pinball"] = each(pinballs.all.count);
}

void forces(benchmark::State& state, Cloud (*cloud)(int)) {
  using T = Pack<S, native_width<S>>;
  omp_set_num_threads(static_cast<int>(state.range(1)));
  const Pinballs pinballs(cloud(static_cast<int>(state.range(0))));
  NeighbourList<S> list;
  list.build(pinballs.all, pinballs.balls, true);
  const Records records(pinballs, list.listed());
  const PinballView<S> view{records.centre.data(), records.velocity.data(), records.outward.data(),
                            records.two_sided.data()};
  std::vector<PinballForce<S>> force(static_cast<std::size_t>(list.size()));
  for (auto _ : state) {
    parallel_for("contact forces", RangePolicy<>{0, list.size()}, [&](std::int64_t i) {
      const auto p = static_cast<std::int32_t>(i);
      force[static_cast<std::size_t>(i)] = pinball_force<T>(view, {1.0, 0.1}, p, list.neighbours(p), list.count(p),
                                                            list.offsets(p), list.stored(p), S(1e-3));
    });
    benchmark::DoNotOptimize(force.data());
  }
  count_neighbours(state, list, pinballs.all.count);
  state.counters["per_pair"] = each(static_cast<double>(list.pairs()));
}

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
BENCHMARK_CAPTURE(forces, close_packed, close_packed)->Apply(packing);
BENCHMARK_CAPTURE(forces, facing_layers, facing_layers)->Apply(layers);

}  // namespace

}  // namespace pinball::bench

BENCHMARK_MAIN();
