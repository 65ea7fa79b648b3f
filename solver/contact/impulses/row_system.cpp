#include "row_system.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <solver/base/lists_in_order.hpp>

namespace pinball {

/// The first place of what a place hangs together with so far; ways to it become shorter.
std::int32_t RowSystem::root(std::int32_t place) {
  while (parent_[place] != place) {
    std::int32_t& up = parent_[place];
    up = parent_[up];
    place = up;
  }
  return place;
}

void RowSystem::build(const ContactRows& rows, const std::vector<std::int32_t>& active,
                      const std::vector<ImpulseNode>& nodes, const std::vector<FrictionRow>& frictions,
                      const RigidPlaces& rigid) {
  rows_ = &rows;
  nodes_ = &nodes;
  rigid_ = rigid;
  rubs_ = !frictions.empty();
  find_islands(active);
  sort(active);
  copy_entries();
  list_rows_of_nodes();
  set_constants(frictions);
  for (Island& island : islands_) {
    for (std::int32_t k = island.first_row; rubs_ && k < island.end_row; ++k) {
      island.rubs = island.rubs || frictions[original(k)].rubs;
    }
  }
  if (rigid_) add_rigid_constants();
}

/// Each row gets the number of its island, in the order of their first rows.
void RowSystem::find_islands(const std::vector<std::int32_t>& active) {
  parent_.resize(nodes_->size());
  std::iota(parent_.begin(), parent_.end(), 0);
  for (const std::int32_t i : active) {
    const RowView row = (*rows_)[i];
    std::int32_t all = root(row.node[0]);
    for (int k = 1; k < row.nodes; ++k) {
      const std::int32_t other = root(row.node[k]);
      parent_[std::max(all, other)] = std::min(all, other);
      all = std::min(all, other);
    }
  }
  groups_.clear();
  if (rigid_) join_rigid_bodies();
  next_.assign(nodes_->size(), -1);  // island of a root
  island_.clear();
  islands_.clear();
  for (const std::int32_t i : active) {
    std::int32_t& island = next_[root((*rows_)[i].node[0])];
    if (island < 0) {
      island = islands_.size();
      islands_.push_back({0, 0, 0, 0});
    }
    island_.push_back(island);
    ++islands_[island].end_row;
  }
}

/// Counting sorts of rows and nodes by islands.
void RowSystem::sort(const std::vector<std::int32_t>& active) {
  const std::int32_t places = nodes_->size();
  const auto island_of = [this](std::int32_t place) { return next_[root(place)]; };
  for (std::int32_t place = 0; place < places; ++place) {
    if (const std::int32_t island = island_of(place); island >= 0) ++islands_[island].end_node;
  }
  std::int32_t rows = 0, nodes = 0;
  for (Island& island : islands_) {
    const std::int32_t own_rows = island.end_row, own_nodes = island.end_node;
    island = {rows, rows, nodes, nodes};
    rows += own_rows;
    nodes += own_nodes;
  }
  order_.resize(rows);
  for (std::size_t a = 0; a < active.size(); ++a) {
    order_[islands_[island_[a]].end_row++] = active[a];
  }
  node_order_.resize(nodes);
  for (std::int32_t place = 0; place < places; ++place) {
    const std::int32_t island = island_of(place);
    if (island >= 0 && node(place).body < 0) node_order_[islands_[island].end_node++] = place;
  }
  for (Island& island : islands_) island.end_free = island.end_node;
  if (rigid_) sort_rigid_nodes();
}

/// All places of a body hang together, and those of bodies that do by joints.
void RowSystem::join_rigid_bodies() {
  rigid_places_.clear();
  for (std::size_t place = 0; place < nodes_->size(); ++place) {
    if (node(static_cast<std::int32_t>(place)).body >= 0) rigid_places_.push_back(static_cast<std::int32_t>(place));
  }
  const auto body = [this](std::size_t i) { return node(rigid_places_[i]).body; };
  const auto join = [this](std::int32_t a, std::int32_t b) {
    const std::int32_t one = root(a), other = root(b);
    parent_[std::max(one, other)] = std::min(one, other);
  };
  std::stable_sort(rigid_places_.begin(), rigid_places_.end(),
                   [this](std::int32_t a, std::int32_t b) { return node(a).body < node(b).body; });
  next_.assign(rigid_.sides->mechanisms.size(), -1);  // first place of each
  for (std::size_t i = 0; i < rigid_places_.size(); ++i) {
    if (i > 0 && body(i - 1) == body(i)) {
      join(rigid_places_[i - 1], rigid_places_[i]);
    } else if (const std::int32_t mechanism = rigid_.side(body(i)).mechanism; mechanism >= 0) {
      if (next_[mechanism] >= 0) join(next_[mechanism], rigid_places_[i]);
      if (next_[mechanism] < 0) next_[mechanism] = rigid_places_[i];
    }
  }
}

/// Behind the free nodes of their islands, body by body.
void RowSystem::sort_rigid_nodes() {
  for (const std::int32_t place : rigid_places_) {
    const std::int32_t number = next_[root(place)], body = node(place).body;
    if (number < 0) continue;
    const std::int32_t at = islands_[number].end_node++;
    node_order_[at] = place;
    if (groups_.empty() || groups_.back().body != body) groups_.push_back({body, at, at});
    groups_.back().end_node = at + 1;
  }
  std::sort(groups_.begin(), groups_.end(),
            [](const RigidGroup& a, const RigidGroup& b) { return a.first_node < b.first_node; });
  std::int32_t group = 0;
  const std::int32_t groups = groups_.size();
  for (Island& island : islands_) {
    island.first_group = group;
    while (group < groups && groups_[group].first_node < island.end_node) ++group;
    island.end_group = group;
  }
}

/// Entries of the rows, in the order that they have here.
void RowSystem::copy_entries() {
  const std::int64_t rows = std::ssize(order_);
  first_entry_.resize(rows + 1);
  for_all_of("entries of rows", rows, rows, [&](std::int64_t k) { first_entry_[k] = rows_->rows[order_[k]].nodes; });
  first_entry_[rows] = 0;
  make_offsets(first_entry_);
  constants_.renew(order_.size());
  node_of_.renew(first_entry_.back());
  weight_of_.renew(node_of_.size());
  for_all_of("copies of rows", rows, first_entry_.back(), [&](std::int64_t k) {
    const RowView row = (*rows_)[order_[k]];
    std::copy_n(row.node, row.nodes, node_of_.data() + first_entry_[k]);
    std::copy_n(row.weight, row.nodes, weight_of_.data() + first_entry_[k]);
  });
}

void RowSystem::list_rows_of_nodes() {
  rows_of_node_.assign(nodes_->size() + 1, 0);
  weights_.assign(nodes_->size(), 0);
  for (std::int32_t k = 0; k < size(); ++k) {
    const RowView row = entries(k);
    for (int e = 0; e < row.nodes; ++e) ++rows_of_node_[row.node[e] + 1];
  }
  std::partial_sum(rows_of_node_.begin(), rows_of_node_.end(), rows_of_node_.begin());
  next_.assign(rows_of_node_.begin(), rows_of_node_.end() - 1);
  row_.renew(rows_of_node_.back());
  weight_.renew(row_.size());
  for (std::int32_t k = 0; k < size(); ++k) {
    const RowView row = entries(k);
    for (int e = 0; e < row.nodes; ++e) {
      const std::size_t at = next_[row.node[e]]++;
      row_[at] = k;
      weight_[at] = row.weight[e];
      weights_[row.node[e]] += std::abs(row.weight[e]);
    }
  }
}

/// The bound: sum over the nodes of |w_iI| times the sum of |w_jI| over all their rows, times what the node moves by.
void RowSystem::set_constants(const std::vector<FrictionRow>& frictions) {
  for_all_of("constants of rows", size(), 8 * size(), [&](std::int64_t row_number) {
    const auto k = static_cast<std::int32_t>(row_number);
    const ImpulseRow& own = rows_->rows[original(k)];
    const RowView row = entries(k);
    Row& constants = constants_[k];
    const Vec3<double> added{own.direction[0], own.direction[1], own.direction[2]};
    constants.length = std::sqrt(dot(added, added));
    constants.direction = (1 / constants.length) * added;
    constants.rate = own.position_rate / constants.length;
    constants.inverse_mass = own.inverse_mass / (constants.length * constants.length);
    constants.coefficient = 0;
    if (!frictions.empty()) {
      const FrictionRow& friction = frictions[original(k)];
      constants.coefficient = friction.inverse_mass > 0 ? friction.coefficient : 0.0;
    }
    constants.sum_along = constants.sum_across = 0;
    for (int e = 0; e < row.nodes; ++e) {
      const double weights = std::abs(row.weight[e]) * weights_[row.node[e]];
      const ImpulseNode& node = this->node(row.node[e]);
      if (node.body >= 0) continue;  // add_rigid_constants
      constants.sum_along += weights * dot(constants.direction, moved_by(node, constants.direction));
      constants.sum_across += weights * friction_mobility(node);
    }
    constants.bound = constants.sum_along;
    if (constants.coefficient > 0) constants.bound = std::max(constants.bound, constants.sum_across);
  });
}

/// The same over the rows of rigid bodies, by the bound of rigid_rows.hpp.
void RowSystem::add_rigid_constants() {
  const ImpulseNode* const nodes = nodes_->data();
  const auto for_entries = [&](const auto& visit) {
    for (std::int32_t k = 0; k < size(); ++k) {
      for_rigid_entries(entries(k), nodes, rigid_, [&](const RigidEntry& entry) {
        const RigidSide& side = rigid_.side(entry.body);
        visit(constants_[k], rigid_.first_of(entry.body), std::sqrt(entry.along(side, constants_[k].direction)),
              std::sqrt(entry.most(side)));
      });
    }
  };
  along_.assign(rigid_.sides->bodies.size(), 0);
  most_.assign(along_.size(), 0);
  for_entries([&](const Row&, std::int32_t body, double along, double most) {
    along_[body] += along;
    most_[body] += most;
  });
  for_entries([&](Row& row, std::int32_t body, double along, double most) {
    row.sum_along += along * along_[body];
    row.sum_across += most * most_[body];
  });
  for (Row& row : std::span(constants_.data(), constants_.size())) {
    row.bound = row.coefficient > 0 ? std::max(row.sum_along, row.sum_across) : row.sum_along;
  }
}

std::size_t RowSystem::bytes() const {
  const auto of = [](const auto& v) { return v.capacity() * sizeof(v[0]); };
  return of(order_) + of(first_entry_) + node_of_.bytes() + weight_of_.bytes() + of(node_order_) + of(islands_) +
         constants_.bytes() + of(rows_of_node_) + row_.bytes() + weight_.bytes() + of(weights_) + of(parent_) +
         of(island_) + of(next_) + of(groups_) + of(rigid_places_) + of(along_) + of(most_);
}

}  // namespace pinball
