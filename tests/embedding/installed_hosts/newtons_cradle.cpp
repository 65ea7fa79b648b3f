// A host in C++ with its own mesh and time loop: the five bars of data/scenes/newtons_cradle.toml, each ten cubes of
// edge 1 in a row, of which the first strikes the second, and so on. A bar is what a row of springs is: along each of
// its four edges a spring per element. All that belongs to a node lies in one structure. Prints what compare.py
// compares.
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <pinball/contact/embedded_contact.hpp>
#include <vector>

namespace {

constexpr int bars = 5, elements_of_bar = 10, layers = elements_of_bar + 1;
constexpr double modulus = 100.0, density = 1.0, gap = 0.05, end_time = 12.0;

struct Node {
  std::array<double, 3> position{}, velocity{}, force{};
  double mass = 0;
};

struct Mesh {
  std::vector<Node> nodes;
  std::vector<std::array<std::int64_t, 8>> elements;

  Mesh() : nodes(bars * layers * 4) {
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
          nodes[static_cast<std::size_t>(corners[corner])].mass += density / 8;
        }
        elements.push_back(corners);
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
};

}  // namespace
