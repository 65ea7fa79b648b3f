#include "keyword_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include <solver/base/error.hpp>
#include <solver/keyword/fields.hpp>
#include <solver/keyword/number_index.hpp>

#include "keyword_sets.hpp"
#include "keyword_transformation.hpp"

namespace pinball {

namespace {

constexpr std::array<int, 6> node_columns{8, 16, 16, 16, 8, 8}, wide_node_columns{10, 16, 16, 16, 10, 10};
constexpr std::array<int, 10> solid_columns{8, 8, 8, 8, 8, 8, 8, 8, 8, 8},
    wide_solid_columns{10, 10, 10, 10, 10, 10, 10, 10, 10, 10};

/// A solid as it stands in the deck.
struct Solid {
  std::array<std::int64_t, 8> nodes;
  DeckPlace place;
};

class Reader {
 public:
  explicit Reader(const KeywordDeck& deck) : deck_(deck), transformations_(deck) {}

  MeshFile read() {
    file_.path = deck_.files.front();
    for (const KeywordBlock& block : deck_.blocks) {
      if (block.name == "NODE") read_nodes(block);
      if (block.name == "PART") read_parts(block);
    }
    check_numbers(file_.node_ids, node_places_, "node");
    nodes_ = NumberIndex(file_.node_ids);
    for (const KeywordBlock& block : deck_.blocks) {
      if (block.name == "ELEMENT_SOLID") read_solids(block);
    }
    check_solid_numbers();
    KeywordSets(deck_, file_, nodes_).read();
    return std::move(file_);
  }

 private:
  struct Run {
    std::size_t first;
    DeckPlace keyword;
  };

  static std::int64_t offset(const KeywordBlock& block, std::int64_t DeckTransform::*which) {
    return block.transform ? (*block.transform).*which : 0;
  }

  void read_nodes(const KeywordBlock& block) {
    const std::span<const int> columns(block.wide ? wide_node_columns : node_columns);
    const Transformation* moved = transformations_.of(block);
    const std::int64_t add = offset(block, &DeckTransform::node);
    node_places_.push_back({file_.node_ids.size(), block.place});
    Cards cards(block);
    while (const auto card = cards.next_filled()) {
      const Fields fields(*card, deck_.parameters, columns);
      file_.node_ids.push_back(fields.integer(0, "nid") + add);
      Point x{fields.number(1, "x", 0.0), fields.number(2, "y", 0.0), fields.number(3, "z", 0.0)};
      if (moved != nullptr) x = moved->apply(x);
      file_.mesh.nodes.push_back(x);
    }
  }

  void read_parts(const KeywordBlock& block) {
    Cards cards(block);
    while (const auto title = cards.next()) {
      const auto card = cards.next();
      if (!card) {
        if (title->blank()) return;
        fail_at(title->place, "*PART: expected a line of numbers after the title");
      }
      const std::int64_t id = Fields(*card, deck_.parameters).integer(0, "pid") + offset(block, &DeckTransform::part);
      part_of(id);
      file_.parts[part_places_.at(id)].name = std::string(trimmed(title->text));
    }
  }

  std::int32_t part_of(std::int64_t id) {
    const auto [found, is_new] = part_places_.try_emplace(id, static_cast<std::int32_t>(file_.parts.size()));
    if (is_new) file_.parts.push_back({id, ""});
    return found->second;
  }

  /// Number, part and eight nodes in one line; or the nodes, of which there may be ten, in the next one.
  void read_solids(const KeywordBlock& block) {
    const std::span<const int> columns(block.wide ? wide_solid_columns : solid_columns);
    const std::int64_t to_node = offset(block, &DeckTransform::node),
                       to_element = offset(block, &DeckTransform::element),
                       to_part = offset(block, &DeckTransform::part);
    const Transformation* moved = transformations_.of(block);
    const bool mirrored = moved != nullptr && moved->determinant() < 0;
    solid_places_.push_back({file_.element_ids.size(), block.place});
    Cards cards(block);
    while (const auto card = cards.next_filled()) {
      const Fields head(*card, deck_.parameters, columns);
      file_.element_ids.push_back(head.integer(0, "eid") + to_element);
      const std::int32_t part = part_of(head.integer(1, "pid") + to_part);
      file_.part.push_back(part);
      file_.line.push_back(static_cast<std::int32_t>(card->place.line));
      bool one_line = false;
      for (std::size_t i = 2; i < 10; ++i) one_line |= !head.blank(i);
      if (one_line) {
        add_solid(head, 2, to_node, mirrored);
      } else {
        const Card nodes = cards.require("the nodes of an element");
        add_solid(Fields(nodes, deck_.parameters, columns), 0, to_node, mirrored);
      }
    }
  }

  void add_solid(const Fields& fields, std::size_t first, std::int64_t to_node, bool mirrored) {
    std::array<std::int32_t, 8> corners{};
    for (std::size_t i = 0; i < 8; ++i) {
      const std::int64_t id = fields.integer(first + i, "node", 0);
      if (id == 0) fail_element(fields, "has fewer than eight nodes: a tetrahedron, which is not read yet");
      corners[i] = nodes_.find(id + to_node);
      if (corners[i] < 0) fail_element(fields, fmt::format("has node {}, which is not there", id + to_node));
    }
    for (std::size_t i = 8; first == 0 && i < 10; ++i) {
      if (fields.integer(i, "node", 0) != 0)
        fail_element(fields, "has ten nodes: a tetrahedron, which is not read yet");
    }
    const std::set<std::int32_t> different(corners.begin(), corners.end());
    if (different.size() <= 4) fail_element(fields, "is a tetrahedron, which is not read yet");
    if (mirrored) std::swap_ranges(corners.begin(), corners.begin() + 4, corners.begin() + 4);
    file_.mesh.hexahedra.push_back(corners);
  }

  [[noreturn]] void fail_element(const Fields& fields, const std::string& problem) const {
    fail_at(fields.place(), fmt::format("*ELEMENT_SOLID: element {} {}", file_.element_ids.back(), problem));
  }

  /// places: of the keywords in which the numbers stand.
  static void check_numbers(const std::vector<std::int64_t>& numbers, const std::vector<Run>& places,
                            const char* what) {
    const std::int32_t repeated = NumberIndex(numbers).repeated();
    if (repeated < 0) return;
    const DeckPlace* keyword = nullptr;
    for (const Run& run : places) {
      if (run.first <= static_cast<std::size_t>(repeated)) keyword = &run.keyword;
    }
    fail_at(*keyword, fmt::format("{} {} is given twice", what, numbers[repeated]));
  }

  void check_solid_numbers() const { check_numbers(file_.element_ids, solid_places_, "element"); }

  const KeywordDeck& deck_;
  Transformations transformations_;
  MeshFile file_;
  NumberIndex nodes_;
  std::map<std::int64_t, std::int32_t> part_places_;
  std::vector<Run> node_places_, solid_places_;
};

}  // namespace

MeshFile keyword_mesh(const KeywordDeck& deck) { return Reader(deck).read(); }

}  // namespace pinball
