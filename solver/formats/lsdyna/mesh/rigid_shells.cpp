#include "rigid_shells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include <solver/base/error.hpp>
#include <solver/formats/lsdyna/layouts/mesh_cards.hpp>
#include <solver/formats/lsdyna/layouts/rigid_cards.hpp>
#include <solver/formats/lsdyna/scan/fields.hpp>

#include "part_inertia.hpp"

namespace pinball {

namespace {

bool is_rigid_material(const std::string& name) { return name == "MAT_RIGID" || name == "MAT_020" || name == "MAT_20"; }

}  // namespace

std::vector<RigidShell> RigidShells::read() {
  std::vector<RigidShell> shells;
  const auto is_shell = [](const KeywordBlock& block) { return block.name == "ELEMENT_SHELL"; };
  if (std::ranges::none_of(deck_.blocks, is_shell)) return shells;
  find_parts();
  for (const KeywordBlock& block : deck_.blocks) {
    if (is_shell(block)) read(block, shells);
  }
  return shells;
}

void RigidShells::find_parts() {
  std::set<std::int64_t> materials;
  std::map<std::int64_t, double> thickness;
  for (const KeywordBlock& block : deck_.blocks) {
    if (is_rigid_material(block.name)) {
      Cards cards(block);
      if (block.title) cards.next();
      if (const auto card = cards.next())
        materials.insert(Fields(*card, deck_.parameters, layout::rigid).integer("MID") +
                         offset_of(block, &DeckTransform::material));
    } else if (block.name == "SECTION_SHELL") {
      for_each_card(block, [&](const Card& card, Cards& cards) {
        const std::int64_t id = Fields(card, deck_.parameters, layout::section_shell).integer("SECID") +
                                offset_of(block, &DeckTransform::other);
        const Card second = cards.next_or_blank();
        const Fields f(second, deck_.parameters, layout::shell_thickness);
        const double first = f.number("T1");
        for (const char* name : {"T2", "T3", "T4"}) {
          if (const double other = f.number(name); other != 0 && other != first)
            f.fail(name, fmt::format("expected the thickness of T1, {}, or blank, got {}", first, other));
        }
        thickness[id] = first;
      });
    }
  }
  for (const KeywordBlock& block : deck_.blocks) {
    if (!is_part(block)) continue;
    const auto pass = [&](const Card&, Cards& cards) {
      if (block.name == "PART_CONTACT") {
        cards.next();
      } else {
        pass_inertia(cards, deck_.parameters);
      }
    };
    for_each_part(
        block,
        [&](const Card&, const Card& card) {
          const Fields f(card, deck_.parameters, layout::part);
          if (!materials.contains(f.integer("MID") + offset_of(block, &DeckTransform::material))) return;
          const std::int64_t id = f.integer("PID") + offset_of(block, &DeckTransform::part);
          const auto place = std::ranges::find(file_.parts, id, &MeshPart::id) - file_.parts.begin();
          const std::int64_t section = f.integer("SECID") + offset_of(block, &DeckTransform::other);
          const auto found = thickness.find(section);
          rigid_[id] = {static_cast<std::int32_t>(place), found == thickness.end() ? 0.0 : found->second, section};
        },
        pass);
  }
}

void RigidShells::read(const KeywordBlock& block, std::vector<RigidShell>& shells) const {
  const std::int64_t to_node = offset_of(block, &DeckTransform::node);
  Cards cards(block);
  while (const auto card = cards.next_filled()) {
    const Fields f(*card, deck_.parameters, layout::shell);
    const std::int64_t id = f.integer("EID") + offset_of(block, &DeckTransform::element);
    const auto part = rigid_.find(f.integer("PID") + offset_of(block, &DeckTransform::part));
    if (part == rigid_.end()) continue;
    const auto fail = [&](const std::string& problem) {
      fail_at(card->place, fmt::format("*ELEMENT_SHELL: element {} {}", id, problem));
    };
    if (!(part->second.thickness > 0))
      fail(fmt::format("has no thickness: expected T1 > 0 of the *SECTION_SHELL {}", part->second.section));
    RigidShell shell{id, part->second.place,    static_cast<std::int32_t>(card->place.line), *card->place.file,
                     {}, part->second.thickness};
    for (std::size_t i = 0; i < 4; ++i) {
      std::int64_t node = f.integer(2 + i);
      if (node == 0 && i == 3) node = f.integer(4);
      shell.nodes[i] = nodes_.find(node + to_node);
      if (shell.nodes[i] < 0) fail(fmt::format("has node {}, which is not there", node + to_node));
    }
    for (std::size_t i = 6; i < 10; ++i) {
      if (f.integer(i) != 0) fail("has more than four nodes: expected three or four");
    }
    const auto& [a, b, c, d] = shell.nodes;
    if (a == b || b == c || a == c || d == a || d == b) fail("has two nodes or less: expected three or four");
    shells.push_back(shell);
  }
}

}  // namespace pinball
