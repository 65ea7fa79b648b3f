#pragma once

#include <cstdint>
#include <pinball/solver/model.hpp>
#include <pinball/solver/surface.hpp>

namespace pinball {

/// The material of an element, given its slot in the element store.
template <class S>
const Material& material_of(const Model<S>& model, std::int64_t slot);

/// Radius of the ball of the volume of an undeformed element, report eq. (3.2) [length].
template <class S>
double volume_radius(const Model<S>& model, std::int64_t slot);

/// Whether an element of the surface may soon erode. A guess, for lists that are to last over erosions: what lies
/// behind such elements is taken in beforehand. If it fails, what is exposed is taken in then, and lists are built
/// anew.
template <class S>
bool may_soon_erode(const Model<S>& model, const Surface& surface, std::int64_t slot);

}  // namespace pinball
