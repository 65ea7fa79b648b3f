#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include <solver/base/error.hpp>

#include "abaqus_parts.hpp"

namespace pinball {

namespace {

/// Whether the nodes of a label's set stand as written (*NSET, UNSORTED), which a mesh here does not know.
bool is_unsorted(const AbaqusData& data, const std::string& label) {
  const auto parts = split_label(label);
  const std::string key = label_key(parts ? parts->second : label);
  return std::ranges::any_of(data.deck.blocks, [&](const AbaqusBlock& block) {
    return block.name == "NSET" && block.has("UNSORTED") && label_key(block.require("NSET")) == key;
  });
}

/// *EQUATION: a line with the number of terms, then up to four of them to a line: node or set, degree of freedom,
/// factor.
class EquationCards {
 public:
  EquationCards(AbaqusData& data, const AbaqusBlock& block, DeckScene& scene)
      : data_(data), block_(block), scene_(scene) {}

  void translate(int& count) {
    DataLines lines(block_);
    while (const auto line = lines.next()) {
      const std::int64_t terms = DataFields(*line).integer(0, "number of terms");
      if (terms < 1) fail_at(line->place, fmt::format("*EQUATION: expected a number of terms >= 1, got {}", terms));
      name_ = fmt::format("equation_{}", ++count);
      std::int64_t read = 0;
      while (read < terms) {
        const DataLine card = lines.require(fmt::format("{} more terms of *EQUATION", terms - read));
        const DataFields f(card);
        for (std::size_t i = 0; i < terms_per_line && read < terms; ++i) {
          if (i > 0 && f.blank(3 * i)) break;  // as few to a line as it likes
          add(f, 3 * i, read++ == 0);
        }
      }
    }
  }

 private:
  static constexpr std::size_t terms_per_line = 4;

  void add(const DataFields& f, std::size_t field, bool is_first) {
    const std::string label = f.text(field);
    const std::int64_t degree = f.integer(field + 1, "degree of freedom");
    const double factor = f.number(field + 2, "coefficient", 0.0);
    const AbaqusNodes nodes = data_.nodes(label, f.place());
    const bool several = nodes.members.size() > 1;
    if (is_first) of_sets_ = several;
    if (degree < 1 || degree > 3)
      return data_.report.reject(f.place(), fmt::format("*EQUATION with degree of freedom {}", degree),
                                 "1 to 3, displacements of nodes of solids");
    if (data_.has_reference(nodes))
      return data_.report.reject(f.place(), "*EQUATION of the reference node of a rigid body");
    if (several && !of_sets_)
      fail_at(f.place(), "*EQUATION: expected a node, as in the first term, got a set of several");
    if (several && is_unsorted(data_, label))
      return data_.report.reject(f.place(), "*EQUATION of sets that are UNSORTED", "give each node its own equation");
    std::vector<std::int64_t> numbers;
    for (const std::int32_t node : nodes.members) {
      if (!data_.used[node])
        return data_.report.reject(f.place(), "*EQUATION of a node of no solid", "a node without mass cannot move");
      numbers.push_back(data_.mesh.file.node_ids[node]);
    }
    std::sort(numbers.begin(), numbers.end());
    if (factor == 0) fail_at(f.place(), "*EQUATION: expected a coefficient that is not 0, got 0");
    Point direction{};
    direction[degree - 1] = 1;
    const auto keys = scene_.entry<EquationTerm>("equation", card_of(block_, f.place()));
    keys.set("name", name_);
    keys.set("direction", direction);
    keys.set("factor", factor);
    keys.set("nodes", numbers);
  }

  AbaqusData& data_;
  const AbaqusBlock& block_;
  DeckScene& scene_;
  std::string name_;
  bool of_sets_ = false;  ///< whether the first term is of several nodes
};

}  // namespace

void translate_abaqus_equations(AbaqusData& data, DeckScene& scene) {
  int count = 0;
  for (const AbaqusBlock& block : data.deck.blocks) {
    if (block.name != "EQUATION") continue;
    if (!block.part.empty() || !block.instance.empty()) {
      data.report.reject(block.place, "*EQUATION in a part or an instance", "move it into *ASSEMBLY");
      continue;
    }
    EquationCards(data, block, scene).translate(count);
  }
}

}  // namespace pinball
