#include <pinball/solver/free_points.hpp>

namespace pinball {

template <class S>
FreePoints<S>::FreePoints(const Model<S>& model) {
  bool erodes = false;
  for (const Part& part : model.parts) erodes = erodes || part.features.erosion;
  if (!erodes || model.scene.constraints.empty()) return;  // planes_ stays empty: nothing to do in this scene

  for (const PlaneConstraint& constraint : model.scene.constraints) {
    Plane plane{constraint.point, constraint.normal, {}};
    double side = 0;  // of the plane on which the bodies lie
    for (const std::string& name : model.mesh.body_names) {
      plane.body.push_back(constraint.body.empty() || constraint.body == name ? 1 : 0);
    }
    for (std::size_t n = 0; n < model.mesh.nodes.size(); ++n) {
      if (plane.body[static_cast<std::size_t>(model.mesh.body_of_node[n])] == 0) continue;
      for (std::size_t k = 0; k < 3; ++k) side += (model.mesh.nodes[n][k] - plane.point[k]) * plane.inward[k];
    }
    if (side < 0) {
      for (double& c : plane.inward) c = -c;
    }
    planes_.push_back(plane);
  }
  alive_.resize(static_cast<std::size_t>(model.elements.slots));
  living_elements_.resize(static_cast<std::size_t>(model.nodes.count));
  for (std::int64_t slot = 0; slot < model.elements.slots; ++slot) {
    if (model.element_of_slot[static_cast<std::size_t>(slot)] < 0) continue;
    alive_[static_cast<std::size_t>(slot)] = 1;
    for (int i = 0; i < 8; ++i) {
      ++living_elements_[static_cast<std::size_t>(model.elements.corner[ElementStore<S>::at(slot, i, 8)])];
    }
  }
}

template <class S>
void FreePoints<S>::update(const Model<S>& model, const std::vector<TileResult<S>>& tiles) {
  constexpr int W = ElementStore<S>::width;
  if (planes_.empty()) return;
  for (std::size_t t = 0; t < tiles.size(); ++t) {
    if (tiles[t].eroded_count == 0) continue;
    for (std::int64_t slot = model.tile_packs[t] * W; slot < model.tile_packs[t + 1] * W; ++slot) {
      const auto s = static_cast<std::size_t>(slot);
      if (alive_[s] == 0 || model.elements.mass[s] > S(0)) continue;
      alive_[s] = 0;
      for (int i = 0; i < 8; ++i) {
        const std::int32_t node = model.elements.corner[ElementStore<S>::at(slot, i, 8)];
        if (--living_elements_[static_cast<std::size_t>(node)] > 0) continue;
        points_.push_back(node);
        body_.push_back(model.mesh.body[static_cast<std::size_t>(model.element_of_slot[s])]);
      }
    }
  }
}

template <class S>
void FreePoints<S>::reflect(Model<S>& model) const {
  for (const Plane& plane : planes_) {
    for (std::size_t i = 0; i < points_.size(); ++i) {
      if (plane.body[static_cast<std::size_t>(body_[i])] == 0) continue;
      S* x = model.nodes.position.data() + 4 * static_cast<std::int64_t>(points_[i]);
      S* v = model.nodes.velocity.data() + 4 * static_cast<std::int64_t>(points_[i]);
      S distance = 0, speed = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        distance += (x[k] - static_cast<S>(plane.point[k])) * static_cast<S>(plane.inward[k]);
        speed += v[k] * static_cast<S>(plane.inward[k]);
      }
      if (!(distance < S(0))) continue;
      for (std::size_t k = 0; k < 3; ++k) {
        x[k] -= S(2) * distance * static_cast<S>(plane.inward[k]);
        if (speed < S(0)) v[k] -= S(2) * speed * static_cast<S>(plane.inward[k]);
      }
    }
  }
}

template class FreePoints<double>;
template class FreePoints<float>;

}  // namespace pinball
