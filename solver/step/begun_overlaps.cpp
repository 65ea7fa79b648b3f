#include "begun_overlaps.hpp"

#include <algorithm>

namespace pinball {

bool BegunOverlaps::begins(const Scene& scene, double before, double time) {
  return std::ranges::any_of(scene.contact_pairs,
                             [&](const ContactPair& pair) { return before < pair.start && pair.start <= time; });
}

void BegunOverlaps::look(const Scene& scene, const ModelMesh& mesh, double before, double time) {
  const std::vector<InitialOverlap> found = find_begun_overlaps(scene, mesh, before, time);
  found_.insert(found_.end(), found.begin(), found.end());
}

void BegunOverlaps::persist(StateArchive& archive, std::int64_t nodes) {
  for (std::vector<InitialOverlap>* all : {&found_, &passed_walls_}) {
    std::vector<std::uint8_t> each(all->size());
    archive(each);
    all->resize(each.size());
    for (InitialOverlap& pair : *all) {
      archive(pair.first, pair.second, pair.points, pair.nodes, pair.node, pair.depth, pair.share, pair.time);
      archive.require(pair.node < nodes);
    }
  }
}

}  // namespace pinball
