#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include <solver/base/state_archive.hpp>
#include <solver/boundary/boundary_conditions.hpp>
#include <solver/boundary/symmetry_walls.hpp>
#include <solver/elements/internal_forces.hpp>
#include <solver/elements/subcycling.hpp>
#include <solver/model/initial_overlap.hpp>
#include <solver/model/model.hpp>
#include <solver/model/model_surface.hpp>
#include <solver/results.hpp>
#include <solver/results/probes.hpp>
#include <solver/results/skipped_work.hpp>
#include <solver/results/timers.hpp>

namespace pinball {

/// Central-difference solution of one scene (report figure 4). Owns the model; no global state, no files.
///
/// After step() number n the forces, stresses and energies belong to time t_n, the positions to t_(n+1), the velocities
/// to the middle between them. finish() ends with a step of no length, after which everything belongs to one time.
///
/// With subcycling, step() makes the steps of a cycle, of the smallest elements, and ends with the one in which all
/// elements are worked; what is said above then holds for the steps that step() ends with.
template <class S>
class Solver {
 public:
  explicit Solver(const Scene& scene);

  /// One step, or one cycle of them, at most to the end of the scene's time. Throws RunError for a state that cannot be
  /// continued.
  void step() { advance(false); }
  /// Forces and energies at the present positions, velocities brought to the same time.
  void finish() { advance(true); }

  const Model<S>& model() const { return model_; }
  /// To change it between steps.
  Model<S>& model() {
    internal_forces_.forget_resting();
    return model_;
  }
  /// To change velocities before the next step. What that adds to the kinetic energy is work from outside; before the
  /// first step it is part of what the run begins with. Throws InputError for a scene with subcycling, in which nodes
  /// have several velocities.
  AlignedArray<S>& change_velocities();
  /// Forces that a host adds in every step (BoundaryConditions). Throws InputError where the program has none of them.
  AlignedArray<S>& host_forces();
  const ContactAlgorithm<S>* contact() const { return contact_.get(); }
  const BoundaryConditions<S>& boundary() const { return boundary_; }
  const Subcycling<S>* subcycling() const { return subcycling_ ? &*subcycling_ : nullptr; }

  /// Whether time.end or time.steps of the scene is reached; then finish() is due.
  bool at_end() const;
  double time() const { return time_; }              ///< of the positions
  double force_time() const { return force_time_; }  ///< of the forces, stresses and energies
  double dt() const { return dt_; }                  ///< the last step
  std::int64_t steps() const { return steps_; }
  const Energies& energies() const { return energies_; }
  /// At force_time(), relative to the initial total energy or the largest work from outside, whichever is larger.
  double balance_error() const;
  double initial_energy() const { return initial_energy_; }
  Point momentum() const;
  std::int64_t contact_pairs() const { return pairs_; }  ///< in contact at force_time()
  std::int64_t eroded_elements() const { return eroded_elements_; }

  ProgressState progress_state() const;
  std::vector<BodyResult> body_results() const;
  HistoryRow history_row() const;
  std::vector<std::string> more_columns() const;  ///< names of HistoryRow::more
  FieldSnapshot snapshot() const {
    FieldSnapshot s;
    snapshot(s);
    return s;
  }
  void snapshot(FieldSnapshot& s) const;  ///< into the memory of an earlier one
  std::uint64_t state_hash() const;
  /// The state between steps; what the scene gives is not in it. After reading, the run goes on with the same bits as
  /// the solver that wrote it, if it was built from the same scene; else this throws InputError, or fingerprint()
  /// differs.
  void persist(StateArchive& archive);
  /// Hash of the model as built: its elements, masses and the order of the stores.
  std::uint64_t fingerprint() const;
  /// Fills everything but wall_seconds, which whoever calls step() measures.
  void fill_summary(RunSummary& summary) const;
  Timers& timers() { return timers_; }

 private:
  void advance(bool last);
  void take_changed_velocities();
  double kinetic_energy_now() const;
  void make_step(std::int32_t step_of_cycle, bool last);
  void search_contact(const ModelSurface<S>& contact_model);
  void choose_time_step(const InternalForceResult<S>& internal, const ContactWork& contact, bool last);
  double integrate(std::int32_t step_of_cycle);
  DueSpans due_nodes(std::int32_t step_of_cycle) const {
    return subcycling_ ? subcycling_->due_nodes(step_of_cycle) : DueSpans{};
  }
  void check_volumes(const InternalForceResult<S>& internal) const;
  void check_finite(double energy) const;
  void check_energy() const;
  void check_time_step() const;
  std::string element_name(std::int64_t slot) const;
  std::string when() const;  ///< for messages

  Model<S> model_;
  InternalForces<S> internal_forces_;
  SymmetryWalls<S> symmetry_walls_;
  BoundaryConditions<S> boundary_;
  Probes<S> probes_;
  std::unique_ptr<ContactAlgorithm<S>> contact_;  ///< only in a scene with contact
  std::optional<Subcycling<S>> subcycling_;       ///< only where the scene asks for it
  Timers timers_;

  double time_ = 0, force_time_ = 0, dt_ = 0, dt_before_ = 0;
  std::int64_t steps_ = 0;
  Energies energies_;
  double damped_power_ = 0;
  std::optional<double> kinetic_before_change_;  ///< velocities may have been changed since [energy]
  double initial_energy_ = 0, external_max_ = 0;
  Point initial_momentum_{};
  std::int64_t eroded_elements_ = 0;
  WorkCounts counts_;
  double balance_error_max_ = 0, penetration_ratio_max_ = 0;
  double contact_frequency2_ = 0;  ///< largest since the cycle began [1/time^2]
  std::int64_t pairs_ = 0, pairs_max_ = 0;
  double
      longest_contact_step_;  ///< from the velocities at the start or after a change; infinite without contact [time]
  InitialOverlap initial_overlap_;  ///< only looked for in a scene with contact
  double dt_min_ = 0, dt_max_ = 0;
  std::string dt_limited_by_;
};

}  // namespace pinball
