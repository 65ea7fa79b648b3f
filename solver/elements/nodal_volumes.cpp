#include "nodal_volumes.hpp"

#include <map>
#include <utility>

#include <kernels/exec.hpp>
#include <kernels/tetrahedron.hpp>

namespace pinball {

namespace {

template <class S>
S volume_of(const NodeStore<S>& nodes, const std::array<std::int32_t, 4>& corners) {
  const auto at = [&](std::size_t i) {
    const S* x = nodes.position_of(corners[i]);
    return Vec3<S>{x[0], x[1], x[2]};
  };
  const Vec3<S> a = at(0);
  const TetrahedronEdges<S> x{{at(1) - a, at(2) - a, at(3) - a}};
  return tetrahedron_volume(uniform_gradient(x), x);
}

}  // namespace

template <class S>
NodalVolumes<S>::NodalVolumes(const Model<S>& model) {
  std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> numbers;  // of part and node
  for (std::int32_t tile = 0; tile < model.tile_count(); ++tile) {
    const std::int32_t part = model.tile_part[tile];
    if (!model.parts[part].features.tetrahedra) continue;
    for (const std::int64_t slot : model.slots_of(tile)) {
      if (model.is_padding(slot)) continue;
      const std::array<std::int32_t, 8> corners = model.elements.corners(slot);
      slots_.push_back(slot);
      std::array<std::int32_t, 4>&nodes = nodes_.emplace_back(), &groups = groups_.emplace_back();
      for (std::size_t i = 0; i < 4; ++i) {
        nodes[i] = corners[tetrahedron_corner(i)];
        groups[i] = numbers.try_emplace({part, nodes[i]}, static_cast<std::int32_t>(numbers.size())).first->second;
      }
      undeformed_.push_back(volume_of(model.nodes, nodes));
    }
  }
  volume_ = undeformed_;
  ratio_.assign(numbers.size(), S(1));
  first_.assign(numbers.size() + 1, 0);
  for (const auto& groups : groups_) {
    for (const std::int32_t group : groups) ++first_[group + 1];
  }
  for (std::size_t g = 0; g < numbers.size(); ++g) first_[g + 1] += first_[g];
  around_.resize(first_.back());
  std::vector<std::int32_t> next(first_.begin(), first_.end() - 1);
  for (std::size_t t = 0; t < groups_.size(); ++t) {
    for (const std::int32_t group : groups_[t]) around_[next[group]++] = static_cast<std::int32_t>(t);
  }
}

template <class S>
void NodalVolumes<S>::average(Model<S>& model) {
  if (!any()) return;
  if (model.elements.single) {
    average_in(model, model.elements.volume_ratio.template data<float>());
  } else {
    average_in(model, model.elements.volume_ratio.template data<S>());
  }
}

template <class S>
template <class E>
void NodalVolumes<S>::average_in(Model<S>& model, E* ratios) {
  const std::int64_t count = slots_.size();
  parallel_for("volumes of tetrahedra", RangePolicy<>{0, count}, [&](std::int64_t t) {
    volume_[t] = model.elements.alive(slots_[t]) ? volume_of(model.nodes, nodes_[t]) : S(0);
  });
  parallel_for("volumes of nodes", RangePolicy<>{0, std::ssize(ratio_)}, [&](std::int64_t g) {
    S now = 0, undeformed = 0;
    for (std::int32_t i = first_[g]; i < first_[g + 1]; ++i) {
      const std::int32_t t = around_[i];
      now += volume_[t];
      if (model.elements.alive(slots_[t])) undeformed += undeformed_[t];
    }
    ratio_[g] = undeformed > 0 ? now / undeformed : S(1);
  });
  parallel_for("averaged volumes", RangePolicy<>{0, count}, [&](std::int64_t t) {
    const auto& [a, b, c, d] = groups_[t];
    E& now = ratios[model.elements.at(slots_[t], 0, 2)];
    ratios[model.elements.at(slots_[t], 1, 2)] = now;
    now = static_cast<E>(S(0.25) * ((ratio_[a] + ratio_[b]) + (ratio_[c] + ratio_[d])));
  });
}

template <class S>
std::size_t NodalVolumes<S>::bytes() const {
  const auto of = [](const auto& v) { return v.capacity() * sizeof(v[0]); };
  return of(slots_) + of(nodes_) + of(groups_) + of(undeformed_) + of(volume_) + of(first_) + of(around_) + of(ratio_);
}

template class NodalVolumes<double>;
template class NodalVolumes<float>;

}  // namespace pinball
