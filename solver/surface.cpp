#include <pinball/solver/exposed_faces.hpp>
#include <pinball/solver/faces.hpp>
#include <pinball/solver/surface.hpp>

namespace pinball {

template <class S>
Surface::Surface(const Model<S>& model)
    : alive_(static_cast<std::size_t>(model.elements.slots), 0),
      exposed_(alive_.size(), 0),
      neighbour_(alive_.size(), {-1, -1, -1, -1, -1, -1}) {
  const std::vector<std::array<std::int32_t, 6>> neighbours = face_neighbours(model.mesh.hexahedra);
  const std::vector<std::uint8_t> exposed = find_exposed_faces(model.mesh, model.scene.constraints, neighbours);
  for (std::size_t e = 0; e < neighbours.size(); ++e) {
    const auto slot = static_cast<std::size_t>(model.slot_of_element[e]);
    alive_[slot] = 1;
    exposed_[slot] = exposed[e];
    for (std::size_t f = 0; f < 6; ++f) {
      if (neighbours[e][f] < 0) continue;
      neighbour_[slot][f] =
          static_cast<std::int32_t>(model.slot_of_element[static_cast<std::size_t>(neighbours[e][f])]);
    }
  }
  for (const std::uint8_t faces : exposed_) {
    exposed_count_ += faces != 0;
    exposed_faces_ += __builtin_popcount(faces);
  }
}

void Surface::erode(std::int64_t slot) {
  const auto s = static_cast<std::size_t>(slot);
  alive_[s] = 0;
  exposed_count_ -= exposed_[s] != 0;
  exposed_faces_ -= __builtin_popcount(exposed_[s]);
  exposed_[s] = 0;
  for_each_face_behind(slot, [this](std::int32_t behind, unsigned face) {
    std::uint8_t& exposed = exposed_[static_cast<std::size_t>(behind)];
    if (exposed == 0) {
      uncovered_.push_back(behind);
      ++exposed_count_;
    }
    exposed |= static_cast<std::uint8_t>(1U << face);
    ++exposed_faces_;
  });
}

template <class S>
bool Surface::remove_eroded(const Model<S>& model, const std::vector<TileResult<S>>& tiles) {
  constexpr int W = ElementStore<S>::width;
  bool changed = false;
  uncovered_.clear();
  for (std::size_t t = 0; t < tiles.size(); ++t) {
    if (tiles[t].eroded_count == 0) continue;
    for (std::int64_t slot = model.tile_packs[t] * W; slot < model.tile_packs[t + 1] * W; ++slot) {
      if (alive(slot) && !(model.elements.mass[static_cast<std::size_t>(slot)] > S(0))) {
        erode(slot);
        changed = true;
      }
    }
  }
  return changed;
}

template Surface::Surface(const Model<double>&);
template Surface::Surface(const Model<float>&);
template bool Surface::remove_eroded(const Model<double>&, const std::vector<TileResult<double>>&);
template bool Surface::remove_eroded(const Model<float>&, const std::vector<TileResult<float>>&);

}  // namespace pinball
