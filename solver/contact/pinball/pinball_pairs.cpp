#include "pinball_pairs.hpp"

#include <array>

#include <kernels/contact_row.hpp>
#include <kernels/exec.hpp>

namespace pinball {

namespace {

template <class S>
Vec3<double> vector_at(const S* records, std::int32_t p) {
  const S* r = records + 4 * static_cast<std::int64_t>(p);
  return {static_cast<double>(r[0]), static_cast<double>(r[1]), static_cast<double>(r[2])};
}

template <class S>
PinballNormal<double> normal_of(const PinballStore<S>& pinballs, std::int32_t p) {
  return {vector_at(pinballs.outward.data(), p), vector_at(pinballs.two_sided.data(), p)};
}

template <class S>
ContactFace face_of(const SurfaceSource<S>& source, const std::array<std::int32_t, 8>& nodes, unsigned exposed,
                    const Vec3<double>& direction) {
  Vec3<double> x[8];
  for (std::size_t i = 0; i < 8; ++i) x[i] = vector_at(source.position, nodes[i]);
  return face_towards(x, exposed, direction);
}

/// The row of two pinballs that may be near each other; without nodes where they cannot touch.
/// d: C1 - C2; reach: R1 + R2.
template <class S>
ContactRow row_of(const SurfaceSource<S>& source, const PinballStore<S>& pinballs, const Surface& surface,
                  std::int32_t p, std::int32_t q, const Vec3<double>& d, double reach) {
  const auto i = static_cast<std::size_t>(p), j = static_cast<std::size_t>(q);
  ContactRow row;
  if (source.settings->gap == ContactGap::face) {
    const ContactFace face1 = face_of(source, pinballs.corners[i], surface.exposed(pinballs.slot[i]), (-1.0) * d);
    const ContactFace face2 = face_of(source, pinballs.corners[j], surface.exposed(pinballs.slot[j]), d);
    row = face_row(face1, face2);
    // Faces that look at each other are told by their own gap alone; edges and corners by the balls.
    if (row.nodes1 == 0 && face1.face >= 0 && face2.face >= 0 && dot(face1.normal, face2.normal) <= -0.5) return row;
  }
  if (row.nodes1 == 0) {
    const Vec3<double> n1 = unit_normal_towards(normal_of(pinballs, p), (-1.0) * d);
    const Vec3<double> n2 = unit_normal_towards(normal_of(pinballs, q), d);
    row = pinball_row(d, reach, n1, n2);
  }
  if (!(row.depth > -0.25 * reach)) row.nodes1 = 0;
  return row;
}

template <class S>
ContactPair pair_of(const PinballStore<S>& pinballs, std::int32_t p, std::int32_t q, const ContactRow& row,
                    double reach) {
  const auto i = static_cast<std::size_t>(p), j = static_cast<std::size_t>(q);
  ContactPair pair;
  pair.first = pinballs.slot[i];
  pair.second = pinballs.slot[j];
  pair.nodes = row.nodes1 + row.nodes2;
  for (int k = 0; k < row.nodes1; ++k) {
    pair.node[k] = pinballs.corners[i][static_cast<std::size_t>(row.corner1[k])];
    pair.weight[k] = -row.weight1[k];
  }
  for (int k = 0; k < row.nodes2; ++k) {
    pair.node[row.nodes1 + k] = pinballs.corners[j][static_cast<std::size_t>(row.corner2[k])];
    pair.weight[row.nodes1 + k] = row.weight2[k];
  }
  pair.direction = row.direction;
  pair.depth = row.depth;
  pair.size = reach;
  return pair;
}

}  // namespace

double pinball_pair_margin(ContactGap gap) {
  // Two cubes whose faces touch, the centre of one beside the corner of the other, are 1.25 radii apart if one is five
  // times as large. Balls have to overlap, but for what they approach within a step.
  return gap == ContactGap::face ? 1.35 : 1.1;
}

template <class S>
std::vector<ContactPair> pinball_pairs(const SurfaceSource<S>& source, const PinballStore<S>& pinballs,
                                       const PairList<S>& list, const Surface& surface) {
  const double margin = pinball_pair_margin(source.settings->gap);
  const auto takes_part = [&pinballs](std::int32_t p) {
    return pinballs.outward[4 * static_cast<std::size_t>(p) + 3] > S(0);
  };
  constexpr std::int64_t pieces = PairList<S>::pieces;
  std::array<std::vector<ContactPair>, pieces> found;
  parallel_for("contact pairs", RangePolicy<>{0, pieces}, [&](std::int64_t piece) {
    for (std::int64_t place = list.piece(piece).begin; place < list.piece(piece).end; ++place) {
      const std::int32_t p = list.first()[place], q = list.second()[place];
      const Vec3<double> d = vector_at(pinballs.centre.data(), p) - vector_at(pinballs.centre.data(), q);
      const auto reach = static_cast<double>(pinballs.centre[4 * static_cast<std::size_t>(p) + 3] +
                                             pinballs.centre[4 * static_cast<std::size_t>(q) + 3]);
      if (dot(d, d) > margin * margin * reach * reach || !takes_part(p) || !takes_part(q)) continue;
      const ContactRow row = row_of(source, pinballs, surface, p, q, d, reach);
      if (row.nodes1 > 0) found[static_cast<std::size_t>(piece)].push_back(pair_of(pinballs, p, q, row, reach));
    }
  });
  std::vector<ContactPair> pairs;
  for (const std::vector<ContactPair>& some : found) pairs.insert(pairs.end(), some.begin(), some.end());
  return pairs;
}

template std::vector<ContactPair> pinball_pairs(const SurfaceSource<double>&, const PinballStore<double>&,
                                                const PairList<double>&, const Surface&);
template std::vector<ContactPair> pinball_pairs(const SurfaceSource<float>&, const PinballStore<float>&,
                                                const PairList<float>&, const Surface&);

}  // namespace pinball
