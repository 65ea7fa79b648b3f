#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

/// Arrays that belong to somebody else: the host's, handed to the solver, or the solver's, shown to the host.
namespace pinball {

enum class NumberType { float32, float64, int32, int64 };

/// Bytes of one number.
constexpr std::int64_t size_of(NumberType type) {
  return type == NumberType::float32 || type == NumberType::int32 ? 4 : 8;
}

template <class T>
constexpr NumberType number_type_of() {
  static_assert(std::is_same_v<T, float> || std::is_same_v<T, double> ||
                    (std::is_integral_v<T> && std::is_signed_v<T> && (sizeof(T) == 4 || sizeof(T) == 8)),
                "float, double, or signed integers of 32 or 64 bits");
  if constexpr (std::is_floating_point_v<T>) {
    return sizeof(T) == 4 ? NumberType::float32 : NumberType::float64;
  } else {
    return sizeof(T) == 4 ? NumberType::int32 : NumberType::int64;
  }
}

/// `count` records of `components` numbers. Owns nothing and copies nothing. Steps are in bytes and may be any, so that
/// interleaved numbers (x y z x y z), padded records (x y z - x y z -), members of larger structures and separate
/// arrays at one distance (x x x y y y z z z) can all be shown. Void: void, or const void where it is only read.
template <class Void>
struct BasicArrayView {
  Void* data = nullptr;
  NumberType type = NumberType::float64;
  std::int64_t count = 0;
  std::int64_t components = 0;
  std::int64_t stride = 0;            ///< from one record to the next [byte]
  std::int64_t component_stride = 0;  ///< from one number of a record to the next [byte]

  /// Address of a number. T: what `type` says.
  template <class T>
  auto* at(std::int64_t record, std::int64_t component = 0) const {
    using Byte = std::conditional_t<std::is_const_v<Void>, const std::byte, std::byte>;
    using Number = std::conditional_t<std::is_const_v<Void>, const T, T>;
    return reinterpret_cast<Number*>(static_cast<Byte*>(data) + record * stride + component * component_stride);
  }
  /// A number, whatever its type.
  double number(std::int64_t record, std::int64_t component = 0) const {
    switch (type) {
      case NumberType::float32:
        return *at<float>(record, component);
      case NumberType::float64:
        return *at<double>(record, component);
      case NumberType::int32:
        return *at<std::int32_t>(record, component);
      case NumberType::int64:
        break;
    }
    return *at<std::int64_t>(record, component);
  }
  /// The same to be read only.
  operator BasicArrayView<const void>() const requires(!std::is_const_v<Void>) {
    return {data, type, count, components, stride, component_stride};
  }
};

using ArrayView = BasicArrayView<void>;
using ConstArrayView = BasicArrayView<const void>;

/// Records one after the other: those of T{components} numbers that begin at data.
template <class T>
auto view_records(T* data, std::int64_t count, std::int64_t components) {
  using Void = std::conditional_t<std::is_const_v<T>, const void, void>;
  constexpr std::int64_t size = sizeof(T);
  return BasicArrayView<Void>{data, number_type_of<std::remove_const_t<T>>(), count, components, components * size,
                              size};
}

}  // namespace pinball
