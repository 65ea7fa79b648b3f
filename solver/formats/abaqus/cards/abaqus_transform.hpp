#pragma once

#include <array>
#include <string>
#include <vector>

#include <solver/scene_boundary.hpp>

#include "abaqus_data.hpp"

namespace pinball {

/// *TRANSFORM: local directions 1 to 3 of nodes, which stay those of the start.
struct AbaqusTransform {
  const AbaqusBlock* block = nullptr;
  bool is_cylindrical = false;        ///< radial, circumferential and axial
  std::array<Point, 3> axes{};        ///< unit vectors; of a cylindrical one the third alone
  Line axis{};                        ///< of a cylindrical one
  std::vector<std::int32_t> nodes{};  ///< places in the mesh, ascending
};

/// Those of a deck.
class AbaqusTransforms {
 public:
  /// What is not done is refused. Throws InputError for points that give no axes.
  explicit AbaqusTransforms(AbaqusData& data);

  /// Of all these nodes; null: they have none. Where only some have it, or several have others, that is refused.
  const AbaqusTransform* of(const AbaqusNodes& nodes, const AbaqusBlock& block, const DeckPlace& place) const;
  /// A direction that is the same for all of these nodes; where it is not, that is refused.
  Point direction(const AbaqusTransform* transform, std::size_t degree, const AbaqusBlock& block,
                  const DeckPlace& place) const;

 private:
  void read(const AbaqusBlock& block);

  AbaqusData& data_;
  std::vector<AbaqusTransform> transforms_;
};

/// Directions by their bits, in the axes of a transform.
void set_directions(unsigned bits, const AbaqusTransform* transform, const DeckKeys<FixedConstraint>& keys);

}  // namespace pinball
