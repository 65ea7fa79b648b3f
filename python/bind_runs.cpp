#include <solver/restart.hpp>
#include <solver/summary.hpp>

#include "bindings.hpp"
#include "interpreter_lock.hpp"

namespace pinball::python {

namespace {

/// Runs without the interpreter's lock. Ctrl-C ends the run after its step, with all its files; it is raised then.
template <class Run>
py::object recorded(RecordOptions options, const Run& run) {
  bool interrupted = false;
  options.quiet = options.silent = true;  // the warnings are in what is returned
  options.stop = [&interrupted] {
    const TakenLock lock;
    interrupted = PyErr_CheckSignals() != 0;
    if (!interrupted) return false;
    PyErr_Clear();
    return true;
  };
  RunSummary summary;
  without_lock([&] { summary = run(options); });
  if (interrupted) {
    PyErr_SetNone(PyExc_KeyboardInterrupt);
    throw py::error_already_set();
  }
  return py::module_::import("json").attr("loads")(summary_json(summary));
}

py::object run(const SourcedScene& given, const std::string& out, std::int64_t checkpoint_every, int threads) {
  const SourcedScene scene = given;  // that no other thread changes
  RecordOptions options;
  options.out = out;
  options.threads = threads;
  options.checkpoint_every = checkpoint_every;
  // The source is that of the scene only if the scene is what is read from it.
  if (scene.source) {
    SourcedScene again{read_scene(*scene.source), scene.source};
    again.device = scene.device;
    if (py::cast(again).equal(py::cast(scene))) options.source = &*scene.source;
  }
  return recorded(options, [&scene](const RecordOptions& with) { return run_recorded(scene, with); });
}

py::object restart(const std::string& checkpoint, const std::string& out, const std::vector<std::string>& set,
                   std::int64_t checkpoint_every, Device device, int threads) {
  RecordOptions options;
  options.threads = threads;
  options.device = device;
  options.out = out;
  options.checkpoint_every = checkpoint_every;
  return recorded(options, [&](const RecordOptions& with) { return restart_recorded(checkpoint, set, with); });
}

}  // namespace

void bind_runs(py::module_& module) {
  module.def(
      "run_recorded", &run, py::arg("scene"), py::arg("out"), py::arg("checkpoint_every") = 0, py::arg("threads") = 0,
      "Runs a scene as `pinball run` does, with history.csv, fields, summary.json and the page in the folder out. "
      "checkpoint_every: steps between checkpoints, 0: none; of scenes that were read and not changed. threads: as "
      "of Simulation. Ctrl-C leaves all files of the run so far. Returns what summary.json holds.");
  module.def("restart_recorded", &restart, py::arg("checkpoint"), py::arg("out") = "",
             py::arg("set") = std::vector<std::string>{}, py::arg("checkpoint_every") = 0,
             py::arg("device") = Device::none, py::arg("threads") = 0,
             "Goes on as `pinball run --restart` does; out: empty: the folder of the checkpoint.");
}

}  // namespace pinball::python
