#include "field_pieces.hpp"

#include <fmt/format.h>

#include <string_view>

#include "output_file.hpp"
#include "units_comment.hpp"

namespace pinball {

namespace {

/// Those of `all` at these places; of an empty list none.
template <class T>
void take_at(const std::vector<std::int64_t>& places, const std::vector<T>& all, std::vector<T>& some) {
  if (all.empty()) return;
  some.reserve(places.size());
  for (const std::int64_t place : places) some.push_back(all[place]);
}

}  // namespace

FieldPiece cut_piece(const FieldSnapshot& all, const FieldBase& base, const std::vector<std::int32_t>& rank_of_element,
                     std::int32_t rank) {
  FieldPiece piece;
  std::vector<std::int64_t>& elements = piece.base.element_place;
  std::vector<std::int64_t>& nodes = piece.base.node_place;
  std::vector<std::int32_t> place_of_node(all.position.size(), -1);
  for (std::int64_t e = 0; e < std::ssize(all.hexahedra); ++e) {
    if (rank_of_element[e] != rank) continue;
    elements.push_back(e);
    for (const std::int32_t node : all.hexahedra[e]) place_of_node[node] = 0;
  }
  for (std::int64_t n = 0; n < std::ssize(place_of_node); ++n) {
    if (place_of_node[n] < 0) continue;
    place_of_node[n] = static_cast<std::int32_t>(nodes.size());
    nodes.push_back(n);
  }
  FieldSnapshot& s = piece.snapshot;
  s.step = all.step;
  s.time = all.time;
  take_at(elements, all.hexahedra, s.hexahedra);
  for (auto& corners : s.hexahedra) {
    for (std::int32_t& node : corners) node = place_of_node[node];
  }
  take_at(nodes, all.position, s.position);
  take_at(nodes, all.velocity, s.velocity);
  take_at(nodes, all.contact_force, s.contact_force);
  take_at(elements, all.stress, s.stress);
  take_at(elements, all.plastic_strain, s.plastic_strain);
  take_at(elements, all.temperature, s.temperature);
  take_at(elements, all.damage, s.damage);
  take_at(elements, all.pinball_radius, s.pinball_radius);
  take_at(elements, all.alive, s.alive);
  take_at(elements, all.body, s.body);
  if (!base.initial.empty()) {
    for (const std::int64_t node : nodes) piece.initial.push_back(base.initial[node]);
  }
  piece.base.initial = piece.initial;
  take_at(nodes, base.node_number, piece.base.node_number);
  take_at(elements, base.element_number, piece.base.element_number);
  return piece;
}

std::string piece_name(const std::string& base, std::int64_t number, std::int32_t rank) {
  return fmt::format("{}_{:04}_{}.vtu", base, number, rank);
}

void write_list_of_pieces(const std::string& path, const FieldArrays& arrays, const std::string& units,
                          const std::vector<std::string>& sources) {
  std::string text = "<?xml version=\"1.0\"?>\n" + units_comment(units) +
                     "<VTKFile type=\"PUnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
                     "header_type=\"UInt64\">\n  <PUnstructuredGrid GhostLevel=\"0\">\n";
  const auto section = [&text](std::string_view name, std::string_view attributes, const std::vector<DataArray>& list) {
    text += fmt::format("    <P{}{}>\n", name, attributes);
    for (const DataArray& array : list) text += fmt::format("      <PDataArray {}/>\n", array.attributes);
    text += fmt::format("    </P{}>\n", name);
  };
  section("PointData", arrays.point_attributes, arrays.point);
  section("CellData", arrays.cell_attributes, arrays.cell);
  section("Points", "", arrays.points);
  for (const std::string& source : sources) text += fmt::format("    <Piece Source=\"{}\"/>\n", source);
  text += "  </PUnstructuredGrid>\n</VTKFile>\n";
  OutputFile file(path);
  file.write(text);
  file.commit();
}

}  // namespace pinball
