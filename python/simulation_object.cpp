#include "simulation_object.hpp"

#include <cmath>
#include <cstring>

#include <solver/base/error.hpp>
#include <solver/base/version.h>
#include <solver/restart.hpp>
#include <solver/scene_rules.hpp>

#include "interpreter_lock.hpp"
#include "numpy_arrays.hpp"

namespace pinball::python {

namespace {

/// Ctrl-C ends a run as it ends other Python code.
AfterStep check_signals(Simulation&) {
  const TakenLock lock;
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  return AfterStep::go_on;
}

/// Building takes as long as some steps: other threads run meanwhile. The scene is the simulation's own, which no other
/// thread changes.
Simulation built(const Scene scene, int threads) {
  std::optional<Simulation> simulation;
  without_lock([&] { simulation.emplace(scene, SimulationOptions{threads}); });
  return std::move(*simulation);
}

/// The mesh of a body, as a mesh of arrays that is where the body's nodes began.
py::object mesh_of(const Simulation& simulation, const std::string& body, const FieldSnapshot& snapshot) {
  const IndexRange nodes = simulation.nodes_of(body), elements = simulation.elements_of(body);
  py::array_t<double> all({simulation.nodes(), std::int64_t{3}});
  simulation.copy(NodeField::initial_position, view_of<void>(all, "coordinates"));
  py::array_t<std::int32_t> corners({elements.count, std::int64_t{8}});
  for (std::int64_t e = 0; e < elements.count; ++e) {
    for (int i = 0; i < 8; ++i) {
      corners.mutable_at(e, i) = static_cast<std::int32_t>(snapshot.hexahedra[elements.first + e][i] - nodes.first);
    }
  }
  const py::object own = all[py::slice(nodes.first, nodes.first + nodes.count, 1)].attr("copy")();
  return py::module_::import("pinball").attr("ArrayMesh")(own, corners);
}

py::bytes saved(Simulation& simulation) {
  StateBytes bytes;
  StateArchive::save(bytes, [&](StateArchive& archive) { simulation.persist(archive); });
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

void load(Simulation& simulation, const std::string& saved) {
  StateBytes bytes(saved.size());
  std::memcpy(bytes.data(), saved.data(), saved.size());
  StateArchive archive = StateArchive::reading({bytes.data(), bytes.size()});
  simulation.persist(archive);
  if (archive.left() > 0) StateArchive::throw_foreign();
}

/// Bodies of rigid ones that have a mass have materials of their own in a model, of another density and with a space in
/// their names, as no scene has them: what was given has none of these.
void leave_out_own_materials(Scene& scene) {
  for (Body& body : scene.bodies) body.material = body.material.substr(0, body.material.find(' '));
  std::erase_if(scene.materials, [](const Material& m) { return m.name.find(' ') != std::string::npos; });
}

}  // namespace

SimulationObject::SimulationObject(const SourcedScene& scene, int threads)
    : source_(scene.source), threads_(threads), simulation_(built(scene, threads)) {
  simulation_.on_step(check_signals);
}

Simulation& SimulationObject::use() {
  if (stepping_ && *stepping_ != std::this_thread::get_id()) {
    throw std::runtime_error(
        "Simulation: another thread is making steps with it; a simulation is used by one thread at a time");
  }
  return simulation_;
}

template <class Make>
bool SimulationObject::make_steps(const Make& make) {
  use();
  if (stepping_) throw std::runtime_error("Simulation: a callback of its own cannot make steps with it");
  stepping_ = std::this_thread::get_id();
  struct End {
    std::optional<std::thread::id>& stepping;
    ~End() { stepping.reset(); }  // with the lock, which comes back first
  } const end{stepping_};
  bool goes_on = false;
  without_lock([&] { goes_on = make(simulation_); });
  return goes_on;
}

bool SimulationObject::step() {
  return make_steps([](Simulation& simulation) { return simulation.step(); });
}
bool SimulationObject::run() {
  return make_steps([](Simulation& simulation) { return simulation.run(); });
}
bool SimulationObject::run_until(double time) {
  return make_steps([time](Simulation& simulation) { return simulation.run_until(time); });
}

/// The callback is kept by the simulation, and let go of with the lock.
void SimulationObject::on_step(py::function function) {
  const std::shared_ptr<py::function> kept(new py::function(std::move(function)), [](py::function* f) {
    const py::gil_scoped_acquire lock;
    delete f;
  });
  use().on_step([this, kept](Simulation&) {
    const TakenLock lock;
    const py::object self = py::cast(this, py::return_value_policy::reference);
    const auto answer = py::reinterpret_steal<py::object>(call_python(kept->ptr(), self.ptr()));
    if (!answer) throw py::error_already_set();
    return answer.is(py::bool_(false)) ? AfterStep::stop : AfterStep::go_on;
  });
}

ArrayView SimulationObject::forces() {
  const ArrayView view = use().external_forces();
  has_forces_ = true;
  return view;
}

SourcedScene SimulationObject::scene() {
  const Simulation& simulation = use();
  SourcedScene scene{simulation.scene(), source_};
  leave_out_own_materials(scene);
  std::optional<FieldSnapshot> snapshot;
  for (Body& body : scene.bodies) {
    if (!std::holds_alternative<ArrayMesh>(body.mesh)) continue;
    if (!snapshot) snapshot = simulation.snapshot();
    body.mesh = mesh_of(simulation, body.name, *snapshot).cast<ArrayMesh>();
    body.axis.reset();
    body.position = {-0.0, -0.0, -0.0};  // what is added to each place: it leaves zeros their sign
  }
  return scene;
}

void SimulationObject::save_checkpoint(const std::string& path) {
  Simulation& simulation = use();
  if (!source_) {
    throw InputError("checkpoint: expected a scene of a file, which it holds the text of; pickle takes any simulation");
  }
  if (has_forces_) {
    throw InputError(
        "checkpoint: expected no external forces, which it does not hold, got a simulation whose external_forces() "
        "were "
        "asked for; pickle takes any simulation");
  }
  SourcedScene as_read{checked_scene(read_scene(*source_)), source_};
  as_read.device = simulation.scene().device;  // of no file
  if (!py::cast(as_read).equal(py::cast(scene()))) {
    throw InputError(
        "checkpoint: expected the scene as it was read, got one that was changed; pickle takes any simulation");
  }
  pinball::save_checkpoint(path, simulation, *source_);
}

std::unique_ptr<SimulationObject> SimulationObject::from_checkpoint(const std::string& path, int threads,
                                                                    const std::vector<std::string>& set,
                                                                    Device device) {
  const SceneSource source = scene_of_checkpoint(path, set);
  SourcedScene scene{read_scene(source), source};
  scene.device = device;
  auto made = std::make_unique<SimulationObject>(scene, threads);
  load_checkpoint(path, made->simulation_);
  return made;
}

py::dict SimulationObject::state() {
  Simulation& simulation = use();
  py::dict state;
  state["version"] = pinball_version();
  state["simd_width"] = simulation.simd_width();
  state["fingerprint"] = simulation.fingerprint();
  state["scene"] = py::cast(scene());
  state["threads"] = threads_;
  state["state"] = saved(simulation);
  if (has_forces_) state["forces"] = shown(simulation.external_forces(), py::none()).attr("copy")();
  return state;
}

std::unique_ptr<SimulationObject> SimulationObject::from_state(const py::dict& state) {
  const auto made = [&] {
    return std::make_unique<SimulationObject>(state["scene"].cast<SourcedScene>(), state["threads"].cast<int>());
  };
  std::unique_ptr<SimulationObject> object = made();
  Simulation& simulation = object->simulation_;
  if (state["simd_width"].cast<int>() != simulation.simd_width() ||
      state["fingerprint"].cast<std::uint64_t>() != simulation.fingerprint()) {
    throw InputError("Simulation: pickled by pinball " + state["version"].cast<std::string>() + " with packs of " +
                     std::to_string(state["simd_width"].cast<int>()) + ", this is pinball " + pinball_version() +
                     " with packs of " + std::to_string(simulation.simd_width()) +
                     "; a state goes on where the same program makes the same mesh");
  }
  load(simulation, state["state"].cast<std::string>());
  if (state.contains("forces")) shown(object->forces(), py::none())[py::ellipsis()] = state["forces"];
  return object;
}

std::string SimulationObject::text() {
  const Simulation& simulation = use();
  const Scene& scene = simulation.scene();
  const auto number = [](double value) { return std::string(py::str(py::float_(value))); };
  return "<pinball.Simulation" + (scene.name.empty() ? "" : " of " + scene.name) + ": " +
         std::to_string(simulation.elements()) + " elements, " + std::to_string(simulation.steps()) + " steps, time " +
         number(simulation.time()) + " of " + number(scene.time.end) + (simulation.complete() ? ", complete>" : ">");
}

}  // namespace pinball::python
