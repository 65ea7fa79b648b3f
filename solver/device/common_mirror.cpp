#include "common_mirror.hpp"

#include <algorithm>

namespace pinball {

template <class S>
bool CommonMirror<S>::add(std::span<const std::int32_t> nodes) {
  const std::size_t before = nodes_.size();
  for (const std::int32_t node : nodes) {
    if (is_common_[node] != 0) continue;
    is_common_[node] = 1;
    nodes_.push_back(node);
  }
  if (nodes_.size() == before) return false;
  device_.set_common(CommonSet::all, nodes_);
  return true;
}

template <class S>
void CommonMirror<S>::list(std::span<const std::int32_t> nodes) {
  give_listed();
  listed_.assign(nodes.begin(), nodes.end());
  device_.set_common(CommonSet::listed, listed_);
  motion_.listed_shown = force_.listed_shown = false;
}

template <class S>
void CommonMirror<S>::set_own(const std::vector<std::int32_t>& nodes) {
  if (nodes.size() == own_.size()) return;  // none goes
  own_ = nodes;
  device_.set_common(CommonSet::own, own_);
}

template <class S>
void CommonMirror<S>::show_own_forces() {
  for (const std::int32_t node : nodes_) std::fill_n(host_.force_of(node), 4, S(0));
  if (!own_.empty()) read(CommonSet::own, NodeNumbers::force);
}

template <class S>
void CommonMirror<S>::show_anew() {
  read(CommonSet::all, NodeNumbers::all);
  motion_ = force_ = {};
}

template <class S>
template <class Is>
NodeNumbers CommonMirror<S>::numbers_where(const Is& is) const {
  return (is(motion_) ? NodeNumbers::motion : NodeNumbers::none) |
         (is(force_) ? NodeNumbers::force : NodeNumbers::none);
}

template <class S>
void CommonMirror<S>::show(NodeNumbers numbers) {
  if (nodes_.empty()) return;
  give_listed();
  const NodeNumbers wanted = numbers & numbers_where([](const Newer& of) { return of.on_device; });
  read(CommonSet::all, wanted);
  if (has(wanted, NodeNumbers::motion)) motion_ = {};
  if (has(wanted, NodeNumbers::force)) force_ = {};
}

template <class S>
void CommonMirror<S>::show_listed(NodeNumbers numbers) {
  if (listed_.empty()) return;
  const NodeNumbers wanted = numbers & numbers_where([](const Newer& of) { return of.on_device && !of.listed_shown; });
  read(CommonSet::listed, wanted);
  if (has(wanted, NodeNumbers::motion)) motion_.listed_shown = true;
  if (has(wanted, NodeNumbers::force)) force_.listed_shown = true;
}

template <class S>
void CommonMirror<S>::take(NodeNumbers changed) {
  if (has(changed, NodeNumbers::motion)) motion_ = {.on_host = true};
  if (has(changed, NodeNumbers::force)) force_ = {.on_host = true};
}

template <class S>
void CommonMirror<S>::take_listed(NodeNumbers changed) {
  if (has(changed, NodeNumbers::motion)) motion_.listed_on_host = true;
  if (has(changed, NodeNumbers::force)) force_.listed_on_host = true;
}

template <class S>
void CommonMirror<S>::give(NodeNumbers changes) {
  if (nodes_.empty()) return;
  const NodeNumbers newer = numbers_where([](const Newer& of) { return of.on_host; });
  send(CommonSet::all, newer);
  if (has(newer, NodeNumbers::motion)) motion_ = {};
  if (has(newer, NodeNumbers::force)) force_ = {};
  give_listed();
  if (has(changes, NodeNumbers::motion)) motion_ = {.on_device = true};
  if (has(changes, NodeNumbers::force)) force_ = {.on_device = true};
}

/// What all are newer in is sent with all.
template <class S>
void CommonMirror<S>::give_listed() {
  send(CommonSet::listed, numbers_where([](const Newer& of) { return of.listed_on_host && !of.on_host; }));
  motion_.listed_on_host = force_.listed_on_host = false;
}

template <class S>
template <class Work>
void CommonMirror<S>::for_records(CommonSet of, NodeNumbers numbers, const Work& work) {
  const std::vector<std::int32_t>& nodes = nodes_of(of);
  const std::int64_t count = std::ssize(nodes);
  parallel_for("common nodes", RangePolicy<>{0, count}, [&](std::int64_t i) {
    S* there = numbers_.data() + 4 * i;
    const auto next = [&](S* record) {
      work(record, there);
      there += 4 * count;
    };
    if (has(numbers, NodeNumbers::motion)) {
      next(host_.position_of(nodes[i]));
      next(host_.velocity_of(nodes[i]));
    }
    if (has(numbers, NodeNumbers::force)) next(host_.force_of(nodes[i]));
  });
}

template <class S>
void CommonMirror<S>::read(CommonSet of, NodeNumbers numbers) {
  if (numbers == NodeNumbers::none) return;
  device_.read_common(of, numbers, numbers_);
  for_records(of, numbers, [](S* here, const S* there) { std::copy_n(there, 4, here); });
}

template <class S>
void CommonMirror<S>::send(CommonSet of, NodeNumbers numbers) {
  if (numbers == NodeNumbers::none) return;
  numbers_.renew(4 * records_of(numbers) * nodes_of(of).size());
  for_records(of, numbers, [](const S* here, S* there) { std::copy_n(here, 4, there); });
  device_.write_common(of, numbers, numbers_);
}

template class CommonMirror<double>;
template class CommonMirror<float>;

}  // namespace pinball
