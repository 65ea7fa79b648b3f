#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include <kernels/element_data.hpp>
#include <kernels/wedge.hpp>
#include <solver/boundary/space/loops.hpp>

/// Sums over the elements of each body, for output, where the arrays of the elements lie.
namespace pinball {

/// Over elements; the momentum is that of the shares of each at its corners: of six nodes, which wedges have, or of
/// eight.
struct BodySum {
  double mass = 0;            ///< of living ones [mass]
  double momentum[3] = {};    ///< of living ones [mass length/time]
  double plastic_strain = 0;  ///< largest of living ones [-]
  std::int64_t eroded = 0;    ///< elements

  PINBALL_FUNCTION void join(const BodySum& other) {
    mass += other.mass;
    for (int k = 0; k < 3; ++k) momentum[k] += other.momentum[k];
    if (other.plastic_strain > plastic_strain) plastic_strain = other.plastic_strain;
    eroded += other.eroded;
  }
};

/// The elements by bodies, those of each in the order of memory, cut into pieces that one thread adds up.
struct BodyElements {
  static constexpr std::int64_t most_of_piece = 128;

  Array<std::int32_t> place;        ///< in the arrays of elements
  Array<double> mass;               ///< initial, of each [mass]
  Array<std::int32_t> nodes;        ///< of each that have equal shares of it: 6 of wedges, else 8 corners
  std::vector<std::int32_t> first;  ///< per piece and one more: its part of both
  std::vector<std::int32_t> body;   ///< per piece
  std::size_t bodies = 0;
};

/// What sums read.
template <class S, class E>
struct BodyArrays {
  const S* velocity;           ///< records of nodes
  const std::int32_t* corner;  ///< in rows
  const E* mass;               ///< 0: eroded
  const E* plastic_strain;     ///< null: there is none
};

/// L: elements in a row of the arrays.
template <class S, class E, int L>
struct SumsBody {
  BodyArrays<S, E> arrays;
  const std::int32_t *place, *first, *nodes;
  const double* mass;
  BodySum* sums;  ///< per piece

  PINBALL_FUNCTION void operator()(std::int64_t piece) const {
    BodySum sum;
    for (std::int32_t i = first[piece]; i < first[piece + 1]; ++i) {
      const std::int64_t element = place[i];
      if (!(arrays.mass[element] > E(0))) {
        ++sum.eroded;
        continue;
      }
      sum.mass += mass[i];
      add_momentum(element, nodes[i], mass[i] / nodes[i], sum.momentum);
      if (arrays.plastic_strain == nullptr) continue;
      const double strain = static_cast<double>(arrays.plastic_strain[element]);
      if (strain > sum.plastic_strain) sum.plastic_strain = strain;
    }
    sums[piece] = sum;
  }

 private:
  PINBALL_FUNCTION void add_momentum(std::int64_t element, std::int32_t count, double mass_of_corner,
                                     double* momentum) const {
    double velocity[3] = {0, 0, 0};
    const std::int32_t* const corners = arrays.corner + place_in_rows<L>(element, 8);
    for (int i = 0; i < count; ++i) {
      const int c = count == 6 ? wedge_corner(i) : i;
      const S* const v = arrays.velocity + 4 * static_cast<std::int64_t>(corners[c * L]);
      for (int k = 0; k < 3; ++k) velocity[k] += static_cast<double>(v[k]);
    }
    for (int k = 0; k < 3; ++k) momentum[k] += mass_of_corner * velocity[k];
  }
};

/// An array of the host in another memory; in the host's own it is the same.
template <class Memory, class T>
Array<T, Memory> moved_to(Array<T> array) {
  if constexpr (std::is_same_v<Memory, HostSpace>) {
    return array;
  } else {
    Array<T, Memory> there;
    there.renew(array.size());
    deep_copy(there, array);
    return there;
  }
}

template <class S, class E, int L, class Space>
class SpaceBodySums {
  using Memory = typename Space::memory_space;

 public:
  explicit SpaceBodySums(BodyElements elements)
      : place_(moved_to<Memory>(std::move(elements.place))),
        first_(list_in<Space>(elements.first)),
        nodes_(moved_to<Memory>(std::move(elements.nodes))),
        mass_(moved_to<Memory>(std::move(elements.mass))),
        body_(std::move(elements.body)),
        bodies_(elements.bodies) {
    sums_.renew(body_.size());
  }

  /// Per body.
  std::vector<BodySum> of(const BodyArrays<S, E>& arrays) {
    parallel_for("sums of bodies", RangePolicy<Space>{0, std::ssize(body_)},
                 SumsBody<S, E, L>{arrays, place_.data(), first_.data(), nodes_.data(), mass_.data(), sums_.data()});
    std::vector<BodySum> of_piece(body_.size()), of_body(bodies_);
    deep_copy(of_piece.data(), sums_);
    for (std::size_t p = 0; p < of_piece.size(); ++p) of_body[body_[p]].join(of_piece[p]);
    return of_body;
  }
  std::size_t bytes() const { return place_.bytes() + first_.bytes() + nodes_.bytes() + mass_.bytes() + sums_.bytes(); }

 private:
  Array<std::int32_t, Memory> place_, first_, nodes_;
  Array<double, Memory> mass_;
  Array<BodySum, Memory> sums_;
  std::vector<std::int32_t> body_;
  std::size_t bodies_;
};

}  // namespace pinball
