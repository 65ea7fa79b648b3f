#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include <solver/base/error.hpp>

#include "abaqus_parts.hpp"
#include "abaqus_transform.hpp"

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

/// Numbers of the nodes of a label, ascending; none where they are refused.
std::vector<std::int64_t> numbers_of_solids(AbaqusData& data, const AbaqusBlock& block, const std::string& label,
                                            const DeckPlace& place) {
  const AbaqusNodes nodes = data.nodes(label, place);
  const auto reject = [&](const char* of_what, const char* advice) {
    data.report.reject(place, block.star_name() + of_what, advice);
    return std::vector<std::int64_t>{};
  };
  if (data.has_reference(nodes)) return reject(" of the reference node of a rigid body", "");
  if (nodes.members.size() > 1 && is_unsorted(data, label))
    return reject(" of sets that are UNSORTED", "give each node its own equation");
  std::vector<std::int64_t> numbers;
  for (const std::int32_t node : nodes.members) {
    if (!data.used[node]) return reject(" of a node of no solid", "a node without mass cannot move");
    numbers.push_back(data.mesh.file.node_ids[node]);
  }
  std::sort(numbers.begin(), numbers.end());
  return numbers;
}

/// Of a set of several nodes that is paired with another one, node by node. What stands for elements of twenty nodes
/// has nodes in the middles of faces, numbered as it comes, which find no partner so.
bool rejects_middles(AbaqusData& data, const AbaqusBlock& block, const std::string& label, const DeckPlace& place) {
  const AbaqusNodes nodes = data.nodes(label, place);
  const bool are_given = std::ranges::none_of(
      nodes.members, [&](std::int32_t node) { return static_cast<std::size_t>(node) >= data.mesh.given_nodes; });
  if (nodes.members.size() < 2 || are_given) return false;
  data.report.reject(place, block.star_name() + " of pairs of nodes of two sets on elements of twenty nodes",
                     "elements of eight nodes, or sets with one of one node");
  return true;
}

/// *EQUATION: a line with the number of terms, then up to four of them to a line: node or set, degree of freedom,
/// factor.
class EquationCards {
 public:
  EquationCards(AbaqusData& data, const AbaqusTransforms& transforms, const AbaqusBlock& block, DeckScene& scene)
      : data_(data), transforms_(transforms), block_(block), scene_(scene) {}

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
    const bool several = data_.nodes(label, f.place()).members.size() > 1;
    if (is_first) of_sets_ = several;
    if (degree < 1 || degree > 3)
      return data_.report.reject(f.place(), fmt::format("*EQUATION with degree of freedom {}", degree),
                                 "1 to 3, displacements of nodes of solids");
    if (several && !of_sets_)
      fail_at(f.place(), "*EQUATION: expected a node, as in the first term, got a set of several");
    const std::vector<std::int64_t> numbers = numbers_of_solids(data_, block_, label, f.place());
    if (numbers.empty() || (!is_first && rejects_middles(data_, block_, label, f.place()))) return;
    if (factor == 0) fail_at(f.place(), "*EQUATION: expected a coefficient that is not 0, got 0");
    const AbaqusTransform* const transform = transforms_.of(data_.nodes(label, f.place()), block_, f.place());
    const Point direction = transforms_.direction(transform, degree - 1, block_, f.place());
    const auto keys = scene_.entry<EquationTerm>("equation", card_of(block_, f.place()));
    keys.set("name", name_);
    keys.set("direction", direction);
    keys.set("factor", factor);
    keys.set("nodes", numbers);
  }

  AbaqusData& data_;
  const AbaqusTransforms& transforms_;
  const AbaqusBlock& block_;
  DeckScene& scene_;
  std::string name_;
  bool of_sets_ = false;  ///< whether the first term is of several nodes
};

/// *MPC: lines of a kind and nodes or sets, of which the first follow the others.
class MpcCards {
 public:
  MpcCards(AbaqusData& data, const AbaqusTransforms& transforms, const AbaqusBlock& block, DeckScene& scene)
      : data_(data), transforms_(transforms), block_(block), scene_(scene) {}

  void translate(int& count) {
    DataLines lines(block_);
    while (const auto line = lines.next()) {
      const DataFields f(*line);
      const std::string kind = squeezed(f.text(0));
      const bool is_pair = kind == "PIN" || kind == "TIE";
      if (!is_pair && kind != "LINEAR") {
        data_.report.reject(f.place(), "*MPC, " + kind,
                            "PIN, TIE and LINEAR are done; what is rigid is a *RIGID BODY with a TIE NSET");
        continue;
      }
      numbers_.clear();
      for (std::size_t i = 1; i <= (is_pair ? 2U : 3U); ++i)
        numbers_.push_back(numbers_of_solids(data_, block_, f.text(i), f.place()));
      if (std::ranges::any_of(numbers_, [](const auto& of_label) { return of_label.empty(); })) continue;
      if (rejects_middles(data_, block_, f.text(2), f.place())) continue;
      for (std::size_t i = 1; i <= numbers_.size(); ++i) {
        if (transforms_.of(data_.nodes(f.text(i), f.place()), block_, f.place()) != nullptr)
          data_.report.reject(f.place(), "*MPC of nodes with a *TRANSFORM", "give *EQUATION");
      }
      write(f, is_pair ? std::vector<double>{1, -1} : shares_of_line(f), count);
    }
  }

 private:
  /// Of what follows two others along their line as it lies at the start.
  std::vector<double> shares_of_line(const DataFields& f) {
    std::vector<Point> x;
    for (std::size_t i = 0; i < numbers_.size(); ++i) {
      if (numbers_[i].size() != 1) fail_at(f.place(), "*MPC, LINEAR: expected nodes, got a set of several");
      x.push_back(data_.mesh.file.mesh.nodes[data_.nodes(f.text(i + 1), f.place()).members.front()]);
    }
    const Point along = minus(x[2], x[1]);
    if (!(dot(along, along) > 0)) fail_at(f.place(), "*MPC, LINEAR: expected two nodes in different places");
    const double share = dot(minus(x[0], x[1]), along) / dot(along, along);
    return {1, share - 1, -share};
  }

  void write(const DataFields& f, const std::vector<double>& factors, int& count) {
    if (numbers_[0].size() == 1 && numbers_[1].size() > 1)
      fail_at(f.place(), "*MPC: expected a node behind a node, got a set of several");
    ++count;
    for (std::size_t k = 0; k < 3; ++k) {
      Point direction{};
      direction[k] = 1;
      for (std::size_t i = 0; i < numbers_.size(); ++i) {
        if (factors[i] == 0) continue;
        const auto keys = scene_.entry<EquationTerm>("equation", card_of(block_, f.place()));
        keys.set("name", fmt::format("mpc_{}_{}", count, "xyz"[k]));
        keys.set("direction", direction);
        keys.set("factor", factors[i]);
        keys.set("nodes", numbers_[i]);
      }
    }
  }

  AbaqusData& data_;
  const AbaqusTransforms& transforms_;
  const AbaqusBlock& block_;
  DeckScene& scene_;
  std::vector<std::vector<std::int64_t>> numbers_;  ///< of the nodes of each label of a line
};

}  // namespace

void translate_abaqus_equations(AbaqusData& data, const AbaqusTransforms& transforms, DeckScene& scene) {
  int equations = 0, mpcs = 0;
  for (const AbaqusBlock& block : data.deck.blocks) {
    const bool is_equation = block.name == "EQUATION";
    if (!is_equation && block.name != "MPC") continue;
    if (!block.part.empty() || !block.instance.empty()) {
      data.report.reject(block.place, block.star_name() + " in a part or an instance", "move it into *ASSEMBLY");
    } else if (is_equation) {
      EquationCards(data, transforms, block, scene).translate(equations);
    } else {
      MpcCards(data, transforms, block, scene).translate(mpcs);
    }
  }
}

}  // namespace pinball
