#pragma once

#include <pybind11/numpy.h>

#include <string>
#include <vector>

#include <solver/array_view.hpp>
#include <solver/base/error.hpp>

/// NumPy arrays and the views of the solver, both ways without copies.
namespace pinball::python {

namespace py = pybind11;

inline py::dtype dtype_of(NumberType type) {
  switch (type) {
    case NumberType::float32:
      return py::dtype::of<float>();
    case NumberType::float64:
      return py::dtype::of<double>();
    case NumberType::int32:
      return py::dtype::of<std::int32_t>();
    case NumberType::int64:
      break;
  }
  return py::dtype::of<std::int64_t>();
}

/// The solver's memory as an array; records of one number have one axis. owner: what has to live as long as the array.
template <class Void>
py::array shown(const BasicArrayView<Void>& view, const py::handle& owner) {
  std::vector<py::ssize_t> shape{view.count}, strides{view.stride};
  if (view.components > 1) {
    shape.push_back(view.components);
    strides.push_back(view.component_stride);
  }
  py::array array(dtype_of(view.type), shape, strides, view.data, owner);
  if (std::is_const_v<Void>) array.attr("setflags")(py::arg("write") = false);
  return array;
}

/// An array as it lies in memory, for the solver to read or write. name: for messages.
template <class Void>
BasicArrayView<Void> view_of(const py::array& array, const std::string& name) {
  BasicArrayView<Void> view;
  const py::dtype type = array.dtype();
  bool known = false;
  for (const NumberType each : {NumberType::float32, NumberType::float64, NumberType::int32, NumberType::int64}) {
    if (!type.is(dtype_of(each)) && !type.equal(dtype_of(each))) continue;
    view.type = each;
    known = true;
  }
  if (!known) {
    throw InputError(name + ": expected numbers of float32, float64, int32 or int64, got " +
                     std::string(py::str(static_cast<const py::object&>(type))));
  }
  if (array.ndim() < 1 || array.ndim() > 2) {
    throw InputError(name + ": expected one or two axes, got " + std::to_string(array.ndim()));
  }
  if constexpr (std::is_const_v<Void>) {
    view.data = array.data();
  } else {
    if (!array.writeable()) throw InputError(name + ": expected an array that can be written");
    view.data = const_cast<void*>(array.data());
  }
  view.count = array.shape(0);
  view.stride = array.strides(0);
  view.components = array.ndim() == 2 ? array.shape(1) : 1;
  view.component_stride = array.ndim() == 2 ? array.strides(1) : array.itemsize();
  return view;
}

}  // namespace pinball::python
