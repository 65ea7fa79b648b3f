#include <solver/summary.hpp>

#include "simulation_object.hpp"

namespace pinball::python {

namespace {

using Object = SimulationObject;

/// A member function of Simulation that only looks.
template <class Result>
auto look(Result (Simulation::*function)() const) {
  return [function](Object& object) -> std::decay_t<Result> { return (object.use().*function)(); };
}

py::object dictionary(const RunSummary& summary) {
  return py::module_::import("json").attr("loads")(summary_json(summary));
}

py::slice slice_of(const IndexRange& range) {
  return {static_cast<py::ssize_t>(range.first), static_cast<py::ssize_t>(range.first + range.count), 1};
}

void bind_steps(py::class_<Object>& simulation) {
  simulation
      .def(py::init<const SourcedScene&, int>(), py::arg("scene"), py::arg("threads") = 0,
           "threads: results are the same bits for any number; 0: OMP_NUM_THREADS, else what the size earns.")
      .def("step", &Object::step, "One step. Returns whether there is more to do.")
      .def("run_until", &Object::run_until, py::arg("time"),
           "Steps until the time is reached; no step is cut for it. Returns whether there is more to do.")
      .def("run", &Object::run, "Steps to the end. Returns False where a callback has stopped the run.")
      .def("on_step", &Object::on_step, py::arg("callback"),
           "callback(simulation) after each step and once at the end; what returns False stops the run.")
      .def_property_readonly("complete", look(&Simulation::complete), "whether all is at one time, at the end")
      .def_property_readonly("time", look(&Simulation::time), "of the positions [time]")
      .def_property_readonly("state_time", look(&Simulation::state_time), "of stresses and energies [time]")
      .def_property_readonly("dt", look(&Simulation::dt), "the last step [time]")
      .def_property_readonly("steps", look(&Simulation::steps), "made so far")
      .def_property_readonly("threads", &Object::threads, "as given");
}

void bind_figures(py::class_<Object>& simulation) {
  simulation.def_property_readonly("scene", &Object::scene, "A copy of the scene as it is run, with every default.")
      .def_property_readonly("energies", look(&Simulation::energies), "at state_time")
      .def_property_readonly("balance_error", look(&Simulation::balance_error), "of the energies, relative [-]")
      .def_property_readonly("bodies", look(&Simulation::bodies), "a BodyResult for each body")
      .def_property_readonly("probes", look(&Simulation::probes), "a ProbeResult for each probe, at state_time")
      .def_property_readonly("state_hash", look(&Simulation::state_hash), "of positions, velocities and stresses")
      .def("history_row", look(&Simulation::history_row), "The present state as a row of history.csv.")
      .def("history_columns", look(&Simulation::history_columns), "names of HistoryRow.more")
      .def(
          "summary", [](Object& object) { return dictionary(object.use().summary()); },
          "What summary.json holds, as a dictionary.")
      .def_property_readonly("nodes", look(&Simulation::nodes), "number of nodes of all bodies")
      .def_property_readonly("elements", look(&Simulation::elements), "number of elements of all bodies")
      .def(
          "nodes_of", [](Object& object, const std::string& body) { return slice_of(object.use().nodes_of(body)); },
          py::arg("body"),
          "The numbers of a body's nodes, as a slice, but for those that it shares with an earlier body of its file.")
      .def(
          "elements_of",
          [](Object& object, const std::string& body) { return slice_of(object.use().elements_of(body)); },
          py::arg("body"), "The numbers of a body's elements, as a slice.");
}

}  // namespace

void bind_simulation(py::module_& module) {
  py::class_<Object> simulation(module, "Simulation",
                                "A scene being run. Writes no files but save_checkpoint(). Pickles and copies go on "
                                "with the same bits; callbacks "
                                "are no part of them.");
  bind_steps(simulation);
  bind_figures(simulation);
  bind_arrays(simulation);
  simulation.def("__repr__", &Object::text)
      .def(py::pickle([](Object& object) { return object.state(); }, &Object::from_state))
      .def("save_checkpoint", &Object::save_checkpoint, py::arg("path"),
           "Writes a file from which `pinball run --restart` and Simulation.from_checkpoint go on with the same bits; "
           "of "
           "scenes that were read and not changed.")
      .def_static("from_checkpoint", &Object::from_checkpoint, py::arg("path"), py::arg("threads") = 0,
                  py::arg("set") = std::vector<std::string>{}, py::arg("device") = Device::none,
                  "The simulation of a checkpoint, also of one that `pinball run` has written; set: \"KEY=VALUE\" of "
                  "time.end, time.steps, time.cfl, output.* or guard.*");
}

}  // namespace pinball::python
