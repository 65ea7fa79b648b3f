#pragma once

#include <cstdint>
#include <pinball/solver/internal_forces.hpp>
#include <pinball/solver/model.hpp>
#include <vector>

namespace pinball {

/// Nodes whose elements have all eroded: mass points in free flight. One that reaches a plane of symmetry meets its
/// mirror image there, which comes from the other side and goes on in its place: it is reflected, which changes neither
/// its energy nor, with the image, any momentum. Nodes that belong to elements are kept by their constraints.
template <class S>
class FreePoints {
 public:
  explicit FreePoints(const Model<S>& model);

  /// Takes in the nodes that erosion has freed in the last step.
  void update(const Model<S>& model, const std::vector<TileResult<S>>& tiles);
  /// Reflects the points that have crossed a plane of symmetry.
  void reflect(Model<S>& model) const;

  std::size_t count() const { return points_.size(); }
  std::size_t bytes() const { return alive_.capacity() + living_elements_.capacity() + 4 * points_.capacity(); }

 private:
  struct Plane {
    Point point, inward;             ///< inward: unit normal towards the bodies
    std::vector<std::uint8_t> body;  ///< per body: the plane applies to it
  };
  std::vector<Plane> planes_;
  std::vector<std::uint8_t> alive_;            ///< per slot
  std::vector<std::uint8_t> living_elements_;  ///< per node of the store
  std::vector<std::int32_t> points_;           ///< free nodes of the store, of bodies that have a plane
  std::vector<std::int32_t> body_;             ///< of each
};

}  // namespace pinball
