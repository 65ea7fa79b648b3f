#include "unequal_velocities.hpp"

#include <array>
#include <cmath>
#include <vector>

#include <kernels/exec.hpp>
#include <solver/mesh/file/split_ten_nodes.hpp>
#include <solver/scene/material/known_solids.hpp>

namespace pinball {

namespace {

constexpr double smooth = 0.01;  ///< of the speed of waves

std::vector<double> smooth_speeds(const Scene& scene) {
  std::vector<double> of_body;
  for (const std::size_t material : material_of_bodies(scene))
    of_body.push_back(smooth * wave_speed(scene.materials[material]));
  return of_body;
}

/// Of the corners of one element.
class CornerMotion {
 public:
  template <class S>
  CornerMotion(const Model<S>& model, const S* velocity, std::int64_t element) {
    const auto point = [](const S* p) { return Point{p[0], p[1], p[2]}; };
    for (std::size_t i = 0; i < 8; ++i) {
      const std::int32_t n = model.node_of_scene_node[model.mesh.hexahedra[element][i]];
      x_[i] = point(model.nodes.position_of(n));
      v_[i] = point(record(velocity, n));
    }
  }
  /// Of the edges: how fast their lengths change [length/time].
  double fastest() const {
    double largest = 0;
    for (const auto& [a, b] : hexahedron_edges) {
      const Point along = minus(x_[b], x_[a]);
      const double length = norm(along);  // 0 where corners are one node
      if (length > 0) largest = std::max(largest, std::abs(dot(minus(v_[b], v_[a]), along)) / length);
    }
    return largest;
  }
  /// Mean square of the velocities beside their mean [length^2/time^2].
  double spread() const {
    Point mean{};
    for (const Point& v : v_) {
      for (std::size_t k = 0; k < 3; ++k) mean[k] += v[k] / 8;
    }
    double sum = 0;
    for (const Point& v : v_) sum += dot(minus(v, mean), minus(v, mean)) / 8;
    return sum;
  }

 private:
  std::array<Point, 8> x_, v_;
};

}  // namespace

template <class S>
UnequalVelocities unequal_velocities(const Model<S>& model, const S* velocity) {
  const std::vector<double> smooth_speed = smooth_speeds(model.scene);
  UnequalVelocities all;
  parallel_reduce(
      "velocities within elements", RangePolicy<>{0, model.element_count()}, all,
      [&](std::int64_t begin, std::int64_t end, UnequalVelocities& partial) {
        for (std::int64_t e = begin; e < end; ++e) {
          const std::int32_t body = model.mesh.body[e];
          if (model.rigid_of_body[body] >= 0 || !model.elements.alive(model.slot_of_element[e])) continue;
          const CornerMotion corners(model, velocity, e);
          const double beyond = corners.fastest() - smooth_speed[body];
          if (beyond > 0) partial.join({beyond, 0.5 * model.element_mass[e] * corners.spread()});
        }
      },
      [](UnequalVelocities& whole, const UnequalVelocities& other) { whole.join(other); });
  return all;
}

template UnequalVelocities unequal_velocities<double>(const Model<double>&, const double*);
template UnequalVelocities unequal_velocities<float>(const Model<float>&, const float*);

}  // namespace pinball
