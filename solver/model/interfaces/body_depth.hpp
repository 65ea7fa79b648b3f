#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include <solver/model/model.hpp>

#include "box_grid.hpp"

namespace pinball {

/// Of what is collapsed to a line both diagonals, or sides, are that line, and their vector product is zero but for
/// rounding: the most that it is, over their lengths [-].
inline constexpr double collapsed_share = 1e-9;

/// How deep a point lies in a body.
struct BodyDepth {
  double depth = 0;   ///< distance to the nearest point of the surface; 0: the point is not inside [length]
  double facets = 0;  ///< what flat faces of a curved surface stand out of it there [length]
  double size = 0;    ///< root of the area of the nearest face [length]
  Point out{};        ///< from the point to that of the surface [length]
};

/// Smallest depth of a point below the planes of an element's faces; negative outside. Collapsed faces do not count.
double depth_in(const ModelMesh& mesh, std::size_t element, const Point& x);

/// A body of a mesh, to tell whether points lie in it.
class BodyInside {
 public:
  /// elements: all of the body; box: in which the points lie.
  BodyInside(const ModelMesh& mesh, const std::vector<std::size_t>& elements, const Bounds& box);

  /// Whether some element of the body holds a point of the box, by more than `depth` of the size of the element [-].
  bool holds(const Point& x, double depth) const;
  /// How deep a point of the box lies in an element of the body; 0: in none [length].
  double depth_at(const Point& x) const;

 private:
  const ModelMesh& mesh_;
  const std::vector<std::size_t>& elements_;
  BoxGrid grid_;
};

/// The surface of a body, to tell how far points in it are from it.
class BodySurface {
 public:
  /// exposed: of all elements of the mesh (find_exposed_faces).
  BodySurface(const ModelMesh& mesh, const std::vector<std::size_t>& elements,
              const std::vector<std::uint8_t>& exposed);

  /// x: inside the body, or on its surface; facing: normals of the faces around x of another body that x is a node of.
  /// Only faces that look against one of these count, so that a node at the rim of two that lie on each other is not as
  /// good as on their common side; none: all. The depth is 0 where there is no face.
  BodyDepth depth_of(const Point& x, const std::vector<Point>& facing) const;
  /// Of the faces around a node, none if it is not on the surface.
  std::vector<Point> normals_at(std::int32_t node) const;

 private:
  struct Face {
    std::array<std::int32_t, 4> node;
    Point normal;  ///< of unit length
    double size;   ///< root of its area [length]
    double facets = 0;
  };
  void measure_facets();

  const ModelMesh& mesh_;
  std::vector<Face> faces_;
  std::unordered_map<std::int32_t, std::vector<std::size_t>> around_;  ///< faces of each node
  Bounds box_;
  std::vector<BoxGrid> grid_;  ///< one, or none without faces
};

}  // namespace pinball
