#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <span>
#include <string>
#include <utility>

#include <solver/base/counted.hpp>
#include <solver/mesh/file/split_ten_nodes.hpp>

#include "abaqus_parts.hpp"

namespace pinball {

namespace {

/// What a deck loads more than once in a step: all of it acts, as in CalculiX (forcadd.f, loadadd.f). OP says what
/// becomes of loads of the steps before, and not of those of the same one.
class RepeatedLoads {
 public:
  explicit RepeatedLoads(DeckReport& report) : report_(report) {}

  /// One load of a card: what it is and what it acts on, in words that no other has.
  void add(const std::string& load) {
    if (!seen_.insert(load).second && repeated_++ == 0) first_ = load;
  }
  void end_of_card(const DeckPlace& place, const std::string& star_name) {
    if (repeated_ > 0)
      report_.understood(fmt::format("{} ({}): {} that {} there already, the first is {}; both act, and add up",
                                     star_name, place.text(), counted(repeated_, "load"), repeated_ == 1 ? "is" : "are",
                                     first_));
    repeated_ = 0;
  }

 private:
  DeckReport& report_;
  std::set<std::string> seen_;
  std::string first_;
  int repeated_ = 0;  ///< of this card
};

/// Without the nodes that hexahedra of twenty nodes have got: a force on each node is one of the nodes of the deck.
void set_given_nodes(const AbaqusData& data, const AbaqusNodes& nodes, const DeckKeys<NodeSelection>& keys) {
  const auto is_new = [&](std::int32_t node) { return static_cast<std::size_t>(node) >= data.mesh.given_nodes; };
  if (std::ranges::none_of(nodes.members, is_new)) return set_nodes(nodes, keys);
  std::vector<std::int64_t> numbers;
  for (const std::int32_t node : nodes.members) {
    if (!is_new(node) && data.used[node]) numbers.push_back(data.mesh.file.node_ids[node]);
  }
  keys.set("nodes", numbers);
}

void write_force(AbaqusData& data, const AbaqusBlock& block, const DataLine& card, RepeatedLoads& loads,
                 DeckScene& scene) {
  const DataFields f(card);
  const std::int64_t degree = f.integer(1, "degree of freedom");
  const AbaqusNodes nodes = data.nodes(f.text(0), card.place);
  if (data.has_reference(nodes))
    return data.report.reject(card.place, "*CLOAD of the reference node of a rigid body",
                              "give it to nodes of its elements");
  if (!is_translation(data, block, card.place, degree)) return;
  const double magnitude = f.number(2, "magnitude", 0.0);
  const AbaqusCurve curve = data.curve(block);
  Point force{};
  force[degree - 1] = curve.times.empty() ? magnitude : 1.0;
  const auto keys = scene.entry<NodalLoad>("load", card_of(block, card.place));
  keys.set("force", force);
  keys.set("each", true);
  set_curve(curve, magnitude, keys);
  set_given_nodes(data, nodes, keys);
  for (const std::int32_t node : nodes.members)
    loads.add(fmt::format("that of node {} along {}", data.mesh.file.node_ids[node], "xyz"[degree - 1]));
}

/// Per node of the mesh: whether one of these bodies has it, or a rigid body with one of these has its reference there.
std::vector<bool> nodes_of_bodies(const AbaqusData& data, const std::vector<std::string>& names) {
  const auto is_named = [&](const std::string& name) { return std::ranges::count(names, name) > 0; };
  std::vector<bool> sections(data.mesh.file.parts.size(), false), nodes(data.used.size(), false);
  for (const AbaqusBody& body : data.bodies) sections[body.section] = is_named(body.name);
  for (std::size_t e = 0; e < data.mesh.file.part.size(); ++e) {
    if (!sections[data.mesh.file.part[e]]) continue;
    for (const std::int32_t node : data.mesh.file.mesh.hexahedra[e]) nodes[node] = true;
  }
  for (const AbaqusRigidBody& rigid : data.rigid) {
    if (rigid.node >= 0 && std::ranges::any_of(rigid.bodies, is_named)) nodes[rigid.node] = true;
  }
  return nodes;
}

/// What gravity does not act on as the deck has it: a *MASS is an element of its own, and has the weight that a load of
/// its set gives it. bodies: of the set; none: it is not made of whole ones. Empty: all is done.
std::pair<std::string, std::string> undone_weight(const AbaqusData& data, const std::string& set,
                                                  const std::vector<std::string>& bodies, const DeckPlace& place) {
  const std::pair<std::string, std::string> alone{
      "*DLOAD, GRAV of elements of one node without the solids of their nodes", "put these into its ELSET"};
  if (bodies.empty())
    return data.elements(set, place).empty()
               ? alone
               : std::pair<std::string, std::string>{"*DLOAD, GRAV of a part of a section", ""};
  if (set.empty()) return {};
  const std::vector<bool> nodes = nodes_of_bodies(data, bodies);
  for (const AbaqusPointElement* point : data.heavy_points) {
    const bool is_loaded = nodes[point->node];
    if (is_loaded == set_has_point(data, set, *point)) continue;
    if (!is_loaded) return alone;
    return {"*DLOAD, GRAV of solids without the *MASS of their nodes",
            "put the elements of one node into its ELSET, or leave that blank: all of the model"};
  }
  return {};
}

/// Magnitude and direction of an acceleration.
void write_gravity(AbaqusData& data, const AbaqusBlock& block, const DataLine& card, RepeatedLoads& loads,
                   DeckScene& scene) {
  const DataFields f(card);
  const std::vector<std::string> bodies = data.whole_bodies(f.text(0), card.place);
  if (const auto [what, advice] = undone_weight(data, f.text(0), bodies, card.place); !what.empty())
    return data.report.reject(card.place, what, advice);
  Point direction{f.number(3, "direction", 0.0), f.number(4, "direction", 0.0), f.number(5, "direction", 0.0)};
  const double length = norm(direction), magnitude = f.number(2, "magnitude", 0.0);
  if (!(length > 0)) fail_at(card.place, "*DLOAD, GRAV: expected a direction");
  const AbaqusCurve curve = data.curve(block);
  for (double& component : direction) component *= (curve.times.empty() ? magnitude : 1.0) / length;
  const auto keys = scene.entry<Gravity>("gravity", card_of(block, card.place));
  keys.set("acceleration", direction);
  for (const std::string& body : bodies)
    loads.add(fmt::format("GRAV of {} along {} {} {}", body, f.text(3), f.text(4), f.text(5)));
  if (bodies.size() != data.bodies.size()) keys.set("bodies", bodies);
  set_curve(curve, magnitude, keys);
}

DeckKeys<Pressure> begin_pressure(AbaqusData& data, const AbaqusBlock& block, const DataLine& card, DeckScene& scene) {
  const double magnitude = DataFields(card).number(2, "magnitude", 0.0);
  const AbaqusCurve curve = data.curve(block);
  auto keys = scene.entry<Pressure>("pressure", card_of(block, card.place));
  keys.set("pressure", curve.times.empty() ? magnitude : 1.0);
  set_curve(curve, magnitude, keys);
  return keys;
}

/// Elements to press on by the numbers of their faces: of the eight of an element of ten or twenty nodes one, that
/// element between its corners.
std::vector<std::pair<std::int32_t, Corners8>> whole_elements(const MeshFile& file,
                                                              std::span<const std::int32_t> elements) {
  std::vector<std::pair<std::int32_t, Corners8>> whole;
  for (const std::int32_t e : elements) {
    const auto next = std::ranges::upper_bound(file.eights, e);
    const std::int32_t first = next == file.eights.begin() ? -8 : *std::prev(next);
    if (first == e || first + 8 <= e) whole.emplace_back(e, first == e ? unsplit(file, first) : file.mesh.hexahedra[e]);
  }
  return whole;
}

/// P1 to P6: on the faces of elements that have these numbers.
void write_face_pressure(AbaqusData& data, const AbaqusBlock& block, const DataLine& card, int number,
                         RepeatedLoads& loads, DeckScene& scene) {
  const MeshFile& file = data.mesh.file;
  std::vector<std::vector<std::int64_t>> faces;
  const std::vector<std::int32_t> elements = data.elements(DataFields(card).text(0), card.place);
  for (const auto& [e, corners] : whole_elements(file, elements)) {
    const int face = abaqus_face(corners, given_shape(data.mesh.types, e), number);
    if (face < 0) fail_at(card.place, fmt::format("*DLOAD: this element has no face P{}", number));
    if (!is_face(corners_of_face(corners, face))) continue;
    loads.add(fmt::format("P{} of element {}", number, file.element_ids[e]));
    for (const auto& one : data.middles.pieces_of(corners_of_face(corners, face))) {
      faces.emplace_back();
      for (const std::int32_t node : one) faces.back().push_back(file.node_ids[node]);
    }
  }
  if (faces.empty() && !elements.empty())
    return data.report.unused(card.place, fmt::format("*DLOAD: P{}", number), "nodes that are the same leave no face");
  begin_pressure(data, block, card, scene).set("faces", faces);
}

void write_surface_pressure(AbaqusData& data, const AbaqusBlock& block, const DataLine& card, RepeatedLoads& loads,
                            DeckScene& scene) {
  const auto keys = begin_pressure(data, block, card, scene);
  const std::string surface = data.faces(DataFields(card).text(0), card.place);
  keys.set("set", surface);
  loads.add("P of surface " + surface);
}

void write_distributed(AbaqusData& data, const AbaqusBlock& block, const DataLine& card, RepeatedLoads& loads,
                       DeckScene& scene) {
  const std::string kind = squeezed(DataFields(card).text(1));
  if (kind == "GRAV") {
    write_gravity(data, block, card, loads, scene);
  } else if (kind.size() == 2) {
    write_face_pressure(data, block, card, kind[1] - '0', loads, scene);
  } else {
    write_surface_pressure(data, block, card, loads, scene);
  }
}

}  // namespace

void translate_abaqus_loads(AbaqusData& data, DeckScene& scene) {
  RepeatedLoads loads(data.report);
  for (const AbaqusBlock& block : data.deck.blocks) {
    if (block.name != "CLOAD" && block.name != "DLOAD" && block.name != "DSLOAD") continue;
    DataLines lines(block);
    while (const auto card = lines.next()) {
      (block.name == "CLOAD" ? write_force : write_distributed)(data, block, *card, loads, scene);
      loads.end_of_card(card->place, block.star_name());
    }
  }
}

}  // namespace pinball
