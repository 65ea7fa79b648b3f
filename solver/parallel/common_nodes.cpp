#include "common_nodes.hpp"

#include <algorithm>

namespace pinball {

template <class S>
CommonNodes<S>::CommonNodes(Ranks& ranks, std::int32_t node_count)
    : ranks_(ranks), is_common_(node_count, 0), of_rank_(ranks.count()), added_(ranks.count()) {}

template <class S>
void CommonNodes<S>::take_added() {
  for (std::size_t r = 0; r < added_.size(); ++r) {
    of_rank_[r].insert(of_rank_[r].end(), added_[r].begin(), added_[r].end());
    count_ += std::ssize(added_[r]);
  }
}

/// numbers_of(node, take): take(S*) for runs of three numbers of the node, `numbers` in all.
template <class S>
template <class Numbers>
void CommonNodes<S>::share(const NodesOfRanks& of_rank, int numbers, const Numbers& numbers_of) {
  std::vector<std::size_t> bytes_of;
  std::size_t nodes = 0;
  for (const std::vector<std::int32_t>& of : of_rank) {
    bytes_of.push_back(numbers * of.size() * sizeof(S));
    nodes += of.size();
  }
  own_.resize(numbers * of_rank[ranks_.number()].size());
  all_.resize(numbers * nodes);
  S* next = own_.data();
  for (const std::int32_t node : of_rank[ranks_.number()])
    numbers_of(node, [&next](const S* three) { next = std::copy_n(three, 3, next); });
  ranks_.gather(std::as_bytes(std::span(own_)), bytes_of, std::as_writable_bytes(std::span(all_)), true);
  ranks_.bytes_given += std::ssize(all_) * static_cast<std::int64_t>(sizeof(S));
  const S* from = all_.data();
  for (const std::vector<std::int32_t>& of : of_rank) {
    for (const std::int32_t node : of) {
      numbers_of(node, [&from](S* three) {
        std::copy_n(from, 3, three);
        from += 3;
      });
    }
  }
}

template <class S>
void CommonNodes<S>::share_forces(NodeStore<S>& nodes) {
  if (!any()) return;
  share(of_rank_, 3, [&nodes](std::int32_t node, const auto& take) { take(nodes.force_of(node)); });
}

template <class S>
void CommonNodes<S>::share_added(NodeStore<S>& nodes) {
  share(added_, 9, [&nodes](std::int32_t node, const auto& take) {
    take(nodes.position_of(node));
    take(nodes.velocity_of(node));
    take(nodes.force_of(node));
  });
}

template <class S>
std::size_t CommonNodes<S>::bytes() const {
  return is_common_.size() + count_ * sizeof(std::int32_t) + (own_.capacity() + all_.capacity()) * sizeof(S);
}

template class CommonNodes<double>;
template class CommonNodes<float>;

}  // namespace pinball
