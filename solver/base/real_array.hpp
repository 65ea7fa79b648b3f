#pragma once

#include <cstddef>
#include <stdexcept>
#include <utility>
#include <variant>

#include "../../kernels/exec/array.hpp"

namespace pinball {

/// An array of numbers of which the run decides whether they have double or single precision: kernels get them as they
/// are, all else reads and writes them as double.
class RealArray {
 public:
  class Place;

  RealArray() = default;
  /// Numbers are zero. single: they have single precision.
  RealArray(std::size_t size, bool single) {
    if (single) {
      numbers_ = Array<float>(size);
    } else {
      numbers_ = Array<double>(size);
    }
  }

  /// use(numbers), with an Array<double>& or an Array<float>&.
  template <class Use>
  auto visit(const Use& use) {
    return std::visit(use, numbers_);
  }
  template <class Use>
  auto visit(const Use& use) const {
    return std::visit(use, numbers_);
  }

  bool empty() const { return size() == 0; }
  std::size_t size() const {
    return visit([](const auto& numbers) { return numbers.size(); });
  }
  std::size_t bytes() const {
    return visit([](const auto& numbers) { return numbers.bytes(); });
  }
  double operator[](std::size_t i) const {
    return visit([i](const auto& numbers) -> double { return numbers[i]; });
  }
  Place operator[](std::size_t i);

  /// The numbers themselves; null where there are none, or none of this precision.
  template <class E>
  E* data() {
    auto* const numbers = std::get_if<Array<E>>(&numbers_);
    return numbers == nullptr ? nullptr : numbers->data();
  }
  /// The array of this precision. Throws std::logic_error where it has another one.
  template <class E>
  Array<E>& in() {
    return required(std::get_if<Array<E>>(&numbers_));
  }
  template <class E>
  const Array<E>& in() const {
    return required(std::get_if<Array<E>>(&numbers_));
  }

 private:
  template <class Numbers>
  static Numbers& required(Numbers* numbers) {
    if (numbers == nullptr) throw std::logic_error("an array of numbers of another precision was asked for");
    return *numbers;
  }

  std::variant<Array<double>, Array<float>> numbers_;
};

/// One of the numbers, to be written.
class RealArray::Place {
 public:
  Place(RealArray& array, std::size_t i) : array_(array), i_(i) {}

  Place& operator=(double value) {
    array_.visit([&]<class E>(Array<E>& numbers) { numbers[i_] = static_cast<E>(value); });
    return *this;
  }
  operator double() const { return std::as_const(array_)[i_]; }

 private:
  RealArray& array_;
  std::size_t i_;
};

inline RealArray::Place RealArray::operator[](std::size_t i) { return {*this, i}; }

}  // namespace pinball
