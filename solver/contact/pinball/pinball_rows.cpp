#include "pinball_rows.hpp"

#include <array>
#include <vector>

#include <kernels/contact_row.hpp>
#include <kernels/exec.hpp>

namespace pinball {

namespace {

template <class S>
PinballNormal<double> normal_of(const PinballStore<S>& pinballs, std::int32_t p) {
  return {double_vector_of(record(pinballs.outward.data(), p)), double_vector_of(record(pinballs.two_sided.data(), p))};
}

/// The row of two pinballs that may be near each other; without nodes where they cannot touch.
/// d: C1 - C2; reach: R1 + R2.
template <class S>
ContactRow row_of(const PinballStore<S>& pinballs, std::int32_t p, std::int32_t q, const Vec3<double>& d,
                  double reach) {
  const Vec3<double> n1 = unit_normal_towards(normal_of(pinballs, p), (-1.0) * d);
  const Vec3<double> n2 = unit_normal_towards(normal_of(pinballs, q), d);
  ContactRow row = pinball_row(d, reach, n1, n2);
  if (!(row.depth > -0.25 * reach)) row.nodes1 = 0;
  return row;
}

/// Two listed pinballs that may touch, and their row.
struct PinballRow {
  std::int32_t p, q;
  double reach;
  ContactRow row;
};

}  // namespace

template <class S>
void add_pinball_rows(const PinballStore<S>& pinballs, const PairList<S>& list, const ContactPairs* pairs,
                      ImpulseSolver<S>& impulses) {
  constexpr double margin = pinball_pair_margin;
  const auto takes_part = [&pinballs](std::int32_t p) { return record(pinballs.outward.data(), p)[3] > S(0); };
  std::array<std::vector<PinballRow>, fixed_pieces> found;
  parallel_for("contact pairs", RangePolicy<>{0, fixed_pieces}, [&](std::int64_t piece) {
    for (std::int64_t place = list.piece(piece).begin; place < list.piece(piece).end; ++place) {
      const std::int32_t p = list.first()[place], q = list.second()[place];
      const S *const ball1 = record(pinballs.centre.data(), p), *const ball2 = record(pinballs.centre.data(), q);
      const Vec3<double> d = double_vector_of(ball1) - double_vector_of(ball2);
      const double reach = ball1[3] + ball2[3];
      if (dot(d, d) > margin * margin * reach * reach || !takes_part(p) || !takes_part(q)) continue;
      const ContactRow row = row_of(pinballs, p, q, d, reach);
      if (row.nodes1 > 0) found[piece].push_back({p, q, reach, row});
    }
  });
  for (const std::vector<PinballRow>& some : found) {
    for (const auto& [p, q, reach, row] : some) {
      const PairOf of = pairs == nullptr ? PairOf{}
                                         : pairs->elements(pinballs.slot[p], pinballs.corners[p], pinballs.slot[q],
                                                           pinballs.corners[q]);
      impulses.add_row(pinballs.slot[p], pinballs.slot[q], row.direction, row.depth, reach, of);
      for (int k = 0; k < row.nodes1; ++k) {
        impulses.add_node(pinballs.corners[p][row.corner1[k]], -row.weight1[k]);
      }
      for (int k = 0; k < row.nodes2; ++k) {
        impulses.add_node(pinballs.corners[q][row.corner2[k]], row.weight2[k]);
      }
    }
  }
}

template void add_pinball_rows(const PinballStore<double>&, const PairList<double>&, const ContactPairs*,
                               ImpulseSolver<double>&);
template void add_pinball_rows(const PinballStore<float>&, const PairList<float>&, const ContactPairs*,
                               ImpulseSolver<float>&);

}  // namespace pinball
