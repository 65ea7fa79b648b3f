#include "contact_pairs.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace pinball {

namespace {

/// Tables have the square of this number of entries.
constexpr std::int32_t most_groups = 4096;

}  // namespace

ContactPairs::ContactPairs(SurfaceSides sides) : sides_(std::move(sides)), active_(sides_.rules.size(), 0) {
  find_edge_groups();
  for (std::int32_t t = 0; t < sides_.ties + sides_.rigid; ++t) {
    const std::int32_t side = 2 * sides_.rules.size() + t;
    for (std::size_t g = 0; g < groups_; ++g) {
      second_of_tie_.push_back(sides_.patterns.has(g, side) ? 1 : 0);
    }
  }
  set_tied({});
  fill_tables();
}

void ContactPairs::set_tied(std::vector<std::int16_t> tie_of_node) {
  tie_of_node_ = std::move(tie_of_node);
  const std::vector<std::int16_t>& attached_to = sides_.attached_to;
  if (attached_to.empty()) return;
  if (tie_of_node_.empty()) tie_of_node_.assign(attached_to.size(), -1);
  for (std::size_t n = 0; n < attached_to.size(); ++n) {
    if (attached_to[n] >= 0) tie_of_node_[n] = static_cast<std::int16_t>(sides_.ties + attached_to[n]);
  }
}

/// An edge belongs to the sides that both its nodes belong to by faces around them.
void ContactPairs::find_edge_groups() {
  std::vector<std::int32_t> of_nodes = sides_.node;
  std::sort(of_nodes.begin(), of_nodes.end());
  of_nodes.erase(std::unique(of_nodes.begin(), of_nodes.end()), of_nodes.end());
  const auto require_few = [this] {
    if (sides_.patterns.count() > most_groups) throw std::length_error("too many combinations of sides of contact");
  };
  require_few();
  std::vector<std::array<std::int32_t, 3>> found;
  for (const std::int32_t a : of_nodes) {
    for (const std::int32_t b : of_nodes) found.push_back({a, b, sides_.patterns.common(a, b, sides_.sides())});
    require_few();
  }
  groups_ = sides_.patterns.count();
  edge_.assign(groups_ * groups_, SidePatterns::none);
  for (const auto& [a, b, group] : found) edge_[a * groups_ + b] = group;
}

bool ContactPairs::set_time(double time) {
  bool changed = false;
  for (std::size_t p = 0; p < active_.size(); ++p) {
    const std::uint8_t active = time >= sides_.rules[p].start && time < sides_.rules[p].end ? 1 : 0;
    changed = std::exchange(active_[p], active) != active || changed;
  }
  if (changed) fill_tables();
  return changed;
}

bool ContactPairs::has_friction() const {
  return std::any_of(sides_.rules.begin(), sides_.rules.end(),
                     [](const PairRule& rule) { return rule.static_friction > 0 || rule.friction > 0; });
}

void ContactPairs::fill_tables() {
  touching_.assign(groups_ * groups_, PairOf{-1, 0, sides_.rules.empty()});
  for (std::size_t p = 0; p < active_.size(); ++p) {
    if (active_[p] != 0) fill_pair(static_cast<std::int16_t>(p));
  }
}

void ContactPairs::fill_pair(std::int16_t pair) {
  const std::int32_t first = 2 * pair, second = rule(pair).alone ? first : first + 1;
  std::vector<std::size_t> faces[2], things[2];  // groups on either side: of faces, and with those of nodes alone
  for (std::size_t g = 0; g < groups_; ++g) {
    for (int s = 0; s < 2; ++s) {
      const std::int32_t group = g;
      const std::int32_t side = s == 0 ? first : second;
      const bool of_faces = sides_.patterns.has(group, side);
      if (of_faces) faces[s].push_back(g);
      if (of_faces || sides_.patterns.has(group, side + sides_.sides())) things[s].push_back(g);
    }
  }
  for (int s = 0; s < 2; ++s) {
    const auto sign = static_cast<std::int8_t>(s == 0 ? 1 : -1);
    for (const std::size_t own : things[s]) {
      for (const std::size_t other : faces[1 - s]) {
        PairOf& of = touching_[own * groups_ + other];
        const bool both = s == 1 && of.pair == pair;  // either thing is on either side
        of = {pair, both ? std::int8_t(0) : sign, true};
      }
    }
  }
}

bool ContactPairs::faces_may(std::int64_t slot1, std::int32_t face1, std::span<const std::int32_t, 4> corners1,
                             std::int64_t slot2, std::int32_t face2, std::span<const std::int32_t, 4> corners2) const {
  const std::int32_t own = face_group(slot1, face1), other = face_group(slot2, face2);
  if (touching(own, other).may) return true;
  const auto any_may = [this](std::span<const std::int32_t, 4> nodes, std::int32_t group) {
    return std::any_of(nodes.begin(), nodes.end(), [&](std::int32_t n) { return touching(sides_.node[n], group).may; });
  };
  return any_may(corners1, other) || any_may(corners2, own);
}

void ContactPairs::persist(StateArchive& archive) {
  archive.of_fixed_size(active_);
  for (const std::uint8_t active : active_) archive.require(active <= 1);
  if (archive.reads()) fill_tables();
}

std::size_t ContactPairs::bytes() const {
  return sides_.element.capacity() * sizeof(sides_.element[0]) + sides_.face.capacity() * sizeof(sides_.face[0]) +
         sides_.node.capacity() * sizeof(sides_.node[0]) + edge_.capacity() * sizeof(edge_[0]) +
         touching_.capacity() * sizeof(touching_[0]) + second_of_tie_.capacity() +
         (tie_of_node_.capacity() + sides_.attached_to.capacity()) * sizeof(tie_of_node_[0]);
}

}  // namespace pinball
