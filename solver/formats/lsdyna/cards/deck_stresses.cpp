#include <fmt/format.h>

#include <solver/formats/deck/deck_stresses.hpp>

#include "boundary_keys.hpp"
#include "deck_parts.hpp"

namespace pinball {

namespace {

/// What the lines of one card have for its element, or each of its set.
class StressCard {
 public:
  StressCard(DeckData& data, const KeywordBlock& block, const Fields& f)
      : data_(data),
        block_(block),
        points_(f.integer("NINT")),
        history_(f.integer("NHISV") + f.integer("IVEFLG")),
        is_large_(f.integer("LARGE") == 1) {
    if (history_ > 0)
      data.report.unused(f.place(), block.star_name() + ": NHISV, IVEFLG", "history variables are their law's own");
    if (points_ > 1)
      data.report.understood(
          fmt::format("{} ({}): the mean of its {} points", block.star_name(), f.place().text(), points_));
  }

  DeckStress read(Cards& cards, const DeckPlace& place) {
    DeckStress mean;
    mean.card = card_of(block_, place);
    for (std::int64_t i = 0; i < points_; ++i) add_point(cards, mean);
    return mean;
  }

 private:
  void add_point(Cards& cards, DeckStress& mean) {
    const Card card = cards.require("a stress");
    if (is_large_) {
      const Card more = cards.require("the second line of a stress");
      add(data_.fields(card, layout::stress_long), data_.fields(more, layout::stress_long_more), mean);
    } else {
      const Fields f = data_.fields(card, layout::stress_point);
      add(f, f, mean);
    }
    const std::int64_t in_line = is_large_ ? 5 : 8, left = is_large_ ? history_ - 3 : history_;
    for (std::int64_t n = 0; n < left; n += in_line) cards.require("history variables");
  }
  void add(const Fields& first, const Fields& last, DeckStress& mean) const {
    const double share = 1.0 / static_cast<double>(points_);
    const Point normal = first.point("SIGXX"),
                shear{first.number("SIGXY"), first.number("SIGYZ"), last.number("SIGZX")};
    for (std::size_t k = 0; k < 3; ++k) {
      mean.stress[k] += share * normal[k];
      mean.shear_stress[k] += share * shear[k];
    }
    mean.plastic_strain += share * last.number("EPS");
  }

  DeckData& data_;
  const KeywordBlock& block_;
  std::int64_t points_, history_;
  bool is_large_;
};

/// Numbers of the elements of a card, as the mesh has them.
std::vector<std::int64_t> elements_of_card(const DeckData& data, const KeywordBlock& block, const Fields& f) {
  if (block.name == "INITIAL_STRESS_SOLID") return {f.integer("EID") + offset_of(block, &DeckTransform::element)};
  const std::int64_t number = set_number(block, f.integer("SID"));
  const MeshSet* set = find_set(data.mesh.element_sets, std::to_string(number));
  if (set == nullptr) fail_at(f.place(), fmt::format("{}: no *SET_SOLID has the number {}", block.star_name(), number));
  if (!set->problem.empty()) fail_at(f.place(), fmt::format("{}: {}", block.star_name(), set->problem));
  std::vector<std::int64_t> elements;
  for (const std::int32_t member : set->members) elements.push_back(data.mesh.element_ids[member]);
  return elements;
}

}  // namespace

void translate_initial_stress(DeckData& data, const KeywordBlock& block, DeckScene& scene) {
  DeckStresses stresses;
  const CardLayout& head = block.name == "INITIAL_STRESS_SOLID" ? layout::stress_element : layout::stress_set;
  for_each_card(block, [&](const Card& card, Cards& cards) {
    const Fields f = data.fields(card, head);
    const std::vector<std::int64_t> elements = elements_of_card(data, block, f);
    const DeckStress stress = StressCard(data, block, f).read(cards, card.place);
    for (const std::int64_t element : elements) stresses.of(element) = stress;
  });
  stresses.write(scene);
}

}  // namespace pinball
