#pragma once

#include <limits>
#include <string>
#include <vector>

/// What of a scene touches what, and what is tied to what, as the user wrote it.
/// Every field carries the TOML key that sets it.
namespace pinball {

/// A set of a mesh file that bodies are from.
struct MeshSetName {
  std::string set{};   ///< its name or number
  std::string file{};  ///< file: the mesh file that has it; empty: the only one
};

/// What is on one side of a contact: all of these together.
struct ContactSide {
  std::vector<std::string> bodies{};    ///< "NAME": all faces of a body
  std::vector<MeshSetName> elements{};  ///< { elements = "SET" }: the faces of elements
  std::vector<MeshSetName> faces{};     ///< { faces = "SET" }
  std::vector<MeshSetName> nodes{};     ///< { nodes = "SET" }: nodes alone, that touch the faces of the other side

  bool empty() const { return bodies.empty() && elements.empty() && faces.empty() && nodes.empty(); }
};

inline constexpr double never = std::numeric_limits<double>::infinity();

/// [[contact.pair]]: two sides that may touch each other. Where a scene has any, nothing else touches.
struct ContactPair {
  std::string name{};             ///< name: unique; default: pair_NUMBER
  ContactSide first{};            ///< first
  ContactSide second{};           ///< second; empty: the members of `first` among each other, each of them with itself
  double friction = -1;           ///< friction; negative: none of the three is set, all become those of [contact] [-]
  double static_friction = -1;    ///< static_friction; negative: not set, becomes friction [-]
  double friction_decay = -1;     ///< friction_decay; negative: not set, becomes 0 [time/length]
  double start = 0, end = never;  ///< start, end: when they may touch [time]
  std::string where{};            ///< "FILE:LINE:COLUMN: KEY" of the table, for messages
};

/// [[contact.tied]]: nodes of `first` that move with the faces of `second` on which they lie at the start.
struct TiedContact {
  std::string name{};             ///< name: unique; default: tied_NUMBER
  ContactSide first{};            ///< first: nodes of the surface of these
  ContactSide second{};           ///< second: faces; no sets of nodes
  double tolerance = -1;          ///< tolerance: largest distance; negative: 0.05 of a face's shorter diagonal [length]
  double start = 0, end = never;  ///< start, end [time]
  std::string where{};            ///< as above
};

}  // namespace pinball
