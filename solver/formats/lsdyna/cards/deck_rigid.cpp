#include <fmt/format.h>

#include <solver/formats/lsdyna/layouts/rigid_cards.hpp>

#include "boundary_keys.hpp"
#include "deck_parts.hpp"

namespace pinball {

namespace {

/// What CMO, CON1 and CON2 of a *MAT_RIGID hold.
struct RigidHeld {
  GivenArray along, about;
  DeckPlace place;
  bool is_used = false;  ///< of a part that leads

  bool any() const { return !along.empty() || !about.empty(); }
};

/// CON1 and CON2 of CMO 1: directions by their bits x, y, z.
GivenArray global_directions(const Fields& f, const char* name) {
  static constexpr unsigned directions_of_code[8] = {0, 1, 2, 4, 3, 6, 5, 7};
  const std::int64_t code = f.integer(name);
  if (code < 0 || code > 7) f.fail(name, fmt::format("expected 0 to 7, got {}", code));
  GivenArray directions;
  for (unsigned k = 0; k < 3; ++k) {
    if ((directions_of_code[code] >> k & 1U) != 0) directions.push_back(given(std::string(1, "xyz"[k])));
  }
  return directions;
}

/// CMO -1: CON1 is a system, and CON2 six digits, one for each direction along and about its axes.
void add_local_directions(const DeckData& data, const KeywordBlock& block, const Fields& f, RigidHeld& held) {
  const std::array<Point, 3> axes = data.axes(definition_number(block, f.integer("CON1")), f.place());
  std::int64_t rest = f.integer("CON2"), power = 100'000;
  const std::int64_t code = rest;
  for (std::size_t i = 0; i < 6; ++i, power /= 10) {
    const std::int64_t digit = rest / power;
    if (digit < 0 || digit > 1 || rest < 0) f.fail("CON2", fmt::format("expected six digits of 0 and 1, got {}", code));
    rest %= power;
    if (digit == 1) (i < 3 ? held.along : held.about).push_back(given(axes[i % 3]));
  }
}

RigidHeld read_held(const DeckData& data, const KeywordBlock& block) {
  Cards cards(block);
  if (block.title) cards.next();
  cards.next();
  const Card constraint = cards.next_or_blank(), system = cards.next_or_blank();
  const Fields f = data.fields(constraint, layout::rigid_held);
  data.fields(system, layout::rigid_system);
  RigidHeld held;
  held.place = constraint.place;
  const double option = f.number("CMO");
  if (option == 1) {
    held.along = global_directions(f, "CON1");
    held.about = global_directions(f, "CON2");
  } else if (option == -1) {
    add_local_directions(data, block, f, held);
  } else if (option != 0) {
    f.fail("CMO", fmt::format("expected 1, 0 or -1, got {}", option));
  }
  return held;
}

}  // namespace

void translate_rigid_bodies(DeckData& data, DeckScene& scene) {
  std::map<std::int64_t, RigidHeld> held_by;
  for (const auto& [number, block] : data.rigid_materials) {
    if (data.is_used(number)) held_by[number] = read_held(data, *block);
  }
  for (const DeckPart& part : data.parts) {
    if (!part.is_rigid()) continue;
    if (part.hourglass != 0)
      data.report.unused(part.place, "*PART: HGID of rigid parts", "they have no hourglass modes");
    if (part.lead != part.id) continue;
    const KeywordBlock& block = *data.rigid_materials.at(part.material);
    RigidHeld& held = held_by[part.material];
    held.is_used = true;
    const auto keys = scene.entry<RigidBody>("rigid_body", card_of(block, held.place));
    keys.set("name", part.body);
    keys.set("bodies", data.bodies_with(part.id));
    if (!held.along.empty()) keys.set("held", held.along, "con1");
    if (!held.about.empty()) keys.set("held_rotations", held.about, "con2");
  }
  for (const auto& [number, held] : held_by) {
    if (!held.is_used && held.any())
      data.report.unused(held.place, "*MAT_RIGID: CON1, CON2",
                         "of a part that is merged into another one those of the other one hold");
  }
}

}  // namespace pinball
