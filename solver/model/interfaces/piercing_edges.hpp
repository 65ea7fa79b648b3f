#pragma once

#include <cstdint>

#include <solver/model/model.hpp>

#include "overlapping_bodies.hpp"

namespace pinball {

/// Edges of the surface of each of two bodies that go through the other one, within the box that both share. Such
/// bodies need have no node and no point of an element in each other: a bar through a plate, of one element each.
///
/// An edge goes through where it enters by one face and leaves by another, and is at least `depth` inside an element in
/// between: of the size of that, or of its way inside, where the faces look away from each other and it meets both at
/// no small angle. What lies on each other, and the facets of curved surfaces that do, has edges along faces, or inside
/// by the little that facets stand out.
std::int64_t edges_through(const ModelMesh& mesh, const BodyParts& a, const BodyParts& b, const Bounds& box,
                           double depth);

}  // namespace pinball
