#pragma once

#include <optional>
#include <string>
#include <thread>

#include <solver/simulation.hpp>

#include "bindings.hpp"

namespace pinball::python {

/// pinball.Simulation: a simulation that other threads of Python cannot disturb. Its members are called with the
/// interpreter's lock; steps are made without it, and while they are, every other thread that comes gets an exception.
/// The thread that makes them comes by in callbacks, between two steps.
class SimulationObject {
 public:
  SimulationObject(const SourcedScene& scene, int threads);

  /// For everything but steps. Throws where another thread is making steps.
  Simulation& use();
  /// Forces of the host, which are no part of a saved state.
  ArrayView forces();

  bool step();
  bool run();
  bool run_until(double time);
  void on_step(py::function callback);

  /// The scene as it is run, with meshes of arrays, by which the same model is built again.
  SourcedScene scene();
  void save_checkpoint(const std::string& path);
  static std::unique_ptr<SimulationObject> from_checkpoint(const std::string& path, int threads,
                                                           const std::vector<std::string>& set, Device device);
  py::dict state();  ///< for pickle
  static std::unique_ptr<SimulationObject> from_state(const py::dict& state);

  int threads() const { return threads_; }
  std::string text();  ///< repr

 private:
  /// make(simulation), without the lock.
  template <class Make>
  bool make_steps(const Make& make);

  std::optional<SceneSource> source_;
  int threads_;
  bool has_forces_ = false;
  std::optional<std::thread::id> stepping_;  ///< the thread that makes steps at present
  Simulation simulation_;
};

/// The ways to the arrays of a simulation, as members of the class.
void bind_arrays(py::class_<SimulationObject>& simulation);

}  // namespace pinball::python
