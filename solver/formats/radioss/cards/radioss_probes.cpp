#include <fmt/format.h>

#include <set>

#include <solver/formats/radioss/layouts/radioss_boundary_cards.hpp>

#include "radioss_keys.hpp"

namespace pinball {

namespace {

/// A line of variables, and then one for each node or solid.
class RadiossProbes {
 public:
  RadiossProbes(RadiossData& data, KeyOf<Probe> kind, const std::vector<std::int64_t>& ids)
      : data_(data), kind_(kind), index_(ids) {}

  void translate(const RadiossBlock& block, const CardLayout& layout, DeckScene& scene) {
    RadiossLines lines(block);
    pass_variables(block, lines);
    const bool nodes = kind_.name == "node";
    while (const auto line = lines.next_filled()) {
      const RadiossFields f(*line, block, layout);
      const std::int64_t number = f.integer(0);
      const std::int32_t place = index_.find(number);
      if (place < 0) f.fail(f.name(0), fmt::format("{} {} is not there", nodes ? "node" : "solid", number));
      f.text("name");
      if (!watched_.insert(number).second) continue;
      if (nodes && data_.rigid_at(place) != nullptr) {
        data_.report.unused(line->place, fmt::format("/TH/NODE of a main node"),
                            "history.csv has the centre of each rigid body");
        continue;
      }
      if (nodes && !data_.used[place]) {
        data_.report.ignore_node(line->place, "/TH/NODE");
        continue;
      }
      const auto keys = scene.entry<Probe>("probe", card_of(block, line->place));
      keys.set("name", fmt::format("{}_{}", kind_.name, number));
      keys.set(kind_, number);
    }
  }

 private:
  /// Probes have all variables that there are.
  static void pass_variables(const RadiossBlock& block, RadiossLines& lines) {
    const auto line = lines.next();
    if (!line) return;
    const RadiossFields f(*line, block, radioss::variables);
    for (std::size_t i = 0; i < radioss::variables.size(); ++i) f.text(i);
  }

  RadiossData& data_;
  KeyOf<Probe> kind_;
  NumberIndex index_;
  std::set<std::int64_t> watched_;
};

}  // namespace

void translate_radioss_probes(RadiossData& data, DeckScene& scene) {
  RadiossProbes nodes(data, "node", data.mesh.node_ids), elements(data, "element", data.mesh.element_ids);
  for (const RadiossBlock& block : data.deck.blocks) {
    if (block.name == "TH/NODE") nodes.translate(block, radioss::watched_node, scene);
    if (block.name == "TH/BRIC") elements.translate(block, radioss::watched_brick, scene);
  }
}

}  // namespace pinball
