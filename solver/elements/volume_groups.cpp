#include "volume_groups.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <span>
#include <utility>

namespace pinball {

namespace {

struct AveragedElement {
  std::int64_t slot;
  std::int32_t tile;
  std::int32_t corners;                         ///< 4 of a tetrahedron, 6 of a wedge
  std::array<std::int32_t, 2> workers{-1, -1};  ///< the rank of its tile, and who works it for a sum
  std::array<std::int32_t, 6> groups{};

  std::span<const std::int32_t> own_groups() const { return {groups.data(), static_cast<std::size_t>(corners)}; }
};

/// All of the model, ascending by their slots, with a number for each node of each material. Elements of orthotropic
/// materials have one each, and so volumes of their own: where a mean stress comes of more than the volume, forces over
/// averaged ones are no gradient of an energy, and make some.
struct AveragedElements {
  template <class S>
  explicit AveragedElements(const Model<S>& model) {
    std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> numbers;  // of material and node
    for (std::int32_t tile = 0; tile < model.tile_count(); ++tile) {
      const std::int32_t part = model.tile_part[tile];
      if (!model.constants[part].averaged_volumes) continue;
      const bool tetrahedra = model.parts[part].features.tetrahedra, alone = model.constants[part].orthotropic.used;
      for (const std::int64_t slot : model.slots_of(tile)) {
        if (model.is_padding(slot)) continue;
        const std::array<std::int32_t, 8> corners = model.elements.corners(slot);
        AveragedElement& one = all.emplace_back(AveragedElement{slot, tile, tetrahedra ? 4 : 6});
        for (int i = 0; i < one.corners; ++i) {
          const std::int32_t node = corners[tetrahedra ? tetrahedron_corner(i) : wedge_corner(i)];
          const std::pair key(model.parts[part].material, alone ? -static_cast<std::int32_t>(all.size()) : node);
          one.groups[i] = numbers.try_emplace(key, static_cast<std::int32_t>(numbers.size())).first->second;
        }
      }
    }
    groups = static_cast<std::int32_t>(numbers.size());
  }

  std::vector<AveragedElement> all;
  std::int32_t groups = 0;
};

/// Adds a rank to those that are there, each once.
void add_rank(std::vector<std::int32_t>& ranks, std::int32_t rank) {
  if (std::ranges::find(ranks, rank) == ranks.end()) ranks.push_back(rank);
}

/// The ranks that average around each node of each material: those that work the elements there.
class RanksOfGroups {
 public:
  explicit RanksOfGroups(std::int32_t groups) : one_(groups, -1) {}
  void add(std::int32_t group, std::int32_t rank) {
    if (one_[group] < 0) one_[group] = rank;
    if (one_[group] == rank) return;
    add_rank(others_[group], rank);
  }
  /// Adds the ranks to those in `ranks`, each once.
  void add_to(std::vector<std::int32_t>& ranks, std::int32_t group) const {
    add_rank(ranks, one_[group]);
    const auto others = others_.find(group);
    if (others == others_.end()) return;
    for (const std::int32_t rank : others->second) add_rank(ranks, rank);
  }

 private:
  std::vector<std::int32_t> one_;                             ///< per group
  std::map<std::int32_t, std::vector<std::int32_t>> others_;  ///< of groups of several ranks
};

VolumeNeighbour& neighbour(std::vector<VolumeNeighbour>& all, std::int32_t rank) {
  const auto found = std::ranges::find(all, rank, &VolumeNeighbour::rank);
  if (found != all.end()) return *found;
  all.emplace_back().rank = rank;
  return all.back();
}

/// Fills `listed`: per element of the model that is averaged its place in the lists of this rank, or -1. Both sides of
/// a message go through the elements in the same order.
template <class S>
void share(AveragedElements& elements, const Subdomain<S>& domain, const typename VolumeGroups<S>::Adder& adder,
           VolumeGroups<S>& found, std::vector<std::int32_t>& listed) {
  RanksOfGroups ranks_of(elements.groups);
  for (AveragedElement& one : elements.all) {
    const std::int32_t of_tile = domain.rank_of_tile(one.tile);
    one.workers = {of_tile, adder ? adder(one.slot) : of_tile};
    for (const std::int32_t group : one.own_groups()) {
      for (const std::int32_t worker : one.workers) ranks_of.add(group, worker);
    }
  }
  std::map<std::int32_t, std::vector<std::size_t>> received;  // by ranks
  std::vector<std::int32_t> ranks;
  for (std::size_t t = 0; t < elements.all.size(); ++t) {
    const AveragedElement& one = elements.all[t];
    const std::int32_t from = one.workers[0];
    ranks = {from};
    add_rank(ranks, one.workers[1]);
    const std::size_t workers = ranks.size();
    for (const std::int32_t group : one.own_groups()) ranks_of.add_to(ranks, group);
    found.sent_by_all += static_cast<std::int64_t>(ranks.size() - workers);
    if (std::ranges::find(one.workers, domain.rank()) != one.workers.end()) {
      listed[t] = static_cast<std::int32_t>(found.own++);
      for (std::size_t r = workers; from == domain.rank() && r < ranks.size(); ++r)
        neighbour(found.neighbours, ranks[r]).sent.push_back(listed[t]);
    } else if (std::ranges::find(ranks, domain.rank()) != ranks.end()) {
      neighbour(found.neighbours, from).count++;
      received[from].push_back(t);
    }
  }
  std::int64_t next = found.own;
  for (VolumeNeighbour& of : found.neighbours) {
    of.first = next;
    for (const std::size_t t : received[of.rank]) listed[t] = static_cast<std::int32_t>(next++);
  }
}

}  // namespace

template <class S>
void find_volumes_of(const Model<S>& model, NodalVolumeLists<S>& lists, std::int64_t count) {
  using Space = DefaultExecutionSpace;
  const ElementStore& elements = model.elements;
  const std::int32_t* const corner = elements.corner.data();
  const S* const position = model.nodes.position.data();
  if (elements.single) {
    find_volumes<Space, native_width<float>>(lists.view(), count, corner, elements.mass.template in<float>().data(),
                                             position);
  } else {
    find_volumes<Space, native_width<S>>(lists.view(), count, corner, elements.mass.template in<S>().data(), position);
  }
}

template <class S>
VolumeGroups<S>::VolumeGroups(const Model<S>& model, const Subdomain<S>* domain, const Adder& adder) {
  AveragedElements elements(model);
  std::vector<std::int32_t> listed(elements.all.size(), -1);
  if (domain == nullptr) {
    own = std::ssize(elements.all);
    for (std::int32_t t = 0; t < own; ++t) listed[t] = t;
  } else {
    share(elements, *domain, adder, *this, listed);
  }
  std::int64_t count = own;
  for (const VolumeNeighbour& of : neighbours) count += of.count;
  lists.place.reset(count);
  lists.corners.reset(count + 1);
  std::vector<std::int32_t> number(elements.groups, -1);  // of groups with an element of this rank
  std::int32_t groups = 0;
  for (std::size_t t = 0; t < listed.size(); ++t) {
    if (listed[t] < 0) continue;
    lists.place[listed[t]] = elements.all[t].slot;
    lists.corners[listed[t] + 1] = elements.all[t].corners;
    for (const std::int32_t group : elements.all[t].own_groups()) {
      if (listed[t] < own && number[group] < 0) number[group] = groups++;
    }
  }
  for (std::int64_t e = 0; e < count; ++e) lists.corners[e + 1] += lists.corners[e];
  lists.group.reset(lists.corners[count]);
  const auto for_each = [&](const auto& visit) {  // in the order in which one process adds
    for (std::size_t t = 0; t < listed.size(); ++t) {
      if (listed[t] < 0) continue;
      for (int i = 0; i < elements.all[t].corners; ++i) visit(listed[t], i, number[elements.all[t].groups[i]]);
    }
  };
  lists.first.reset(groups + 1);
  for_each([&](std::int32_t place, int i, std::int32_t group) {
    lists.group[lists.corners[place] + i] = group;
    if (group >= 0) ++lists.first[group + 1];
  });
  for (std::int32_t g = 0; g < groups; ++g) lists.first[g + 1] += lists.first[g];
  lists.around.reset(lists.first[groups]);
  std::vector<std::int32_t> next(lists.first.data(), lists.first.data() + groups);
  for_each([&](std::int32_t place, int, std::int32_t group) {
    if (group >= 0) lists.around[next[group]++] = place;
  });
  lists.ratio.reset(groups);
  lists.volume.reset(count);
  lists.undeformed.reset(count);
  find_volumes_of(model, lists, lists.elements());
  deep_copy(lists.undeformed, lists.volume);
}

template void find_volumes_of(const Model<double>&, NodalVolumeLists<double>&, std::int64_t);
template void find_volumes_of(const Model<float>&, NodalVolumeLists<float>&, std::int64_t);
template struct VolumeGroups<double>;
template struct VolumeGroups<float>;

}  // namespace pinball
