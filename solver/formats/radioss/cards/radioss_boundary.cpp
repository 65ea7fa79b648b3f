#include <fmt/format.h>

#include <algorithm>

#include <solver/formats/radioss/layouts/radioss_boundary_cards.hpp>

#include "radioss_keys.hpp"

namespace pinball {

namespace {

/// "   111 111": in columns 4 to 6 translations, in 8 to 10 rotations, 1 where the direction is held.
unsigned held_of(const RadiossFields& f, const DataLine& line) {
  f.text("Trarot");  // whose places count
  unsigned bits = 0;
  for (const auto& [column, bit] : {std::pair{3, 1U}, {4, 2U}, {5, 4U}, {7, 8U}, {8, 16U}, {9, 32U}}) {
    const char c = static_cast<std::size_t>(column) < line.text.size() ? line.text[column] : ' ';
    if (c != '0' && c != '1' && c != ' ')
      f.fail("Trarot",
             fmt::format("expected 0 or 1 in columns 4 to 6 and 8 to 10, got \"{}\"", line.text.substr(0, 10)));
    if (c == '1') bits |= bit;
  }
  for (const std::size_t column : {0U, 1U, 2U, 6U}) {
    if (column < line.text.size() && line.text[column] != ' ')
      f.fail("Trarot",
             fmt::format("expected 0 or 1 in columns 4 to 6 and 8 to 10, got \"{}\"", line.text.substr(0, 10)));
  }
  return bits;
}

/// Nodes of the wall that a group moves or holds are refused: walls go as they are pushed.
bool has_wall(RadiossData& data, const MeshSet& group, const RadiossBlock& block, const DeckPlace& place) {
  for (const std::int32_t node : data.wall_nodes) {
    if (!std::ranges::binary_search(group.members, node)) continue;
    data.report.reject(place, fmt::format("{} of the node of a rigid wall", '/' + block.name),
                       "walls go as nodes push them");
    return true;
  }
  return false;
}

/// What is left of a group where its main nodes are seen to; false: nothing.
bool has_rest(RadiossData& data, const MeshSet& group, bool had_main, const RadiossBlock& block,
              const DeckPlace& place) {
  if (data.has_used(group)) return true;
  if (!had_main) data.report.ignore(place, fmt::format("{} of nodes of no solid", '/' + block.name));
  return false;
}

/// Nodes of solids in a group beside those of shells that are held as a whole: their numbers.
std::vector<std::int64_t> beside_held_shells(const RadiossData& data, const MeshSet& group) {
  std::vector<std::int64_t> numbers;
  for (const std::int32_t node : group.members) {
    const std::int32_t rigid = data.rigid_of_node[node];
    if (data.used[node] && (rigid < 0 || !data.rigid[rigid].is_held)) numbers.push_back(data.mesh.node_ids[node]);
  }
  return numbers;
}

/// Single nodes of rigid bodies cannot be held or moved by themselves.
bool has_rigid_nodes(RadiossData& data, const MeshSet& group, const RadiossBlock& block, const DeckPlace& place) {
  for (const std::int32_t node : group.members) {
    const std::int32_t rigid = data.rigid_of_node[node];
    if (rigid < 0 || (block.name == "BCS" && data.rigid[rigid].is_held)) continue;
    data.report.reject(place, fmt::format("{} of nodes of an /RBODY", '/' + block.name), "give its main node");
    return true;
  }
  return false;
}

void translate_held(RadiossData& data, const RadiossBlock& block, DeckScene& scene) {
  RadiossLines lines(block);
  while (const auto line = lines.next_filled()) {
    const RadiossFields f(*line, block, radioss::held);
    const unsigned bits = held_of(f, *line);
    const std::int64_t skew = f.integer("skew_ID"), id = f.integer("grnod_ID");
    if (id == 0) f.fail("grnod_ID", "expected the number of a group, got nothing");
    const MeshSet& group = data.node_group(id, line->place);
    if (has_wall(data, group, block, line->place)) continue;
    const auto mains = data.rigid_in(group);
    for (RadiossRigidBody* rigid : mains) {
      rigid->held |= bits;
      if (skew != 0)
        data.report.reject(line->place, block.title + " of a main node in a skew", "hold it along the global axes");
    }
    if (!has_rest(data, group, !mains.empty(), block, line->place)) continue;
    if ((bits & 7U) == 0) {
      if (bits != 0) data.report.unused(line->place, block.title + ": Trarot", "nodes of solids have no rotations");
      continue;
    }
    const bool has_shells = std::ranges::any_of(group.members, [&](std::int32_t node) {
      return data.rigid_of_node[node] >= 0 && data.rigid[data.rigid_of_node[node]].is_held;
    });
    const std::vector<std::int64_t> others = has_shells ? beside_held_shells(data, group) : std::vector<std::int64_t>{};
    if ((has_shells && others.empty()) || has_rigid_nodes(data, group, block, line->place)) continue;
    const auto keys = scene.entry<FixedConstraint>("constraint", card_of(block, line->place));
    keys.set("type", "fixed");
    if (skew == 0) {
      keys.set("directions", direction_names(bits), "Trarot");
    } else {
      const auto axes = data.axes(skew, line->place);
      std::vector<Point> directions;
      for (unsigned k = 0; k < 3; ++k) {
        if ((bits >> k & 1U) != 0) directions.push_back(axes[k]);
      }
      keys.set("directions", directions, "Trarot, skew_ID");
    }
    if (has_shells) {
      keys.set("nodes", others, "grnod_ID");
    } else {
      keys.set("set", std::to_string(id), "grnod_ID");
    }
  }
}

void set_span(const RadiossFields& f, const DeckKeys<TimeSpan>& keys) {
  const double start = f.number("Tstart"), stop = f.number("Tstop");
  if (start > 0) keys.set("start", start, "Tstart");
  if (stop > 0 && stop < 1e19) keys.set("end", stop, "Tstop");
}

const char* quantity_of(const RadiossBlock& block) {
  return block.name == "IMPVEL" ? "velocity" : block.name == "IMPDISP" ? "displacement" : "acceleration";
}

void move_rigid(const RadiossData& data, const RadiossBlock& block, const RadiossFields& f, const RadiossFields& s,
                const RadiossRigidBody& rigid, const Point& direction, bool turns, DeckScene& scene) {
  const auto keys = scene.entry<RigidMotion>("rigid_motion", card_of(block, f.place()));
  keys.set("rigid_body", rigid.name, "grnod_ID");
  keys.set(turns ? KeyOf<RigidMotion>("axis") : KeyOf<RigidMotion>("direction"), direction, "Dir");
  keys.set(turns ? KeyOf<RigidMotion>("angular_speed") : KeyOf<RigidMotion>("speed"), 1.0);
  keys.set("quantity", quantity_of(block));
  data.set_function(f.integer("fct_IDT"), s.number("Ascale_x"), s.number("Fscale_y"), f.place(), keys);
  set_span(s, keys);
}

void translate_motion(RadiossData& data, const RadiossBlock& block, DeckScene& scene) {
  RadiossLines lines(block);
  const DataLine first = lines.require("a function, a direction and a group"), second = lines.next_or_blank();
  const RadiossFields f(first, block, radioss::motion), s(second, block, radioss::motion_scales);
  const int degree = degree_of(f, "Dir");
  const bool turns = degree >= 3;
  const Point direction = data.axes(f.integer("skew_ID"), first.place)[degree % 3];
  const std::int64_t id = f.integer("grnod_ID");
  const MeshSet& group = data.node_group(id, first.place);
  if (has_wall(data, group, block, first.place)) return;
  const auto mains = data.rigid_in(group);
  for (const RadiossRigidBody* rigid : mains) move_rigid(data, block, f, s, *rigid, direction, turns, scene);
  if (!has_rest(data, group, !mains.empty(), block, first.place)) return;
  if (turns) {
    data.report.unused(first.place, block.title, "nodes of solids have no rotations");
    if (block.log != nullptr) block.log->done(&block);
    return;
  }
  if (has_rigid_nodes(data, group, block, first.place)) return;
  const auto keys = scene.entry<PrescribedVelocity>("prescribed_velocity", card_of(block, first.place));
  keys.set("direction", direction, "Dir");
  keys.set("speed", 1.0);
  keys.set("quantity", quantity_of(block));
  data.set_function(f.integer("fct_IDT"), s.number("Ascale_x"), s.number("Fscale_y"), first.place, keys);
  set_span(s, keys);
  keys.set("set", std::to_string(id), "grnod_ID");
}

}  // namespace

void translate_radioss_boundary(RadiossData& data, DeckScene& scene) {
  for (const RadiossBlock& block : data.deck.blocks) {
    if (block.engine) continue;
    if (block.name == "BCS") translate_held(data, block, scene);
    if (block.name == "IMPVEL" || block.name == "IMPDISP" || block.name == "IMPACC")
      translate_motion(data, block, scene);
  }
}

}  // namespace pinball
