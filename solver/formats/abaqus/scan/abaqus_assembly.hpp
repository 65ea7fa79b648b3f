#pragma once

#include <string>
#include <vector>

#include <solver/base/point.hpp>

#include "abaqus_deck.hpp"

namespace pinball {

/// Where an instance is: moved, and then turned.
class InstancePlacement {
 public:
  InstancePlacement() = default;
  /// Of the data lines of *INSTANCE: a translation [length]; two points of an axis [length] and an angle [degrees].
  /// Throws InputError for two equal points.
  explicit InstancePlacement(const AbaqusBlock& instance);

  Point apply(Point x) const;
  bool turns() const { return turns_; }

 private:
  bool moves_ = false, turns_ = false;
  Point shift_{}, origin_{};
  std::array<Point, 3> rotation_{};  ///< rows
};

/// What has nodes and elements with numbers of its own: an instance of a part, or all of a deck without parts, or what
/// stands in the assembly itself.
struct AbaqusComponent {
  std::string name;  ///< of the instance, as written; empty: of the assembly, or of a deck without parts
  std::string key;   ///< of its label
  std::vector<const AbaqusBlock*> blocks;
  InstancePlacement placement;
  DeckPlace place;
};

/// The instances in the order of the deck; last what is in no part and no instance. Parts of a deck without *ASSEMBLY
/// are instances of themselves. Throws InputError for an instance of no part, and for two of one name.
std::vector<AbaqusComponent> abaqus_components(const AbaqusDeck& deck);

/// A *SOLID SECTION of a component, which is a body, or a *RIGID BODY of a deck with rigid elements.
struct AbaqusSection {
  std::size_t component = 0;
  const AbaqusBlock* block = nullptr;
  std::string part;  ///< name of its elements in the mesh: that of the instance, of the set, or "INSTANCE.SET"
  bool is_rigid() const { return block->name == "RIGIDBODY"; }
};
/// In the order of the components. with_rigid: the deck has rigid elements. Throws InputError for a *SOLID SECTION
/// without an ELSET.
std::vector<AbaqusSection> abaqus_sections(const std::vector<AbaqusComponent>& components, bool with_rigid);

}  // namespace pinball
