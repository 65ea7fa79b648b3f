#include "symmetry_walls.hpp"

#include <cmath>

#include <kernels/exec.hpp>

namespace pinball {

template <class S>
SymmetryWalls<S>::SymmetryWalls(const Model<S>& model) {
  bool erodes = false;
  for (const Part& part : model.parts) erodes = erodes || part.features.erosion;
  if (!erodes) return;
  for (const PlaneConstraint& plane : model.scene.constraints) {
    Wall wall{plane.point, plane.normal, {}};
    double side = 0;  // of the plane on which the bodies lie
    for (std::size_t n = 0; n < model.mesh.nodes.size(); ++n) {
      const auto body = static_cast<std::size_t>(model.mesh.body_of_node[n]);
      if (!plane.body.empty() && plane.body != model.mesh.body_names[body]) continue;
      double distance = 0, size = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const double d = model.mesh.nodes[n][k] - plane.point[k];
        distance += d * plane.normal[k];
        size += d * d;
      }
      side += distance;
      if (distance * distance > 1e-18 * size) wall.nodes.push_back(model.node_of_scene_node[n]);
    }
    if (side < 0) {
      for (double& c : wall.inward) c = -c;
    }
    walls_.push_back(std::move(wall));
  }
}

template <class S>
void SymmetryWalls<S>::reflect(Model<S>& model, S position_step) const {
  for (const Wall& wall : walls_) {
    const S point[3] = {S(wall.point[0]), S(wall.point[1]), S(wall.point[2])};
    const S inward[3] = {S(wall.inward[0]), S(wall.inward[1]), S(wall.inward[2])};
    parallel_for("symmetry walls", RangePolicy<>{0, static_cast<std::int64_t>(wall.nodes.size())}, [&](std::int64_t i) {
      const std::int64_t place = 4 * static_cast<std::int64_t>(wall.nodes[i]);
      S* x = model.nodes.position.data() + place;
      S distance = 0, speed = 0;
      for (int k = 0; k < 3; ++k) distance += (x[k] - point[k]) * inward[k];
      if (!(distance < S(0))) return;
      S* v = model.nodes.velocity.data() + place;
      for (int k = 0; k < 3; ++k) speed += v[k] * inward[k];
      if (!(speed < S(0))) return;
      for (int k = 0; k < 3; ++k) {
        x[k] -= S(2) * position_step * speed * inward[k];
        v[k] -= S(2) * speed * inward[k];
      }
    });
  }
}

template <class S>
std::size_t SymmetryWalls<S>::bytes() const {
  std::size_t sum = 0;
  for (const Wall& wall : walls_) sum += wall.nodes.capacity() * sizeof(std::int32_t);
  return sum;
}

template class SymmetryWalls<double>;
template class SymmetryWalls<float>;

}  // namespace pinball
