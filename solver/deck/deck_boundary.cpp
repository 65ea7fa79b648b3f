#include <fmt/format.h>

#include <algorithm>
#include <map>

#include <solver/keyword/number_index.hpp>

#include "deck_parts.hpp"

namespace pinball {

namespace {

constexpr std::array<int, 6> node_columns{8, 16, 16, 16, 8, 8}, wide_node_columns{10, 16, 16, 16, 10, 10};

/// Directions that are held, by their bits x, y, z, and the local system that they are of.
struct Held {
  unsigned directions = 0;
  std::int64_t system = 0;
  auto operator<=>(const Held&) const = default;
};

void write_directions(const DeckData& data, const Held& held, const DeckPlace& place, TomlText& scene) {
  const std::array<Point, 3> axes = data.axes(held.system, place);
  std::vector<std::string> directions;
  for (unsigned k = 0; k < 3; ++k) {
    if ((held.directions >> k & 1U) == 0) continue;
    directions.push_back(held.system == 0 ? fmt::format("\"{}\"", "xyz"[k]) : toml(axes[k]));
  }
  scene.raw("directions", fmt::format("[{}]", fmt::join(directions, ", ")));
}

void write_nodes(const std::vector<std::int64_t>& nodes, TomlText& scene) { scene.key("nodes", nodes); }

/// Times and factors of a curve.
void write_curve(const DeckCurve& curve, double scale, TomlText& scene) {
  std::vector<double> factors = curve.ordinate;
  for (double& factor : factors) factor *= scale;
  scene.key("times", curve.abscissa);
  scene.key("factors", factors);
}

Point axis_of(std::int64_t degree) {
  Point axis{};
  axis[degree - 1] = 1;
  return axis;
}

/// The tables of everything: one for each body.
template <class Write>
void for_each_body(const DeckData& data, const Write& write) {
  for (const DeckPart& part : data.parts) write(part.body);
}

}  // namespace

void translate_node_codes(DeckData& data, TomlText& scene) {
  static constexpr unsigned directions_of_code[8] = {0, 1, 2, 4, 3, 6, 5, 7};
  std::map<unsigned, std::vector<std::int64_t>> nodes;
  const NumberIndex index(data.mesh.node_ids);
  for (const KeywordBlock& block : data.deck.blocks) {
    if (block.name != "NODE") continue;
    const std::span<const int> columns(block.wide ? wide_node_columns : node_columns);
    Cards cards(block);
    while (const auto card = cards.next_filled()) {
      const Fields f(*card, data.deck.parameters, columns);
      const std::int64_t code = f.integer(4, "tc", 0);
      if (code < 0 || code > 7) fail_at(card->place, fmt::format("*NODE: tc: expected 0 to 7, got {}", code));
      if (code == 0) continue;
      const std::int64_t id = f.integer(0, "nid") + offset_of(block, &DeckTransform::node);
      if (data.used[index.find(id)]) nodes[directions_of_code[code]].push_back(id);
    }
  }
  for (const auto& [directions, ids] : nodes) {
    scene.entry("constraint", "TC of *NODE");
    scene.key("type", "fixed");
    write_directions(data, {directions, 0}, {}, scene);
    write_nodes(ids, scene);
  }
}

namespace {

/// What the numbers behind that of a node or a set say; nothing for rotations alone.
Held held_of(const Fields& f, const KeywordBlock& block) {
  Held held;
  const std::int64_t system = f.integer(1, "cid", 0);
  held.system = system == 0 ? 0 : system + offset_of(block, &DeckTransform::define);
  for (unsigned k = 0; k < 3; ++k) {
    if (f.integer(2 + k, "dof", 0) != 0) held.directions |= 1U << k;
  }
  return held;
}

}  // namespace

void translate_single_point_constraints(DeckData& data, TomlText& scene) {
  std::map<Held, std::pair<std::vector<std::int64_t>, DeckPlace>> nodes;
  const NumberIndex index(data.mesh.node_ids);
  for (const KeywordBlock& block : data.deck.blocks) {
    if (block.name != "BOUNDARY_SPC_NODE" && block.name != "BOUNDARY_SPC_SET") continue;
    Cards cards(block);
    while (true) {
      if (block.id && !cards.next()) break;
      const auto card = cards.next_filled();
      if (!card) break;
      const Fields f = data.fields(*card);
      const Held held = held_of(f, block);
      if (held.directions == 0) continue;
      if (block.name == "BOUNDARY_SPC_SET") {
        scene.entry("constraint", fmt::format("{} {}", block.star_name(), card->place.text()));
        scene.key("type", "fixed");
        write_directions(data, held, card->place, scene);
        scene.key("set", std::to_string(f.integer(0, "nsid") + offset_of(block, &DeckTransform::set)));
        continue;
      }
      const std::int64_t id = f.integer(0, "nid") + offset_of(block, &DeckTransform::node);
      const std::int32_t place = index.find(id);
      if (place < 0) fail_at(card->place, fmt::format("{}: node {} is not there", block.star_name(), id));
      auto& [ids, first] = nodes[held];
      if (ids.empty()) first = card->place;
      if (data.used[place]) ids.push_back(id);
    }
  }
  for (const auto& [held, ids] : nodes) {
    if (ids.first.empty()) continue;
    scene.entry("constraint", "*BOUNDARY_SPC_NODE " + ids.second.text());
    scene.key("type", "fixed");
    write_directions(data, held, ids.second, scene);
    write_nodes(ids.first, scene);
  }
}

void translate_prescribed_motion(DeckData& data, const KeywordBlock& block, TomlText& scene) {
  static const char* const quantities[] = {"velocity", "acceleration", "displacement"};
  const bool set = block.name.ends_with("_SET");
  Cards cards(block);
  while (true) {
    if (block.id && !cards.next()) return;
    const auto card = cards.next_filled();
    if (!card) return;
    const Fields f = data.fields(*card);
    const std::int64_t degree = f.integer(1, "dof"), quantity = f.integer(2, "vad", 0);
    if (quantity < 0 || quantity > 2 || !((degree >= 1 && degree <= 3) || degree == 4)) {
      if (degree >= 5 && degree <= 7) continue;  // rotations of nodes of solids
      data.report.refuse(card->place, fmt::format("{} with DOF {} and VAD {}", block.star_name(), degree, quantity));
      continue;
    }
    const double death = f.number(6, "death", 0.0);
    if (f.number(7, "birth", 0.0) != 0 || (death != 0 && death < 1e27)) {
      data.report.refuse(card->place, block.star_name() + " with birth or death");
      continue;
    }
    const double scale = f.number(4, "sf", 1.0);
    const Point direction =
        degree == 4 ? data.vector(f.integer(5, "vid") + offset_of(block, &DeckTransform::define), card->place)
                    : axis_of(degree);
    scene.entry("prescribed_velocity", fmt::format("{} {}", block.star_name(), card->place.text()));
    scene.key("direction", direction);
    scene.key("speed", 1.0);
    scene.key("quantity", quantities[quantity]);
    write_curve(data.curve(f.integer(3, "lcid") + offset_of(block, &DeckTransform::define), card->place),
                scale == 0 ? 1.0 : scale, scene);
    const std::int64_t id = f.integer(0, "node or set");
    if (set) {
      scene.key("set", std::to_string(id + offset_of(block, &DeckTransform::set)));
    } else {
      write_nodes({id + offset_of(block, &DeckTransform::node)}, scene);
    }
  }
}

namespace {

Point velocity_of(const Fields& f, std::size_t first) {
  return {f.number(first, "vx", 0.0), f.number(first + 1, "vy", 0.0), f.number(first + 2, "vz", 0.0)};
}

}  // namespace

/// Set, and then velocity.
void translate_initial_velocity(DeckData& data, const KeywordBlock& block, TomlText& scene) {
  Cards cards(block);
  const Card head = cards.require("the set of nodes");
  const Card card = cards.require("the velocity");
  const Fields f = data.fields(head);
  if (f.integer(1, "nsidex", 0) != 0 || f.integer(2, "boxid", 0) != 0 || f.integer(4, "icid", 0) != 0) {
    data.report.refuse(head.place, block.star_name() + " with NSIDEX, BOXID or ICID");
    return;
  }
  const Point velocity = velocity_of(data.fields(card), 0);
  const std::int64_t set = f.integer(0, "nsid", 0);
  const auto write = [&](const char* key, const std::string& value) {
    scene.entry("initial_velocity", fmt::format("{} {}", block.star_name(), block.place.text()));
    scene.key("velocity", velocity);
    scene.key(key, value);
  };
  if (set != 0) {
    write("set", std::to_string(set + offset_of(block, &DeckTransform::set)));
  } else {
    for_each_body(data, [&](const std::string& body) { write("body", body); });
  }
}

void translate_initial_velocity_of_nodes(DeckData& data, const KeywordBlock& block, TomlText& scene) {
  std::map<Point, std::vector<std::int64_t>> nodes;
  const NumberIndex index(data.mesh.node_ids);
  Cards cards(block);
  while (const auto card = cards.next_filled()) {
    const Fields f = data.fields(*card);
    const std::int64_t id = f.integer(0, "nid") + offset_of(block, &DeckTransform::node);
    const std::int32_t place = index.find(id);
    if (place < 0) fail_at(card->place, fmt::format("{}: node {} is not there", block.star_name(), id));
    if (data.used[place]) nodes[velocity_of(f, 1)].push_back(id);
  }
  for (const auto& [velocity, ids] : nodes) {
    scene.entry("initial_velocity", fmt::format("{} {}", block.star_name(), block.place.text()));
    scene.key("velocity", velocity);
    write_nodes(ids, scene);
  }
}

/// One card, or one with a second for a spin.
void translate_velocity_generation(DeckData& data, const KeywordBlock& block, TomlText& scene) {
  Cards cards(block);
  while (const auto card = cards.next_filled()) {
    const Fields f = data.fields(*card);
    cards.next();  // of the spin
    if (f.number(2, "omega", 0.0) != 0 || f.integer(7, "icid", 0) != 0) {
      data.report.refuse(card->place, block.star_name() + " with a spin (OMEGA) or a local system (ICID)");
      continue;
    }
    const Point velocity = velocity_of(f, 3);
    const auto write = [&](const char* key, const std::string& value) {
      scene.entry("initial_velocity", fmt::format("{} {}", block.star_name(), card->place.text()));
      scene.key("velocity", velocity);
      scene.key(key, value);
    };
    const std::int64_t id = f.integer(0, "id", 0), kind = f.integer(1, "styp", 0);
    if (id == 0) {
      for_each_body(data, [&](const std::string& body) { write("body", body); });
    } else if (kind == 3) {
      write("set", std::to_string(id + offset_of(block, &DeckTransform::set)));
    } else if (kind == 1 || kind == 2) {
      const auto parts = kind == 1 ? data.part_set(id + offset_of(block, &DeckTransform::set), card->place)
                                   : std::vector{id + offset_of(block, &DeckTransform::part)};
      for (const std::int64_t part : parts) {
        if (const auto body = data.body_of(part, card->place)) write("body", *body);
      }
    } else {
      fail_at(card->place, fmt::format("{}: styp: expected 1, 2 or 3, got {}", block.star_name(), kind));
    }
  }
}

void translate_rigid_wall(DeckData& data, const KeywordBlock& block, std::size_t number, TomlText& scene) {
  Cards cards(block);
  if (block.id) cards.next();
  const Card head = cards.require("the nodes of the wall");
  const Card card = cards.require("the plane of the wall");
  const Fields f = data.fields(head), plane = data.fields(card);
  const double death = f.number(5, "death", 0.0);
  if (f.integer(0, "nsid", 0) != 0 || f.integer(1, "nsidex", 0) != 0 || f.integer(2, "boxid", 0) != 0) {
    data.report.refuse(head.place, block.star_name() + " for a set of nodes");
    return;
  }
  if (f.number(4, "birth", 0.0) != 0 || (death != 0 && death < 1e19) || plane.number(6, "fric", 0.0) >= 1.0 + 1e-12) {
    data.report.refuse(head.place, block.star_name() + " with birth, death or nodes that stick (FRIC > 1)");
    return;
  }
  Point point{}, normal{};
  for (std::size_t k = 0; k < 3; ++k) {
    point[k] = plane.number(k, "tail", 0.0);
    normal[k] = plane.number(3 + k, "head", 0.0) - point[k];
  }
  scene.entry("rigid_wall", fmt::format("{} {}", block.star_name(), block.place.text()));
  scene.key("name", fmt::format("wall_{}", number));
  scene.key("point", point);
  scene.key("normal", normal);
  scene.key("friction", plane.number(6, "fric", 0.0));
}

void translate_node_load(DeckData& data, const KeywordBlock& block, TomlText& scene) {
  const bool set = block.name.ends_with("_SET");
  Cards cards(block);
  while (const auto card = cards.next_filled()) {
    const Fields f = data.fields(*card);
    const std::int64_t degree = f.integer(1, "dof"), system = f.integer(4, "cid", 0);
    if (degree < 1 || degree > 3) {
      if (degree >= 5 && degree <= 7) continue;  // moments on nodes of solids
      data.report.refuse(card->place, fmt::format("{} with DOF {}", block.star_name(), degree));
      continue;
    }
    const auto axes = data.axes(system == 0 ? 0 : system + offset_of(block, &DeckTransform::define), card->place);
    const double scale = f.number(3, "sf", 1.0);
    scene.entry("load", fmt::format("{} {}", block.star_name(), card->place.text()));
    scene.key("force", axes[degree - 1]);
    scene.key("each", true);
    write_curve(data.curve(f.integer(2, "lcid") + offset_of(block, &DeckTransform::define), card->place),
                scale == 0 ? 1.0 : scale, scene);
    const std::int64_t id = f.integer(0, "node or set");
    if (set) {
      scene.key("set", std::to_string(id + offset_of(block, &DeckTransform::set)));
    } else {
      write_nodes({id + offset_of(block, &DeckTransform::node)}, scene);
    }
  }
}

void translate_body_load(DeckData& data, const KeywordBlock& block, TomlText& scene) {
  Cards cards(block);
  const Card card = cards.require("the curve of the load");
  const Fields f = data.fields(card);
  if (f.integer(6, "cid", 0) != 0) {
    data.report.refuse(card.place, block.star_name() + " with a local system");
    return;
  }
  const double scale = f.number(1, "sf", 1.0);
  Point acceleration{};
  acceleration[block.name.back() - 'X'] = -1;
  scene.entry("gravity", fmt::format("{} {}: the frame is accelerated, bodies the other way", block.star_name(),
                                     card.place.text()));
  scene.key("acceleration", acceleration);
  write_curve(data.curve(f.integer(0, "lcid") + offset_of(block, &DeckTransform::define), card.place),
              scale == 0 ? 1.0 : scale, scene);
}

}  // namespace pinball
