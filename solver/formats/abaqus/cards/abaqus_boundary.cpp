#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <tuple>

#include <solver/base/error.hpp>

#include "abaqus_parts.hpp"
#include "abaqus_transform.hpp"

namespace pinball {

void set_nodes(const AbaqusNodes& nodes, const DeckKeys<NodeSelection>& keys) {
  if (nodes.set.empty()) {
    keys.set("nodes", std::vector<std::int64_t>{nodes.number});
  } else {
    keys.set("set", nodes.set);
  }
}

bool is_translation(AbaqusData& data, const AbaqusBlock& block, const DeckPlace& place, std::int64_t degree) {
  if (degree >= 4 && degree <= 6) data.report.ignore(place, block.star_name() + " of rotations of nodes of solids");
  if (degree < 1 || degree > 6)
    data.report.reject(place, fmt::format("{} with degree of freedom {}", block.star_name(), degree));
  return degree >= 1 && degree <= 3;
}

namespace {

/// One data line of *BOUNDARY: directions by their bits x, y, z, and behind these of rotations about them.
struct Held {
  unsigned directions = 0;
  double magnitude = 0;
};

unsigned named_directions(const std::string& name, const DeckPlace& place) {
  static const std::map<std::string, unsigned> names{
      {"ENCASTRE", 0b111'111}, {"PINNED", 0b000'111}, {"XSYMM", 0b110'001},  {"YSYMM", 0b101'010},
      {"ZSYMM", 0b011'100},    {"XASYMM", 0b001'110}, {"YASYMM", 0b010'101}, {"ZASYMM", 0b100'011}};
  const auto found = names.find(name);
  if (found == names.end()) fail_at(place, fmt::format("*BOUNDARY: expected degrees of freedom, got \"{}\"", name));
  return found->second;
}

/// rotates: of a reference node; of others those of rotations are reported.
Held held_of(AbaqusData& data, const AbaqusBlock& block, const DataFields& f, bool rotates) {
  if (!f.blank(1) && !deck_integer(f.text(1)))
    return {named_directions(squeezed(f.text(1)), f.place()) & (rotates ? 63U : 7U), 0.0};
  Held held{0, f.number(3, "magnitude", 0.0)};
  const std::int64_t first = f.integer(1, "first degree of freedom"), last = f.integer(2, "last one", first);
  if (last < first)
    fail_at(f.place(),
            fmt::format("*BOUNDARY: expected the first degree of freedom before the last, got {} and {}", first, last));
  for (std::int64_t degree = std::clamp<std::int64_t>(first, 1, 7); degree <= std::min<std::int64_t>(last, 6);
       ++degree) {
    if (rotates || is_translation(data, block, f.place(), degree)) held.directions |= 1U << (degree - 1);
  }
  if (first < 1 || first > 6) is_translation(data, block, f.place(), first);
  if (last > 6 && last != first) is_translation(data, block, f.place(), last);
  return held;
}

/// A line of *BOUNDARY and when it acts.
struct BoundaryLine {
  const AbaqusBlock* block;
  DeckPlace place;
  AbaqusNodes nodes;
  Held held;
  bool moves = false;
  AbaqusCurve curve;
  double start = 0;
  std::optional<double> end{};
  const AbaqusTransform* transform = nullptr;  ///< of its directions; null: those of the scene
};

class Boundary {
 public:
  Boundary(AbaqusData& data, const AbaqusTransforms& transforms, DeckScene& scene)
      : data_(data), transforms_(transforms), scene_(scene) {}

  void translate() {
    for (int step = 0; step <= std::ssize(data_.steps); ++step) read_step(step);
    for (const BoundaryLine& line : lines_) write(line);
    for (const auto& [kind, singles] : singles_) {
      begin_fixed(*singles.first).set("nodes", singles.numbers);
    }
  }

 private:
  /// Nodes of no set that are held alike.
  struct Singles {
    const BoundaryLine* first;
    std::vector<std::int64_t> numbers;
  };

  /// Step 0: what stands before all steps.
  void read_step(int step) {
    const std::size_t before = lines_.size();
    std::vector<const AbaqusBlock*> blocks;
    for (const AbaqusBlock& block : data_.deck.blocks) {
      if (block.name == "BOUNDARY" && block.step == step) blocks.push_back(&block);
    }
    const auto is_new = [](const AbaqusBlock* block) { return block->option("OP") == "NEW"; };
    if (step > 0 && std::ranges::any_of(blocks, is_new)) end_all(data_.step_of(*blocks.front()).start);
    for (const AbaqusBlock* block : blocks) {
      DataLines lines(*block);
      while (const auto card = lines.next()) add(*block, *card);
    }
    if (step == 0) return;
    for (std::size_t i = before, after = lines_.size(); i < after; ++i) replace(BoundaryLine(lines_[i]));
  }

  bool are_references(const AbaqusNodes& nodes) {
    return std::ranges::all_of(nodes.members, [&](std::int32_t node) { return data_.rigid_at(node) != nullptr; });
  }

  void end_all(double time) {
    const AbaqusBlock* last = nullptr;
    for (BoundaryLine& line : lines_) {
      if (line.end) continue;
      line.end = time;
      if (line.block != last)
        data_.report.understood(
            fmt::format("*BOUNDARY ({}): ends where the step begins (OP=NEW)", line.block->place.text()));
      last = line.block;
    }
  }

  void add(const AbaqusBlock& block, const DataLine& card) {
    const DataFields f(card);
    const AbaqusNodes nodes = data_.nodes(f.text(0), card.place);
    const bool rigid = data_.has_reference(nodes);
    const Held held = held_of(data_, block, f, rigid);
    if (held.directions == 0) return;
    if (rigid && !are_references(nodes))
      return data_.report.reject(card.place, "*BOUNDARY of a reference node of a rigid body and of other nodes",
                                 "give each its own line");
    if (!rigid && nodes.set.empty() && !data_.used[nodes.members[0]])
      return data_.report.ignore_node(card.place, "*BOUNDARY");
    BoundaryLine line{&block, card.place, nodes, held, false, {}, block.step > 0 ? data_.step_of(block).start : 0.0};
    line.transform = transforms_.of(nodes, block, card.place);
    if (rigid && line.transform != nullptr)
      return data_.report.reject(card.place, "*BOUNDARY of a reference node with a *TRANSFORM",
                                 "hold and move it along the axes of the scene");
    if (block.step > 0) line.curve = data_.curve(block);
    line.moves = held.magnitude != 0 || line.curve.absolute || block.option("TYPE") == "ACCELERATION";
    if (!line.moves || may_move(line)) lines_.push_back(line);
  }

  /// What a line in a step says of nodes that one of an earlier step holds or moves counts from the step on; that both
  /// hold them is nothing new.
  void replace(const BoundaryLine& later) {
    const auto of_later = [&](std::int32_t node) { return std::ranges::binary_search(later.nodes.members, node); };
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      const unsigned common = lines_[i].held.directions & later.held.directions;
      if (lines_[i].block->step >= later.block->step || lines_[i].end) continue;
      if (common == 0 || (!lines_[i].moves && !later.moves)) continue;
      if (std::ranges::none_of(lines_[i].nodes.members, of_later)) continue;
      BoundaryLine ended = lines_[i], rest = lines_[i];
      ended.held.directions = rest.held.directions = common;
      ended.end = later.start;
      std::erase_if(ended.nodes.members, std::not_fn(of_later));
      std::erase_if(rest.nodes.members, of_later);
      lines_[i].held.directions &= ~common;
      if (!rest.nodes.members.empty()) {
        ended.nodes.set = rest.nodes.set = "";
        lines_.push_back(rest);
      }
      lines_.push_back(ended);
    }
  }

  bool may_move(const BoundaryLine& line) {
    const std::string quantity = quantity_of(line);
    std::string rejected;
    if (line.block->step == 0) rejected = "*BOUNDARY that moves nodes before the step";
    if (line.block->step > 1 && quantity == "acceleration") rejected = "*BOUNDARY: a later step gives no accelerations";
    if (quantity == "displacement" && line.curve.times.empty())
      rejected = "*BOUNDARY: a displacement at once, without AMPLITUDE";
    if (!rejected.empty()) data_.report.reject(line.place, rejected);
    return rejected.empty();
  }

  static std::string quantity_of(const BoundaryLine& line) {
    const std::string quantity = lower_case(line.block->option("TYPE"));
    return quantity.empty() ? "displacement" : quantity;
  }

  void write(const BoundaryLine& line) {
    if (line.held.directions == 0 || (line.end && *line.end <= line.start)) return;
    if (data_.has_reference(line.nodes)) return write_rigid(line);
    if (line.nodes.set.empty() && numbers_of(line).empty()) return;
    if (line.moves) {
      write_motion(line);
    } else if (line.nodes.set.empty()) {
      Singles& singles =
          singles_.try_emplace({line.held.directions, line.start, line.end, line.transform}, Singles{&line, {}})
              .first->second;
      for (const std::int64_t number : numbers_of(line)) singles.numbers.push_back(number);
    } else {
      begin_fixed(line).set("set", line.nodes.set);
    }
  }

  /// Of reference nodes: what is held from the first to the last is so of the body, all else is a motion.
  void write_rigid(const BoundaryLine& line) {
    for (const std::int32_t node : line.nodes.members) {
      AbaqusRigidBody& rigid = *data_.rigid_at(node);
      rigid.translations |= line.held.directions & 7U;
      for (unsigned k = 0; k < 6; ++k) {
        if ((line.held.directions >> k & 1U) != 0) rigid.led[k].push_back({line.start, line.end.value_or(data_.end())});
      }
      if (!line.moves && line.start == 0 && !line.end) {
        rigid.held |= line.held.directions;
        continue;
      }
      for (unsigned k = 0; k < 6; ++k) {
        if ((line.held.directions >> k & 1U) != 0) write_rigid_motion(line, rigid, k);
      }
    }
  }

  void write_rigid_motion(const BoundaryLine& line, AbaqusRigidBody& rigid, unsigned k) {
    Point direction{};
    direction[k % 3] = 1;
    const bool turns = k >= 3;
    const auto keys = scene_.entry<RigidMotion>("rigid_motion", card_of(*line.block, line.place));
    if (rigid.is_coupling()) keys.set("rigid_body", rigid.name);
    if (!rigid.bodies.empty()) keys.set("rigid_body", rigid.bodies.front());
    keys.set(turns ? KeyOf<RigidMotion>("axis") : KeyOf<RigidMotion>("direction"), direction);
    if (line.moves) {
      if (turns && quantity_of(line) == "displacement") rigid.angles |= 1U << k;
      keys.set(turns ? KeyOf<RigidMotion>("angular_speed") : KeyOf<RigidMotion>("speed"),
               line.curve.times.empty() ? line.held.magnitude : 1.0);
      keys.set("quantity", quantity_of(line));
      set_curve(line.curve, line.held.magnitude, keys);
    }
    set_times(line, keys);
  }

  /// Of nodes that an element has.
  std::vector<std::int64_t> numbers_of(const BoundaryLine& line) const {
    std::vector<std::int64_t> numbers;
    for (const std::int32_t node : line.nodes.members) {
      const std::size_t at = node;
      if (data_.used[at]) numbers.push_back(data_.mesh.file.node_ids[at]);
    }
    return numbers;
  }

  DeckKeys<FixedConstraint> begin_fixed(const BoundaryLine& line) {
    auto keys = scene_.entry<FixedConstraint>("constraint", card_of(*line.block, line.place));
    keys.set("type", "fixed");
    set_directions(line.held.directions, line.transform, keys);
    set_times(line, keys);
    return keys;
  }

  void write_motion(const BoundaryLine& line) {
    for (unsigned k = 0; k < 3; ++k) {
      if ((line.held.directions >> k & 1U) == 0) continue;
      const Point direction = transforms_.direction(line.transform, k, *line.block, line.place);
      const auto keys = scene_.entry<PrescribedVelocity>("prescribed_velocity", card_of(*line.block, line.place));
      keys.set("direction", direction);
      keys.set("speed", line.curve.times.empty() ? line.held.magnitude : 1.0);
      keys.set("quantity", quantity_of(line));
      set_curve(line.curve, line.held.magnitude, keys);
      set_times(line, keys);
      if (line.nodes.set.empty()) {
        keys.set("nodes", numbers_of(line));
      } else {
        keys.set("set", line.nodes.set);
      }
    }
  }

  static void set_times(const BoundaryLine& line, const DeckKeys<TimeSpan>& keys) {
    if (line.start > 0) keys.set("start", line.start);
    if (line.end) keys.set("end", *line.end);
  }

  AbaqusData& data_;
  const AbaqusTransforms& transforms_;
  DeckScene& scene_;
  std::vector<BoundaryLine> lines_;
  std::map<std::tuple<unsigned, double, std::optional<double>, const AbaqusTransform*>, Singles> singles_;
};

}  // namespace

void translate_abaqus_boundary(AbaqusData& data, const AbaqusTransforms& transforms, DeckScene& scene) {
  Boundary(data, transforms, scene).translate();
}

}  // namespace pinball
