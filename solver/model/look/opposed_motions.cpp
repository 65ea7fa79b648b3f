#include "opposed_motions.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <span>

#include <solver/model/given_directions.hpp>
#include <solver/model/place_names.hpp>

namespace pinball {

namespace {

bool is_at_rest(const PrescribedVelocity& given) {
  const bool factors_are_zero = !given.table.factors.empty() &&
                                std::ranges::all_of(given.table.factors, [](double factor) { return factor == 0; });
  return norm(given.velocity) == 0 || factors_are_zero;
}

/// Whether speeds of both are alike at all times, but for a factor.
bool have_one_table(const PrescribedVelocity& one, const PrescribedVelocity& other) {
  return one.quantity == other.quantity && one.table.times == other.table.times &&
         one.table.factors == other.table.factors;
}

/// One look at the directions of one scene.
class Opposed {
 public:
  Opposed(const Scene& scene, const ModelMesh& mesh) : scene_(scene), mesh_(mesh) {}

  std::vector<std::string> sentences() {
    if (scene_.prescribed_velocities.empty()) return {};
    std::vector<GivenDirection> directions = given_directions(scene_, mesh_);
    std::ranges::stable_sort(directions, {}, &GivenDirection::node);
    for (auto first = directions.cbegin(); first != directions.cend();) {
      const auto last =
          std::find_if(first, directions.cend(), [first](const GivenDirection& d) { return d.node != first->node; });
      look_at_node({first, last});
      first = last;
    }
    std::vector<std::string> all;
    for (const auto& [pair, found] : found_) all.push_back(sentence(pair, found));
    return all;
  }

 private:
  struct Pair {
    std::int32_t motion, other;  ///< numbers of prescribed velocities, of the other one or of a constraint
    bool held;
    auto operator<=>(const Pair&) const = default;
  };
  struct Found {
    std::set<std::int32_t> nodes;
    double time;  ///< first
  };

  /// At all times when something of the node begins.
  void look_at_node(std::span<const GivenDirection> of_node) {
    if (std::ranges::all_of(of_node, &GivenDirection::held)) return;
    std::set<double> times;
    for (const GivenDirection& given : of_node) times.insert(std::max(0.0, given.when.start));
    for (const double time : times) {
      NodeDirections directions(scene_);
      for (const GivenDirection& given : of_node) {
        if (given.when.contains(time) && !directions.add(given) && !given.held) compare(given, directions, time);
      }
    }
  }

  /// The speed of a motion along a direction beside what the directions before it make of that.
  void compare(const GivenDirection& given, const NodeDirections& directions, double time) {
    const PrescribedVelocity& motion = scene_.prescribed_velocities[given.table];
    double missing = is_at_rest(motion) ? 0 : given.speed, largest = std::abs(missing);
    bool otherwise = false;  // in another course of time
    const GivenDirection* opposed = nullptr;
    for (const NodeDirections::Own& own : directions.all()) {
      const double part = dot(own.direction, given.direction);
      if (std::abs(part) < 1e-6) continue;
      const bool moves = !own.given->held && !is_at_rest(scene_.prescribed_velocities[own.given->table]);
      const double speed = moves ? part * own.speed : 0;
      if (opposed == nullptr || speed != 0) opposed = own.given;
      if (speed == 0) continue;
      largest = std::max(largest, std::abs(speed));
      missing -= speed;
      otherwise = otherwise || !have_one_table(motion, scene_.prescribed_velocities[own.given->table]);
    }
    if (opposed == nullptr || (!otherwise && std::abs(missing) <= 1e-6 * largest)) return;
    Found& found = found_.try_emplace({given.table, opposed->table, opposed->held}, Found{{}, time}).first->second;
    found.nodes.insert(given.node);
    found.time = std::min(found.time, time);
  }

  std::string sentence(const Pair& pair, const Found& found) const {
    const std::size_t planes = scene_.constraints.size(), other = pair.other;
    const std::string& giver = !pair.held       ? scene_.prescribed_velocities[other].nodes.where
                               : other < planes ? scene_.constraints[other].where
                                                : scene_.fixed_constraints[other - planes].nodes.where;
    const std::string since = found.time > 0 ? fmt::format(" from time {:.4g} on", found.time) : "";
    const bool one = found.nodes.size() == 1;
    const char* const them = one ? "it" : "them";
    const std::string why =
        pair.held ? fmt::format("holds {}", them) : fmt::format("comes before it and moves {} otherwise", them);
    return fmt::format("{}: {} {} not move as it says{}, since {} {}, first {}: leave {} out of one of the two",
                       scene_.prescribed_velocities[pair.motion].nodes.where, found.nodes.size(),
                       one ? "node does" : "nodes do", since, giver, why, node_name(mesh_, *found.nodes.begin()), them);
  }

  const Scene& scene_;
  const ModelMesh& mesh_;
  std::map<Pair, Found> found_;
};

}  // namespace

std::vector<std::string> opposed_motions(const Scene& scene, const ModelMesh& mesh) {
  return Opposed(scene, mesh).sentences();
}

}  // namespace pinball
