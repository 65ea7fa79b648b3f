#include "keyword_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include <solver/base/error.hpp>
#include <solver/formats/deck/given_once.hpp>
#include <solver/formats/lsdyna/layouts/mesh_cards.hpp>
#include <solver/formats/lsdyna/scan/fields.hpp>
#include <solver/mesh/file/split_ten_nodes.hpp>
#include <solver/mesh/number_index.hpp>
#include <solver/mesh/tetrahedra.hpp>

#include "keyword_segments.hpp"
#include "keyword_sets.hpp"
#include "keyword_transformation.hpp"
#include "part_inertia.hpp"
#include "rigid_shells.hpp"

namespace pinball {

namespace {

class KeywordMeshReader {
 public:
  explicit KeywordMeshReader(const KeywordDeck& deck) : deck_(deck), transformations_(deck) {}

  MeshFile read() {
    file_.path = deck_.files.front().path;
    file_.sources = deck_.files;
    for (const KeywordBlock& block : deck_.blocks) {
      require_readable(block);
      if (block.name == "NODE") read_nodes(block);
      if (is_part(block)) read_parts(block);
    }
    check_node_numbers();
    nodes_ = NumberIndex(file_.node_ids);
    for (const KeywordBlock& block : deck_.blocks) {
      if (block.name == "ELEMENT_SOLID") read_solids(block);
    }
    check_element_numbers();
    add_shell_layers(RigidShells(deck_, file_, nodes_).read(), file_);
    if (!file_.held.empty()) file_.held.resize(file_.node_ids.size(), 0);
    KeywordSets(deck_, file_, nodes_).read();
    read_keyword_segments(deck_, nodes_, file_);
    put_layers_into_sets(file_);
    split_ten_nodes(file_);
    return std::move(file_);
  }

 private:
  // Places in the layouts of lines of which there are many.
  static constexpr std::size_t nid = layout::node.find("NID"), x_of = layout::node.find("X"),
                               tc = layout::node.find("TC"), rc = layout::node.find("RC"),
                               eid = layout::solid.find("EID"), pid = layout::solid.find("PID"),
                               n1 = layout::solid.find("N1");

  struct Run {
    std::size_t first;
    const KeywordBlock* block;
  };

  /// What would make another mesh, if it were passed over.
  static void require_readable(const KeywordBlock& block) {
    const std::string& name = block.name;
    const bool readable = name == "ELEMENT_SOLID" || name == "NODE";
    if (!readable && (name.starts_with("ELEMENT_SOLID") || name.starts_with("NODE_") || name.starts_with("INCLUDE")))
      fail_at(block.place, block.star_name() + " is not read");
  }

  void read_nodes(const KeywordBlock& block) {
    const Transformation* moved = transformations_.of(block);
    const std::int64_t add = offset_of(block, &DeckTransform::node);
    node_blocks_.push_back({file_.node_ids.size(), &block});
    Cards cards(block);
    while (const auto card = cards.next_filled()) {
      const Fields fields(*card, deck_.parameters, layout::node);
      file_.node_ids.push_back(fields.integer(nid) + add);
      const Point given{fields.number(x_of), fields.number(x_of + 1), fields.number(x_of + 2)};
      file_.mesh.nodes.push_back(moved != nullptr ? moved->apply(given) : given);
      hold(fields);
    }
  }

  /// TC: which directions of the node just read are held.
  void hold(const Fields& fields) {
    static constexpr std::uint8_t directions_of_code[8] = {0, 1, 2, 4, 3, 6, 5, 7};
    if (fields.integer(rc) != 0) ++file_.held_rotations;
    const std::int64_t code = fields.integer(tc);
    if (code == 0) return;
    file_.held.resize(file_.node_ids.size(), 0);
    file_.held.back() = directions_of_code[code];
  }

  void read_parts(const KeywordBlock& block) {
    const auto read = [&](const Card& title, const Card& card) {
      const std::int64_t id =
          Fields(card, deck_.parameters, layout::part).integer("PID") + offset_of(block, &DeckTransform::part);
      given_.add(fmt::format("part {}", id), card.place, block.of_case);
      std::string_view name = trimmed(title.text);
      if (deck_integer(name)) name = {};  // parts are found by their numbers, which no title takes away
      file_.parts[part_of(id)].name = std::string(name);
    };
    for_each_part(block, read, [&](const Card&, Cards& cards) {
      if (block.name == "PART_CONTACT") {
        cards.next();
      } else {
        pass_inertia(cards, deck_.parameters);
      }
    });
  }

  std::int32_t part_of(std::int64_t id) {
    const auto [found, is_new] = part_places_.try_emplace(id, static_cast<std::int32_t>(file_.parts.size()));
    if (is_new) file_.parts.push_back({id, ""});
    return found->second;
  }

  /// Number, part and eight nodes in one line; or the nodes, of which there may be ten, in the next one.
  void read_solids(const KeywordBlock& block) {
    const std::int64_t to_node = offset_of(block, &DeckTransform::node),
                       to_element = offset_of(block, &DeckTransform::element),
                       to_part = offset_of(block, &DeckTransform::part);
    const Transformation* moved = transformations_.of(block);
    const bool mirrored = moved != nullptr && moved->determinant() < 0;
    file_.lines_of.push_back({static_cast<std::int32_t>(file_.element_ids.size()), *block.place.file});
    Cards cards(block);
    while (const auto card = cards.next_filled()) {
      const Fields head(*card, deck_.parameters, layout::solid);
      file_.element_ids.push_back(head.integer(eid) + to_element);
      const std::int32_t part = part_of(head.integer(pid) + to_part);
      file_.part.push_back(part);
      file_.line.push_back(card->place.line);
      bool one_line = false;
      for (std::size_t i = n1; i < 10; ++i) one_line |= !head.blank(i);
      if (one_line) {
        add_solid(head, n1, to_node, mirrored);
      } else {
        const Card nodes = cards.require("the nodes of an element");
        add_solid(Fields(nodes, deck_.parameters, layout::solid_nodes), 0, to_node, mirrored);
      }
    }
  }

  std::int32_t node_of(const Fields& fields, std::int64_t id) const {
    const std::int32_t node = nodes_.find(id);
    if (node < 0) fail_element(fields, fmt::format("has node {}, which is not there", id));
    return node;
  }

  void add_solid(const Fields& fields, std::size_t first, std::int64_t to_node, bool mirrored) {
    if (first == 0 && (fields.integer(8) != 0 || fields.integer(9) != 0))
      return add_ten_nodes(fields, to_node, mirrored);
    std::array<std::int32_t, 8> corners{};
    int given = 0;
    for (std::size_t i = 4; i < 8; ++i) given += fields.integer(first + i) != 0 ? 1 : 0;
    if (given != 0 && given != 4)
      fail_element(fields,
                   "has seven nodes or less: expected eight, of a wedge n1 n2 n3 n4 n5 n5 n6 n6, of a pyramid "
                   "n1 n2 n3 n4 n5 n5 n5 n5");
    for (std::size_t i = 0; i < 8; ++i) {
      std::int64_t id = fields.integer(first + i);
      if (id == 0 && i >= 4) id = fields.integer(first + 3);  // of a tetrahedron the last node again
      corners[i] = node_of(fields, id + to_node);
    }
    if (mirrored) std::swap_ranges(corners.begin(), corners.begin() + 4, corners.begin() + 4);
    if (different_nodes(corners) <= 4) {
      const auto found = as_tetrahedron(corners);
      if (!found)
        fail_element(fields, "has four nodes or less, and fills no tetrahedron: expected n1 n2 n3 n4 n4 n4 n4 n4");
      corners = *found;
    }
    file_.mesh.hexahedra.push_back(corners);
  }

  /// The node of the edge 1-4 comes last, behind those of 2-4 and 3-4, as OpenRadioss' reader and LS-PrePost have it.
  void add_ten_nodes(const Fields& fields, std::int64_t to_node, bool mirrored) {
    std::array<std::int32_t, 10> n{};
    for (std::size_t i = 0; i < 10; ++i) {
      const std::int64_t id = fields.integer(i);
      if (id == 0) fail_element(fields, "has nine nodes or less: expected eight, or ten of a tetrahedron");
      n[i] = node_of(fields, id + to_node);
    }
    std::rotate(n.begin() + 7, n.begin() + 9, n.end());  // 1-4, 2-4, 3-4
    if (mirrored) {  // the first two corners change their places, and edges with them
      std::swap(n[0], n[1]);
      std::swap(n[5], n[6]);
      std::swap(n[7], n[8]);
    }
    const auto place = static_cast<std::int32_t>(file_.mesh.hexahedra.size());
    file_.edge_nodes.push_back({place, {n[4], n[5], n[6], n[7], n[8], n[9]}});
    file_.mesh.hexahedra.push_back(tetrahedron(n[0], n[1], n[2], n[3]));
  }

  [[noreturn]] void fail_element(const Fields& fields, const std::string& problem) const {
    fail_at(fields.place(), fmt::format("*ELEMENT_SOLID: element {} {}", file_.element_ids.back(), problem));
  }

  void check_element_numbers() const {
    const std::int32_t repeated = NumberIndex(file_.element_ids).repeated();
    if (repeated < 0) return;
    const std::int64_t number = file_.element_ids[repeated];
    const auto first = std::ranges::find(file_.element_ids, number) - file_.element_ids.begin();
    throw InputError(fmt::format("{}: element {} is given twice, first in {}", place_of_element(file_, repeated),
                                 number, place_of_element(file_, first)));
  }

  void check_node_numbers() const {
    const std::int32_t repeated = NumberIndex(file_.node_ids).repeated();
    if (repeated < 0) return;
    const std::int64_t number = file_.node_ids[repeated];
    const std::size_t first = std::ranges::find(file_.node_ids, number) - file_.node_ids.begin();
    fail_at(place_of_node(repeated),
            fmt::format("node {} is given twice, first in {}", number, place_of_node(first).text()));
  }

  DeckPlace place_of_node(std::size_t node) const {
    const auto is_later = [node](const Run& run) { return run.first > node; };
    const Run& run = *(std::ranges::find_if(node_blocks_, is_later) - 1);
    Cards cards(*run.block);
    for (auto i = run.first; i < node; ++i) cards.next_filled();
    return cards.next_filled()->place;
  }

  const KeywordDeck& deck_;
  Transformations transformations_;
  MeshFile file_;
  NumberIndex nodes_;
  std::map<std::int64_t, std::int32_t> part_places_;
  GivenOnce given_;
  std::vector<Run> node_blocks_;
};

}  // namespace

MeshFile keyword_mesh(const KeywordDeck& deck) { return KeywordMeshReader(deck).read(); }

}  // namespace pinball
