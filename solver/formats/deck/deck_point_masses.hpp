#pragma once

#include <cstdint>
#include <map>
#include <string_view>
#include <vector>

#include "deck_scene.hpp"

namespace pinball {

/// Masses that cards give to nodes: those of one node add up, and nodes with the same mass are one [[point_mass]].
class DeckPointMasses {
 public:
  /// node: its place in the mesh.
  void add(std::int32_t node, double mass, const DeckCard& card);
  /// node_ids: their numbers. mass, nodes: what the manual calls the fields.
  void write(const std::vector<std::int64_t>& node_ids, std::string_view mass, std::string_view nodes,
             DeckScene& scene) const;

 private:
  struct OfNode {
    double mass = 0;
    DeckCard card;  ///< the first
  };

  std::map<std::int32_t, OfNode> of_node_;
};

}  // namespace pinball
