#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <numeric>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <solver/base/counted.hpp>
#include <solver/mesh/file/split_ten_nodes.hpp>

#include "abaqus_parts.hpp"
#include "abaqus_transform.hpp"

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
std::vector<std::int64_t> given_numbers(const AbaqusData& data, const std::vector<std::int32_t>& nodes) {
  std::vector<std::int64_t> numbers;
  for (const std::int32_t node : nodes) {
    const std::size_t at = node;
    if (at < data.mesh.given_nodes && data.used[at]) numbers.push_back(data.mesh.file.node_ids[at]);
  }
  return numbers;
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

/// Loads of all steps: a line of a card each, from its step on, until a later one says otherwise of what it acts on.
class Loads {
 public:
  Loads(AbaqusData& data, const AbaqusTransforms& transforms, DeckScene& scene)
      : data_(data), transforms_(transforms), scene_(scene) {}

  void translate() {
    for (int step = 0; step <= std::ssize(data_.steps); ++step) read_step(step);
    for (const Line& line : lines_) {
      if (!line.members.empty() && !only_ends(line)) line.write(line);
    }
  }

 private:
  struct Line {
    const AbaqusBlock* block;
    DeckPlace place;
    double magnitude;
    std::vector<std::string> things;   ///< what it acts on, in words that no other has
    std::vector<std::size_t> members;  ///< places of those in things that it still is of
    std::optional<double> end;         ///< when a later step says otherwise of them
    std::function<void(const Line&)> write;
  };

  /// A magnitude of 0 in a later step: of that which it ends.
  bool only_ends(const Line& line) const {
    return line.block->step > 1 && line.magnitude == 0 && !data_.curve(*line.block).absolute;
  }

  static bool is_load(const AbaqusBlock& block) {
    return block.name == "CLOAD" || block.name == "DLOAD" || block.name == "DSLOAD";
  }

  /// Step 0: what stands outside of all, and is refused.
  void read_step(int step) {
    const std::size_t before = lines_.size();
    RepeatedLoads repeated(data_.report);
    for (const AbaqusBlock& block : data_.deck.blocks) {
      if (block.step != step || !is_load(block)) continue;
      if (step > 1 && block.option("OP") == "NEW") end_all(block, before);
      DataLines lines(block);
      while (const auto card = lines.next()) {
        (this->*(block.name == "CLOAD" ? &Loads::read_force : &Loads::read_distributed))(block, *card, repeated);
        repeated.end_of_card(card->place, block.star_name());
      }
    }
    if (step > 1) replace(before, step);
  }

  /// OP=NEW: loads of the same keyword in the steps before, the first `count` lines, end.
  void end_all(const AbaqusBlock& renewing, std::size_t count) {
    const AbaqusBlock* last = nullptr;
    for (std::size_t i = 0; i < count; ++i) {
      Line& line = lines_[i];
      if (line.end || line.block->name != renewing.name) continue;
      line.end = data_.step_of(renewing).start;
      if (line.block != last)
        data_.report.understood(fmt::format("{} ({}): ends where the step begins (OP=NEW)", line.block->star_name(),
                                            line.block->place.text()));
      last = line.block;
    }
  }

  /// What lines from `first` on, which are of one step, act on counts from it on: lines before end there.
  void replace(std::size_t first, int step) {
    std::set<std::string> renewed;
    for (std::size_t i = first; i < lines_.size(); ++i)
      renewed.insert(lines_[i].things.begin(), lines_[i].things.end());
    const double start = data_.steps[step - 1].start;
    for (std::size_t i = 0; i < first; ++i) {
      if (lines_[i].end) continue;
      Line ended = lines_[i];
      const auto is_renewed = [&](std::size_t member) { return renewed.contains(ended.things[member]); };
      std::erase_if(ended.members, std::not_fn(is_renewed));
      if (ended.members.empty()) continue;
      std::erase_if(lines_[i].members, is_renewed);
      ended.end = start;
      if (lines_[i].members.empty()) {
        lines_[i] = std::move(ended);
      } else {
        lines_.push_back(std::move(ended));
      }
    }
  }

  void add(const AbaqusBlock& block, const DataFields& f, std::vector<std::string> things,
           std::function<void(const Line&)> write) {
    std::vector<std::size_t> members(things.size());
    std::iota(members.begin(), members.end(), std::size_t{0});
    lines_.push_back({&block,
                      f.place(),
                      f.number(2, "magnitude", 0.0),
                      std::move(things),
                      std::move(members),
                      {},
                      std::move(write)});
  }

  AbaqusCurve curve_of(const Line& line) const {
    return within(data_.curve(*line.block), line.block->step > 1 ? data_.step_of(*line.block).start : 0.0, line.end);
  }

  void read_force(const AbaqusBlock& block, const DataLine& card, RepeatedLoads& repeated) {
    const DataFields f(card);
    const std::int64_t degree = f.integer(1, "degree of freedom");
    const AbaqusNodes nodes = data_.nodes(f.text(0), card.place);
    if (data_.has_reference(nodes))
      return data_.report.reject(card.place, "*CLOAD of the reference node of a rigid body",
                                 "give it to nodes of its elements");
    if (!is_translation(data_, block, card.place, degree)) return;
    std::vector<std::string> things;
    for (const std::int32_t node : nodes.members) {
      things.push_back(fmt::format("that of node {} along {}", data_.mesh.file.node_ids[node], "xyz"[degree - 1]));
      repeated.add(things.back());
    }
    const AbaqusTransform* const transform = transforms_.of(nodes, block, card.place);
    const Point direction = transforms_.direction(transform, degree - 1, block, card.place);
    add(block, f, std::move(things),
        [this, nodes, direction](const Line& line) { write_force(line, nodes, direction); });
  }

  void write_force(const Line& line, const AbaqusNodes& nodes, const Point& direction) {
    AbaqusNodes some = nodes;
    if (line.members.size() != line.things.size()) {
      some.set.clear();
      some.members.clear();
      for (const std::size_t member : line.members) some.members.push_back(nodes.members[member]);
    }
    const std::vector<std::int64_t> numbers = given_numbers(data_, some.members);
    const bool is_part = line.members.size() != line.things.size() || std::ranges::any_of(some.members, [&](auto node) {
                           return static_cast<std::size_t>(node) >= data_.mesh.given_nodes;
                         });
    if (is_part && numbers.empty()) return;
    const AbaqusCurve curve = curve_of(line);
    Point force = direction;
    for (double& component : force) component *= curve.times.empty() ? line.magnitude : 1.0;
    const auto keys = scene_.entry<NodalLoad>("load", card_of(*line.block, line.place));
    keys.set("force", force);
    keys.set("each", true);
    set_curve(curve, line.magnitude, keys);
    if (is_part) {
      keys.set("nodes", numbers);
    } else {
      set_nodes(some, keys);
    }
  }

  void read_distributed(const AbaqusBlock& block, const DataLine& card, RepeatedLoads& repeated) {
    const DataFields f(card);
    const std::string kind = squeezed(f.text(1));
    if (kind == "GRAV") {
      read_gravity(block, f, repeated);
    } else if (kind.size() == 2) {
      read_face_pressure(block, f, kind[1] - '0', repeated);
    } else {
      const std::string surface = data_.faces(f.text(0), card.place), thing = "P of surface " + surface;
      repeated.add(thing);
      add(block, f, {thing}, [this, surface](const Line& line) { begin_pressure(line).set("set", surface); });
    }
  }

  /// Magnitude and direction of an acceleration: a later one of the same bodies may have another direction.
  void read_gravity(const AbaqusBlock& block, const DataFields& f, RepeatedLoads& repeated) {
    const std::vector<std::string> bodies = data_.whole_bodies(f.text(0), f.place());
    if (const auto [what, advice] = undone_weight(data_, f.text(0), bodies, f.place()); !what.empty())
      return data_.report.reject(f.place(), what, advice);
    Point direction{f.number(3, "direction", 0.0), f.number(4, "direction", 0.0), f.number(5, "direction", 0.0)};
    const double length = norm(direction);
    if (!(length > 0)) fail_at(f.place(), "*DLOAD, GRAV: expected a direction");
    for (double& component : direction) component /= length;
    std::vector<std::string> things;
    for (const std::string& body : bodies) {
      things.push_back("GRAV of " + body);
      repeated.add(fmt::format("GRAV of {} along {} {} {}", body, f.text(3), f.text(4), f.text(5)));
    }
    add(block, f, std::move(things),
        [this, bodies, direction](const Line& line) { write_gravity(line, bodies, direction); });
  }

  void write_gravity(const Line& line, const std::vector<std::string>& bodies, Point direction) {
    const AbaqusCurve curve = curve_of(line);
    for (double& component : direction) component *= curve.times.empty() ? line.magnitude : 1.0;
    const auto keys = scene_.entry<Gravity>("gravity", card_of(*line.block, line.place));
    keys.set("acceleration", direction);
    std::vector<std::string> some;
    for (const std::size_t member : line.members) some.push_back(bodies[member]);
    if (some.size() != data_.bodies.size()) keys.set("bodies", some);
    set_curve(curve, line.magnitude, keys);
  }

  DeckKeys<Pressure> begin_pressure(const Line& line) {
    const AbaqusCurve curve = curve_of(line);
    auto keys = scene_.entry<Pressure>("pressure", card_of(*line.block, line.place));
    keys.set("pressure", curve.times.empty() ? line.magnitude : 1.0);
    set_curve(curve, line.magnitude, keys);
    return keys;
  }

  /// P1 to P6: on the faces of elements that have these numbers.
  void read_face_pressure(const AbaqusBlock& block, const DataFields& f, int number, RepeatedLoads& repeated) {
    const MeshFile& file = data_.mesh.file;
    std::vector<std::string> things;
    std::vector<std::vector<std::vector<std::int64_t>>> faces;  // of each thing, of several where it is split
    const std::vector<std::int32_t> elements = data_.elements(f.text(0), f.place());
    for (const auto& [e, corners] : whole_elements(file, elements)) {
      const int face = abaqus_face(corners, given_shape(data_.mesh.types, e), number);
      if (face < 0) fail_at(f.place(), fmt::format("*DLOAD: this element has no face P{}", number));
      if (!is_face(corners_of_face(corners, face))) continue;
      things.push_back(fmt::format("P{} of element {}", number, file.element_ids[e]));
      repeated.add(things.back());
      faces.emplace_back();
      for (const auto& one : data_.middles.pieces_of(corners_of_face(corners, face))) {
        faces.back().emplace_back();
        for (const std::int32_t node : one) faces.back().back().push_back(file.node_ids[node]);
      }
    }
    if (faces.empty() && !elements.empty())
      return data_.report.unused(f.place(), fmt::format("*DLOAD: P{}", number),
                                 "nodes that are the same leave no face");
    add(block, f, std::move(things), [this, faces = std::move(faces)](const Line& line) {
      std::vector<std::vector<std::int64_t>> all;
      for (const std::size_t member : line.members) all.insert(all.end(), faces[member].begin(), faces[member].end());
      begin_pressure(line).set("faces", all);
    });
  }

  AbaqusData& data_;
  const AbaqusTransforms& transforms_;
  DeckScene& scene_;
  std::vector<Line> lines_;
};

}  // namespace

void translate_abaqus_loads(AbaqusData& data, const AbaqusTransforms& transforms, DeckScene& scene) {
  Loads(data, transforms, scene).translate();
}

}  // namespace pinball
