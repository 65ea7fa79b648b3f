#include <solver/base/error.hpp>

#include "bindings.hpp"

/// The Python module `pinball`: the C++ interface of <pinball/solver/simulation.hpp>, with NumPy arrays for views.
PYBIND11_MODULE(pinball, module) {
  namespace py = pybind11;
  module.doc() = "Explicit dynamics of solids in contact and impact, around the pinball algorithm";
  py::register_exception<pinball::InputError>(module, "InputError", PyExc_ValueError);
  py::register_exception<pinball::RunError>(module, "RunError", PyExc_RuntimeError);
  pinball::python::bind_scene(module);
  pinball::python::bind_results(module);
  pinball::python::bind_simulation(module);
}
