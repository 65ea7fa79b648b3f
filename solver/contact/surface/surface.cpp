#include "surface.hpp"

#include <utility>

namespace pinball {

Surface::Surface(SurfaceTopology topology)
    : alive_(std::move(topology.alive)),
      exposed_(std::move(topology.exposed)),
      neighbour_(std::move(topology.neighbour)) {
  for (const std::uint8_t faces : exposed_) {
    exposed_count_ += faces != 0;
    exposed_faces_ += __builtin_popcount(faces);
  }
}

void Surface::erode(std::int64_t slot) {
  alive_[slot] = 0;
  exposed_count_ -= exposed_[slot] != 0;
  exposed_faces_ -= __builtin_popcount(exposed_[slot]);
  exposed_[slot] = 0;
  rearranged_.push_back(static_cast<std::int32_t>(slot));
  for_each_face_behind(slot, [this](std::int32_t behind, unsigned face) {
    std::uint8_t& exposed = exposed_[behind];
    if (exposed == 0) {
      uncovered_.push_back(behind);
      ++exposed_count_;
    }
    exposed |= 1U << face;
    ++exposed_faces_;
    rearranged_.push_back(behind);
  });
}

bool Surface::remove_eroded(const std::vector<std::int64_t>& slots) {
  bool changed = false;
  uncovered_.clear();
  rearranged_.clear();
  for (const std::int64_t slot : slots) {
    if (!alive(slot)) continue;
    erode(slot);
    changed = true;
  }
  return changed;
}

}  // namespace pinball
