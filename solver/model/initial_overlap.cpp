#include "initial_overlap.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include <kernels/hexahedron.hpp>
#include <solver/base/point.hpp>

namespace pinball {

namespace {

struct Bounds {
  Point low{INFINITY, INFINITY, INFINITY}, high{-INFINITY, -INFINITY, -INFINITY};
  void take(const Point& x) {
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], x[k]);
      high[k] = std::max(high[k], x[k]);
    }
  }
  bool holds(const Point& x) const {
    for (std::size_t k = 0; k < 3; ++k) {
      if (x[k] < low[k] || x[k] > high[k]) return false;
    }
    return true;
  }
  bool empty() const { return low[0] > high[0] || low[1] > high[1] || low[2] > high[2]; }
};

Bounds common(const Bounds& a, const Bounds& b) {
  Bounds both = a;
  for (std::size_t k = 0; k < 3; ++k) {
    both.low[k] = std::max(a.low[k], b.low[k]);
    both.high[k] = std::min(a.high[k], b.high[k]);
  }
  return both;
}

/// Smallest depth of a point below the planes of an element's faces; negative outside. Collapsed faces do not count.
double depth_in(const ModelMesh& mesh, std::size_t element, const Point& x) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& face : face_nodes) {
    const auto corner = [&](int i) -> const Point& { return mesh.corner(element, face[i]); };
    const Point normal = cross(minus(corner(2), corner(0)), minus(corner(3), corner(1)));
    const double length = std::hypot(normal[0], normal[1], normal[2]);
    if (!(length > 0)) continue;
    Point centre{};
    for (int i = 0; i < 4; ++i) {
      for (std::size_t k = 0; k < 3; ++k) centre[k] += corner(i)[k] / 4;
    }
    const Point to = minus(centre, x);
    least = std::min(least, (to[0] * normal[0] + to[1] * normal[1] + to[2] * normal[2]) / length);
  }
  return least;
}

/// Elements of a body by the cells of a grid over a box that their own boxes meet.
class Grid {
 public:
  Grid(const ModelMesh& mesh, const std::vector<std::size_t>& elements, const Bounds& box) : box_(box) {
    const double most = std::clamp(std::cbrt(static_cast<double>(elements.size())), 1.0, 100.0);
    for (std::size_t k = 0; k < 3; ++k) {
      cells_[k] = static_cast<int>(most);
      scale_[k] = box.high[k] > box.low[k] ? cells_[k] / (box.high[k] - box.low[k]) : 0.0;
    }
    cell_.resize(cells_[0] * cells_[1] * cells_[2]);
    for (const std::size_t e : elements) {
      Bounds own;
      for (const Point& corner : mesh.corners(e)) own.take(corner);
      if (common(own, box).empty()) continue;
      const auto low = place(own.low), high = place(own.high);
      for (int z = low[2]; z <= high[2]; ++z) {
        for (int y = low[1]; y <= high[1]; ++y) {
          for (int x = low[0]; x <= high[0]; ++x) cell_[number({x, y, z})].push_back(e);
        }
      }
    }
  }
  const std::vector<std::size_t>& at(const Point& x) const { return cell_[number(place(x))]; }

 private:
  std::array<int, 3> place(const Point& x) const {
    std::array<int, 3> cell{};
    for (std::size_t k = 0; k < 3; ++k) {
      cell[k] = static_cast<int>(std::clamp((x[k] - box_.low[k]) * scale_[k], 0.0, cells_[k] - 1.0));
    }
    return cell;
  }
  int number(const std::array<int, 3>& cell) const {  // 10^6 cells at most
    return (cell[2] * cells_[1] + cell[1]) * cells_[0] + cell[0];
  }

  Bounds box_;
  std::array<int, 3> cells_{};
  Point scale_{};
  std::vector<std::vector<std::size_t>> cell_;
};

struct BodyParts {
  Bounds box;
  std::vector<std::size_t> nodes, elements;
};

/// Points of one body inside elements of another, within the box that both share.
std::int64_t points_inside(const ModelMesh& mesh, const BodyParts& of, const BodyParts& in, const Bounds& box,
                           double depth) {
  const Grid grid(mesh, in.elements, box);
  std::int64_t count = 0;
  const auto look = [&](const Point& x) {
    if (!box.holds(x)) return;
    const auto& near = grid.at(x);
    count += std::any_of(near.begin(), near.end(), [&](std::size_t e) {
      return depth_in(mesh, e, x) > depth * std::cbrt(std::max(0.0, element_volume(mesh, e)));
    });
  };
  for (const std::size_t n : of.nodes) look(mesh.nodes[n]);
  for (const std::size_t e : of.elements) {
    const Point centre = element_centre(mesh, e);
    look(centre);
    // Nodes and centres of regular meshes may all lie on faces of the other body's elements.
    for (const Point& corner : mesh.corners(e)) {
      const Point to = minus(corner, centre);
      look({centre[0] + 0.55 * to[0], centre[1] + 0.55 * to[1], centre[2] + 0.55 * to[2]});
    }
  }
  return count;
}

/// Whether some pair lets two bodies touch; of sets any body may be a part.
bool may_touch(const std::vector<ContactPair>& pairs, const std::string& a, const std::string& b) {
  const auto holds = [](const ContactSide& side, const std::string& body) {
    return !side.elements.empty() || !side.faces.empty() || !side.nodes.empty() ||
           std::ranges::find(side.bodies, body) != side.bodies.end();
  };
  return pairs.empty() || std::any_of(pairs.begin(), pairs.end(), [&](const ContactPair& pair) {
           const ContactSide& second = pair.second.empty() ? pair.first : pair.second;
           return (holds(pair.first, a) && holds(second, b)) || (holds(pair.first, b) && holds(second, a));
         });
}

}  // namespace

InitialOverlap find_initial_overlap(const ModelMesh& mesh, const std::vector<ContactPair>& pairs, double depth) {
  std::vector<BodyParts> bodies(mesh.body_names.size());
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
    BodyParts& body = bodies[mesh.body_of_node[n]];
    body.box.take(mesh.nodes[n]);
    body.nodes.push_back(n);
  }
  for (std::size_t e = 0; e < mesh.hexahedra.size(); ++e) {
    bodies[mesh.body[e]].elements.push_back(e);
  }
  for (std::size_t a = 0; a < bodies.size(); ++a) {
    for (std::size_t b = a + 1; b < bodies.size(); ++b) {
      const Bounds box = common(bodies[a].box, bodies[b].box);
      if (box.empty() || !may_touch(pairs, mesh.body_names[a], mesh.body_names[b])) continue;
      const std::int64_t points =
          points_inside(mesh, bodies[a], bodies[b], box, depth) + points_inside(mesh, bodies[b], bodies[a], box, depth);
      if (points > 0) return {mesh.body_names[a], mesh.body_names[b], points};
    }
  }
  return {};
}

}  // namespace pinball
