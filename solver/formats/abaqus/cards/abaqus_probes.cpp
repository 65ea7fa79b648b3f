#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <set>

#include "abaqus_parts.hpp"

namespace pinball {

namespace {

/// Nodes or elements, each of which becomes a probe at most once.
class Probes {
 public:
  /// kind: the key of a probe.
  Probes(const AbaqusData& data, KeyOf<Probe> kind, DeckScene& scene) : data_(data), kind_(kind), scene_(scene) {}

  void add_nodes(const AbaqusBlock& block) {
    for (const std::int32_t node : data_.nodes(block.require("NSET"), block.place).members) {
      const std::size_t at = node;
      if (at >= data_.mesh.given_nodes + 2 * data_.mesh.file.layers.size()) continue;
      if (at >= data_.mesh.given_nodes) {
        data_.report.ignore(block.place, block.star_name() + " of nodes of rigid elements");
        continue;
      }
      if (!data_.used[at]) {
        data_.report.ignore_node(block.place, block.star_name());
        continue;
      }
      add(block, data_.mesh.file.node_ids[at], component_of(at, &AbaqusRange::first_node, &AbaqusRange::nodes));
    }
  }
  void add_elements(const AbaqusBlock& block) {
    for (const std::int32_t element : data_.elements(block.require("ELSET"), block.place)) {
      const std::size_t at = element;
      add(block, data_.mesh.file.element_ids[at],
          component_of(at, &AbaqusRange::first_element, &AbaqusRange::elements));
    }
  }

 private:
  /// id: in the mesh.
  void add(const AbaqusBlock& block, std::int64_t id, std::size_t component) {
    if (!watched_.insert(id).second) return;
    const std::string& instance = data_.mesh.components[component].name;
    std::string name = fmt::format("{}_{}{}{}", kind_.name, AbaqusData::plain_name(instance),
                                   instance.empty() ? "" : "_", id - data_.mesh.ranges[component].added);
    while (!names_.insert(name).second) name += '_';  // plain names of two instances may be one
    const auto keys = scene_.entry<Probe>("probe", card_of(block, block.place));
    keys.set("name", name);
    keys.set(kind_, id);
  }

  /// Whose range a place in the mesh is in.
  std::size_t component_of(std::size_t at, std::size_t AbaqusRange::*first, std::size_t AbaqusRange::*count) const {
    const auto& ranges =
        data_.mesh.ranges;  // one behind the other; of those without any the next one begins there, too
    const auto after = std::ranges::upper_bound(ranges, at, {}, first);
    auto range = std::prev(after);
    while (at - (*range).*first >= (*range).*count) --range;
    return range - ranges.begin();
  }

  const AbaqusData& data_;
  KeyOf<Probe> kind_;
  DeckScene& scene_;
  std::set<std::int64_t> watched_;
  std::set<std::string> names_;
};

}  // namespace

void translate_abaqus_probes(AbaqusData& data, DeckScene& scene) {
  Probes nodes(data, "node", scene), elements(data, "element", scene);
  bool history = false;
  for (const AbaqusBlock& block : data.deck.blocks) {
    if (block.name == "OUTPUT") history = block.has("HISTORY");
    if (block.name == "NODEOUTPUT" && history && block.has("NSET")) {
      nodes.add_nodes(block);
    } else if (block.name == "ELEMENTOUTPUT" && history && block.has("ELSET")) {
      elements.add_elements(block);
    } else if (block.name == "NODEOUTPUT" || block.name == "ELEMENTOUTPUT") {
      data.report.ignore(block.place, block.star_name());
    }
  }
}

}  // namespace pinball
