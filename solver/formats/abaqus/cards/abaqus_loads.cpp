#include <fmt/format.h>

#include "abaqus_parts.hpp"

namespace pinball {

namespace {

void write_force(AbaqusData& data, const AbaqusBlock& block, const DataLine& card, DeckScene& scene) {
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
  set_nodes(nodes, keys);
}

/// Magnitude and direction of an acceleration.
void write_gravity(AbaqusData& data, const AbaqusBlock& block, const DataLine& card, DeckScene& scene) {
  const DataFields f(card);
  const std::vector<std::string> bodies = data.whole_bodies(f.text(0), card.place);
  if (bodies.empty()) {
    data.report.reject(card.place, "*DLOAD, GRAV of a part of a section");
    return;
  }
  Point direction{f.number(3, "direction", 0.0), f.number(4, "direction", 0.0), f.number(5, "direction", 0.0)};
  const double length = norm(direction), magnitude = f.number(2, "magnitude", 0.0);
  if (!(length > 0)) fail_at(card.place, "*DLOAD, GRAV: expected a direction");
  const AbaqusCurve curve = data.curve(block);
  for (double& component : direction) component *= (curve.times.empty() ? magnitude : 1.0) / length;
  const auto keys = scene.entry<Gravity>("gravity", card_of(block, card.place));
  keys.set("acceleration", direction);
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

/// P1 to P6: on the faces of elements that have these numbers.
void write_face_pressure(AbaqusData& data, const AbaqusBlock& block, const DataLine& card, int number,
                         DeckScene& scene) {
  std::vector<std::vector<std::int64_t>> faces;
  for (const std::int32_t e : data.elements(DataFields(card).text(0), card.place)) {
    const auto& hexahedron = data.mesh.file.mesh.hexahedra[e];
    const int face = abaqus_face(hexahedron, number);
    if (face < 0) fail_at(card.place, fmt::format("*DLOAD: this element has no face P{}", number));
    faces.emplace_back();
    for (const std::int32_t node : corners_of_face(hexahedron, face))
      faces.back().push_back(data.mesh.file.node_ids[node]);
  }
  begin_pressure(data, block, card, scene).set("faces", faces);
}

void write_surface_pressure(AbaqusData& data, const AbaqusBlock& block, const DataLine& card, DeckScene& scene) {
  const auto keys = begin_pressure(data, block, card, scene);
  keys.set("set", data.faces(DataFields(card).text(0), card.place));
}

void write_distributed(AbaqusData& data, const AbaqusBlock& block, const DataLine& card, DeckScene& scene) {
  const std::string kind = squeezed(DataFields(card).text(1));
  if (kind == "GRAV") {
    write_gravity(data, block, card, scene);
  } else if (kind.size() == 2) {
    write_face_pressure(data, block, card, kind[1] - '0', scene);
  } else {
    write_surface_pressure(data, block, card, scene);
  }
}

}  // namespace

void translate_abaqus_loads(AbaqusData& data, DeckScene& scene) {
  for (const AbaqusBlock& block : data.deck.blocks) {
    if (block.name != "CLOAD" && block.name != "DLOAD" && block.name != "DSLOAD") continue;
    DataLines lines(block);
    while (const auto card = lines.next()) {
      (block.name == "CLOAD" ? write_force : write_distributed)(data, block, *card, scene);
    }
  }
}

}  // namespace pinball
