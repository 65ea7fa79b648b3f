#pragma once

#include <string>

#include <solver/contact/contact_settings.hpp>
#include <solver/contact/surface/surface.hpp>
#include <solver/contact/surface/surface_source.hpp>

namespace pinball {

/// Whether spheres may fall between the balls of elements: at a node of a face these leave a hole, as wide as the node
/// is away from the centres of the elements around it, seen along the normal of the face, less their radii. A sentence
/// about the smallest sphere and the widest hole; empty: none does, or no gap is that of balls.
template <class S>
std::string sphere_holes(const ContactSettings& settings, const SurfaceSource<S>& source, const Surface& surface);

}  // namespace pinball
