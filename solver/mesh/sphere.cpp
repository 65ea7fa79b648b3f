#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include <solver/base/error.hpp>

#include "generators.hpp"
#include "section.hpp"

namespace pinball {
namespace {

/// Conformal map of the unit ball onto itself that makes everything near the lower pole smaller by `grading` and near
/// the upper one larger by 1/grading: angles and aspect ratios of small elements stay as they are.
///     x -> ((1 - a^2)(x - c) - |x - c|^2 c) / (1 - 2 x.c + a^2 |x|^2),   c = a e_z,   a = (1 - grading)/(1 + grading)
/// In the plane it is the Moebius transformation (x - c)/(1 - c x).
Point graded(const Point& x, double grading) {
  const double a = (1.0 - grading) / (1.0 + grading);
  const double x2 = x[0] * x[0] + x[1] * x[1] + x[2] * x[2];
  const double distance2 = x2 - 2.0 * a * x[2] + a * a;
  const double scale = 1.0 / (1.0 - 2.0 * a * x[2] + a * a * x2);
  const double keep = (1.0 - a * a) * scale;
  return {keep * x[0], keep * x[1], keep * (x[2] - a) - scale * distance2 * a};
}

/// The cube [-1, 1]^3 onto the unit ball. On the faces the lines through their centres get equal angles.
Point ball(const Point& parameter) {
  Point u;
  for (int i = 0; i < 3; ++i) u[i] = std::numbers::sqrt2 * std::sin(0.25 * std::numbers::pi * parameter[i]);
  Point x;
  for (int i = 0; i < 3; ++i) {
    const double v2 = u[(i + 1) % 3] * u[(i + 1) % 3], w2 = u[(i + 2) % 3] * u[(i + 2) % 3];
    x[i] = u[i] * std::sqrt(1.0 - 0.5 * v2 - 0.5 * w2 + v2 * w2 / 3.0);
  }
  return x;
}

/// A core of c x c x c elements and b layers between each of its faces and the sphere; unit radius, not graded. Nodes
/// are found by the lattice point of the core, i, j, k = 0 ... c, and the layers m outward from its surface.
class Sphere {
 public:
  Sphere(int core, int ring, const std::array<bool, 3>& cut)
      : c_(core),
        b_(ring),
        cut_(cut),
        core_scale_(1.0 / (1.0 + core_edge * 0.5 * std::numbers::pi / core * ring)),
        layer_node_(static_cast<std::size_t>(core + 1) * (core + 1) * (core + 1), -1) {
    for (int axis = 0; axis < 3; ++axis) low_[axis] = cut[axis] ? core / 2 : 0;
  }

  Mesh mesh() {
    add_nodes();
    Mesh mesh;
    mesh.nodes = nodes_;
    for_each_cell([&](const Lattice& p) {
      const auto at = [&](int i, int j, int k) { return node({p[0] + i, p[1] + j, p[2] + k}, 0); };
      mesh.hexahedra.push_back(
          {at(0, 0, 0), at(1, 0, 0), at(1, 1, 0), at(0, 1, 0), at(0, 0, 1), at(1, 0, 1), at(1, 1, 1), at(0, 1, 1)});
    });
    for (int axis = 0; axis < 3; ++axis)
      for (const bool upper : {false, true})
        if (upper || !cut_[axis]) add_block(mesh, axis, upper);
    return mesh;
  }

 private:
  using Lattice = std::array<int, 3>;

  std::size_t index(const Lattice& p) const {
    return (static_cast<std::size_t>(p[2]) * (c_ + 1) + p[1]) * (c_ + 1) + p[0];
  }
  std::int32_t node(const Lattice& p, int m) const { return layer_node_[index(p)] + m; }

  template <class Action>
  void for_each_cell(Action action) const {
    for (int k = low_[2]; k < c_; ++k)
      for (int j = low_[1]; j < c_; ++j)
        for (int i = low_[0]; i < c_; ++i) action(Lattice{i, j, k});
  }

  void add_nodes() {
    for (int k = low_[2]; k <= c_; ++k)
      for (int j = low_[1]; j <= c_; ++j)
        for (int i = low_[0]; i <= c_; ++i) {
          const Lattice p{i, j, k};
          layer_node_[index(p)] = nodes_.size();
          Point u, inner;
          bool surface = false;
          for (int axis = 0; axis < 3; ++axis) {
            u[axis] = 2.0 * p[axis] / c_ - 1.0;  // exactly 0 in the middle
            surface = surface || p[axis] == 0 || p[axis] == c_;
          }
          const Point outer = ball(u);
          for (int axis = 0; axis < 3; ++axis)
            inner[axis] = core_scale_ * ((1.0 - core_bulge) / std::numbers::sqrt3 * u[axis] + core_bulge * outer[axis]);
          nodes_.push_back(inner);
          for (int m = 1; surface && m <= b_; ++m) {
            const double w = static_cast<double>(m) / b_;
            nodes_.push_back({(1 - w) * inner[0] + w * outer[0], (1 - w) * inner[1] + w * outer[1],
                              (1 - w) * inner[2] + w * outer[2]});
          }
        }
  }

  /// The layers over one face of the core.
  void add_block(Mesh& mesh, int axis, bool upper) const {
    // first x second = outward
    const int first = upper ? (axis + 1) % 3 : (axis + 2) % 3, second = upper ? (axis + 2) % 3 : (axis + 1) % 3;
    for (int m = 0; m < b_; ++m)
      for (int s = low_[second]; s < c_; ++s)
        for (int f = low_[first]; f < c_; ++f) {
          const auto at = [&](int df, int ds, int dm) {
            Lattice p{};
            p[axis] = upper ? c_ : 0;
            p[first] = f + df;
            p[second] = s + ds;
            return node(p, m + dm);
          };
          mesh.hexahedra.push_back(
              {at(0, 0, 0), at(1, 0, 0), at(1, 1, 0), at(0, 1, 0), at(0, 0, 1), at(1, 0, 1), at(1, 1, 1), at(0, 1, 1)});
        }
  }

  int c_, b_;
  std::array<bool, 3> cut_;
  Lattice low_{};
  double core_scale_;                     // distance of the core's corners from the centre
  std::vector<std::int32_t> layer_node_;  // node of a lattice point; those of its layers follow it
  std::vector<Point> nodes_;
};

void check(const SphereMesh& settings) {
  const auto fail = [](const std::string& what) { throw InputError("sphere mesh: " + what); };
  if (!std::isfinite(settings.radius) || settings.radius <= 0.0)
    fail(fmt::format("radius: expected a length > 0, got {}", settings.radius));
  if (!(settings.grading > 0.0) || settings.grading > 1.0)
    fail(fmt::format("grading: expected a number > 0 and <= 1, got {}", settings.grading));
  for (const int count : settings.core)
    if (count < 1) fail(fmt::format("core: expected an integer >= 1, got {}", count));
  if (settings.ring < 1) fail(fmt::format("ring: expected an integer >= 1, got {}", settings.ring));
  const double p = settings.core[0], q = settings.core[1], b = settings.ring;
  double nodes = 0.0;
  if (settings.section == Section::wedge) {
    if (!(settings.angle > 0.0) || settings.angle > largest_wedge_angle)
      fail(fmt::format("angle: expected a number > 0 and <= {}, got {}", largest_wedge_angle, settings.angle));
    nodes = 2.0 * ((p + 1) * (q + 1) + (2 * p + q + 1) * b);
  } else {
    if (settings.core[0] != settings.core[1]) fail("core: expected one count, the same in all directions");
    if (settings.section != Section::full && settings.core[0] % 2 != 0)
      fail(
          fmt::format("core: expected an even integer, since the section is cut through it, got {}", settings.core[0]));
    nodes = (p + 1) * (p + 1) * (p + 1 + 6 * b);
  }
  if (nodes > std::numeric_limits<std::int32_t>::max()) fail("core, ring: more than 2^31 - 1 nodes");
}

}  // namespace

Mesh generate_sphere(const SphereMesh& settings) {
  check(settings);
  Mesh mesh;
  if (settings.section == Section::wedge) {
    SectionMesh section = disc_section({2 * settings.core[0], settings.core[1]}, settings.ring, {true, false});
    for (auto& [r, z] : section.nodes) {
      const Point x = graded({r, 0.0, z}, settings.grading);
      r = settings.radius * x[0];
      z = settings.radius * x[2];
    }
    return turn_section(section, settings.angle);
  }
  const bool cut_x = settings.section == Section::quarter, cut_y = settings.section != Section::full;
  mesh = Sphere(settings.core[0], settings.ring, {cut_x, cut_y, false}).mesh();
  for (Point& x : mesh.nodes) {
    x = graded(x, settings.grading);
    for (double& coordinate : x) coordinate *= settings.radius;
  }
  return mesh;
}

}  // namespace pinball
