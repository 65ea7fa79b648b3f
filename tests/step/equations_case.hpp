#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <tests/support/tied_case.hpp>

/// Scenes with equations among displacements.
namespace pinball::test {

inline const std::array<Point, 3> axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

inline EquationTerm term(const std::string& name, const Point& direction, double factor, const std::string& body,
                         std::optional<Plane> plane = {}) {
  EquationTerm one{name, direction, factor, {}};
  one.nodes.body = body;
  one.nodes.plane = plane;
  return one;
}

/// Factors of the displacements of two bodies' nodes along all axes.
inline std::vector<EquationTerm> of_pair(double a, double b, std::optional<Plane> plane = {}) {
  std::vector<EquationTerm> terms;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::string name = std::string(1, "xyz"[k]);
    terms.push_back(term(name, axes[k], a, "a", plane));
    terms.push_back(term(name, axes[k], b, "b", plane));
  }
  return terms;
}

/// Two cubes of one element, 1 m from each other.
inline Scene two_cubes(double end) {
  return scene_of({block("a", {1, 1, 1}, 0.1, {0, 0, 0}), block("b", {1, 1, 1}, 0.1, {1, 0, 0})}, end, false);
}

inline constexpr double cube_mass = 7.850;

template <class S>
Point velocity_of(const Solver<S>& solver, std::size_t scene_node) {
  const S* v = solver.model().nodes.velocity.data() + 4 * solver.model().node_of_scene_node[scene_node];
  return {v[0], v[1], v[2]};
}

}  // namespace pinball::test
