// What contact costs a host that embeds it (contact.h), beside the solver's own contact stage on the same states: two
// plates that slide over each other (sliding_plates.hpp). In each step all of them work on the state that a solver has
// reached, one after the other with emptied caches, each first in every third step: the solver's stage, embedded
// contact on records of four, and on interleaved x, y, z. Counters: seconds per step, and the ratios of the two
// embedded ones to the solver's. Arguments: elements along a side of the plates, threads.

#include <benchmark/benchmark.h>
#include <omp.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <memory>
#include <utility>
#include <vector>

#include <solver/contact/embedded_contact.hpp>
#include <solver/step/solver.hpp>

#include "sliding_plates.hpp"

namespace pinball::bench {

namespace {

using S = double;

/// What a host hands over of a model; elements in the order of the store.
struct HostMeshOf {
  std::vector<std::int32_t> corners, body;
  std::vector<S> bulk_modulus;

  explicit HostMeshOf(const Model<S>& model) {
    const ModelSurface<S> of_model(model);
    for (std::size_t slot = 0; slot < model.element_of_slot.size(); ++slot) {
      if (model.element_of_slot[slot] < 0) continue;
      const ContactElement element = of_model.element(static_cast<std::int64_t>(slot));
      corners.insert(corners.end(), element.corners.begin(), element.corners.end());
      body.push_back(element.body);
      bulk_modulus.push_back(element.bulk_modulus);
    }
  }
  EmbeddedContact contact(const Model<S>& model) const {
    pinball_contact_mesh mesh = contact_mesh();
    mesh.node_count = model.nodes.count;
    mesh.mass = model.node_mass.data();
    mesh.element_count = static_cast<std::int64_t>(body.size());
    mesh.corners = corners.data();
    mesh.body = body.data();
    mesh.bulk_modulus = bulk_modulus.data();
    return {contact_options(), mesh, interleaved(model.nodes.position.data(), 4)};
  }
};

/// Goes over more memory than caches hold, as the internal forces do before contact.
void empty_caches(std::vector<double>& sweep) {
  for (double& s : sweep) s += 1;
  benchmark::ClobberMemory();
}

template <class Work>
double seconds_of(const Work& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// Positions, velocities and forces as x, y, z of one node after the other.
struct Interleaved {
  std::array<std::vector<S>, 3> arrays;

  explicit Interleaved(std::size_t nodes) {
    for (std::vector<S>& array : arrays) array.resize(3 * nodes);
  }
  void take(const NodeStore<S>& nodes) {
    for (std::size_t n = 0; n < static_cast<std::size_t>(nodes.count); ++n) {
      for (std::size_t k = 0; k < 3; ++k) {
        arrays[0][3 * n + k] = nodes.position[4 * n + k];
        arrays[1][3 * n + k] = nodes.velocity[4 * n + k];
      }
    }
    std::fill(arrays[2].begin(), arrays[2].end(), 0);
  }
  pinball_contact_arrays host() {
    pinball_contact_arrays host = contact_arrays();
    host.position = interleaved(arrays[0].data());
    host.velocity = interleaved(arrays[1].data());
    host.force = interleaved_sums(arrays[2].data());
    return host;
  }
};

pinball_contact_arrays records_of(NodeStore<S>& nodes) {
  pinball_contact_arrays host = contact_arrays();
  host.position = interleaved(nodes.position.data(), 4);
  host.velocity = interleaved(nodes.velocity.data(), 4);
  host.force = interleaved_sums(nodes.force.data(), 4);
  host.force_records = 1;
  return host;
}

void embedding(benchmark::State& state) {
  const auto per_side = static_cast<int>(state.range(0));
  omp_set_num_threads(static_cast<int>(state.range(1)));
  const Scene scene = sliding_plates(per_side, ContactMethod::pinball);
  Solver<S> solver(scene);
  Model<S> model = build_model<S>(scene);  // where the state of the solver is worked on
  const HostMeshOf mesh(model);
  const std::unique_ptr<ContactAlgorithm<S>> own = make_model_contact(model);
  EmbeddedContact with_records = mesh.contact(model), with_vectors = mesh.contact(model);
  Interleaved vectors(model.node_mass.size());
  std::array<std::vector<double>, 3> seconds;
  std::vector<double> sweep(std::size_t{8} << 20, 0.0);
  double dt = 0;
  std::int64_t pairs[3] = {0, 0, 0}, pairs_seen = 0;
  int step = 0;
  const std::vector<TileResult<S>> no_erosion(static_cast<std::size_t>(model.tile_count()));
  const auto clear_forces = [&] { std::fill_n(model.nodes.force.data(), model.nodes.force.size(), S(0)); };
  const auto work = [&](int which) {
    if (which == 0) {
      const ModelSurface<S> of_model(model);
      own->update_surface(of_model, eroded_slots(model, no_erosion));
      own->search(of_model, dt);
      ContactWork springs = own->before_step(of_model, dt);
      own->add_forces(of_model, springs);
      pairs[0] = springs.pairs;
    } else {
      EmbeddedContact& contact = which == 1 ? with_records : with_vectors;
      const pinball_contact_arrays host = which == 1 ? records_of(model.nodes) : vectors.host();
      contact.update(host, dt);
      pairs[which] = contact.add_forces(host, dt).pairs;
    }
  };
  for (auto _ : state) {
    std::copy_n(std::as_const(solver).model().nodes.position.data(), model.nodes.position.size(),
                model.nodes.position.data());
    std::copy_n(std::as_const(solver).model().nodes.velocity.data(), model.nodes.velocity.size(),
                model.nodes.velocity.data());
    vectors.take(model.nodes);
    for (int i = 0; i < 3; ++i) {
      const int which = (step + i) % 3;
      clear_forces();
      empty_caches(sweep);
      const double time = seconds_of([&] { work(which); });
      if (step >= 4) seconds[static_cast<std::size_t>(which)].push_back(time);
    }
    pairs_seen += pairs[0];
    if (pairs[1] != pairs[0] || pairs[2] != pairs[0]) state.SkipWithError("they differ in what touches");
    solver.step();
    dt = solver.dt();
    ++step;
  }
  const auto mean = [&seconds](std::size_t which) {
    double sum = 0;
    for (const double s : seconds[which]) sum += s;
    return sum / static_cast<double>(seconds[which].size());
  };
  // Of each step, so that one that was disturbed does not decide.
  const auto median_ratio = [&seconds](std::size_t which) {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < seconds[0].size(); ++i) ratios.push_back(seconds[which][i] / seconds[0][i]);
    std::nth_element(ratios.begin(), ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2), ratios.end());
    return ratios[ratios.size() / 2];
  };
  using benchmark::Counter;
  state.counters["pairs"] = Counter(static_cast<double>(pairs_seen) / step);
  state.counters["searches"] = Counter(static_cast<double>(own->searches()));
  state.counters["seconds_solver"] = Counter(mean(0));
  state.counters["seconds_records"] = Counter(mean(1));
  state.counters["seconds_interleaved"] = Counter(mean(2));
  state.counters["ratio_records"] = Counter(median_ratio(1));
  state.counters["ratio_interleaved"] = Counter(median_ratio(2));
}

// Lists last for 20 steps at most: several searches, and each of the three first in as many steps.
BENCHMARK(embedding)
    ->ArgNames({"per_side", "threads"})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->Iterations(64)
    ->Args({30, 1})
    ->Args({120, 1})
    ->Args({120, 2});

}  // namespace

}  // namespace pinball::bench

BENCHMARK_MAIN();
