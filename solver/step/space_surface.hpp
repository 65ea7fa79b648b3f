#pragma once

#include <cstdint>
#include <span>

#include <solver/contact/surface/surface.hpp>
#include <solver/device/step_space.hpp>
#include <solver/model/model_surface.hpp>

namespace pinball {

/// The surface of a model whose elements are worked elsewhere, on other ranks or on a device: before contact reads what
/// the model has not, it is brought there.
template <class S>
class SpaceSurface final : public SurfaceSource<S> {
 public:
  /// surface: of the contact that is given this; in_space: its loops run in the space.
  SpaceSurface(Model<S>& model, StepSpace<S>& space, const Surface& surface, bool in_space)
      : SurfaceSource<S>(ModelSurface<S>(model)), own_(model), space_(space), surface_(surface), in_space_(in_space) {
    this->sharers = space.sharers();
  }

  bool is_element(std::int64_t slot) const override { return own_.is_element(slot); }
  ContactElement element(std::int64_t slot) const override { return own_.element(slot); }
  bool may_soon_erode(std::int64_t slot) const override { return own_.may_soon_erode(slot); }
  void before_search() const override {
    if (in_space_) space_.show(NodeNumbers::motion);
    space_.show_strains(surface_);
  }
  void before_following() const override {
    if (in_space_) space_.show(NodeNumbers::motion);
  }
  void before_motion(std::span<const std::int32_t> nodes) const override { space_.take_in(nodes); }
  SurfaceNodes<S> nodes(bool loads) const override {
    if (!in_space_) return SurfaceSource<S>::nodes(loads);
    const NodeArrays<S> there = space_.nodes(loads ? NodeNumbers::force : NodeNumbers::none);
    return {there.position, there.velocity, there.force, there.inverse_mass};
  }

 private:
  ModelSurface<S> own_;
  StepSpace<S>& space_;
  const Surface& surface_;
  bool in_space_;
};

}  // namespace pinball
