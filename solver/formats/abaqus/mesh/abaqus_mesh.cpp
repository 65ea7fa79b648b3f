#include "abaqus_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include <solver/base/error.hpp>
#include <solver/mesh/element_types.hpp>
#include <solver/mesh/file/shell_layers.hpp>
#include <solver/mesh/file/split_ten_nodes.hpp>
#include <solver/mesh/file/split_twenty_nodes.hpp>
#include <solver/mesh/number_index.hpp>

#include "abaqus_rigid_elements.hpp"
#include "abaqus_sets.hpp"

namespace pinball {

namespace {

/// "C3D8, C3D6, ..."
std::string names_of_elements() {
  std::string all;
  for (const ElementType& type : element_types()) {
    if (!type.abaqus.empty()) (all += all.empty() ? "" : ", ") += type.abaqus.substr(0, type.abaqus.find(' '));
  }
  return all + ", R3D4, R3D3, MASS, ROTARYI";
}

/// Whether any component has rigid elements.
bool has_rigid_elements(const std::vector<AbaqusComponent>& components) {
  const auto is_rigid = [](const AbaqusBlock* block) {
    return block->name == "ELEMENT" && nodes_of_rigid_element(block->option("TYPE")) > 0;
  };
  return std::ranges::any_of(
      components, [&](const AbaqusComponent& component) { return std::ranges::any_of(component.blocks, is_rigid); });
}

/// Keywords that make nodes or elements in a way that is not read.
bool makes_mesh(const std::string& name) {
  static const std::set<std::string> names{"NGEN",   "NFILL",  "NCOPY",  "NMAP",      "ELGEN",
                                           "ELCOPY", "SYSTEM", "IMPORT", "PARAMETER", "SUBMODEL"};
  return names.contains(name);
}

std::size_t lines_of(const AbaqusBlock& block) {
  std::size_t lines = 0;
  for (const DataText& data : block.data) lines += std::ranges::count(data.text, '\n') + 1;
  return lines;
}

class AbaqusMeshReader {
 public:
  explicit AbaqusMeshReader(const AbaqusDeck& deck) {
    mesh_.components = abaqus_components(deck);
    mesh_.sections = abaqus_sections(mesh_.components, has_rigid_elements(mesh_.components));
    file_.path = deck.files.front().path;
    file_.sources = deck.files;
  }

  AbaqusMesh read() {
    reserve();
    for (std::size_t c = 0; c < mesh_.components.size(); ++c) read_component(c);
    AbaqusSets sets(mesh_, file_, std::move(nodes_), std::move(elements_));
    for (const NamedRange& set : named_) sets.add_range(set.component, set.of_nodes, set.name, set.first, set.last);
    for (const AbaqusPointElement& point : mesh_.points) sets.pass_over(point.component, point.number);
    sets.read();
    assign_parts(sets);
    for (AbaqusPointElement& point : mesh_.points) point.node = node_of(sets, point);
    std::vector<std::int32_t> references = reference_nodes(sets);
    mesh_.keys = sets.name_all();
    shift_numbers();
    mesh_.given_nodes = file_.mesh.nodes.size();
    thicken_rigid_elements(mesh_, file_, std::move(references));
    split();
    mesh_.file = std::move(file_);
    return std::move(mesh_);
  }

 private:
  /// Nodes or elements to which a keyword gives a name.
  struct NamedRange {
    std::size_t component;
    bool of_nodes;
    std::string name;
    std::size_t first, last;
  };

  void reserve() {
    std::size_t nodes = 0, elements = 0;
    for (const AbaqusComponent& component : mesh_.components) {
      for (const AbaqusBlock* block : component.blocks) {
        if (block->name == "NODE") nodes += lines_of(*block);
        if (block->name == "ELEMENT") elements += lines_of(*block);
      }
    }
    file_.mesh.nodes.reserve(nodes);
    file_.node_ids.reserve(nodes);
    file_.mesh.hexahedra.reserve(elements);
    file_.element_ids.reserve(elements);
    file_.line.reserve(elements);
  }

  void read_component(std::size_t c) {
    const AbaqusComponent& component = mesh_.components[c];
    AbaqusRange range{file_.node_ids.size(), 0, file_.element_ids.size(), 0, 0};
    for (const AbaqusBlock* block : component.blocks) {
      if (makes_mesh(block->name)) fail_at(block->place, block->star_name() + " is not read");
      if (block->name == "NODE") read_nodes(*block, c);
    }
    range.nodes = file_.node_ids.size() - range.first_node;
    nodes_.push_back(index_of(file_.node_ids, range.first_node));
    if (const std::int32_t twice = nodes_.back().repeated(); twice >= 0)
      fail_twice(component, "NODE", "node", file_.node_ids[range.first_node + twice]);
    for (const AbaqusBlock* block : component.blocks) {
      if (block->name == "ELEMENT") read_elements(*block, c, range.first_node);
    }
    range.elements = file_.element_ids.size() - range.first_element;
    elements_.push_back(index_of(file_.element_ids, range.first_element));
    if (const std::int32_t twice = elements_.back().repeated(); twice >= 0)
      fail_twice(component, "ELEMENT", "element", file_.element_ids[range.first_element + twice]);
    mesh_.ranges.push_back(range);
  }

  static NumberIndex index_of(const std::vector<std::int64_t>& numbers, std::size_t first) {
    if (first == 0) return NumberIndex(numbers);
    return NumberIndex({numbers.begin() + first, numbers.end()});
  }

  /// The line of the second one is looked for only now.
  [[noreturn]] static void fail_twice(const AbaqusComponent& component, const char* keyword, const char* what,
                                      std::int64_t number) {
    std::optional<DeckPlace> first;
    for (const AbaqusBlock* block : component.blocks) {
      if (block->name != keyword) continue;
      DataLines lines(*block);
      while (const auto card = lines.next()) {
        if (DataFields(*card).integer(0, "number") != number) continue;
        if (first) fail_at(card->place, fmt::format("{} {} is given twice, first in {}", what, number, first->text()));
        first = card->place;
      }
    }
    fail_at(component.place, fmt::format("{} {} is given twice", what, number));
  }

  void read_nodes(const AbaqusBlock& block, std::size_t c) {
    if (const std::string system = block.option("SYSTEM"); !system.empty() && system != "R")
      fail_at(block.place, "*NODE with SYSTEM=" + system + " is not read");
    const std::size_t first = file_.node_ids.size();
    DataLines lines(block);
    while (const auto card = lines.next()) {
      const DataFields f(*card);
      file_.node_ids.push_back(f.integer(0, "node"));
      const Point x{f.number(1, "x", 0.0), f.number(2, "y", 0.0), f.number(3, "z", 0.0)};
      file_.mesh.nodes.push_back(mesh_.components[c].placement.apply(x));
    }
    if (const auto name = block.value("NSET")) named_.push_back({c, true, *name, first, file_.node_ids.size()});
  }

  void read_elements(const AbaqusBlock& block, std::size_t c, std::size_t first_node) {
    const std::string type = squeezed(block.require("TYPE"));
    if (is_point_element(type)) return read_points(block, type, c);
    static constexpr ElementType triangle{.shape = SolidShape::wedge, .nodes = 3},
        quadrilateral{.shape = SolidShape::hexahedron, .nodes = 4};
    const int rigid = nodes_of_rigid_element(type);
    const ElementType* const known = rigid == 3   ? &triangle
                                     : rigid == 4 ? &quadrilateral
                                                  : element_type(&ElementType::abaqus, type);
    if (known == nullptr)
      fail_at(block.place, fmt::format("*ELEMENT, TYPE={} is not read: expected {}", type, names_of_elements()));
    const std::size_t first = file_.element_ids.size();
    mesh_.types.push_back({first, type, known->shape});
    DataLines lines(block);
    while (const auto card = lines.next()) read_element(*card, lines, *known, first_node);
    if (const auto name = block.value("ELSET")) named_.push_back({c, false, *name, first, file_.element_ids.size()});
  }

  /// Elements of one node, a line each; of their set the mesh has none.
  void read_points(const AbaqusBlock& block, const std::string& type, std::size_t c) {
    if (const auto name = block.value("ELSET"))
      named_.push_back({c, false, *name, file_.element_ids.size(), file_.element_ids.size()});
    DataLines lines(block);
    while (const auto card = lines.next()) {
      const DataFields f(*card);
      AbaqusPointElement point;
      point.component = c;
      point.turns = type == "ROTARYI";
      point.number = f.integer(0, "number");
      if (const auto name = block.value("ELSET")) point.set = label_key(*name);
      point.node_label = f.text(1);
      point.place = card->place;
      if (point.node_label.empty()) fail_at(card->place, fmt::format("element {}: expected its node", point.number));
      mesh_.points.push_back(std::move(point));
    }
  }

  /// Number and nodes, which may take several lines; those but the last end in a comma.
  void read_element(DataLine card, DataLines& lines, const ElementType& type, std::size_t first_node) {
    const DeckPlace place = card.place;
    const std::size_t nodes = type.nodes;
    std::array<std::int64_t, 1 + most_nodes_of_element> numbers{};
    std::size_t count = 0;
    while (true) {
      const DataFields f(card);
      for (std::size_t i = 0; i < 20 && !f.blank(i); ++i) {
        if (count == nodes + 1)
          fail_at(card.place, fmt::format("element {}: expected {} nodes, got more", numbers[0], nodes));
        numbers[count++] = f.integer(i, "number");
      }
      if (count == nodes + 1 || !goes_on(card.text)) break;
      card = lines.require("the rest of an element");
    }
    if (count == 0) fail_at(place, fmt::format("expected the number of an element and its {} nodes", nodes));
    if (count != nodes + 1)
      fail_at(place, fmt::format("element {}: expected {} nodes, got {}", numbers[0], nodes, count - 1));
    add_element(numbers, type, first_node, place);
  }

  const std::string& path_of_last_line() const {
    return file_.lines_of.empty() ? file_.path : file_.lines_of.back().file;
  }

  void add_element(std::span<const std::int64_t> numbers, const ElementType& type, std::size_t first_node,
                   const DeckPlace& place) {
    std::array<std::int32_t, most_nodes_of_element> nodes{};
    for (int i = 0; i < type.nodes; ++i) {
      const std::int64_t number = numbers[1 + i];
      const std::int32_t node = nodes_.back().find(number);
      if (node < 0) fail_at(place, fmt::format("element {} has node {}, which is not there", numbers[0], number));
      nodes[i] = static_cast<std::int32_t>(node + first_node);
    }
    if (*place.file != path_of_last_line())
      file_.lines_of.push_back({static_cast<std::int32_t>(file_.element_ids.size()), *place.file});
    file_.element_ids.push_back(numbers[0]);
    file_.line.push_back(place.line);
    if (type.nodes < 5 && type.abaqus.empty()) return add_rigid_element(numbers[0], type.nodes, nodes, place);
    append_element(file_, type, nodes);
  }

  /// Flat, until its thickness is known.
  void add_rigid_element(std::int64_t number, int count, const std::array<std::int32_t, most_nodes_of_element>& nodes,
                         const DeckPlace& place) {
    const std::array<std::int32_t, 4> n{nodes[0], nodes[1], nodes[2], count == 3 ? nodes[2] : nodes[3]};
    const bool differ = n[0] != n[1] && n[1] != n[2] && n[2] != n[0] && n[3] != n[0] && n[3] != n[1];
    if (!differ || (count == 4 && n[3] == n[2]))
      fail_at(place, fmt::format("element {}: expected {} different nodes", number, count));
    file_.mesh.hexahedra.push_back({n[0], n[1], n[2], n[3], n[0], n[1], n[2], n[3]});
  }

  /// Sections first; what is in none belongs to its instance as such.
  void assign_parts(AbaqusSets& sets) {
    file_.part.assign(file_.element_ids.size(), -1);
    for (const AbaqusSection& section : mesh_.sections) {
      const std::int32_t part = file_.parts.size();
      file_.parts.push_back({0, section.part});
      const std::string set = section.block->require("ELSET");
      for (const std::int32_t e : sets.members(section.component, false, set, section.block->place)) {
        if (section.is_rigid() != is_flat_layer(file_.mesh.hexahedra[e])) {
          if (section.is_rigid()) continue;
          fail_at(section.block->place, fmt::format("*SOLID SECTION: element {} is a rigid one", file_.element_ids[e]));
        }
        if (file_.part[e] >= 0 && file_.part[e] != part)
          fail_at(
              section.block->place,
              fmt::format("{}: element {} is in that of {}, too, {}", section.block->star_name(), file_.element_ids[e],
                          file_.parts[file_.part[e]].name, mesh_.sections[file_.part[e]].block->place.text()));
        file_.part[e] = part;
      }
    }
    for (std::size_t c = 0; c < mesh_.components.size(); ++c) {
      std::int32_t rest = -1;
      const AbaqusRange& range = mesh_.ranges[c];
      for (std::size_t e = range.first_element; e < range.first_element + range.elements; ++e) {
        if (file_.part[e] >= 0) continue;
        if (is_flat_layer(file_.mesh.hexahedra[e]))
          throw InputError(fmt::format("{}: element {}, a rigid one, is of no *RIGID BODY",
                                       place_of_element(file_, static_cast<std::int32_t>(e)), file_.element_ids[e]));
        if (rest < 0) {
          rest = file_.parts.size();
          file_.parts.push_back({0, mesh_.components[c].name});
        }
        file_.part[e] = rest;
      }
    }
  }

  static std::int32_t node_of(AbaqusSets& sets, const AbaqusPointElement& point) {
    const std::vector<std::int32_t>& nodes = sets.members(point.component, true, point.node_label, point.place);
    if (nodes.size() == 1) return nodes[0];
    fail_at(point.place, fmt::format("element {}: expected one node, got {}", point.number, nodes.size()));
  }

  /// Of rigid bodies; what is wrong with one is said elsewhere.
  std::vector<std::int32_t> reference_nodes(AbaqusSets& sets) const {
    std::vector<std::int32_t> references;
    for (const AbaqusSection& section : mesh_.sections) {
      if (!section.is_rigid()) continue;
      const std::string label = section.block->require("REFNODE");
      const auto& nodes = sets.members(section.component, true, label, section.block->place);
      if (nodes.size() == 1) references.push_back(nodes[0]);
    }
    return references;
  }

  /// When all sets and sections are known.
  void split() {
    follow(split_ten_nodes(file_));
    follow(split_twenty_nodes(file_));
  }

  /// first: as split_ten_nodes returns it.
  void follow(const std::vector<std::int32_t>& first) {
    if (first.empty()) return;
    for (AbaqusRange& range : mesh_.ranges) {
      const std::size_t end = first[range.first_element + range.elements];
      range.first_element = first[range.first_element];
      range.elements = end - range.first_element;
    }
    for (AbaqusElements& run : mesh_.types) run.first = first[run.first];
  }

  void shift_numbers() {
    std::int64_t largest = 0, unit = 10;
    std::size_t filled = 0;
    for (const AbaqusRange& range : mesh_.ranges) filled += range.nodes > 0 ? 1 : 0;
    if (filled < 2) return;
    for (const auto* numbers : {&file_.node_ids, &file_.element_ids}) {
      for (const std::int64_t number : *numbers) largest = std::max(largest, number);
    }
    while (unit <= largest && unit < 1'000'000'000'000'000) unit *= 10;
    std::int64_t added = 0;
    for (AbaqusRange& range : mesh_.ranges) {
      if (range.nodes == 0) continue;
      range.added = added;
      for (std::size_t n = 0; n < range.nodes; ++n) file_.node_ids[range.first_node + n] += added;
      for (std::size_t e = 0; e < range.elements; ++e) file_.element_ids[range.first_element + e] += added;
      added += unit;
    }
  }

  AbaqusMesh mesh_;
  MeshFile file_;
  std::vector<NumberIndex> nodes_, elements_;  ///< per component, places counted from its first
  std::vector<NamedRange> named_;
};

}  // namespace

AbaqusMesh abaqus_mesh(const AbaqusDeck& deck) { return AbaqusMeshReader(deck).read(); }

}  // namespace pinball
