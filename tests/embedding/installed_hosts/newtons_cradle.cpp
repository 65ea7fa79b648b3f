// A host in C++ with its own mesh and time loop: the five bars of data/scenes/newtons_cradle.toml, each ten cubes of
// edge 1 in a row, of which the first strikes the second, and so on. A bar is what a row of springs is: along each of
// its four edges a spring per element. All that belongs to a node lies in one structure. Prints what compare.py
// compares.
#include <array>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <pinball/contact/embedded_contact.hpp>
#include <vector>

namespace {

constexpr int bars = 5, elements_of_bar = 10, layers = elements_of_bar + 1;
constexpr double modulus = 100.0, density = 1.0, gap = 0.05, end_time = 12.0;
constexpr double dt = 0.05;  // half of h / c
constexpr int steps = 240;

struct Node {
  std::array<double, 3> position{}, velocity{}, force{};
};
static_assert(sizeof(Node) == 9 * sizeof(double));

struct Mesh {
  std::vector<Node> nodes;
  std::vector<double> masses;
  std::vector<std::array<std::int64_t, 8>> elements;
  std::vector<std::int32_t> bar_of_element;
  std::vector<double> bulk_moduli;

  Mesh() : nodes(bars * layers * 4), masses(nodes.size(), 0.0) {
    for (int bar = 0; bar < bars; ++bar) {
      for (int layer = 0; layer < layers; ++layer) {
        for (int corner = 0; corner < 4; ++corner) {
          Node& node = nodes[static_cast<std::size_t>((bar * layers + layer) * 4 + corner)];
          node.position = {bar * (elements_of_bar + gap) + layer, corner == 1 || corner == 2 ? 1.0 : 0.0,
                           corner >= 2 ? 1.0 : 0.0};
          node.velocity[0] = bar == 0 ? 0.1 : 0.0;
        }
      }
      for (int i = 0; i < elements_of_bar; ++i) {
        std::array<std::int64_t, 8> corners{};
        for (std::size_t corner = 0; corner < 8; ++corner) {
          corners[corner] = (bar * layers + i) * 4 + static_cast<std::int64_t>(corner);
          masses[static_cast<std::size_t>(corners[corner])] += density / 8;
        }
        elements.push_back(corners);
        bar_of_element.push_back(bar);
        bulk_moduli.push_back(modulus / 3);  // without Poisson effect
      }
    }
  }

  /// Forces of the springs along x; returns their energy.
  double add_spring_forces() {
    constexpr double stiffness = modulus / 4;
    double energy = 0;
    for (const auto& corners : elements) {
      for (std::size_t edge = 0; edge < 4; ++edge) {
        Node& left = nodes[static_cast<std::size_t>(corners[edge])];
        Node& right = nodes[static_cast<std::size_t>(corners[edge + 4])];
        const double stretch = right.position[0] - left.position[0] - 1.0;
        left.force[0] += stiffness * stretch;
        right.force[0] -= stiffness * stretch;
        energy += stiffness * stretch * stretch / 2;
      }
    }
    return energy;
  }

  /// Of the velocities half a step before t_n and after it: what it changes by is the work of the forces, exactly.
  double kinetic_energy(double step) const {
    double energy = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        const double v = nodes[i].velocity[k];
        energy += v * (masses[i] * v + nodes[i].force[k] * step) / 2;
      }
    }
    return energy;
  }
  double momentum(std::size_t first, std::size_t last) const {
    double sum = 0;
    for (std::size_t i = first; i < last; ++i) sum += masses[i] * nodes[i].velocity[0];
    return sum;
  }
};

// [create]
pinball::EmbeddedContact contact_of(const Mesh& mesh) {
  pinball_contact_options options = pinball::contact_options();
  options.enforcement = PINBALL_CONTACT_LAGRANGE;
  options.index = PINBALL_CONTACT_INT64;
  options.radius_factor = 0.8059959770082347;  // (pi/6)^(1/3): balls touch where the faces of the bars touch
  options.self = 0;

  pinball_contact_mesh contact_mesh = pinball::contact_mesh();
  contact_mesh.node_count = static_cast<std::int64_t>(mesh.nodes.size());
  contact_mesh.mass = mesh.masses.data();
  contact_mesh.element_count = static_cast<std::int64_t>(mesh.elements.size());
  contact_mesh.corners = mesh.elements.data();
  contact_mesh.body = mesh.bar_of_element.data();
  contact_mesh.bulk_modulus = mesh.bulk_moduli.data();
  return {options, contact_mesh, pinball::interleaved(mesh.nodes[0].position.data(), 9)};
}
// [create]

void run() {
  Mesh mesh;
  std::printf("momentum_initial %.17g\n", mesh.momentum(0, mesh.nodes.size()));
  std::printf("energy_initial %.17g\n", mesh.kinetic_energy(0));

  pinball::EmbeddedContact contact = contact_of(mesh);
  // [loop]
  pinball_contact_arrays arrays = pinball::contact_arrays();
  arrays.position = pinball::interleaved(mesh.nodes[0].position.data(), 9);
  arrays.velocity = pinball::interleaved(mesh.nodes[0].velocity.data(), 9);
  arrays.force = pinball::interleaved_sums(mesh.nodes[0].force.data(), 9);

  double total_energy = 0;
  pinball_contact_result result{};
  for (int step = 0; step <= steps; ++step) {
    // Velocities belong to the middle of a step: the first and the last acceleration are over half a step.
    const double before = step == 0 ? 0 : dt, after = step == steps ? 0 : dt;

    for (Node& node : mesh.nodes) node.force.fill(0);
    total_energy = mesh.add_spring_forces();
    contact.update(arrays, before);
    result = contact.add_forces(arrays, after);
    total_energy += mesh.kinetic_energy(before) + result.stored + result.dissipated;
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
      Node& node = mesh.nodes[i];
      for (std::size_t k = 0; k < 3; ++k) {
        node.velocity[k] += node.force[k] / mesh.masses[i] * (before + after) / 2;
        node.position[k] += node.velocity[k] * after;
      }
    }
  }
  // [loop]

  std::printf("momentum_final %.17g\n", mesh.momentum(0, mesh.nodes.size()));
  std::printf("energy_final %.17g\n", total_energy);
  std::printf("contact_dissipated %.17g\n", result.dissipated);
  const std::size_t nodes_of_bar = layers * 4;
  for (std::size_t bar = 0; bar < bars; ++bar) {
    const double momentum = mesh.momentum(bar * nodes_of_bar, (bar + 1) * nodes_of_bar);
    std::printf("velocity_bar%zu %.17g\n", bar + 1, momentum / (elements_of_bar * density));
  }
}

}  // namespace

int main() {
  static_assert(steps * dt == end_time);
  try {
    run();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
