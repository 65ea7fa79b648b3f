#include "generators.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include <solver/base/error.hpp>

#include "array_mesh.hpp"

namespace pinball {
namespace {

/// Shortest rotation of z onto a unit vector. With t the direction of the axis' part in the xy plane,
/// z = c e_z + s t, it turns the plane of e_z and t by the angle of cosine c and leaves the normal of that plane alone.
class TurnFromZ {
 public:
  explicit TurnFromZ(const Point& axis) : cosine_(axis[2]), sine_(std::hypot(axis[0], axis[1])) {
    if (sine_ > 0.0) {
      tx_ = axis[0] / sine_;
      ty_ = axis[1] / sine_;
    }
  }

  Point operator()(const Point& x) const {
    const double along = tx_ * x[0] + ty_ * x[1];
    const double turned = cosine_ * along + sine_ * x[2];
    Point result{x[0] + (turned - along) * tx_, x[1] + (turned - along) * ty_, cosine_ * x[2] - sine_ * along};
    if (ty_ == 0.0) result[0] = turned * tx_, result[1] = x[1];
    return result;
  }

 private:
  double cosine_, sine_;
  double tx_ = 1.0, ty_ = 0.0;  // with the axis along -z any direction is a shortest one: turn about y
};

}  // namespace

Mesh generate(const MeshSettings& settings) {
  struct Generator {
    Mesh operator()(const BlockMesh& block) const { return generate_block(block); }
    Mesh operator()(const RoundNosedRodMesh& rod) const { return generate_round_nosed_rod(rod); }
    Mesh operator()(const CylinderMesh& cylinder) const { return generate_cylinder(cylinder); }
    Mesh operator()(const SphereMesh& sphere) const { return generate_sphere(sphere); }
    Mesh operator()(const ArrayMesh& arrays) const { return copy_mesh(arrays); }
    Mesh operator()(const FileMesh&) const { throw std::logic_error("a mesh from a file is read, not generated"); }
  };
  return std::visit(Generator{}, settings);
}

void place(Mesh& mesh, const std::optional<Point>& axis, const Point& position) {
  if (axis) {
    Point direction = *axis;
    const double length = std::hypot(direction[0], direction[1], direction[2]);
    if (!std::isfinite(length) || length <= 0.0) throw InputError("axis: expected a vector of nonzero length");
    for (double& component : direction) component /= length;
    const TurnFromZ turn(direction);
    for (Point& node : mesh.nodes) node = turn(node);
  }
  for (Point& node : mesh.nodes)
    for (int i = 0; i < 3; ++i) node[i] += position[i];
}

}  // namespace pinball
