#pragma once

#include <cstdint>
#include <memory>
#include <utility>
#include <variant>
#include <vector>

#include <solver/base/thread_count.hpp>
#include <solver/scene_rules.hpp>
#include <solver/simulation.hpp>
#include <solver/step/solver.hpp>

namespace pinball {

/// What is behind a Simulation: a solver of the scene's precision. Not for hosts.
struct Simulation::Implementation {
  std::variant<std::unique_ptr<Solver<double>>, std::unique_ptr<Solver<float>>> solver;
  SimulationOptions options;
  std::int64_t elements = 0;
  std::vector<StepCallback> callbacks;
  double wall_seconds = 0;
  bool complete = false;

  /// Threads of a step that begins now.
  int threads() const { return options.threads > 0 ? options.threads : earned_threads(elements); }

  /// use(solver), with a Solver<double>& or a Solver<float>&.
  template <class Use>
  auto change(const Use& use) {
    return std::visit([&](auto& one) { return use(*one); }, solver);
  }
  /// The same with const.
  template <class Use>
  auto read(const Use& use) const {
    return std::visit([&](const auto& one) { return use(std::as_const(*one)); }, solver);
  }
};

}  // namespace pinball
