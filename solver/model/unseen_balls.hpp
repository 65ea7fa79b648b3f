#pragma once

#include <cstdint>
#include <optional>

#include "model.hpp"

namespace pinball {

/// Two elements whose balls cannot see what they should: bodies are in each other before balls overlap.
struct UnseenBalls {
  std::int32_t first = -1, second = -1;  ///< numbers of the scene; the same for a body that folds onto itself
  double depth = 0;  ///< at which balls first overlap, over the mean thickness; 1: they never do [-]
};

/// The worst pair of a scene whose gap is that of balls; nothing for other scenes, and where balls see enough:
/// two bodies down to a quarter of the thickness, a body itself down to a half.
///
/// The ball of an element has its volume: R = (3 V / 4 pi)^(1/3). Its centre is e/2 below a face, e being the thickness
/// there, and faces meet at (e1 + e2)/2 between the centres. Balls whose centres are d apart along the faces overlap
/// from sqrt((R1 + R2)^2 - d^2) on, and with it from the depth
///
///     1 - sqrt((R1 + R2)^2 - d^2) / ((e1 + e2)/2)          of the mean thickness.
///
/// Elements a times longer along the normal than across, on top of each other (d = 0), have 1 - 1.241 a^(-2/3): 0.22 at
/// a = 2, 0.40 at 3, 0.51 at 4. Worst is d half the diagonal of a face: the centre of one ball is then above a corner
/// between four others. Of two meshes that lie on each other it is the smaller of their faces; a body that is smaller
/// than the other's faces comes down beside all of their balls: d is half the diagonal of those, less what its own
/// outermost balls reach out.
///
/// Along a direction in which an element lies between two planes of symmetry nothing is beside anything: it counts as
/// without extent.
///
/// Counted are faces that look at some part of the box around all other bodies. A body that may touch itself, and is
/// eight times as long as thick, is compared with itself by its broad faces, whose elements are not thicker than wide:
/// these come to lie on each other when it folds.
std::optional<UnseenBalls> find_unseen_balls(const Scene& scene, const ModelMesh& mesh);

}  // namespace pinball
