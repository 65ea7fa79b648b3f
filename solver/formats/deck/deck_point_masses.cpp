#include "deck_point_masses.hpp"

#include <utility>

#include <solver/scene_boundary.hpp>

namespace pinball {

void DeckPointMasses::add(std::int32_t node, double mass, const DeckCard& card) {
  of_node_.try_emplace(node, OfNode{0, card}).first->second.mass += mass;
}

void DeckPointMasses::write(const std::vector<std::int64_t>& node_ids, std::string_view mass, std::string_view nodes,
                            DeckScene& scene) const {
  struct OfMass {
    std::vector<std::int64_t> numbers;
    DeckCard card;  ///< of its first node
  };
  std::map<double, OfMass> of_mass;
  for (const auto& [node, own] : of_node_) {
    OfMass& all = of_mass.try_emplace(own.mass, OfMass{{}, own.card}).first->second;
    all.numbers.push_back(node_ids[node]);
  }
  for (const auto& [value, all] : of_mass) {
    const auto keys = scene.entry<PointMass>("point_mass", all.card);
    keys.set("mass", value, mass);
    keys.set("each", true);
    keys.set("nodes", all.numbers, nodes);
  }
}

}  // namespace pinball
