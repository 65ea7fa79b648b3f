#include "abaqus_exclusions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numeric>

namespace pinball {

namespace {

using Places = std::vector<std::size_t>;

bool touches_itself(const std::string& first, const std::string& second) {
  return second.empty() || label_key(second) == label_key(first);
}

/// Rows of a table that are the same together, in the order of the first ones.
std::vector<Places> equal_rows(const std::vector<std::vector<Share>>& table) {
  std::vector<Places> groups;
  std::map<std::vector<Share>, std::size_t> group_of;
  for (std::size_t i = 0; i < table.size(); ++i) {
    const auto [found, is_new] = group_of.try_emplace(table[i], groups.size());
    if (is_new) groups.emplace_back();
    groups[found->second].push_back(i);
  }
  return groups;
}

Places members(const std::vector<Places>& groups, const Places& some) {
  Places all;
  for (const std::size_t g : some) all.insert(all.end(), groups[g].begin(), groups[g].end());
  std::ranges::sort(all);
  return all;
}

}  // namespace

void AbaqusExclusions::read(const AbaqusBlock& block) {
  DataLines lines(block);
  while (const auto card = lines.next()) {
    const DataFields f(*card);
    add(card->place, f.text(0), f.text(1));
  }
}

void AbaqusExclusions::add(const DeckPlace& place, const std::string& first, const std::string& second) {
  const std::string other = touches_itself(first, second) ? first : second;
  for (const std::string& label : {first, other}) side_of(label, place);  // they have to be there
  exclusions_.push_back({place, first, other});
}

Share AbaqusExclusions::share_of_pair(const std::string& first, const std::string& second, const DeckPlace& place) {
  const std::string a = label_key(first), b = touches_itself(first, second) ? a : label_key(second);
  for (const Exclusion& one : exclusions_) {  // of surfaces of nodes no more is known than that
    const std::string c = label_key(one.first), d = label_key(one.second);
    if ((a == c && b == d) || (a == d && b == c)) return Share::all;
  }
  bool any = false, all = true;
  const Side side_a = side(first, place), side_b = a == b ? side_a : side(second, place);
  for (const std::vector<Share>& row : left_out(side_a, side_b)) {
    for (const Share share : row) {
      any = any || share != Share::none;
      all = all && share == Share::all;
    }
  }
  return !any ? Share::none : all ? Share::all : Share::some;
}

DeckSide AbaqusExclusions::side_of(const std::string& label, const DeckPlace& place) const {
  if (!label.empty()) return data_.surface(label, place);
  std::vector<std::string> names;
  for (const AbaqusBody& body : data_.bodies) names.push_back(body.name);
  return {names};
}

AbaqusExclusions::Side AbaqusExclusions::side(const std::string& label, const DeckPlace& place) {
  if (!outside_) outside_.emplace(data_);
  Side side{&outside_->faces(label, place), {}, side_of(label, place)};
  for (std::size_t b = 0; b < data_.bodies.size(); ++b) {
    if (label.empty() || !side.faces->of_body[b].empty()) side.bodies.push_back(b);
  }
  return side;
}

AbaqusSides AbaqusExclusions::all_of(const std::string& first, const std::string& second,
                                     const DeckPlace& place) const {
  return {side_of(first, place), touches_itself(first, second) ? DeckSide{} : side_of(second, place)};
}

std::vector<AbaqusSides> AbaqusExclusions::left_of(const std::string& first, const std::string& second,
                                                   const DeckPlace& place) {
  const AbaqusSides all = all_of(first, second, place);
  if (exclusions_.empty()) return {all};
  const bool alone = all.second.empty();
  const Side one = side(first, place), other = alone ? one : side(second, place);
  const Table out = left_out(one, other);
  const auto any = [&out](Share share) {
    return std::ranges::any_of(out, [share](const auto& row) { return std::ranges::count(row, share) > 0; });
  };
  if (any(Share::some)) reject(*partial_);
  if (!any(Share::all)) return {all};
  return alone ? among(one, out) : between(one, other, out);
}

AbaqusExclusions::Table AbaqusExclusions::left_out(const Side& first, const Side& second) {
  Table out(first.bodies.size(), std::vector<Share>(second.bodies.size(), Share::none));
  for (Exclusion& exclusion : exclusions_) leave_out(exclusion, first, second, out);
  return out;
}

void AbaqusExclusions::leave_out(Exclusion& exclusion, const Side& first, const Side& second, Table& out) {
  const AbaqusFaces& a = outside_->faces(exclusion.first, exclusion.place);
  const AbaqusFaces& b = outside_->faces(exclusion.second, exclusion.place);
  const auto shares = [](const Side& side, const AbaqusFaces& other) {
    std::vector<Share> all;
    for (const std::size_t body : side.bodies) all.push_back(share_of(*side.faces, other, body));
    return all;
  };
  const std::vector<Share> first_a = shares(first, a), first_b = shares(first, b), second_a = shares(second, a),
                           second_b = shares(second, b);
  for (std::size_t i = 0; i < out.size(); ++i) {
    for (std::size_t j = 0; j < out[i].size(); ++j) {
      const Share share = std::max(std::min(first_a[i], second_b[j]), std::min(first_b[i], second_a[j]));
      if (share == Share::none) continue;
      exclusion.idle = false;
      (share == Share::some ? partial_ : whole_) = &exclusion;
      out[i][j] = std::max(out[i][j], share);
    }
  }
}

/// First as many as may all touch each other, again and again; then those that may touch others alone. Bodies that may
/// touch the same ones may touch each other, or may not, as they may themselves.
std::vector<AbaqusSides> AbaqusExclusions::among(const Side& side, const Table& out) {
  const std::vector<Places> groups = equal_rows(out);
  std::vector<std::vector<bool>> may;
  for (const Places& group : groups) {
    may.emplace_back();
    for (const Places& other : groups) may.back().push_back(out[group[0]][other[0]] == Share::none);
  }
  std::vector<AbaqusSides> sides;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    if (!may[g][g]) continue;
    Places together{g};
    for (std::size_t h = g + 1; h < groups.size(); ++h) {
      if (may[h][h] && std::ranges::all_of(together, [&](std::size_t k) { return may[h][k]; })) together.push_back(h);
    }
    for (const std::size_t h : together) {
      for (const std::size_t k : together) may[h][k] = false;
    }
    sides.push_back({part_of(side, members(groups, together)), {}});
  }
  for (std::size_t g = 0; g < groups.size(); ++g) {
    Places others;
    for (std::size_t h = g + 1; h < groups.size(); ++h) {
      if (may[g][h]) others.push_back(h);
    }
    if (!others.empty()) sides.push_back({part_of(side, groups[g]), part_of(side, members(groups, others))});
  }
  return sides;
}

/// Bodies of the first side together that may touch the same ones of the second.
std::vector<AbaqusSides> AbaqusExclusions::between(const Side& first, const Side& second, const Table& out) {
  std::vector<AbaqusSides> sides;
  for (const Places& group : equal_rows(out)) {
    const std::vector<Share>& shares = out[group[0]];
    Places others;
    for (std::size_t j = 0; j < shares.size(); ++j) {
      if (shares[j] == Share::none) others.push_back(j);
    }
    if (!others.empty()) sides.push_back({part_of(first, group), part_of(second, others)});
  }
  return sides;
}

DeckSide AbaqusExclusions::part_of(const Side& side, const Places& places) {
  if (places.size() == side.bodies.size()) return side.whole;
  std::vector<std::string> names;
  for (const std::size_t place : places) {
    const std::size_t body = side.bodies[place];
    if (!side.faces->whole[body]) {
      reject(*whole_);
      break;
    }
    names.push_back(data_.bodies[body].name);
  }
  return {names};
}

void AbaqusExclusions::reject(const Exclusion& exclusion) {
  const auto name = [](const std::string& label) { return label.empty() ? "all bodies" : label; };
  const std::string second = exclusion.second == exclusion.first ? "itself" : name(exclusion.second);
  data_.report.reject(exclusion.place, fmt::format("*CONTACT EXCLUSIONS of {} and {}", name(exclusion.first), second),
                      "only whole bodies, and whole surfaces of a pair, can be left out");
}

void AbaqusExclusions::report_idle() const {
  for (const Exclusion& exclusion : exclusions_) {
    if (exclusion.idle)
      data_.report.understood(
          fmt::format("*CONTACT EXCLUSIONS ({}): not in general contact anyway", exclusion.place.text()));
  }
}

}  // namespace pinball
