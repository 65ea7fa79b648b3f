#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <set>
#include <string>

#include <kernels/tetrahedron.hpp>

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
      report_.understood(fmt::format("{} ({}): {} that {} already, the first is {}; both act, and add up", star_name,
                                     place.text(), repeated_ == 1 ? "1 load" : fmt::format("{} loads", repeated_),
                                     repeated_ == 1 ? "is there" : "are there", first_));
    repeated_ = 0;
  }

 private:
  DeckReport& report_;
  std::set<std::string> seen_;
  std::string first_;
  int repeated_ = 0;  ///< of this card
};

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
  set_nodes(nodes, keys);
  for (const std::int32_t node : nodes.members)
    loads.add(fmt::format("that of node {} along {}", data.mesh.file.node_ids[node], "xyz"[degree - 1]));
}

/// Magnitude and direction of an acceleration.
void write_gravity(AbaqusData& data, const AbaqusBlock& block, const DataLine& card, RepeatedLoads& loads,
                   DeckScene& scene) {
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

/// Of eight elements that have been made of one of ten nodes the place of the first, where e is that; -1: where it is
/// another of them; none: where it is another element.
std::optional<std::int32_t> first_of_eight(const AbaqusMesh& mesh, std::int32_t e) {
  const auto place = static_cast<std::size_t>(e);
  const auto run = std::prev(std::ranges::upper_bound(mesh.types, place, {}, &AbaqusElements::first));
  if (abaqus_nodes(run->type) != 10) return std::nullopt;
  return (place - run->first) % 8 == 0 ? e : -1;
}

/// The four triangles of a face of a tetrahedron of ten nodes, as split_ten_nodes has made them. first: of its eight.
std::vector<std::array<std::int32_t, 4>> faces_of_eight(const Mesh& mesh, std::int32_t first, int number) {
  std::vector<std::array<std::int32_t, 4>> faces;
  for (int corner = 0; corner < 4; ++corner) {
    const auto& element = mesh.hexahedra[first + 4 + corner];
    std::array<std::int32_t, 4> face = corners_of_face(element, abaqus_face(element, number));
    const auto own = std::ranges::find(face, element[tetrahedron_corner(corner)]);
    if (own == face.end()) continue;  // it looks inside
    std::rotate(face.begin(), own, face.begin() + 3);
    faces.push_back({face[0], face[1], face[2], face[2]});
  }
  const bool in_order = faces[0][1] == faces[1][2];  // the corners, around the face
  faces.push_back({faces[0][1], faces[in_order ? 1 : 2][1], faces[in_order ? 2 : 1][1], faces[in_order ? 2 : 1][1]});
  return faces;
}

/// P1 to P6: on the faces of elements that have these numbers.
void write_face_pressure(AbaqusData& data, const AbaqusBlock& block, const DataLine& card, int number,
                         RepeatedLoads& loads, DeckScene& scene) {
  std::vector<std::vector<std::int64_t>> faces;
  const Mesh& mesh = data.mesh.file.mesh;
  const auto add = [&](const std::array<std::int32_t, 4>& face) {
    faces.emplace_back();
    for (const std::int32_t node : face) faces.back().push_back(data.mesh.file.node_ids[node]);
  };
  for (const std::int32_t e : data.elements(DataFields(card).text(0), card.place)) {
    const int face = abaqus_face(mesh.hexahedra[e], number);
    if (face < 0) fail_at(card.place, fmt::format("*DLOAD: this element has no face P{}", number));
    const std::optional<std::int32_t> first = first_of_eight(data.mesh, e);
    if (!first || *first >= 0) loads.add(fmt::format("P{} of element {}", number, data.mesh.file.element_ids[e]));
    if (!first) {
      add(corners_of_face(mesh.hexahedra[e], face));
    } else if (*first >= 0) {
      std::ranges::for_each(faces_of_eight(mesh, *first, number), add);
    }
  }
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
