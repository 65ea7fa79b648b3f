#pragma once

#include <cstdint>
#include <span>

#include <solver/contact/surface/surface.hpp>
#include <solver/model/model_surface.hpp>

#include "subdomain.hpp"

namespace pinball {

/// The surface of a model of which each rank works a part: before contact reads what this rank has not, all make it
/// known to each other.
template <class S>
class SharedSurface final : public SurfaceSource<S> {
 public:
  /// surface: of the contact that is given this.
  SharedSurface(Model<S>& model, Subdomain<S>& domain, const Surface& surface)
      : SurfaceSource<S>(ModelSurface<S>(model)), own_(model), model_(model), domain_(domain), surface_(surface) {}

  bool is_element(std::int64_t slot) const override { return own_.is_element(slot); }
  ContactElement element(std::int64_t slot) const override { return own_.element(slot); }
  bool may_soon_erode(std::int64_t slot) const override { return own_.may_soon_erode(slot); }
  void before_search() const override { domain_.share_strains(model_, surface_); }
  void before_motion(std::span<const std::int32_t> nodes) const override { domain_.take_in(model_, nodes); }

 private:
  ModelSurface<S> own_;
  Model<S>& model_;
  Subdomain<S>& domain_;
  const Surface& surface_;
};

}  // namespace pinball
