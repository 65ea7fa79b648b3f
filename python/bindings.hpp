#pragma once

#include <pybind11/pybind11.h>
#include <pybind11/stl_bind.h>

#include <solver/scene.hpp>

/// Lists of a scene are objects of their own, so that scene.bodies.append(...) changes the scene. Every file of the
/// module has to know that.
PYBIND11_MAKE_OPAQUE(std::vector<pinball::Material>)
PYBIND11_MAKE_OPAQUE(std::vector<pinball::Body>)
PYBIND11_MAKE_OPAQUE(std::vector<pinball::PlaneConstraint>)
PYBIND11_MAKE_OPAQUE(std::vector<pinball::FixedConstraint>)
PYBIND11_MAKE_OPAQUE(std::vector<pinball::RigidWall>)
PYBIND11_MAKE_OPAQUE(std::vector<pinball::PrescribedVelocity>)
PYBIND11_MAKE_OPAQUE(std::vector<pinball::NodalLoad>)
PYBIND11_MAKE_OPAQUE(std::vector<pinball::InitialVelocity>)

namespace pinball::python {

void bind_scene(pybind11::module_& module);
void bind_boundary(pybind11::module_& module);
void bind_results(pybind11::module_& module);
void bind_simulation(pybind11::module_& module);

/// A class of plain data: made without arguments or with its fields by name, Material(name="steel", density=7850).
template <class Data>
pybind11::class_<Data> bind_data(pybind11::module_& module, const char* name, const char* text) {
  namespace py = pybind11;
  return py::class_<Data>(module, name, text).def(py::init([](const py::kwargs& fields) {
    py::object object = py::cast(Data{});
    for (const auto& [field, value] : fields) py::setattr(object, field, value);
    return object.cast<Data>();
  }));
}

/// A list of such data, to which Python lists convert.
template <class Data>
void bind_list(pybind11::module_& module, const char* name) {
  pybind11::bind_vector<std::vector<Data>>(module, name);
  pybind11::implicitly_convertible<pybind11::list, std::vector<Data>>();
}

/// An enumeration, for which the texts of a scene file do, too.
template <class Enum>
void bind_choice(pybind11::module_& module, const char* name, const std::vector<std::pair<const char*, Enum>>& values) {
  namespace py = pybind11;
  py::enum_<Enum> choice(module, name);
  for (const auto& [text, value] : values) choice.value(text, value);
  choice.def(py::init([values, name](const std::string& given) {
    for (const auto& [text, value] : values) {
      if (given == text) return value;
    }
    throw py::value_error(std::string(name) + ": unknown value \"" + given + "\"");
  }));
  py::implicitly_convertible<py::str, Enum>();
}

}  // namespace pinball::python
