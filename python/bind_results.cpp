#include <solver/results.hpp>

#include "bindings.hpp"

namespace pinball::python {

namespace {

void bind_energies(py::module_& module) {
  DataClass<Energies> energies(module, "Energies", "Energies of the whole model [energy].");
  energies.def_readonly("kinetic", &Energies::kinetic)
      .def_readonly("kinetic_below_zero", &Energies::kinetic_below_zero, "of the kinetic energy, reported apart")
      .def_readonly("internal", &Energies::internal)
      .def_readonly("hourglass", &Energies::hourglass)
      .def_readonly("hourglass_plastic", &Energies::hourglass_plastic, "part of internal")
      .def_readonly("bulk_viscosity", &Energies::bulk_viscosity)
      .def_readonly("folding", &Energies::folding)
      .def_readonly("contact_stored", &Energies::contact_stored, "elastic, in the springs")
      .def_readonly("contact_damped", &Energies::contact_damped, "dissipated")
      .def_readonly("eroded", &Energies::eroded)
      .def_readonly("external", &Energies::external, "work done on the model")
      .def_property_readonly("contact", &Energies::contact)
      .def_property_readonly("total", &Energies::total);
}

void bind_probes(py::module_& module) {
  DataClass<ProbeValue>(module, "ProbeValue", "What one quantity of a probe is.")
      .def_readonly("quantity", &ProbeValue::quantity, "\"velocity_x\"")
      .def_readonly("value", &ProbeValue::value);
  DataClass<ProbeResult>(module, "ProbeResult", "What a probe watches, and what it sees.")
      .def_readonly("name", &ProbeResult::name)
      .def_readonly("body", &ProbeResult::body)
      .def_readonly("number", &ProbeResult::number, "of the node or element, in the order of the scene")
      .def_readonly("element", &ProbeResult::element, "whether it is an element")
      .def_readonly("point", &ProbeResult::point, "where that was at the start [length]")
      .def_readonly("values", &ProbeResult::values)
      .def(
          "__getitem__",
          [](const ProbeResult& probe, const std::string& quantity) {
            for (const ProbeValue& each : probe.values) {
              if (each.quantity == quantity) return each.value;
            }
            throw py::key_error(quantity);
          },
          py::arg("quantity"), "A value by its quantity: probe[\"velocity_x\"].");
}

}  // namespace

void bind_results(py::module_& module) {
  bind_energies(module);
  bind_probes(module);
  DataClass<BodyResult>(module, "BodyResult", "What has become of a body.")
      .def_readonly("name", &BodyResult::name)
      .def_readonly("elements", &BodyResult::elements)
      .def_readonly("eroded_elements", &BodyResult::eroded_elements)
      .def_readonly("mass_initial", &BodyResult::mass_initial, "[mass]")
      .def_readonly("mass_remaining", &BodyResult::mass_remaining, "without eroded elements [mass]")
      .def_readonly("mass_added", &BodyResult::mass_added, "of mass_initial, for the step [mass]")
      .def_readonly("velocity", &BodyResult::velocity, "mean [length/time]")
      .def_readonly("max_plastic_strain", &BodyResult::max_plastic_strain, "[-]");
  DataClass<HistoryRow>(module, "HistoryRow", "One row of history.csv.")
      .def_readonly("step", &HistoryRow::step)
      .def_readonly("time", &HistoryRow::time, "[time]")
      .def_readonly("dt", &HistoryRow::dt, "[time]")
      .def_readonly("energy", &HistoryRow::energy)
      .def_readonly("inside_out", &HistoryRow::inside_out, "elements with a corner that has turned over")
      .def_readonly("balance_error", &HistoryRow::balance_error, "of the energies, relative [-]")
      .def_readonly("momentum", &HistoryRow::momentum, "[mass length/time]")
      .def_readonly("bodies", &HistoryRow::bodies)
      .def_readonly("more", &HistoryRow::more, "of walls and probes: Simulation.history_columns()");
}

}  // namespace pinball::python
