#include <solver/simulation.hpp>
#include <solver/summary.hpp>

#include "bindings.hpp"
#include "numpy_arrays.hpp"

namespace pinball::python {

namespace {

using Self = py::object;  // the Python object of a simulation: arrays keep it

Simulation& of(const Self& self) { return self.cast<Simulation&>(); }

/// Ctrl-C ends a run as it ends other Python code.
AfterStep check_signals(Simulation&) {
  const py::gil_scoped_acquire lock;
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  return AfterStep::go_on;
}

std::unique_ptr<Simulation> make(const SourcedScene& scene, int threads) {
  auto simulation = std::make_unique<Simulation>(scene, SimulationOptions{threads});
  simulation->on_step(check_signals);
  return simulation;
}

/// The callback is kept by the simulation, and let go of with the lock.
void on_step(Simulation& simulation, py::function function) {
  const std::shared_ptr<py::function> kept(new py::function(std::move(function)), [](py::function* f) {
    const py::gil_scoped_acquire lock;
    delete f;
  });
  simulation.on_step([kept](Simulation& s) {
    const py::gil_scoped_acquire lock;
    const py::object answer = (*kept)(py::cast(&s, py::return_value_policy::reference));
    return answer.is(py::bool_(false)) ? AfterStep::stop : AfterStep::go_on;
  });
}

template <class Index>
py::array indices(std::span<const Index> numbers, const Self& self) {
  return shown(view_records(numbers.data(), static_cast<std::int64_t>(numbers.size()), 1), self);
}

/// A copy in the order of the scene, into an array of the caller's or a new one.
template <class Field>
py::array copied(const Simulation& simulation, Field field, std::int64_t count, std::int64_t components,
                 const std::optional<py::array>& out) {
  std::vector<py::ssize_t> shape{count};
  if (components > 1) shape.push_back(components);
  py::array to = out ? *out : py::array(py::dtype::of<double>(), shape);
  simulation.copy(field, view_of<void>(to, "out"));
  return to;
}

py::slice slice_of(const IndexRange& range) {
  return {static_cast<py::ssize_t>(range.first), static_cast<py::ssize_t>(range.first + range.count), 1};
}

void bind_copies(py::class_<Simulation>& simulation) {
  const auto node_copy = [&](const char* name, NodeField field, std::int64_t components, const char* text) {
    simulation.def(
        name,
        [field, components](const Simulation& s, const std::optional<py::array>& out) {
          return copied(s, field, s.nodes(), components, out);
        },
        py::arg("out") = py::none(), text);
  };
  const auto element_copy = [&](const char* name, ElementField field, std::int64_t components, const char* text) {
    simulation.def(
        name,
        [field, components](const Simulation& s, const std::optional<py::array>& out) {
          return copied(s, field, s.elements(), components, out);
        },
        py::arg("out") = py::none(), text);
  };
  node_copy("position", NodeField::position, 3, "Copy of the positions in the order of the scene [length].");
  node_copy("velocity", NodeField::velocity, 3, "Copy of the velocities in the order of the scene [length/time].");
  node_copy("mass", NodeField::mass, 1, "Copy of the masses of the nodes in the order of the scene [mass].");
  element_copy("stress", ElementField::stress, 6, "Copy of the stresses, xx yy zz xy yz zx [stress].");
  element_copy("plastic_strain", ElementField::plastic_strain, 1, "Copy of the effective plastic strains [-].");
  element_copy("element_mass", ElementField::mass, 1, "Copy of the masses of the elements, 0 once eroded [mass].");
}

}  // namespace

void bind_simulation(py::module_& module) {
  using Unlocked = py::call_guard<py::gil_scoped_release>;
  py::class_<Simulation> simulation(module, "Simulation", "A scene being run. Writes no files.");
  simulation
      .def(py::init(&make), py::arg("scene"), py::arg("threads") = 0,
           "threads: results are the same bits for any number; 0: as many as OpenMP takes.")
      .def("step", &Simulation::step, Unlocked(), "One step. Returns whether there is more to do.")
      .def("run_until", &Simulation::run_until, py::arg("time"), Unlocked(),
           "Steps until the time is reached; no step is cut for it. Returns whether there is more to do.")
      .def("run", &Simulation::run, Unlocked(), "Steps to the end. Returns False where a callback has stopped the run.")
      .def("on_step", &on_step, py::arg("callback"),
           "callback(simulation) after each step and once at the end; what returns False stops the run.")
      .def_property_readonly("complete", &Simulation::complete)
      .def_property_readonly("time", &Simulation::time, "of the positions [time]")
      .def_property_readonly("state_time", &Simulation::state_time, "of stresses and energies [time]")
      .def_property_readonly("dt", &Simulation::dt, "the last step [time]")
      .def_property_readonly("steps", &Simulation::steps)
      .def_property_readonly("energies", [](const Simulation& s) { return s.energies(); })
      .def_property_readonly("balance_error", &Simulation::balance_error)
      .def_property_readonly("bodies", &Simulation::bodies)
      .def_property_readonly("state_hash", &Simulation::state_hash)
      .def("history_row", &Simulation::history_row, "The present state as a row of history.csv.")
      .def("history_columns", &Simulation::history_columns, "names of HistoryRow.more")
      .def(
          "summary",
          [](const Simulation& s) { return py::module_::import("json").attr("loads")(summary_json(s.summary())); },
          "What summary.json holds, as a dictionary.")
      .def_property_readonly("nodes", &Simulation::nodes)
      .def_property_readonly("elements", &Simulation::elements)
      .def(
          "nodes_of", [](const Simulation& s, const std::string& body) { return slice_of(s.nodes_of(body)); },
          py::arg("body"), "The numbers of a body's nodes, as a slice.")
      .def(
          "elements_of", [](const Simulation& s, const std::string& body) { return slice_of(s.elements_of(body)); },
          py::arg("body"), "The numbers of a body's elements, as a slice.")
      .def_property_readonly(
          "positions", [](const Self& self) { return shown(of(self).positions(), self); },
          "The solver's own positions, in its order: node n of the scene is positions[place_of_node[n]].")
      .def_property_readonly("velocities", [](const Self& self) { return shown(of(self).velocities(), self); })
      .def_property_readonly("masses", [](const Self& self) { return shown(of(self).masses(), self); })
      .def_property_readonly("plastic_strains",
                             [](const Self& self) { return shown(of(self).plastic_strains(), self); })
      .def_property_readonly("place_of_node", [](const Self& self) { return indices(of(self).place_of_node(), self); })
      .def_property_readonly("place_of_element",
                             [](const Self& self) { return indices(of(self).place_of_element(), self); })
      .def(
          "velocities_to_change", [](const Self& self) { return shown(of(self).velocities_to_change(), self); },
          "The velocities, to be written before the next step; to be asked for again before each change.")
      .def(
          "external_forces", [](const Self& self) { return shown(of(self).external_forces(), self); },
          "Forces on the nodes that are added in every step, zero until they are written [force].");
  bind_copies(simulation);
}

}  // namespace pinball::python
