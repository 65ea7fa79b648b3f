#include <fmt/format.h>

#include <algorithm>
#include <map>

#include <solver/base/error.hpp>

#include "abaqus_parts.hpp"

namespace pinball {

void write_abaqus_head(const char* table, const AbaqusBlock& block, const DeckPlace& place, TomlText& scene) {
  scene.entry(table, fmt::format("{} {}", block.star_name(), place.text()));
}

void write_abaqus_nodes(const AbaqusNodes& nodes, TomlText& scene) {
  if (nodes.set.empty()) {
    scene.key("nodes", std::vector<std::int64_t>{nodes.number});
  } else {
    scene.key("set", nodes.set);
  }
}

namespace {

/// One data line of *BOUNDARY: directions by their bits x, y, z; rotations of nodes of solids mean nothing.
struct Held {
  unsigned directions = 0;
  double magnitude = 0;
};

unsigned named_directions(const std::string& name, const DeckPlace& place) {
  static const std::map<std::string, unsigned> names{{"ENCASTRE", 7}, {"PINNED", 7}, {"XSYMM", 1},  {"YSYMM", 2},
                                                     {"ZSYMM", 4},    {"XASYMM", 6}, {"YASYMM", 5}, {"ZASYMM", 3}};
  const auto found = names.find(name);
  if (found == names.end()) fail_at(place, fmt::format("*BOUNDARY: expected degrees of freedom, got \"{}\"", name));
  return found->second;
}

Held held_of(const DataFields& f) {
  if (!f.blank(1) && !deck_integer(f.text(1))) return {named_directions(squeezed(f.text(1)), f.place()), 0.0};
  Held held{0, f.number(3, "magnitude", 0.0)};
  const std::int64_t first = f.integer(1, "first degree of freedom"), last = f.integer(2, "last one", first);
  for (std::int64_t degree = first; degree <= last && degree <= 3; ++degree) {
    if (degree >= 1) held.directions |= 1U << (degree - 1);
  }
  return held;
}

std::string directions_text(unsigned directions) {
  std::vector<std::string> names;
  for (unsigned k = 0; k < 3; ++k) {
    if ((directions >> k & 1U) != 0) names.push_back(fmt::format("\"{}\"", "xyz"[k]));
  }
  return fmt::format("[{}]", fmt::join(names, ", "));
}

class Boundary {
 public:
  Boundary(AbaqusData& data, TomlText& scene) : data_(data), scene_(scene) {}

  void translate() {
    const bool renewed = std::ranges::any_of(data_.deck.blocks, [](const AbaqusBlock& block) {
      return block.name == "BOUNDARY" && block.step > 0 && block.option("OP") == "NEW";
    });
    for (const AbaqusBlock& block : data_.deck.blocks) {
      if (block.name != "BOUNDARY") continue;
      if (renewed && block.step == 0) {
        data_.report.understood(fmt::format("*BOUNDARY ({}): ends where the step begins (OP=NEW)", block.place.text()));
        continue;
      }
      DataLines lines(block);
      while (const auto card = lines.next()) add(block, *card);
    }
    for (const auto& [directions, single] : held_) {
      write_abaqus_head("constraint", *single.block, single.place, scene_);
      write_fixed(directions);
      scene_.key("nodes", single.numbers);
    }
  }

 private:
  struct Singles {
    const AbaqusBlock* block;
    DeckPlace place;
    std::vector<std::int64_t> numbers;
  };

  void write_fixed(unsigned directions) {
    scene_.key("type", "fixed");
    scene_.raw("directions", directions_text(directions));
  }

  void add(const AbaqusBlock& block, const Card& card) {
    const DataFields f(card);
    const Held held = held_of(f);
    if (held.directions == 0) return;
    const AbaqusNodes nodes = data_.nodes(f.text(0), card.place);
    if (nodes.set.empty() && !data_.used[static_cast<std::size_t>(nodes.members[0])])
      return data_.report.ignore_node(card.place, "*BOUNDARY");
    const AbaqusCurve curve = block.step > 0 ? data_.curve(block) : AbaqusCurve{};
    const bool moves = held.magnitude != 0 || curve.absolute || block.option("TYPE") == "ACCELERATION";
    if (moves) {
      add_motion(block, card, held, nodes, curve);
    } else if (nodes.set.empty()) {
      Singles& singles = held_.try_emplace(held.directions, Singles{&block, card.place, {}}).first->second;
      singles.numbers.push_back(nodes.number);
    } else {
      write_abaqus_head("constraint", block, card.place, scene_);
      write_fixed(held.directions);
      write_abaqus_nodes(nodes, scene_);
    }
  }

  void add_motion(const AbaqusBlock& block, const Card& card, const Held& held, const AbaqusNodes& nodes,
                  const AbaqusCurve& curve) {
    std::string quantity = lower_case(block.option("TYPE"));
    if (quantity.empty()) quantity = "displacement";
    if (block.step == 0) {
      data_.report.refuse(card.place, "*BOUNDARY that moves nodes before the step");
      return;
    }
    if (quantity == "displacement" && curve.times.empty()) {
      data_.report.refuse(card.place, "*BOUNDARY: a displacement at once, without AMPLITUDE");
      return;
    }
    for (unsigned k = 0; k < 3; ++k) {
      if ((held.directions >> k & 1U) == 0) continue;
      Point direction{};
      direction[k] = 1;
      write_abaqus_head("prescribed_velocity", block, card.place, scene_);
      scene_.key("direction", direction);
      scene_.key("speed", curve.times.empty() ? held.magnitude : 1.0);
      scene_.key("quantity", quantity);
      write_curve(curve, held.magnitude, scene_);
      write_abaqus_nodes(nodes, scene_);
    }
  }

  AbaqusData& data_;
  TomlText& scene_;
  std::map<unsigned, Singles> held_;
};

}  // namespace

void translate_abaqus_boundary(AbaqusData& data, TomlText& scene) { Boundary(data, scene).translate(); }

namespace {

/// A label of *INITIAL CONDITIONS with the velocity that its lines give together.
struct Moving {
  AbaqusNodes nodes;
  DeckPlace place;
  Point velocity{};
  std::array<bool, 3> given{};
};

/// Whether a node is in two of them: what one leaves out, the other may give.
bool overlap(const std::vector<Moving>& all, std::size_t nodes) {
  std::vector<bool> taken(nodes, false);
  for (const Moving& one : all) {
    for (const std::int32_t node : one.nodes.members) {
      if (taken[static_cast<std::size_t>(node)]) return true;
      taken[static_cast<std::size_t>(node)] = true;
    }
  }
  return false;
}

/// Each node by itself: later lines replace the components that they give.
void write_by_node(const AbaqusData& data, const std::vector<Moving>& all, const AbaqusBlock& block, TomlText& scene) {
  std::map<std::int32_t, Point> of_node;
  for (const Moving& one : all) {
    for (const std::int32_t node : one.nodes.members) {
      Point& velocity = of_node[node];
      for (std::size_t k = 0; k < 3; ++k) {
        if (one.given[k]) velocity[k] = one.velocity[k];
      }
    }
  }
  std::map<Point, std::vector<std::int64_t>> nodes;
  for (const auto& [node, velocity] : of_node) {
    if (data.used[static_cast<std::size_t>(node)]) {
      nodes[velocity].push_back(data.mesh.file.node_ids[static_cast<std::size_t>(node)]);
    } else {
      data.report.ignore_node(block.place, "*INITIAL CONDITIONS");
    }
  }
  for (const auto& [velocity, numbers] : nodes) {
    write_abaqus_head("initial_velocity", block, block.place, scene);
    scene.key("velocity", velocity);
    scene.key("nodes", numbers);
  }
}

}  // namespace

void translate_abaqus_initial_velocities(AbaqusData& data, TomlText& scene) {
  std::vector<Moving> all;
  std::map<std::string, std::size_t> known;
  const AbaqusBlock* last = nullptr;
  for (const AbaqusBlock& block : data.deck.blocks) {
    if (block.name != "INITIALCONDITIONS") continue;
    last = &block;
    DataLines lines(block);
    while (const auto card = lines.next()) {
      const DataFields f(*card);
      const std::int64_t degree = f.integer(1, "degree of freedom");
      const double value = f.number(2, "velocity", 0.0);
      if (degree < 1 || degree > 3) continue;  // rotations
      const auto [found, is_new] = known.try_emplace(label_key(f.text(0)), all.size());
      if (is_new) all.push_back({data.nodes(f.text(0), card->place), card->place, {}, {}});
      all[found->second].velocity[static_cast<std::size_t>(degree - 1)] = value;
      all[found->second].given[static_cast<std::size_t>(degree - 1)] = true;
    }
  }
  const bool singles = std::ranges::any_of(all, [](const Moving& one) { return one.nodes.set.empty(); });
  if (singles || overlap(all, data.used.size())) {
    write_by_node(data, all, *last, scene);
    return;
  }
  for (const Moving& one : all) {
    write_abaqus_head("initial_velocity", *last, one.place, scene);
    scene.key("velocity", one.velocity);
    write_abaqus_nodes(one.nodes, scene);
  }
}

}  // namespace pinball
