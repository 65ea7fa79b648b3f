#include <fmt/format.h>

#include <algorithm>
#include <array>

#include <solver/base/error.hpp>
#include <solver/formats/lsdyna/layouts/rigid_cards.hpp>

#include "boundary_keys.hpp"
#include "deck_parts.hpp"

/// *CONSTRAINED_JOINT_...: nodes in pairs, the first of each of one rigid part and the second of another.
namespace pinball {

namespace {

/// How far nodes of a joint may lie apart, over the size of the mesh: digits of a card.
constexpr double coincident = 1e-5;

struct JointKeyword {
  JointKind kind;
  const char* name;
  std::size_t pairs;     ///< of nodes
  std::size_t together;  ///< of these lie in one place, the first ones; others of those that give an axis lie on it
};

JointKeyword joint_keyword(const std::string& name) {
  if (name.ends_with("_SPHERICAL")) return {JointKind::spherical, "spherical", 1, 1};
  if (name.ends_with("_REVOLUTE")) return {JointKind::revolute, "revolute", 2, 2};
  if (name.ends_with("_CYLINDRICAL")) return {JointKind::cylindrical, "cylindrical", 2, 0};
  if (name.ends_with("_TRANSLATIONAL")) return {JointKind::translational, "translational", 2, 0};
  if (name.ends_with("_UNIVERSAL")) return {JointKind::universal, "universal", 2, 1};
  return {JointKind::locking, "locking", 1, 1};
}

/// The leading rigid part of each node that *CONSTRAINED_EXTRA_NODES gives to one.
std::map<std::int32_t, std::int64_t> leads_of_extra_nodes(const DeckData& data) {
  std::map<std::int32_t, std::int64_t> leads;
  for (const bool set : {false, true}) {
    for (const KeywordBlock* block :
         data.blocks_of(set ? "CONSTRAINED_EXTRA_NODES_SET" : "CONSTRAINED_EXTRA_NODES_NODE")) {
      for_each_card(*block, [&](const Card& card) {
        const Fields f = data.fields(card, set ? layout::attached_set : layout::attached_node);
        const DeckPart* part = data.find_part(f.integer("PID") + offset_of(*block, &DeckTransform::part));
        if (part == nullptr || !part->is_rigid()) return;
        const std::size_t of_nodes = 1;
        for (const std::int32_t node : nodes_of_card(data, *block, set, f, of_nodes)) leads[node] = part->lead;
      });
    }
  }
  return leads;
}

/// Of a card: its nodes, and whose they are.
class JointNodes {
 public:
  JointNodes(const DeckData& data, const KeywordBlock& block, const JointKeyword& joint, const Fields& f)
      : data_(data) {
    const std::map<std::int32_t, std::int64_t> extra = leads_of_extra_nodes(data);
    for (std::size_t i = 0; i < 2 * joint.pairs; ++i) {
      const std::int64_t id = node_number(block, f.integer(names[i]));
      const std::int32_t node = data.nodes.find(id);
      if (node < 0) f.fail(names[i], fmt::format("node {} is not there", id));
      const auto attached = extra.find(node);
      const std::int64_t lead = attached != extra.end()     ? attached->second
                                : data.lead_of_node.empty() ? 0
                                                            : data.lead_of_node[node];
      if (lead == 0)
        f.fail(names[i], fmt::format("node {} is of no rigid part: expected a node of one, or of its "
                                     "*CONSTRAINED_EXTRA_NODES",
                                     id));
      std::int64_t& side = lead_[i % 2];
      if (side != 0 && side != lead)
        f.fail(names[i], fmt::format("node {} is of the rigid part {}, {} before it of {}: expected one part on a side",
                                     id, lead, names[i % 2], side));
      side = lead;
      node_[i] = node;
    }
    if (lead_[0] == lead_[1])
      f.fail("N2", fmt::format("expected a node of another rigid part than {}, that of N1", lead_[0]));
  }
  static constexpr std::array<const char*, 4> names{"N1", "N2", "N3", "N4"};

  const Point& place(std::size_t i) const { return data_.mesh.mesh.nodes[node_[i]]; }
  std::int64_t lead(std::size_t side) const { return lead_[side]; }
  /// From one node to another; one of them has no place of its own where this is 0.
  Point between(std::size_t i, std::size_t j) const { return minus(place(j), place(i)); }

 private:
  const DeckData& data_;
  std::array<std::int32_t, 4> node_{};
  std::array<std::int64_t, 2> lead_{0, 0};
};

double size_of(const std::vector<Point>& nodes) {
  Point low = nodes.front(), high = low;
  for (const Point& node : nodes) {
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], node[k]);
      high[k] = std::max(high[k], node[k]);
    }
  }
  return norm(minus(high, low));
}

void check_places(const JointKeyword& joint, const JointNodes& nodes, double near, const Fields& f) {
  const auto fail = [&](std::size_t i, const std::string& text) { f.fail(JointNodes::names[i], text); };
  for (std::size_t pair = 0; pair < joint.pairs; ++pair) {
    const double apart = norm(nodes.between(2 * pair, 2 * pair + 1));
    if (pair < joint.together && apart > near)
      fail(2 * pair + 1, fmt::format("expected it where {} is, it is {:.3g} away: joints close no gaps",
                                     JointNodes::names[2 * pair], apart));
  }
  if (joint.pairs < 2) return;
  const Point axis = nodes.between(0, 2);
  if (!(norm(axis) > near)) fail(2, "expected it away from N1: the two are an axis");
  if (joint.together != 0) return;
  for (const std::size_t i : {std::size_t{1}, std::size_t{3}}) {
    const double off = norm(cross(axis, nodes.between(0, i))) / norm(axis);
    if (off > near) fail(i, fmt::format("expected it on the axis of N1 and N3, it is {:.3g} off", off));
  }
}

}  // namespace

void translate_joints(DeckData& data, const KeywordBlock& block, DeckScene& scene) {
  const JointKeyword joint = joint_keyword(block.name);
  const double near = coincident * size_of(data.mesh.mesh.nodes);
  Cards cards(block);
  while (true) {
    std::int64_t id = 0;
    std::optional<Card> number;
    if (block.id) {
      number = cards.next();
      if (!number) return;
      number->log = nullptr;  // what follows it is a title
      id = data.fields(*number, layout::joint_number).integer("JID");
    }
    const std::optional<Card> card = cards.next_behind(number);
    if (!card) return;
    const Fields f = data.fields(*card, joint.pairs > 1 ? layout::joint_pairs : layout::joint_pair);
    const JointNodes nodes(data, block, joint, f);
    check_places(joint, nodes, near, f);
    const auto keys = scene.entry<Joint>("joint", card_of(block, card->place));
    if (id != 0) {
      data.give_once(block, fmt::format("joint {}", id), card->place);
      keys.set("name", fmt::format("joint_{}", id));
    } else {
      keys.set("name", fmt::format("{}_of_{}_{}", joint.name, f.integer("N1"), f.integer("N2")));
    }
    keys.set("kind", joint.name);
    keys.set("bodies",
             std::vector<std::string>{data.find_part(nodes.lead(0))->body, data.find_part(nodes.lead(1))->body});
    keys.set("point", nodes.place(0), "n1");
    if (joint.pairs > 1) keys.set("axis", nodes.between(0, 2), "n1, n3");
    if (joint.kind == JointKind::universal) keys.set("second_axis", nodes.between(1, 3), "n2, n4");
  }
}

}  // namespace pinball
