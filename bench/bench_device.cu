// Whole steps of a block of n x n x n elements on a GPU, without contact: element steps per second, and what part that
// is of the memory's bandwidth, which a copy in the same run measures. Builds with nvcc alone, on a machine without
// anything else:
//
//     nvcc -std=c++20 -O3 -arch=native -I. bench/bench_device.cu -o bench_device
//     ./bench_device [n ...]                            default: 60 120 216
//     ./bench_device --steps COUNT [n ...]              so many steps, for a sanitizer; no copy is measured
//     ./bench_device --bytes                            only the bytes below, without a GPU
//
// bench/device does this, and makes tables of it.
//
// Each line: precision, n, steps, seconds, element steps per second, bytes of an element and step where every array is
// read and written once, and the rate of those bytes over that of the copy.
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include <solver/device/space_step.hpp>

using namespace pinball;

namespace {

constexpr ElementFeatures elastic{false, false, true, HourglassKind::stiffness};
constexpr ElementFeatures viscous{true, true, true, HourglassKind::viscous};
constexpr ElementFeatures everything{true, true, true, HourglassKind::stiffness};

bool same(const ElementFeatures& a, const ElementFeatures& b) {
  return a.plastic == b.plastic && a.hourglass == b.hourglass;
}

}  // namespace

namespace pinball {

// Only what is measured is compiled.
template <class S, class Space>
ElementKernel<S> choose_linear_kernel(const ElementFeatures& f) {
  const UpdatesElementsIn<S, Space> kernels;
  return same(f, elastic)   ? kernels.template of<elastic>()
         : same(f, viscous) ? kernels.template of<viscous>()
                            : kernels.template of<everything>();
}
template <class S, class Space>
ElementKernel<S> choose_general_kernel(const ElementFeatures&) {
  return nullptr;
}
template <class S, class Space>
ElementKernel<S> tetrahedron_kernel() {
  return nullptr;
}

}  // namespace pinball

namespace {

struct Box {
  int n;
  /// Elements in bricks of 8 x 8 x 8, so that neighbours share nodes while these are in the caches.
  std::vector<std::array<int, 3>> elements() const {
    std::vector<std::array<int, 3>> all;
    constexpr int brick = 8;
    for (int z = 0; z < n; z += brick) {
      for (int y = 0; y < n; y += brick) {
        for (int x = 0; x < n; x += brick) {
          for (int k = z; k < std::min(n, z + brick); ++k) {
            for (int j = y; j < std::min(n, y + brick); ++j) {
              for (int i = x; i < std::min(n, x + brick); ++i) all.push_back({i, j, k});
            }
          }
        }
      }
    }
    return all;
  }
};

template <class S>
struct Block {
  DeviceMesh<S> mesh;
  DeviceState<S> state;
};

/// Steel in inches, pounds and seconds, of elements with edges of 0.1; every node has a velocity of its own.
template <class S>
Block<S> make_block(int n, const ElementFeatures& features) {
  constexpr double h = 0.1, density = 7.4e-4, young = 3e7, poisson = 0.3;
  const auto elements = Box{n}.elements();
  const std::int64_t count = static_cast<std::int64_t>(elements.size()), m = n + 1;
  Block<S> block;
  DeviceMesh<S>& mesh = block.mesh;
  mesh.nodes = static_cast<std::int32_t>(m * m * m);
  mesh.places = (count + device_row - 1) / device_row * device_row;

  ElementConstants<S> constants{};
  const double mu = young / (2 * (1 + poisson)), lambda = young * poisson / ((1 + poisson) * (1 - 2 * poisson));
  constants.material.lambda = S(lambda);
  constants.material.mu = S(mu);
  constants.material.density = S(density);
  constants.material.sound_speed = S(std::sqrt((lambda + 2 * mu) / density));
  constants.material.yield_stress = S(5e4);
  constants.material.plastic_modulus = S(1e5);
  constants.material.ultimate_stress = S(1e30);
  constants.failure.plastic_strain = S(10);
  constants.hourglass.coefficient = S(0.1);
  constants.viscosity.linear = S(0.06);
  constants.viscosity.quadratic = S(1.2);
  constants.hourglass.modulus = S(0.05 * (lambda + 2 * mu));
  constants.specific_volume = S(1 / density);
  mesh.parts.push_back({features, constants, 0, mesh.places});

  mesh.corner = Array<std::int32_t>(8 * mesh.places);
  block.state.mass = Array<S>(mesh.places);
  std::vector<std::int32_t> number(m * m * m, -1);
  std::int32_t next = 0;
  block.state.position = Array<S>(4 * static_cast<std::size_t>(mesh.nodes));
  block.state.velocity = Array<S>(4 * static_cast<std::size_t>(mesh.nodes));
  mesh.node_mass = Array<double>(mesh.nodes);
  mesh.first_of_node = Array<std::uint32_t>(static_cast<std::size_t>(mesh.nodes) + 1);
  constexpr int dx[8] = {0, 1, 1, 0, 0, 1, 1, 0}, dy[8] = {0, 0, 1, 1, 0, 0, 1, 1}, dz[8] = {0, 0, 0, 0, 1, 1, 1, 1};
  for (std::int64_t e = 0; e < count; ++e) {
    block.state.mass[e] = S(density * h * h * h);
    for (int c = 0; c < 8; ++c) {
      const int at[3] = {elements[e][0] + dx[c], elements[e][1] + dy[c], elements[e][2] + dz[c]};
      std::int32_t& node = number[(at[2] * m + at[1]) * m + at[0]];
      if (node < 0) {
        node = next++;
        for (int k = 0; k < 3; ++k) {
          block.state.position[4 * node + k] = S(h * at[k]);
          block.state.velocity[4 * node + k] = S(0.01 * ((node * 2654435761u >> (8 * k)) % 256));
        }
      }
      mesh.corner[place_in_rows<device_row>(e, 8) + c * device_row] = node;
      mesh.node_mass[node] += density * h * h * h / 8;
      ++mesh.first_of_node[node + 1];
    }
  }
  for (std::int32_t i = 0; i < mesh.nodes; ++i) mesh.first_of_node[i + 1] += mesh.first_of_node[i];
  mesh.corners_of_node = Array<std::uint32_t>(8 * count);
  std::vector<std::uint32_t> place(mesh.first_of_node.data(), mesh.first_of_node.data() + mesh.nodes);
  for (std::int64_t e = 0; e < count; ++e) {
    for (int c = 0; c < 8; ++c) {
      const std::int32_t node = mesh.corner[place_in_rows<device_row>(e, 8) + c * device_row];
      mesh.corners_of_node[place[node]++] = static_cast<std::uint32_t>(8 * e + c);
    }
  }
  mesh.inverse_mass = Array<S>(mesh.nodes);
  for (std::int32_t i = 0; i < mesh.nodes; ++i) mesh.inverse_mass[i] = S(1 / mesh.node_mass[i]);

  block.state.stress = Array<S>(6 * mesh.places);
  if (features.plastic) block.state.plastic_strain = Array<S>(mesh.places);
  if (stores_hourglass_modes(features.hourglass)) block.state.hourglass_state = Array<S>(12 * mesh.places);
  if (features.bulk_viscosity) block.state.viscous_stress = Array<S>(mesh.places);
  if (features.erosion) block.state.internal_energy = Array<S>(mesh.places);
  return block;
}

constexpr int all_steps = 1 << 30;

double seconds() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

/// Of an element and a step: all arrays once, the nodes' as if there were one for each element.
template <class S>
double bytes_of(const ElementFeatures& f) {
  const double read_and_written = 6 + (f.plastic ? 1 : 0) + (stores_hourglass_modes(f.hourglass) ? 12 : 0) +
                                  (f.bulk_viscosity ? 1 : 0) + (f.erosion ? 1 : 0);
  const double element = sizeof(S) * (1 + 2 * read_and_written + 24) + 8 * 4 + sizeof(S) * 8;  // with x and v gathered
  const double node = sizeof(S) * (24 + 1 + 2 * 8) + 8 + 9 * 4;                                // with the sums
  return element + node;
}

struct alignas(32) Four {
  double numbers[4];
};

struct Copies {
  const Four* from;
  Four* to;
  PINBALL_FUNCTION void operator()(std::int64_t i) const { to[i] = from[i]; }
};

/// Bytes read and written per second by a copy of 2 x 4 GB.
double copy_rate() {
  constexpr std::size_t count = std::size_t(1) << 27;
  Array<Four, Cuda::memory_space> from(count), to(count);
  const auto copy = [&] {
    parallel_for("copy", RangePolicy<Cuda>{0, static_cast<std::int64_t>(count)}, Copies{from.data(), to.data()});
  };
  copy();
  fence<Cuda>();
  const double start = seconds();
  for (int i = 0; i < 10; ++i) copy();
  fence<Cuda>();
  return 10 * 2.0 * static_cast<double>(from.bytes()) / (seconds() - start);
}

template <class S>
void measure(const char* precision, const char* what, int n, int most_steps, const ElementFeatures& features,
             double bandwidth) {
  const Block<S> block = make_block<S>(n, features);
  SpaceStep<S, Cuda> step(block.mesh);
  step.write(block.state);
  const double elements = double(n) * n * n, dt = 0.3 * 0.1 / 2.3e5;
  const int steps = std::min(most_steps, std::max(20, static_cast<int>(2e9 / elements)));
  const auto run = [&](int count) {
    double energy = 0;
    for (int i = 0; i < count; ++i) {
      energy += step.update_elements({S(dt)}).internal;
      step.integrate({dt, dt});
    }
    return energy;
  };
  run(5);
  fence<Cuda>();
  const double start = seconds();
  const double energy = run(steps);
  fence<Cuda>();
  const double time = seconds() - start, rate = elements * steps / time, bytes = bytes_of<S>(features);
  std::printf("%-7s %-10s %4d %7d %8.3f s  %8.3f G/s  %5.0f B  %5.1f %% of the copy's rate   (energy %.6e)\n",
              precision, what, n, steps, time, 1e-9 * rate, bytes, 100 * bytes * rate / bandwidth, energy);
}

/// Calls measured(precision, its zero, name of the features, features) for each kind of step.
template <class Measured>
void for_each_kind(const Measured& measured) {
  measured("double", 0.0, "everything", everything);
  measured("double", 0.0, "viscous", viscous);
  measured("double", 0.0, "elastic", elastic);
  measured("float", 0.0F, "everything", everything);
  measured("float", 0.0F, "viscous", viscous);
  measured("float", 0.0F, "elastic", elastic);
}

}  // namespace

int main(int count, char** words) {
  std::vector<int> sizes;
  int most_steps = all_steps;
  for (int i = 1; i < count; ++i) {
    const std::string word = words[i];
    if (word == "--bytes") {
      for_each_kind([](const char* precision, auto zero, const char* what, const ElementFeatures& features) {
        std::printf("%s %s %.0f\n", precision, what, bytes_of<decltype(zero)>(features));
      });
      return 0;
    }
    if (word == "--steps" && i + 1 < count) {
      most_steps = std::atoi(words[++i]);
    } else {
      sizes.push_back(std::atoi(words[i]));
    }
  }
  if (sizes.empty()) sizes = {60, 120, 216};
  try {
    const double bandwidth = most_steps == all_steps ? copy_rate() : NAN;
    std::printf("copy: %.0f GB/s\n", 1e-9 * bandwidth);
    for (const int n : sizes) {
      for_each_kind([&](const char* precision, auto zero, const char* what, const ElementFeatures& features) {
        measure<decltype(zero)>(precision, what, n, most_steps, features, bandwidth);
      });
    }
  } catch (const std::exception& failure) {
    std::fprintf(stderr, "bench_device: %s\n", failure.what());
    return 2;
  }
  return 0;
}
