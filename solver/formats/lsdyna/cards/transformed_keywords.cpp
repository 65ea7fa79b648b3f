#include "transformed_keywords.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include <solver/formats/lsdyna/mesh/keyword_transformation.hpp>

#include "keyword_rules.hpp"

namespace pinball {

namespace {

bool begins_with_one_of(const std::string& name, std::initializer_list<std::string_view> heads) {
  return std::ranges::any_of(heads, [&](std::string_view head) { return name.starts_with(head); });
}

/// Its cards give places.
bool has_places(const KeywordBlock& block) {
  return begins_with_one_of(block.name, {"DEFINE_BOX", "RIGIDWALL_", "INITIAL_VELOCITY_GENERATION"});
}
/// Its cards give vectors.
bool has_vectors(const KeywordBlock& block) {
  if (keyword_alias(block.name) == "MAT_ORTHOTROPIC_ELASTIC") return true;
  return begins_with_one_of(
      block.name, {"DEFINE_VECTOR", "DEFINE_COORDINATE_", "INITIAL_VELOCITY", "INITIAL_STRESS_", "LOAD_BODY_VECTOR"});
}
/// Its cards name axes: x, y, z.
bool names_axes(const KeywordBlock& block) {
  return begins_with_one_of(block.name, {"BOUNDARY_SPC_", "BOUNDARY_PRESCRIBED_MOTION_", "LOAD_NODE_", "LOAD_BODY_X",
                                         "LOAD_BODY_Y", "LOAD_BODY_Z"});
}

bool turns(const Transformation& t) { return t.rows != Transformation{}.rows; }
bool moves(const Transformation& t) { return t.shift != Point{}; }

/// The order of several is that of the cards, as in OpenRadioss' reader (one /TRANSFORM each, which act in their order)
/// and in decks of PRIMER, which puts what it adds behind the others. PyDyna multiplies their matrices the other way.
void tell_order(const KeywordBlock& block, DeckReport& report) {
  KeywordBlock silent = block;
  silent.log = nullptr;
  Cards cards(silent);
  if (block.title) cards.next();
  cards.next();
  int steps = 0;
  while (cards.next_filled()) ++steps;
  if (steps > 1)
    report.understood(fmt::format("{} ({}): its {} cards act one after the other, the first one first",
                                  block.star_name(), block.place.text(), steps));
}

}  // namespace

void reject_transformed(const KeywordDeck& deck, DeckReport& report) {
  const auto is_transformed = [](const KeywordBlock& block) {
    return block.transform && block.transform->transformation != 0;
  };
  if (std::ranges::none_of(deck.blocks, is_transformed)) return;
  const Transformations transformations(deck);
  for (const KeywordBlock& block : deck.blocks) {
    if (block.name == "DEFINE_TRANSFORMATION") tell_order(block, report);
    const Transformation* transformation = transformations.of(block);
    if (transformation == nullptr || !(turns(*transformation) || moves(*transformation))) continue;
    if (has_places(block) || (turns(*transformation) && has_vectors(block))) {
      report.reject(
          block.place, block.star_name() + " in a file that is transformed",
          "nodes alone are: move it into a file that is not, with its places and directions as they come out");
    } else if (turns(*transformation) && names_axes(block)) {
      report.understood(
          fmt::format("{} ({}): x, y and z are those of the deck, which the transformation of the file "
                      "does not turn",
                      block.star_name(), block.place.text()));
    }
  }
}

}  // namespace pinball
