#include "deck_stresses.hpp"

#include <vector>

namespace pinball {

void DeckStresses::write(DeckScene& scene) const {
  struct Group {
    const DeckStress* first = nullptr;
    std::vector<std::int64_t> elements{};
  };
  std::map<std::array<double, 7>, std::size_t> known;
  std::vector<Group> groups;
  for (const auto& [element, given] : all_) {
    const Point &s = given.stress, &t = given.shear_stress;
    const auto [found, is_new] =
        known.try_emplace({s[0], s[1], s[2], t[0], t[1], t[2], given.plastic_strain}, groups.size());
    if (is_new) groups.push_back({&given, {}});
    groups[found->second].elements.push_back(element);
  }
  for (const Group& group : groups) {
    const DeckStress& given = *group.first;
    const auto keys = scene.entry<InitialStress>("initial_stress", given.card);
    keys.set("stress", given.stress);
    if (given.shear_stress != Point{}) keys.set("shear_stress", given.shear_stress);
    if (given.plastic_strain != 0) keys.set("plastic_strain", given.plastic_strain);
    keys.set("elements", group.elements);
  }
}

}  // namespace pinball
