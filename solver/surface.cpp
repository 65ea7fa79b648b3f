#include <pinball/solver/faces.hpp>
#include <pinball/solver/surface.hpp>

namespace pinball {

template <class S>
Surface::Surface(const Model<S>& model)
    : alive_(static_cast<std::size_t>(model.elements.slots), 0),
      exposed_(alive_.size(), 0),
      neighbour_(alive_.size(), {-1, -1, -1, -1, -1, -1}) {
  const std::vector<std::array<std::int32_t, 6>> neighbours = face_neighbours(model.mesh.hexahedra);
  for (std::size_t e = 0; e < neighbours.size(); ++e) {
    const auto slot = static_cast<std::size_t>(model.slot_of_element[e]);
    alive_[slot] = 1;
    for (std::size_t f = 0; f < 6; ++f) {
      const std::int32_t other = neighbours[e][f];
      if (other == -1) {
        exposed_[slot] |= static_cast<std::uint8_t>(1U << f);
      } else if (other != collapsed_face) {
        neighbour_[slot][f] = static_cast<std::int32_t>(model.slot_of_element[static_cast<std::size_t>(other)]);
      }
    }
  }
  // A face in a plane of symmetry is no surface: the mirror image of the body continues there.
  for (const PlaneConstraint& plane : model.scene.constraints) {
    for (std::size_t e = 0; e < neighbours.size(); ++e) {
      const auto body = static_cast<std::size_t>(model.mesh.body[e]);
      if (!plane.body.empty() && plane.body != model.mesh.body_names[body]) continue;
      const auto slot = static_cast<std::size_t>(model.slot_of_element[e]);
      for (std::size_t f = 0; f < 6; ++f) {
        if (neighbours[e][f] >= 0) continue;
        bool inside = true;
        for (const int corner : face_nodes[f]) {
          const auto node = static_cast<std::size_t>(model.mesh.hexahedra[e][static_cast<std::size_t>(corner)]);
          double distance = 0, size = 0;
          for (std::size_t k = 0; k < 3; ++k) {
            const double d = model.mesh.nodes[node][k] - plane.point[k];
            distance += d * plane.normal[k];
            size += d * d;
          }
          inside = inside && distance * distance <= 1e-18 * (size + 1e-300);
        }
        if (inside) exposed_[slot] &= static_cast<std::uint8_t>(~(1U << f));
      }
    }
  }
  for (const std::uint8_t exposed : exposed_) {
    exposed_count_ += exposed != 0;
    exposed_faces_ += __builtin_popcount(exposed);
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
