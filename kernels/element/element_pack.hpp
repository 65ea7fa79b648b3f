#pragma once

#include <cstdint>

#include "../corner_differences.hpp"
#include "../element_data.hpp"
#include "../hexahedron.hpp"
#include "../tensor.hpp"

/// The elements of a pack: which are there, and where their numbers lie.
namespace pinball {

/// What a pack's elements have in an array of several components in rows of L (ElementView).
template <class T, int L>
class ElementNumbers {
  using S = ScalarOf<T>;

 public:
  /// components: of one element in the array; first: element with which the pack begins.
  PINBALL_FUNCTION ElementNumbers(S* array, int components, std::int64_t first, const MaskOf<T>& alive)
      : base_(array + place_in_rows<L>(first, components)), alive_(alive) {}
  /// Of padding and eroded elements: zero.
  PINBALL_FUNCTION T get(int component) const { return select(alive_, load<T>(base_ + component * L), T(0)); }
  PINBALL_FUNCTION void set(int component, const T& value) const { store(value, base_ + component * L); }

 private:
  S* base_;
  MaskOf<T> alive_;
};

/// Six numbers from `place` on: xx yy zz xy yz zx.
template <class T, int L>
PINBALL_FUNCTION Symmetric<T> symmetric_at(const ElementNumbers<T, L>& numbers, int place) {
  return {numbers.get(place),     numbers.get(place + 1), numbers.get(place + 2),
          numbers.get(place + 3), numbers.get(place + 4), numbers.get(place + 5)};
}
template <class T, int L>
PINBALL_FUNCTION void set_symmetric(const Symmetric<T>& tensor, const ElementNumbers<T, L>& numbers, int place) {
  numbers.set(place, tensor.xx);
  numbers.set(place + 1, tensor.yy);
  numbers.set(place + 2, tensor.zz);
  numbers.set(place + 3, tensor.xy);
  numbers.set(place + 4, tensor.yz);
  numbers.set(place + 5, tensor.zx);
}

/// Nine numbers from `place` on, row by row.
template <class T, int L>
PINBALL_FUNCTION Tensor<T> tensor_at(const ElementNumbers<T, L>& numbers, int place) {
  const auto row = [&](int first) __attribute__((always_inline)) {
    return Vec3<T>{numbers.get(first), numbers.get(first + 1), numbers.get(first + 2)};
  };
  return {row(place), row(place + 3), row(place + 6)};
}
template <class T, int L>
PINBALL_FUNCTION void set_tensor(const Tensor<T>& tensor, const ElementNumbers<T, L>& numbers, int place) {
  const auto set_row = [&](const Vec3<T>& row, int first) __attribute__((always_inline)) {
    numbers.set(first, row.x);
    numbers.set(first + 1, row.y);
    numbers.set(first + 2, row.z);
  };
  set_row(tensor.row_x, place);
  set_row(tensor.row_y, place + 3);
  set_row(tensor.row_z, place + 6);
}

/// Elements first ... first + width_of<T> - 1.
template <class T, int L>
struct ElementPack {
  using S = ScalarOf<T>;

  PINBALL_FUNCTION ElementPack(const ElementView<S>& elements, std::int64_t first_element)
      : arrays(elements), first(first_element), mass(load<T>(elements.mass + first)), alive(mass > T(0)) {}

  PINBALL_FUNCTION const std::int32_t* corner() const { return arrays.corner + place_in_rows<L>(first, 8); }
  /// Of an array with one number of an element; of padding and eroded elements: zero.
  PINBALL_FUNCTION T get(const S* array) const { return select(alive, load<T>(array + first), T(0)); }
  PINBALL_FUNCTION void set(S* array, const T& value) const { store(value, array + first); }
  PINBALL_FUNCTION ElementNumbers<T, L> numbers(S* array, int components) const {
    return {array, components, first, alive};
  }

  const ElementView<S>& arrays;
  std::int64_t first;
  T mass;           ///< 0: not there
  MaskOf<T> alive;  ///< there, and not eroded
};

/// Modes of what the nodes of a pack's elements have in their records.
template <class T, int L, class N>
PINBALL_FUNCTION HexahedronModes<T> gather_modes(const N* record, const std::int32_t* corner) {
  Vec3<T> value[8];
  gather_corners<T, L>(record, corner, value);
  return to_modes(value);
}

}  // namespace pinball
