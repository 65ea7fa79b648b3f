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
  device_.set_common(nodes_);
  return true;
}

template <class S>
void CommonMirror<S>::show_anew() {
  read_motion();
  read_force();
}

template <class S>
void CommonMirror<S>::show(NodeNumbers numbers) {
  if (nodes_.empty()) return;
  if (has(numbers, NodeNumbers::motion) && motion_.on_device) read_motion();
  if (has(numbers, NodeNumbers::force) && force_.on_device) read_force();
}

template <class S>
void CommonMirror<S>::take(NodeNumbers changed) {
  if (has(changed, NodeNumbers::motion)) motion_ = {true, false};
  if (has(changed, NodeNumbers::force)) force_ = {true, false};
}

template <class S>
void CommonMirror<S>::give(NodeNumbers changes) {
  if (nodes_.empty()) return;
  if (motion_.on_host) send_motion();
  if (force_.on_host) send_force();
  if (has(changes, NodeNumbers::motion)) motion_.on_device = true;
  if (has(changes, NodeNumbers::force)) force_.on_device = true;
}

template <class S>
void CommonMirror<S>::read_motion() {
  device_.read_common_motion(numbers_);
  const S *const position = numbers_.data(), *const velocity = position + 4 * nodes_.size();
  parallel_for("common nodes", RangePolicy<>{0, std::ssize(nodes_)}, [&](std::int64_t i) {
    std::copy_n(position + 4 * i, 4, host_.position_of(nodes_[i]));
    std::copy_n(velocity + 4 * i, 4, host_.velocity_of(nodes_[i]));
  });
  motion_ = {};
}

template <class S>
void CommonMirror<S>::read_force() {
  device_.read_common_force(numbers_);
  const S* const force = numbers_.data();
  parallel_for("common nodes", RangePolicy<>{0, std::ssize(nodes_)},
               [&](std::int64_t i) { std::copy_n(force + 4 * i, 4, host_.force_of(nodes_[i])); });
  force_ = {};
}

template <class S>
void CommonMirror<S>::send_motion() {
  numbers_.renew(8 * nodes_.size());
  S *const position = numbers_.data(), *const velocity = position + 4 * nodes_.size();
  parallel_for("common nodes", RangePolicy<>{0, std::ssize(nodes_)}, [&](std::int64_t i) {
    std::copy_n(host_.position_of(nodes_[i]), 4, position + 4 * i);
    std::copy_n(host_.velocity_of(nodes_[i]), 4, velocity + 4 * i);
  });
  device_.write_common_motion(numbers_);
  motion_ = {};
}

template <class S>
void CommonMirror<S>::send_force() {
  numbers_.renew(4 * nodes_.size());
  S* const force = numbers_.data();
  parallel_for("common nodes", RangePolicy<>{0, std::ssize(nodes_)},
               [&](std::int64_t i) { std::copy_n(host_.force_of(nodes_[i]), 4, force + 4 * i); });
  device_.write_common_force(numbers_);
  force_ = {};
}

template class CommonMirror<double>;
template class CommonMirror<float>;

}  // namespace pinball
