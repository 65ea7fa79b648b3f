#include <fmt/format.h>

#include <cmath>
#include <set>

#include <solver/formats/lsdyna/layouts/control_cards.hpp>

#include "deck_parts.hpp"

namespace pinball {

namespace {

/// What holds for parts without an *HOURGLASS, and where that leaves something blank.
DeckHourglass defaults_of(DeckData& data) {
  DeckHourglass defaults{1, 0.1, 1.5, 0.06};
  if (const auto card = last_card(data, "CONTROL_HOURGLASS")) {
    const Fields f = data.fields(*card, layout::control_hourglass);
    if (const auto form = f.integer("IHQ"); form != 0) defaults.form = form;
    if (const double coefficient = f.number("QH"); coefficient != 0) defaults.coefficient = coefficient;
  }
  if (const auto card = last_card(data, "CONTROL_BULK_VISCOSITY")) {
    const Fields f = data.fields(*card, layout::bulk_viscosity);
    defaults.quadratic = f.number("Q1");
    defaults.linear = f.number("Q2");
    for (const char* name : {"Q1", "Q2"}) {
      if (f.number(name) == 0)
        data.report.unused(card->place, fmt::format("*CONTROL_BULK_VISCOSITY: {} of 0", name),
                           "the viscosity is off; LS-DYNA may take its default, 1.5 and 0.06");
    }
    if (const auto type = f.integer("TYPE"); type != 0 && type != 1 && type != -1)
      data.report.understood(
          fmt::format("*CONTROL_BULK_VISCOSITY ({}): the standard one in place of TYPE {}", card->place.text(), type));
  }
  return defaults;
}

DeckHourglass hourglass_of(const DeckData& data, const DeckPart& part, const DeckHourglass& defaults) {
  if (part.hourglass == 0 || part.is_rigid()) return defaults;
  const auto found = data.hourglass.find(part.hourglass);
  if (found == data.hourglass.end())
    fail_at(part.place, fmt::format("no *HOURGLASS has the number {}", part.hourglass));
  const DeckHourglass& own = found->second;
  return {own.form != 0 ? own.form : defaults.form, own.coefficient != 0 ? own.coefficient : defaults.coefficient,
          own.quadratic != 0 ? own.quadratic : defaults.quadratic, own.linear != 0 ? own.linear : defaults.linear};
}

bool is_fully_integrated(const DeckData& data, const DeckPart& part) {
  const auto section = data.section_form.find(part.section);
  return section != data.section_form.end() && is_of_full_integration(section->second);
}

DeckElement element_of(DeckData& data, const DeckPart& part, const DeckHourglass& defaults) {
  const DeckHourglass h = hourglass_of(data, part, defaults);
  DeckElement element{"assumed_strain", 1.0, std::sqrt(h.quadratic), h.linear};
  if (is_fully_integrated(data, part)) return element;
  if (h.form == 6 || h.form == 7) {
    element.coefficient = h.coefficient;
  } else if (h.form >= 1 && h.form <= 3) {
    element.hourglass = "viscous";
    element.coefficient = h.coefficient / 4;
  } else if (h.form == 4 || h.form == 5) {
    element.hourglass = "stiffness";
    element.coefficient = h.coefficient;
  } else {
    data.report.reject(part.place, fmt::format("hourglass control of form {} (IHQ)", h.form), "give 1 to 7",
                       part.solids);
  }
  return element;
}

/// Of forms that are one here, which a deck asks for.
void tell_forms(DeckData& data, const DeckHourglass& defaults) {
  if (data.hourglass.empty() && !last_card(data, "CONTROL_HOURGLASS")) return;
  std::set<std::int64_t> forms;
  for (const DeckPart& part : data.parts) {
    if (!is_fully_integrated(data, part) && !part.is_rigid()) forms.insert(hourglass_of(data, part, defaults).form);
  }
  for (const std::int64_t form : forms) {
    if (form >= 1 && form <= 3)
      data.report.understood(fmt::format("hourglass control IHQ {}: viscous, the same for 1 to 3", form));
    if (form == 4 || form == 5)
      data.report.understood(fmt::format("hourglass control IHQ {}: stiffness, the same for 4 and 5", form));
    if (form == 6 || form == 7)
      data.report.understood(fmt::format("hourglass control IHQ {}: assumed strains, the same for 6 and 7", form));
  }
}

}  // namespace

std::vector<DeckElement> deck_elements(DeckData& data) {
  const DeckHourglass defaults = defaults_of(data);
  tell_forms(data, defaults);
  std::vector<DeckElement> elements;
  for (const DeckPart& part : data.parts) elements.push_back(element_of(data, part, defaults));
  return elements;
}

std::optional<Card> last_card(const DeckData& data, const std::string& name, int number) {
  std::optional<Card> found;
  for (const KeywordBlock* block : data.blocks_of(name)) {
    Cards cards(*block);
    std::optional<Card> card = cards.next();
    for (int i = 0; i < number && card; ++i) card = cards.next();
    if (card || number > 0) found = card;
  }
  return found;
}

}  // namespace pinball
