#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "base/iteration_counts.hpp"
#include "base/tied_result.hpp"
#include "mesh.hpp"

/// What a run reports: plain data in double, in the order of the scene (not of the solver's internal numbering).
namespace pinball {

/// Energies of the whole model [energy]; the total is kept constant up to `external` work.
struct Energies {
  double kinetic = 0.0;
  double kinetic_below_zero = 0.0;  ///< what of the kinetic energy is reported apart from it; not above 0
  double internal = 0.0;            ///< work of the stresses, of elements that still carry stress
  double hourglass = 0.0;           ///< work of the hourglass forces
  double bulk_viscosity = 0.0;      ///< work of the bulk viscosity
  double folding = 0.0;             ///< stored by corners of elements that are about to turn over
  double contact_stored = 0.0;      ///< elastic energy in the penalty springs
  double contact_damped = 0.0;      ///< dissipated by the contact damping
  double eroded = 0.0;              ///< internal energy that eroded elements took with them
  double external = 0.0;            ///< work done on the model from outside
  double hourglass_plastic = 0.0;   ///< of `internal`: plastic work of the hourglass modes

  double contact() const { return contact_stored + contact_damped; }
  double total() const {
    return kinetic + kinetic_below_zero + internal + hourglass + bulk_viscosity + folding + contact() + eroded -
           external;
  }
};

struct BodyResult {
  std::string name;
  std::int64_t elements = 0;
  std::int64_t eroded_elements = 0;
  double mass_initial = 0.0;        ///< mass of all its elements, without [[point_mass]] [mass]
  double mass_remaining = 0.0;      ///< mass of the elements that are not eroded [mass]
  double mass_added = 0.0;          ///< what of mass_initial no material has (time.smallest_step) [mass]
  Point velocity{};                 ///< of the remaining elements, mass-weighted [length/time]
  double max_plastic_strain = 0.0;  ///< among the remaining elements [-]
};

/// What a rigid wall has felt.
struct WallResult {
  std::string name;
  double force = 0.0;             ///< along its normal, at present [force]
  double force_max = 0.0;         ///< largest of one step [force]
  double impulse = 0.0;           ///< given to the bodies [mass length/time]
  bool moves = false;             ///< it has a speed or a mass
  double displacement = 0.0;      ///< along the normal [length]
  double row_displacement = 0.0;  ///< at the time of the force, before the step that it makes [length]
  double velocity = 0.0;          ///< of a wall that moves, along the normal [length/time]
};

/// What a pressure has done.
struct PressureResult {
  std::string name;
  Point force{};      ///< of all its faces together, mean over the steps of the last cycle of subcycling [force]
  double work = 0.0;  ///< done on the bodies, up to the time of the forces [energy]
};

/// What constraints, prescribed velocities and accelerations of one name exert on the nodes.
struct ForceResult {
  std::string name;
  Point force{};  ///< mean over the steps of the last cycle of subcycling [force]
};

/// Where a rigid body is and how it moves; about its centre.
struct RigidBodyResult {
  std::string name;
  double mass = 0.0;               ///< [mass]
  std::array<Point, 3> inertia{};  ///< at the start [mass length^2]
  Point centre{};                  ///< [length]
  Point velocity{};                ///< of the centre [length/time]
  Point angular_velocity{};        ///< [1/time]
  Point angular_momentum{};        ///< [mass length^2/time]
  Point force{}, moment{};         ///< of what holds and moves it, at present [force], [force length]
};

/// What a joint of rigid bodies does.
struct JointResult {
  std::string name;
  Point force{}, moment{};  ///< on the first body, at present; about the place of the joint [force], [force length]
  double work = 0.0;        ///< done on the bodies, which only the length of steps lets it do [energy]
  double opening = 0.0;     ///< how far what it keeps together is apart now, over the size of its bodies [-]
};

/// What the two sides of a contact pair have done to each other.
struct PairResult {
  std::string name;
  Point force{};           ///< on the first side, at present [force]
  double force_max = 0.0;  ///< size of the largest of one step [force]
  Point impulse{};         ///< given to the first side [mass length/time]
};

/// Two bodies that share space at the start, or when contact between them begins.
struct OverlapResult {
  std::string first, second;
  std::int64_t points = 0;  ///< nodes, and points of elements, that lie more than a tenth of an element inside
  std::int64_t nodes = 0;   ///< nodes of both that lie deeper in the other one than facets of curved surfaces explain
  std::string place;        ///< the deepest of them: "node 17 of body rod"; empty: there is none
  double depth = 0.0;       ///< of it, from the surface of the other body [length]
  double share = 0.0;       ///< the same over the size of a face there [-]
  double time = 0.0;        ///< when they do [time]
  bool rigid_wall = false;  ///< `second` is one, and the nodes lie behind it
};

/// What one quantity of a probe is at the end.
struct ProbeValue {
  std::string quantity;  ///< column of history.csv without the name of the probe: "velocity_x"
  double value = 0.0;
};

struct ProbeResult {
  std::string name;
  std::string body;
  std::int64_t number = 0;  ///< of the node or element, in the order of the scene
  bool element = false;
  Point point{};  ///< where the node or the centre of the element was at the start [length]
  std::vector<ProbeValue> values;
};

/// One row of history.csv.
struct HistoryRow {
  std::int64_t step = 0;
  double time = 0.0;
  double dt = 0.0;
  Energies energy;
  double balance_error = 0.0;   ///< (total - initial total) / initial total
  Point momentum{};             ///< [mass length/time]
  std::int64_t inside_out = 0;  ///< elements with a corner that has turned over
  std::vector<BodyResult> bodies;
  std::vector<double> more;  ///< of walls and probes, one per further column
};

/// Where a run is: what a line of progress shows.
struct ProgressState {
  std::int64_t step = 0;
  double time = 0.0;
  double dt = 0.0;
  double balance_error = 0.0;        ///< relative, as in HistoryRow
  std::int64_t active_elements = 0;  ///< not eroded
  std::int64_t elements = 0;         ///< of the scene
  std::int64_t pairs = -1;           ///< in contact; negative: the scene has no contact
};

/// A copy of the fields at one time, for output and as the last good state.
struct FieldSnapshot {
  std::int64_t step = 0;
  double time = 0.0;
  std::vector<Point> position;                         ///< per node [length]
  std::vector<Point> velocity;                         ///< per node [length/time]
  std::vector<Point> contact_force;                    ///< per node [force]
  std::vector<std::array<std::int32_t, 8>> hexahedra;  ///< per element
  std::vector<std::array<double, 6>> stress;           ///< per element: xx yy zz xy yz zx [stress]
  std::vector<double> plastic_strain;                  ///< per element [-]
  std::vector<double> temperature;                     ///< per element; empty: no material has one [temperature]
  std::vector<double> damage;                          ///< per element, 1: failed; empty: none has one [-]
  std::vector<double> pinball_radius;                  ///< per element, 0 where it is no pinball [length]
  std::vector<std::uint8_t> alive;                     ///< per element: 0 once eroded
  std::vector<std::int32_t> body;                      ///< per element: index of its body
};

/// An energy that a run is watched for, as a share of what it is measured by.
struct WatchedShare {
  double largest = 0.0;  ///< of the whole run [-]
  double since = 0.0;    ///< when it last went beyond what is sound [time]
  std::string place;     ///< where that was: "node 17 of body rod"; empty: it never did
};

/// Elements with a corner that has turned over.
struct InsideOutCount {
  std::int64_t elements = 0;  ///< at the end
  std::int64_t most = 0;      ///< at once
  double first_time = 0.0;    ///< [time]
  std::string first_place;    ///< "element 17 of body rod"; empty: there was none
};

struct PhaseSeconds {
  std::string name;
  double seconds = 0.0;
};

/// What leaving out work has saved, estimated from the run's own cost of the same work.
struct SkippedSeconds {
  double resting = 0.0;         ///< elements at rest, at the cost of an element step
  double subcycling = 0.0;      ///< elements that make larger steps, at the same cost
  double searches = 0.0;        ///< steps without a search, at the cost of one that searches
  double inner_elements = 0.0;  ///< elements without an exposed face, at the cost that the surface has
};

/// What has become of a run.
enum class RunStatus {
  running,  ///< neither of the others: it goes on, or was killed
  done,     ///< came to its end
  failed,   ///< ended by an error
  stopped   ///< ended where it was, because it was asked to
};

/// How a run was shared by the processes of one mpirun.
struct ParallelRun {
  int ranks = 1;
  std::int64_t records = 0;          ///< forces of element corners that all ranks together send in a step
  std::int64_t messages = 0;         ///< in which they do, each of one rank to one other
  std::int64_t common_nodes = 0;     ///< that all ranks move, those of contact, ties and rigid bodies
  std::int64_t bytes_per_step = 0;   ///< that they send in the last step, or the mean of its cycle
  double imbalance = 1;              ///< work of the rank that has most of it, over the mean
  std::vector<std::string> devices;  ///< that work the elements of each rank; empty: the processors do
};

/// Everything that summary.json holds.
struct RunSummary {
  std::string scene, title, units, version, precision;
  std::string device;  ///< where its steps are made: "none", on the host; "mock", "cuda", "hip"
  RunStatus status = RunStatus::running;
  std::string error;    ///< of a run that has failed
  std::string started;  ///< when its files were begun, UTC: "2024-05-31T08:15:00Z"; empty: it has none
  int threads = 1;
  int simd_width = 1;  ///< lanes of a pack in the element kernels
  ParallelRun parallel;
  std::int64_t elements = 0, nodes = 0, steps = 0;
  double end_time = 0.0;
  double dt_min = 0.0, dt_max = 0.0;
  std::string dt_limited_by;  ///< "element 17 of body rod" or "contact", at the smallest step
  double wall_seconds = 0.0;
  std::vector<PhaseSeconds> phases;
  std::int64_t element_steps = 0;            ///< computed
  std::int64_t element_steps_eroded = 0;     ///< not computed, because the element is eroded
  std::int64_t element_steps_resting = 0;    ///< not computed, because its tile rests
  std::int64_t element_steps_subcycled = 0;  ///< not computed, because the element makes a larger step
  std::int64_t element_steps_rigid = 0;      ///< not computed, because the element is of a rigid body
  Energies energy;                           ///< at the end
  double initial_total = 0.0, final_total = 0.0, balance_error_max = 0.0;
  /// What is in motion in its own frame, or the largest work from outside where that is more [energy].
  double energy_in_motion = 0.0;
  WatchedShare balance_error_in_motion;  ///< of energy_in_motion, each time of that so far
  WatchedShare contact_created;          ///< contact energy below zero, of energy_in_motion
  WatchedShare contact_swallowed;        ///< contact energy that is not stored at the end, of energy_in_motion
  double contact_swallowed_sound = 0.0;  ///< up to where the scene may expect it; 0: it asks for what swallows [-]
  /// Hourglass energy below and above zero, of the largest internal energy, or of a hundredth of energy_in_motion where
  /// that is more.
  WatchedShare hourglass_created, hourglass_large;
  WatchedShare hourglass_plastic;  ///< what yield has taken from hourglass modes, of the same
  /// Kinetic and internal energy below zero, of energy_in_motion.
  WatchedShare kinetic_below_zero, internal_below_zero;
  InsideOutCount inside_out;
  double point_mass = 0.0;       ///< at nodes, beside the masses of bodies (point_mass) [mass]
  double mass_added = 0.0;       ///< to all bodies for time.smallest_step [mass]
  std::string large_added_mass;  ///< where it is more than is sound, as a sentence; empty: nowhere
  Point momentum_initial{}, momentum_final{};
  std::vector<BodyResult> bodies;
  std::vector<RigidBodyResult> rigid_bodies;
  std::vector<JointResult> joints;
  std::vector<WallResult> walls;
  std::vector<PressureResult> pressures;
  std::vector<ProbeResult> probes;
  std::string contact_method, contact_enforcement;
  std::string contact_gap;                ///< "pinball": between balls; "face"
  std::vector<PairResult> contact_pairs;  ///< of the scene
  std::vector<TiedResult> tied;           ///< of the scene, at the start
  std::int64_t pinballs = 0;              ///< at the end
  std::int64_t pairs_max = 0;             ///< most pairs in contact at one step
  IterationCounts iterations;             ///< of impulses of contact, by lagrange
  std::int64_t searches = 0, searches_skipped = 0;
  std::int64_t inner_element_steps = 0;  ///< of elements that are not in contact, because no face of theirs is exposed
  std::int64_t bytes_not_stored = 0;     ///< of element arrays that the scene's features need not have
  SkippedSeconds skipped_seconds;
  double max_penetration_ratio = 0.0;   ///< deepest penetration over the sum of the two radii
  double max_penetration_time = 0.0;    ///< when it was
  std::string max_penetration_place;    ///< a node of it: "node 17 of body rod"; empty: there was none
  std::string overlapping_bodies;       ///< "a and b": the first two that shared space at the start; empty: none did
  std::vector<OverlapResult> overlaps;  ///< all that share space then, two by two
  std::string overlap_at_end;           ///< the same two at the end, with the number of points inside; empty: none do
  std::string unseen_balls;             ///< which balls find each other too late, and how late; empty: none do
  std::vector<std::string>
      mesh_warnings;                    ///< of meshes of files: nodes on each other, folded elements, what is left out
  std::vector<std::string> near_nodes;  ///< selections that nodes lie near to and that do not take them, in words
  /// What nobody is likely to mean, seen before the first step: units, speeds, meshes, bodies that never meet.
  std::vector<std::string> unlikely;
  double expected_impact = 0.0;    ///< speed of the fastest; 0: none is expected [length/time]
  std::string contact_because;     ///< why contact is on or off where the scene leaves that open; empty: it does not
  std::string unstable_hourglass;  ///< an hourglass coefficient too large for the steps; empty: it is not
  std::vector<std::string> notes;  ///< what was made of a deck, line by line
  std::uint64_t state_hash = 0;
  std::int64_t bytes_per_element = 0;  ///< memory of the stores over the number of elements
};

}  // namespace pinball
