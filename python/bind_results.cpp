#include <pybind11/stl.h>

#include <solver/results.hpp>

#include "bindings.hpp"

namespace pinball::python {

namespace py = pybind11;

void bind_results(py::module_& module) {
  py::class_<Energies>(module, "Energies", "Energies of the whole model [energy].")
      .def_readonly("kinetic", &Energies::kinetic)
      .def_readonly("internal", &Energies::internal)
      .def_readonly("hourglass", &Energies::hourglass)
      .def_readonly("bulk_viscosity", &Energies::bulk_viscosity)
      .def_property_readonly("contact", &Energies::contact)
      .def_readonly("eroded", &Energies::eroded)
      .def_readonly("external", &Energies::external)
      .def_property_readonly("total", &Energies::total);
  py::class_<BodyResult>(module, "BodyResult", "What has become of a body.")
      .def_readonly("name", &BodyResult::name)
      .def_readonly("elements", &BodyResult::elements)
      .def_readonly("eroded_elements", &BodyResult::eroded_elements)
      .def_readonly("mass_initial", &BodyResult::mass_initial)
      .def_readonly("mass_remaining", &BodyResult::mass_remaining)
      .def_readonly("velocity", &BodyResult::velocity)
      .def_readonly("max_plastic_strain", &BodyResult::max_plastic_strain);
  py::class_<HistoryRow>(module, "HistoryRow", "One row of history.csv.")
      .def_readonly("step", &HistoryRow::step)
      .def_readonly("time", &HistoryRow::time)
      .def_readonly("dt", &HistoryRow::dt)
      .def_readonly("energy", &HistoryRow::energy)
      .def_readonly("balance_error", &HistoryRow::balance_error)
      .def_readonly("momentum", &HistoryRow::momentum)
      .def_readonly("bodies", &HistoryRow::bodies)
      .def_readonly("more", &HistoryRow::more, "of walls and probes: Simulation.history_columns()");
}

}  // namespace pinball::python
