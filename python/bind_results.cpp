#include <solver/results.hpp>

#include "bindings.hpp"

namespace pinball::python {

namespace {

void bind_energies(py::module_& module) {
  DataClass<Energies> energies(module, "Energies", "Energies of the whole model [energy].");
  energies.def_readonly("kinetic", &Energies::kinetic, "of the masses of nodes")
      .def_readonly("kinetic_below_zero", &Energies::kinetic_below_zero, "of the kinetic energy, reported apart")
      .def_readonly("internal", &Energies::internal, "elastic and plastic, of elements that are there")
      .def_readonly("hourglass", &Energies::hourglass, "of the forces against hourglass modes")
      .def_readonly("hourglass_plastic", &Energies::hourglass_plastic, "part of internal")
      .def_readonly("bulk_viscosity", &Energies::bulk_viscosity, "dissipated")
      .def_readonly("folding", &Energies::folding, "stored by corners that are about to turn over")
      .def_readonly("contact_stored", &Energies::contact_stored, "elastic, in the springs")
      .def_readonly("contact_damped", &Energies::contact_damped, "dissipated")
      .def_readonly("eroded", &Energies::eroded, "of elements that are no longer there")
      .def_readonly("external", &Energies::external, "work done on the model")
      .def_property_readonly("contact", &Energies::contact, "stored and damped")
      .def_property_readonly("total", &Energies::total, "of all these, less the work done on the model");
}

void bind_probes(py::module_& module) {
  DataClass<ProbeValue>(module, "ProbeValue", "What one quantity of a probe is.")
      .def_readonly("quantity", &ProbeValue::quantity, "\"velocity_x\"")
      .def_readonly("value", &ProbeValue::value, "in the units of the scene");
  DataClass<ProbeResult>(module, "ProbeResult", "What a probe watches, and what it sees.")
      .def_readonly("name", &ProbeResult::name, "as in the scene")
      .def_readonly("body", &ProbeResult::body, "the name of the body that is watched")
      .def_readonly("number", &ProbeResult::number, "of the node or element, in the order of the scene")
      .def_readonly("element", &ProbeResult::element, "whether it is an element")
      .def_readonly("point", &ProbeResult::point, "where that was at the start [length]")
      .def_readonly("values", &ProbeResult::values, "a ProbeValue for each quantity")
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
      .def_readonly("name", &BodyResult::name, "as in the scene")
      .def_readonly("elements", &BodyResult::elements, "how many it began with")
      .def_readonly("eroded_elements", &BodyResult::eroded_elements, "how many of these are no longer there")
      .def_readonly("mass_initial", &BodyResult::mass_initial, "[mass]")
      .def_readonly("mass_remaining", &BodyResult::mass_remaining, "without eroded elements [mass]")
      .def_readonly("mass_added", &BodyResult::mass_added, "of mass_initial, for the step [mass]")
      .def_readonly("velocity", &BodyResult::velocity, "mean [length/time]")
      .def_readonly("max_plastic_strain", &BodyResult::max_plastic_strain, "[-]");
  DataClass<HistoryRow>(module, "HistoryRow", "One row of history.csv.")
      .def_readonly("step", &HistoryRow::step, "steps made before it")
      .def_readonly("time", &HistoryRow::time, "[time]")
      .def_readonly("dt", &HistoryRow::dt, "[time]")
      .def_readonly("energy", &HistoryRow::energy, "of all elements and nodes")
      .def_readonly("inside_out", &HistoryRow::inside_out, "elements with a corner that has turned over")
      .def_readonly("balance_error", &HistoryRow::balance_error, "of the energies, relative [-]")
      .def_readonly("momentum", &HistoryRow::momentum, "[mass length/time]")
      .def_readonly("bodies", &HistoryRow::bodies, "a BodyResult for each body")
      .def_readonly("more", &HistoryRow::more, "of walls and probes: Simulation.history_columns()");
}

}  // namespace pinball::python
