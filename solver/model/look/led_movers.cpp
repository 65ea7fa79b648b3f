#include "led_movers.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <string>

#include <solver/model/rigid/rigid_nodes.hpp>
#include <solver/model/selection/node_selection.hpp>

namespace pinball {

namespace {

void add_joints(const Scene& scene, const ModelMesh& mesh, const std::vector<std::int32_t>& group,
                std::vector<Lead>& leads) {
  for (const Joint& joint : scene.joints) {
    Lead& lead = leads.emplace_back();
    for (const std::string& name : joint.bodies) {
      const auto rigid = std::ranges::find(scene.rigid_bodies, name, &RigidBody::name);
      if (rigid != scene.rigid_bodies.end()) lead.movers.push_back(group[body_with(scene, mesh, *rigid)]);
    }
  }
}

/// Of an equation that moves one of its terms by what the others move.
struct LeadingTerms {
  std::vector<std::size_t> movers;
  double sum = 0, least = INFINITY;  ///< of the sizes of the factors [-]
};

void add_equations(const Scene& scene, const ModelMesh& mesh, const std::vector<std::int32_t>& group,
                   std::vector<Lead>& leads) {
  std::map<std::string, LeadingTerms> equations;
  for (const EquationTerm& term : scene.equation_terms) {
    LeadingTerms& of = equations[term.name];
    for (const std::int32_t n : select_nodes(mesh, term.nodes)) {
      const std::size_t mover = group[mesh.body_of_node[n]];
      if (std::ranges::find(of.movers, mover) == of.movers.end()) of.movers.push_back(mover);
    }
    of.sum += std::abs(term.factor);
    of.least = std::min(of.least, std::abs(term.factor));
  }
  for (const auto& [name, of] : equations) {
    if (of.movers.size() > 1)
      leads.push_back({of.movers, std::max(1.0, (of.sum - of.least) / of.least), !scene.rigid_walls.empty()});
  }
}

}  // namespace

std::vector<Lead> leads_of(const Scene& scene, const ModelMesh& mesh, const std::vector<std::int32_t>& group) {
  std::vector<Lead> leads;
  add_joints(scene, mesh, group, leads);
  add_equations(scene, mesh, group, leads);
  return leads;
}

void let_others_lead(const std::vector<Lead>& leads, const std::vector<DrivenMotion>& driven, Movers& movers) {
  const std::size_t count = movers.all.size();
  std::vector<std::size_t> first(count);
  std::iota(first.begin(), first.end(), 0);
  const auto root = [&first](std::size_t m) {
    while (first[m] != m) m = first[m];
    return m;
  };
  std::vector<bool> moves(count, false), is_led(count, false), meets_walls(count, false);
  for (const Lead& lead : leads) {
    for (const std::size_t m : lead.movers) {
      first[std::max(root(m), root(lead.movers.front()))] = std::min(root(m), root(lead.movers.front()));
      is_led[m] = true;
      meets_walls[m] = meets_walls[m] || lead.may_meet_walls;
    }
  }
  std::vector<double> length(count, 0), speed = length, times_as_far(count, 1), ratio = times_as_far;
  for (const Lead& lead : leads) {
    for (const std::size_t m : lead.movers) ratio[root(m)] = std::max(ratio[root(m)], lead.ratio);
  }
  std::vector<bool> is_first(count, true);
  for (std::size_t m = 0; m < count; ++m) {
    const Mover& own = movers.all[m];
    if (!is_led[m]) continue;
    moves[root(m)] = moves[root(m)] || own.speed > 0 || own.strayed.back().reach() > 0 || driven[m].turned > 0;
    length[root(m)] += std::sqrt(3.0) * own.box.size();
    speed[root(m)] = std::max(speed[root(m)], own.speed);
    // From one to the other, and so to the last.
    if (!is_first[root(m)]) times_as_far[root(m)] *= ratio[root(m)];
    is_first[root(m)] = false;
  }
  for (std::size_t j = 0; j < movers.times.size(); ++j) {
    std::vector<double> furthest(count, 0);
    for (std::size_t m = 0; m < count; ++m)
      furthest[root(m)] = std::max(furthest[root(m)], movers.all[m].strayed[j].reach());
    for (std::size_t m = 0; m < count; ++m) {
      Mover& own = movers.all[m];
      if (!is_led[m] || own.held || !moves[root(m)] || j == 0) continue;
      const double way = times_as_far[root(m)] * (furthest[root(m)] + length[root(m)]);
      own.strayed[j].take(Extent{{-way, -way, -way}, {way, way, way}});
      own.speed = std::max(own.speed, times_as_far[root(m)] * speed[root(m)]);
      own.meets_wall = own.meets_wall || meets_walls[m];
    }
  }
}

}  // namespace pinball
