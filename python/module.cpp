#include <solver/base/error.hpp>
#include <solver/base/version.h>

#include "bindings.hpp"
#include "interpreter_lock.hpp"

/// Behind the Python package `pinball`: the C++ interface of <pinball/solver/simulation.hpp>, with NumPy arrays for
/// views.
PYBIND11_MODULE(_core, module) {
  namespace python = pinball::python;
  const python::py::object own_name = module.attr("__name__");
  module.attr("__name__") = "pinball";  // where users see the classes, and pickle looks for them
  python::py::register_exception<pinball::InputError>(module, "InputError", PyExc_ValueError).doc() =
      "Input that cannot be used: its text says where it stands, and what was expected.";
  python::py::register_exception<pinball::RunError>(module, "RunError", PyExc_RuntimeError).doc() =
      "A run that cannot go on, or a file that cannot be read or written: its text says what, where and when.";
  module.attr("version") = pinball_version();
  python::watch_end_of_interpreter();
  python::bind_scene(module);
  python::bind_results(module);
  python::bind_simulation(module);
  python::bind_contact(module);
  python::bind_runs(module);
  python::annotate_fields();
  module.attr("__name__") = own_name;
}
