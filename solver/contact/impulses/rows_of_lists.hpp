#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <solver/base/lists_in_order.hpp>

#include "impulse_solver.hpp"

/// Rows that are found in parallel, taken in parallel: what a list gives is put where the rows and entries of those
/// before it end, and nodes are numbered by the first entry that has them, as if rows came one by one.
namespace pinball {

template <class S>
template <class Row>
int ImpulseSolver<S>::entries_of(const Row& row, std::int32_t* node, double* weight) {
  int count = 0;
  for (int k = 0; k < row.nodes; ++k) {
    if (row.weight[k] == 0) continue;
    const std::int64_t at = std::find(node, node + count, row.node[k]) - node;
    if (at < count) {
      weight[at] += row.weight[k];
      continue;
    }
    node[count] = row.node[k];
    weight[count++] = row.weight[k];
  }
  return count;
}

/// Of a list, the rows from this number on, with entries counted from zero. Returns how many entries these have.
template <class S>
template <class Row>
std::size_t ImpulseSolver<S>::put_rows(std::span<const Row> list, std::size_t number) {
  constexpr std::size_t most = sizeof(Row::node) / sizeof(Row::node[0]);
  std::size_t entries = 0, next = memory_.size();
  for (const Row& row : list) {
    std::int32_t node[most];
    double weight[most];
    const int nodes = entries_of(row, node, weight);
    rows_.rows[number] = {{row.direction.x, row.direction.y, row.direction.z}, entries, nodes};
    entries += nodes;
    if (contact_pairs_ != nullptr) pair_of_row_[number] = row.pair;
    Pair& pair = pairs_[number++];
    pair = {};
    pair.depth = row.depth;
    pair.size = row.size;
    pair.memory.first = row.first;
    pair.memory.second = row.second;
    recall(pair.memory, next);
  }
  return entries;
}

/// Of nodes of the store, each of which learns of the first entry that has it.
template <class S>
template <class Row>
void ImpulseSolver<S>::put_entries(std::span<const Row> list, std::size_t number, std::size_t first) {
  for (const Row& row : list) {
    ImpulseRow& own = rows_.rows[number++];
    own.first += first;
    entries_of(row, rows_.node.data() + own.first, rows_.weight.data() + own.first);
    for (int e = 0; e < own.nodes; ++e) {
      const std::size_t entry = own.first + e;
      keep_lowest(node_place_[rows_.node[entry]], static_cast<std::int32_t>(entry));
    }
  }
}

template <class S>
void ImpulseSolver<S>::number_nodes() {
  const std::int64_t entries = std::ssize(rows_.node);
  list_where("nodes of rows", entries, node_, [&](std::int64_t e) { return node_place_[rows_.node[e]] == e; });
  const std::int64_t nodes = std::ssize(node_);
  for_all_of("places of nodes", nodes, nodes, [&](std::int64_t place) {
    const std::int32_t node = rows_.node[node_[place]];
    node_[place] = node;
    node_place_[node] = static_cast<std::int32_t>(place);
  });
  for_all_of("places in rows", entries, entries, [&](std::int64_t e) { rows_.node[e] = node_place_[rows_.node[e]]; });
  last_entry_.assign(nodes, {rows_.size(), -1});
}

template <class S>
template <class Row>
void ImpulseSolver<S>::begin_rows(std::span<const std::span<const Row>> lists) {
  std::size_t rows = 0, entries = 0;
  for (const std::span<const Row>& list : lists) rows += list.size();
  if (ties_ != nullptr || rows < rows_worth_a_thread) {  // in one loop in the place of six
    begin_rows();
    for (const std::span<const Row>& list : lists) {
      for (const Row& row : list) row.give_to(*this);
    }
    return;
  }
  std::vector<std::size_t> number(lists.size()), first(lists.size());
  for (std::size_t l = 1; l < lists.size(); ++l) number[l] = number[l - 1] + lists[l - 1].size();
  // What was there is written over: to make it anew is one thread's work.
  rows_.rows.resize(rows);
  pairs_.resize(rows);
  pair_of_row_.resize(contact_pairs_ != nullptr ? rows : 0);
  active_.clear();
  next_memory_ = 0;
  const std::int64_t count = std::ssize(lists), numbers = rows * sizeof(Row) / sizeof(double);
  for_all_of("rows of lists", count, numbers, [&](std::int64_t l) { first[l] = put_rows(lists[l], number[l]); });
  for (std::size_t& of_list : first) entries += std::exchange(of_list, entries);
  rows_.node.resize(entries);
  rows_.weight.resize(entries);
  for_all_of("entries of lists", count, numbers, [&](std::int64_t l) { put_entries(lists[l], number[l], first[l]); });
  number_nodes();
}

}  // namespace pinball
