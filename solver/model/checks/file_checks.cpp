#include "file_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include <solver/base/error.hpp>
#include <solver/mesh/mesh_checks.hpp>

namespace pinball {

namespace {

/// Nodes this close, over the shortest edge, are taken for one that was not joined: more than numbers of few digits are
/// off, less than the gaps that somebody leaves.
constexpr double coincidence = 1e-4;
constexpr std::size_t most_warnings = 5;

class Check {
 public:
  Check(const MeshFile& file, const std::vector<std::int32_t>& body, const std::vector<std::string>& names,
        const std::function<bool(std::int32_t, std::int32_t)>& may_meet)
      : file_(file), body_(body), names_(names), may_meet_(may_meet), warnings_(file.notes) {}

  std::vector<std::string> warnings() {
    collect_taken();
    check_repetitions();
    const ShapeFindings shapes = check_shapes(file_.mesh.nodes, taken());
    check_inversions(shapes);
    check_coincidence(coincidence * shapes.shortest_edge);
    return std::move(warnings_);
  }

 private:
  struct Coincidence {
    std::int64_t count = 0;
    std::pair<std::int32_t, std::int32_t> first;
  };

  /// Elements of bodies; of a file of which all are, as it is.
  void collect_taken() {
    bool all = true;
    for (const std::int32_t b : body_) all &= b >= 0;
    if (all) return;
    for (std::size_t e = 0; e < body_.size(); ++e) {
      if (body_[e] < 0) continue;
      hexahedra_.push_back(file_.mesh.hexahedra[e]);
      element_.push_back(e);
    }
  }
  const std::vector<std::array<std::int32_t, 8>>& taken() const {
    return element_.empty() ? file_.mesh.hexahedra : hexahedra_;
  }
  /// Place in the file.
  std::int32_t element(std::int32_t place) const { return element_.empty() ? place : element_[place]; }
  std::string name(std::int32_t place) const { return element_name(file_, element(place)); }
  const std::string& body(std::int32_t place) const { return names_[body_[element(place)]]; }

  void check_repetitions() const {
    const auto pairs = repeated_elements(taken());
    if (pairs.empty()) return;
    const auto [first, second] = pairs.front();
    throw InputError(
        fmt::format("{}: {} and {} have the same nodes, as {} pair{} of elements: expected each of them once",
                    file_.path, name(first), name(second), pairs.size(), pairs.size() == 1 ? "" : "s"));
  }

  void check_inversions(const ShapeFindings& shapes) {
    if (!shapes.inverted_at_centre.empty()) {
      const std::int32_t first = shapes.inverted_at_centre.front();
      throw InputError(
          fmt::format("{}: body {}: {} is turned inside out, as {} are: the Jacobian of its centre is not positive",
                      file_.path, body(first), name(first), shapes.inverted_at_centre.size()));
    }
    if (shapes.inverted_somewhere.empty()) return;
    const std::int32_t first = shapes.inverted_somewhere.front();
    warnings_.push_back(fmt::format(
        "{}: {} element{} folded: the Jacobian of a corner or of a Gauss point is negative, such as of {} of body {}",
        file_.path, shapes.inverted_somewhere.size(), shapes.inverted_somewhere.size() == 1 ? " is" : "s are",
        name(first), body(first)));
  }

  void check_coincidence(double tolerance) {
    std::vector<bool> used(file_.mesh.nodes.size(), false);
    for (const auto& hexahedron : taken()) {
      for (const std::int32_t node : hexahedron) used[node] = true;
    }
    auto pairs = coincident_nodes(file_.mesh.nodes, used, tolerance);
    std::erase_if(pairs, [this](const auto& pair) { return may_meet_(pair.first, pair.second); });
    if (pairs.empty()) return;
    const std::vector<std::int32_t> body_of_node = bodies_of_nodes();
    std::map<std::pair<std::int32_t, std::int32_t>, Coincidence> by_bodies;
    for (const auto& [a, b] : pairs) {
      Coincidence& found = by_bodies[std::minmax(body_of_node[a], body_of_node[b])];
      if (found.count++ == 0) found.first = {a, b};
    }
    std::size_t reported = 0;
    for (const auto& [bodies, found] : by_bodies) {
      if (reported++ < most_warnings) report(bodies, found);
    }
    if (reported > most_warnings) {
      warnings_.push_back(
          fmt::format("{}: nodes of {} more pairs of bodies lie on each other", file_.path, reported - most_warnings));
    }
  }

  /// The first body that has it.
  std::vector<std::int32_t> bodies_of_nodes() const {
    std::vector<std::int32_t> bodies(file_.mesh.nodes.size(), -1);
    for (std::size_t e = 0; e < body_.size(); ++e) {
      if (body_[e] < 0) continue;
      for (const std::int32_t node : file_.mesh.hexahedra[e]) {
        if (bodies[node] < 0 || bodies[node] > body_[e]) bodies[node] = body_[e];
      }
    }
    return bodies;
  }

  std::int64_t number(std::int32_t node) const { return file_.node_ids.empty() ? node : file_.node_ids[node]; }

  void report(const std::pair<std::int32_t, std::int32_t>& bodies, const Coincidence& found) {
    const Point& x = file_.mesh.nodes[found.first.first];
    const bool one = bodies.first == bodies.second;
    const std::string who = one ? "body " + names_[bodies.first]
                                : fmt::format("bodies {} and {}", names_[bodies.first], names_[bodies.second]);
    warnings_.push_back(fmt::format(
        "{}: {}: {} pair{} of nodes lie on each other and are not joined, such as {} and {} at ({:.6g}, {:.6g}, "
        "{:.6g}): {}",
        file_.path, who, found.count, found.count == 1 ? "" : "s", number(found.first.first),
        number(found.first.second), x[0], x[1], x[2],
        one ? "it comes apart there" : "the bodies come apart there, where contact does not hold them"));
  }

  const MeshFile& file_;
  const std::vector<std::int32_t>& body_;
  const std::vector<std::string>& names_;
  const std::function<bool(std::int32_t, std::int32_t)>& may_meet_;
  std::vector<std::string> warnings_;
  std::vector<std::array<std::int32_t, 8>> hexahedra_;
  std::vector<std::int32_t> element_;
};

}  // namespace

std::vector<std::string> check_file(const MeshFile& file, const std::vector<std::int32_t>& body,
                                    const std::vector<std::string>& names,
                                    const std::function<bool(std::int32_t, std::int32_t)>& may_meet) {
  return Check(file, body, names, may_meet).warnings();
}

}  // namespace pinball
