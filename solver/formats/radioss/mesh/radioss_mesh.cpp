#include "radioss_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <utility>

#include <solver/base/counted.hpp>
#include <solver/base/error.hpp>
#include <solver/mesh/file/split_ten_nodes.hpp>
#include <solver/mesh/file/split_twenty_nodes.hpp>
#include <solver/mesh/number_index.hpp>
#include <solver/mesh/quality.hpp>
#include <solver/mesh/tetrahedra.hpp>

#include "radioss_groups.hpp"
#include "radioss_members.hpp"
#include "radioss_shells.hpp"

namespace pinball {

namespace {

/// What would make another mesh, if it were passed over.
bool makes_mesh(const std::string& name) {
  static const std::set<std::string> names{"CNODE", "SUBMODEL", "MERGE/NODE", "MERGE/RBODY", "NODE/SCALE"};
  return names.contains(name) || name.starts_with("TRANSFORM/") || name.starts_with("PARAMETER/");
}

bool is_of_solids(const RadiossBlock& block) { return element_type(&ElementType::radioss, block.name) != nullptr; }

/// Of the line that begins a solid. /TETRA10 has its nodes on the next, /BRIC20 those of its edges on two.
const CardLayout& layout_of(const ElementType& type) {
  if (type.nodes == 8) return radioss::brick;
  if (type.nodes == 20) return radioss::bric20;
  if (type.nodes == 6) return radioss::penta6;
  return type.has_edge_nodes ? radioss::tetra10 : radioss::tetra4;
}

bool is_of_nodes(const RadiossBlock& block) { return block.name == "NODE"; }

class RadiossMeshReader {
 public:
  explicit RadiossMeshReader(const RadiossDeck& deck) : deck_(deck), parts_(deck) {}

  MeshFile read() {
    file_.path = deck_.files.front().path;
    file_.sources = deck_.files;
    for (const auto& [id, part] : parts_.all()) add_part(id, part.title);
    for (const RadiossBlock& block : deck_.blocks) {
      if (makes_mesh(block.name)) fail_at(block.place, block.title + " is not read");
      if (block.name == "NODE") read_nodes(block);
    }
    nodes_ = NumberIndex(file_.node_ids);
    if (nodes_.repeated() >= 0) fail_twice(is_of_nodes, radioss::node, "node", file_.node_ids[nodes_.repeated()]);
    for (const RadiossBlock& block : deck_.blocks) {
      if (is_of_solids(block)) read_solids(block);
      if (is_of_shells(block)) add_part(block.id(), "");
    }
    if (const std::int32_t twice = NumberIndex(file_.element_ids).repeated(); twice >= 0)
      fail_twice(is_of_solids, radioss::brick, "solid", file_.element_ids[twice]);
    note_turned();
    const RadiossShells shells(deck_, parts_, file_, nodes_);
    std::vector<RigidShell> rigid;
    if (!shells.all().empty()) {
      MeshFile with_all = file_;
      RadiossGroups(deck_, parts_, with_all, nodes_, shells.all()).read();
      rigid = shells.that_stay_as_they_are(with_all.node_sets);
    }
    RadiossGroups(deck_, parts_, file_, nodes_, rigid).read();
    add_shell_layers(rigid, file_);
    put_layers_into_sets(file_);
    given_nodes_ = file_.mesh.nodes.size();
    split_ten_nodes(file_);
    split_twenty_nodes(file_);
    return std::move(file_);
  }
  std::size_t given_nodes() const { return given_nodes_; }

 private:
  std::int32_t add_part(std::int64_t id, const std::string& title) {
    const auto [found, is_new] = part_places_.try_emplace(id, static_cast<std::int32_t>(file_.parts.size()));
    // Parts are found by their numbers, which no title takes away.
    if (is_new) file_.parts.push_back({id, deck_integer(title) ? "" : title});
    return found->second;
  }

  void read_nodes(const RadiossBlock& block) {
    RadiossLines lines(block);
    while (const auto line = lines.next_filled()) {
      const RadiossFields f(*line, block, radioss::node);
      file_.node_ids.push_back(f.integer(0));
      file_.mesh.nodes.push_back({f.number(1), f.number(2), f.number(3)});
    }
  }

  void read_solids(const RadiossBlock& block) {
    const ElementType& type = *element_type(&ElementType::radioss, block.name);
    const CardLayout& layout = layout_of(type);
    const std::int32_t part = add_part(block.id(), "");
    RadiossLines lines(block);
    std::string path = *block.place.file;
    file_.lines_of.push_back({static_cast<std::int32_t>(file_.element_ids.size()), path});
    while (const auto line = lines.next_filled()) {
      if (*line->place.file != path) {
        path = *line->place.file;
        file_.lines_of.push_back({static_cast<std::int32_t>(file_.element_ids.size()), path});
      }
      const RadiossFields f(*line, block, layout);
      file_.element_ids.push_back(f.integer(0));
      file_.part.push_back(part);
      file_.line.push_back(line->place.line);
      if (type.shape == SolidShape::hexahedron && type.has_edge_nodes) {
        add_twenty_nodes(type, f, block, lines);
      } else if (type.shape == SolidShape::hexahedron) {
        add_brick(f);
      } else if (type.has_edge_nodes) {
        const DataLine nodes = lines.require("the nodes of a solid");
        add_ten_nodes(RadiossFields(nodes, block, radioss::tetra10_nodes));
      } else {
        add_solid(type, f);
      }
    }
  }

  std::int32_t node_of(const RadiossFields& f, std::size_t field) const {
    const std::int64_t id = f.integer(field);
    const std::int32_t node = nodes_.find(id);
    if (node < 0)
      fail_at(f.place(), fmt::format("solid {} has node {}, which is not there", file_.element_ids.back(), id));
    return node;
  }

  void add_solid(const ElementType& type, const RadiossFields& f) {
    std::array<std::int32_t, most_nodes_of_element> nodes{};
    for (int i = 0; i < type.nodes; ++i) nodes[i] = node_of(f, 1 + i);
    if (is_inverted(stored_corners(type, nodes))) turn(type, nodes);
    append_element(file_, type, nodes);
  }

  bool is_inverted(const Corners8& corners) const {
    std::array<Point, 8> points;
    for (std::size_t i = 0; i < 8; ++i) points[i] = file_.mesh.nodes[corners[i]];
    return volume_by_quadrature(points) < 0;
  }

  /// Other corners come first, as the starter of OpenRadioss has it (hm_read_solid.F): those of the opposite face of a
  /// brick or a wedge, two of a tetrahedron with the middles of their edges.
  void turn(const ElementType& type, std::span<std::int32_t> nodes) {
    ++turned_;
    if (type.shape == SolidShape::tetrahedron) {
      std::swap(nodes[1], nodes[2]);
      if (!type.has_edge_nodes) return;
      std::swap(nodes[4], nodes[6]);
      std::swap(nodes[8], nodes[9]);
    } else {
      std::rotate(nodes.begin(), nodes.begin() + type.nodes / 2, nodes.begin() + type.nodes);
    }
  }

  void note_turned() {
    if (turned_ == 0) return;
    file_.notes.push_back(
        fmt::format("{} of negative volume: the order of {} nodes is turned round, as OpenRadioss does",
                    counted(turned_, "solid"), turned_ == 1 ? "its" : "their"));
  }

  /// On edges: four of the first face, four from it to the opposite one, four of that.
  void add_twenty_nodes(const ElementType& type, const RadiossFields& f, const RadiossBlock& block,
                        RadiossLines& lines) {
    const DataLine second = lines.require("nodes 9 to 16 of a solid"),
                   third = lines.require("nodes 17 to 20 of a solid");
    const RadiossFields edges(second, block, radioss::bric20_edges), more(third, block, radioss::bric20_more);
    std::array<std::int32_t, most_nodes_of_element> nodes{};
    for (std::size_t i = 0; i < 8; ++i) nodes[i] = node_of(f, 1 + i);
    for (std::size_t i = 0; i < 4; ++i) {
      nodes[8 + i] = node_of(edges, i);
      nodes[12 + i] = node_of(more, i);
      nodes[16 + i] = node_of(edges, 4 + i);
    }
    append_element(file_, type, nodes);
  }

  void add_ten_nodes(const RadiossFields& f) {
    int given = 0;
    for (std::int64_t i = 4; i < 10; ++i) given += f.integer(i) != 0 ? 1 : 0;
    if (given != 0 && given != 6)
      fail_at(f.place(), fmt::format("/TETRA10: solid {} has nodes on {} of its six edges: expected all, or none",
                                     file_.element_ids.back(), given));
    const ElementType& type = *element_type(&ElementType::radioss, given == 6 ? "TETRA10" : "TETRA4");
    std::array<std::int32_t, 10> nodes{};
    for (int i = 0; i < type.nodes; ++i) nodes[i] = node_of(f, i);
    if (is_inverted(stored_corners(type, nodes))) turn(type, nodes);
    append_element(file_, type, nodes);
  }

  /// Wedges, pyramids and tetrahedra are collapsed hexahedra.
  void add_brick(const RadiossFields& f) {
    std::array<std::int32_t, 8> corners{};
    for (std::size_t i = 0; i < 8; ++i) corners[i] = node_of(f, 1 + i);
    if (different_nodes(corners) <= 4) {
      const auto found = as_tetrahedron(corners);
      if (!found)
        fail_at(f.place(), fmt::format("/BRICK: solid {} has four nodes or less, and fills no tetrahedron: expected "
                                       "n1 n2 n3 n3 n4 n4 n4 n4",
                                       file_.element_ids.back()));
      corners = *found;
    } else if (different_nodes(corners) == 8 && is_inverted(corners)) {
      turn(*element_type(&ElementType::radioss, "BRICK"), corners);
    }
    file_.mesh.hexahedra.push_back(corners);
  }

  /// The line of the second one is looked for only now.
  template <class Layout>
  [[noreturn]] void fail_twice(bool (*is_of)(const RadiossBlock&), const Layout& layout, const char* what,
                               std::int64_t number) const {
    std::optional<DeckPlace> first;
    for (const RadiossBlock& block : deck_.blocks) {
      if (!is_of(block)) continue;
      RadiossLines lines(block);
      while (const auto line = lines.next_filled()) {
        const bool is_other = RadiossFields(*line, block, layout).integer(0) != number;
        if (block.name == "TETRA10" || block.name == "BRIC20") lines.next();  // its nodes
        if (block.name == "BRIC20") lines.next();
        if (is_other) continue;
        if (first) fail_at(line->place, fmt::format("{} {} is given twice, first in {}", what, number, first->text()));
        first = line->place;
      }
    }
    throw InputError(fmt::format("{}: {} {} is given twice", file_.path, what, number));
  }

  const RadiossDeck& deck_;
  RadiossParts parts_;
  MeshFile file_;
  NumberIndex nodes_;
  std::map<std::int64_t, std::int32_t> part_places_;
  std::size_t given_nodes_ = 0;
  std::int64_t turned_ = 0;  ///< solids that were given the other way round
};

}  // namespace

MeshFile radioss_mesh(const RadiossDeck& deck, std::size_t* given_nodes) {
  RadiossMeshReader reader(deck);
  MeshFile file = reader.read();
  if (given_nodes != nullptr) *given_nodes = reader.given_nodes();
  return file;
}

}  // namespace pinball
