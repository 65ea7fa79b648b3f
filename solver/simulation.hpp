#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "array_view.hpp"
#include "base/export.h"
#include "base/state_archive.hpp"
#include "mesh.hpp"
#include "results.hpp"
#include "scene.hpp"

namespace pinball {

class Simulation;
class Ranks;       // parallel/ranks.hpp: not for hosts
struct FieldBase;  // field_base.hpp

/// What a callback wants.
enum class AfterStep {
  go_on,  ///< with the next step
  stop    ///< the call of run() or run_until() that is under way
};
/// Called between two steps; may look at everything, and change what is meant to be changed.
using StepCallback = std::function<AfterStep(Simulation&)>;

/// What one of the program's ranks does with what it works, and says of it to rank 0.
using RankAnswer = std::function<std::string(Simulation&, std::int64_t number)>;

/// How a scene is to be run; none of it changes results.
struct SimulationOptions {
  /// Threads that steps are made with, results being the same bits for any number; 0: what the scene's size earns, at
  /// most as many as OpenMP takes by default in the thread that calls; these where OMP_NUM_THREADS says how many.
  int threads = 0;
  /// Of the program's: the processes that run the scene together; null: this one is alone.
  Ranks* ranks = nullptr;
};

/// Consecutive numbers.
struct IndexRange {
  std::int64_t first = 0;  ///< number
  std::int64_t count = 0;  ///< of them
};

/// Which field a copy is made of.
enum class NodeField {
  position,         ///< [length]
  velocity,         ///< [length/time]
  mass,             ///< [mass]
  initial_position  ///< where the scene has put it [length]
};
/// Which field a copy is made of.
enum class ElementField {
  stress,          ///< xx yy zz xy yz zx [stress]
  plastic_strain,  ///< effective [-]
  mass             ///< 0 once the element is eroded [mass]
};

/// A scene being run: the whole solver as one object. Writes no files, prints nothing, has no global state: a program
/// may have any number of them, each used by one thread at a time.
///
/// After step() number n the positions belong to time() = t_(n+1), the velocities to the middle between t_n and
/// t_(n+1), stresses and energies to state_time() = t_n. The last of all calls of step() makes no step but brings
/// everything to one time; complete() then holds.
///
/// Numbers of nodes and elements are those of the scene: bodies one after the other, in each of them the order of its
/// mesh. The solver sorts them (for locality, and into packs as wide as the processor's registers): views show its own
/// memory in its own order, and place_of_node() and place_of_element() lead there.
///
/// All units are those of the scene. Errors are exceptions: InputError for what a scene or a caller asks for, RunError
/// for a run that cannot go on; both have a whole sentence in what(). After a RunError the state can be looked at, not
/// continued.
class PINBALL_API Simulation {
 public:
  /// Completes and checks the scene (scene_rules.hpp) and builds the model. Arrays of an ArrayMesh are copied here and
  /// not needed afterwards.
  explicit Simulation(const Scene& scene, const SimulationOptions& options = {});
  ~Simulation();
  Simulation(Simulation&&) noexcept;             ///< views and callbacks stay valid
  Simulation& operator=(Simulation&&) noexcept;  ///< the same

  // ---- Time ----

  /// One step, or one cycle of steps with time.subcycling, and then the callbacks. Returns whether there is more to do:
  /// false once complete() holds, and where a callback stops the run.
  bool step();
  /// Steps until time() has reached `time`, the run is complete or a callback stops it. No step is cut for it, so that
  /// results are those of a run without a stop. Returns as step().
  bool run_until(double time);
  /// Steps until the run is complete or a callback stops it; another call goes on. Returns complete().
  bool run();
  /// For ranks other than 0: does what rank 0 does, until that has no more to do. answer: what each does, rank 0 too,
  /// when that asks all of them.
  void follow_rank_0(const RankAnswer& answer = {});
  /// On rank 0: what all of them say, in their order. number: that all get.
  std::vector<std::string> ask_ranks(std::int64_t number, const RankAnswer& answer);
  /// Adds a callback to those that are called after each step, in order; any of them can stop the run, the others are
  /// called all the same. An exception from one ends step() with it, and the run may go on. Their time counts as output
  /// in phase_seconds. They move with the simulation.
  void on_step(StepCallback callback);

  bool complete() const;  ///< whether all is brought to one time at the end
  /// Whether time.end or time.steps is reached, so that the next step() completes the run.
  bool at_end() const;
  double time() const;         ///< of the positions [time]
  double state_time() const;   ///< of stresses and energies [time]
  double dt() const;           ///< the last step [time]
  std::int64_t steps() const;  ///< made so far; with subcycling the smallest ones

  // ---- Results ----

  const Scene& scene() const;              ///< completed; without the views of an ArrayMesh
  const Energies& energies() const;        ///< at state_time(); valid until the next step
  double balance_error() const;            ///< of the energies, relative
  double balance_error_in_motion() const;  ///< of the energies, relative to what is in motion in its own frame
  std::vector<BodyResult> bodies() const;  ///< elements, masses and mean velocities of the bodies
  ProgressState progress() const;          ///< what a line of progress shows
  HistoryRow history_row() const;          ///< what a row of history.csv holds
  std::vector<std::string> history_columns() const;  ///< names of HistoryRow::more
  std::vector<ProbeResult> probes() const;           ///< what the probes of the scene see now
  RunSummary summary() const;                        ///< wall_seconds: of all calls of step()
  std::uint64_t state_hash() const;                  ///< of positions, velocities and stresses
  /// Copy of all fields at state_time(), in double and in the order of the scene.
  FieldSnapshot snapshot() const;
  /// The same of one of several ranks: of elements that are another's, and of their nodes, it may be old.
  FieldSnapshot own_snapshot() const;
  int rank() const;                                    ///< of this process; 0 where it is alone
  std::vector<std::int32_t> rank_of_elements() const;  ///< of each; empty where this process is alone
  /// What of the fields does not change; its views are valid as long as the simulation is.
  FieldBase field_base() const;

  // ---- Arrays ----
  // Numbers are of the scene's precision, but for masses (double). A view is valid as long as the simulation is, also
  // after it was moved; a step changes what it shows.

  std::int64_t nodes() const;     ///< number of nodes of all bodies
  std::int64_t elements() const;  ///< number of elements of all bodies, eroded ones too
  /// Numbers of its nodes, but for those that it shares with an earlier body. Throws InputError: no such body.
  IndexRange nodes_of(const std::string& body) const;
  IndexRange elements_of(const std::string& body) const;  ///< numbers of its elements

  ConstArrayView positions() const;                     ///< three numbers per node, at time() [length]
  ConstArrayView velocities() const;                    ///< three numbers per node [length/time]
  ConstArrayView masses() const;                        ///< one number per node [mass]
  std::span<const std::int32_t> place_of_node() const;  ///< record of each node in the views of nodes

  /// The velocities, to be written before the next step; to be asked for again before each change, because it wakes
  /// elements at rest. The kinetic energy that a change brings counts as work from outside. Throws InputError with
  /// time.subcycling.
  ArrayView velocities_to_change();
  /// Forces on the nodes in records of three that are added in every step from now on, beside those of the scene; zero
  /// until they are written, and then as they were written last. Their work counts as work from outside. No part of
  /// a saved state. [force]
  ArrayView external_forces();

  /// Effective plastic strain, one number per place of an element; no records in a scene without plasticity [-].
  ConstArrayView plastic_strains() const;
  std::span<const std::int64_t> place_of_element() const;  ///< record of each element in plastic_strains()

  /// Copies into the host's memory, in the order of the scene, floats or doubles; stresses lie in tiles as wide as the
  /// processor's registers, so that no view of fixed steps can show them. Positions and velocities: three numbers;
  /// stress: six, xx yy zz xy yz zx; the others one. Without plasticity plastic strains are 0; the mass of an element
  /// is 0 once it is eroded. Throws InputError for a view that does not fit, and writes nothing then.
  void copy(NodeField field, const ArrayView& to) const;
  void copy(ElementField field, const ArrayView& to) const;  ///< the same of elements

  // ---- State ----

  /// Writes or reads the state between two steps, or at the end (Solver::persist).
  void persist(StateArchive& archive);
  std::uint64_t fingerprint() const;             ///< of the model as built: a state belongs to one
  int simd_width() const;                        ///< lanes of a pack: a state belongs to one
  std::vector<MeshSource> mesh_sources() const;  ///< the files that meshes are from, as they were read

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace pinball
