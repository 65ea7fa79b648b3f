#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <vector>

#include <solver/model/model.hpp>

#include "body_depth.hpp"
#include "box_grid.hpp"

namespace pinball {

/// Whether some pair lets two bodies touch at some time; of sets any body may be a part. No pairs: all bodies may.
bool may_touch(const std::vector<ContactPair>& pairs, const std::string& a, const std::string& b);

struct BodyParts {
  Bounds box;
  std::vector<std::size_t> nodes, elements;
};

/// The bodies of a mesh, and which of them may share space.
class OverlappingBodies {
 public:
  /// pairs: of the scene; where there are any, only bodies that these let touch. rigid: number of the rigid body of
  /// each body, negative: none; empty: there are none. Bodies of one never touch.
  OverlappingBodies(const ModelMesh& mesh, const std::vector<ContactPair>& pairs, std::vector<std::int32_t> rigid);

  const BodyParts& parts(std::size_t body) const { return bodies_[body]; }
  /// Calls visit(a, b, box that both share) for two bodies after the other, a < b, until it returns false.
  void for_each(const std::function<bool(std::size_t, std::size_t, const Bounds&)>& visit) const;

 private:
  bool may_touch(std::size_t a, std::size_t b) const;

  const ModelMesh& mesh_;
  const std::vector<ContactPair>& pairs_;
  std::vector<std::int32_t> rigid_;
  std::vector<BodyParts> bodies_;
};

/// The nodes of bodies that lie in other bodies, and how deep. Surfaces are made where they are asked for.
class NodeDepths {
 public:
  NodeDepths(const Scene& scene, const ModelMesh& mesh, const OverlappingBodies& bodies)
      : scene_(scene), mesh_(mesh), bodies_(bodies) {}

  /// Calls visit(node, depth) for the nodes of each of two bodies that lie deeper in the other one than facets explain,
  /// by more than `least` of the size of a face [-].
  void for_each(std::size_t a, std::size_t b, const Bounds& box, double least,
                const std::function<void(std::size_t, const BodyDepth&)>& visit);

 private:
  void of_one_in_other(std::size_t of, std::size_t in, const Bounds& box, double least,
                       const std::function<void(std::size_t, const BodyDepth&)>& visit);
  const BodySurface& surface(std::size_t body);

  const Scene& scene_;
  const ModelMesh& mesh_;
  const OverlappingBodies& bodies_;
  std::vector<std::uint8_t> exposed_;  ///< per element; empty: not asked for yet
  std::map<std::size_t, BodySurface> surfaces_;
};

}  // namespace pinball
