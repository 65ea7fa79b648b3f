#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <solver/results.hpp>

#include "solver.hpp"

/// What a run tells of itself: functions of a model or of a solver that change nothing.
namespace pinball {

/// The name of the element of a slot (place_names.hpp); "no element" for padding and a negative slot.
template <class S>
std::string element_name(const Model<S>& model, std::int64_t slot);
/// What set the smallest step: the name of an element, "contact", "the speed of impact", "rigid bodies"; empty before
/// the first step.
template <class S>
std::string step_limit(const Model<S>& model, const StepClock& clock);
template <class S>
std::vector<BodyResult> body_results(const Solver<S>& solver);
/// Hash of positions, velocities and stresses, in the order of the scene: it does not depend on the layout of the
/// stores.
template <class S>
std::uint64_t state_hash(const Model<S>& model);
/// Hash of the model as built: its elements, masses and the order of the stores. A saved state belongs to one.
template <class S>
std::uint64_t fingerprint(const Model<S>& model);

/// The energies, but none of motion below zero: what central differences keep is m/2 v(n-1/2) . v(n+1/2), of velocities
/// that may be opposite where the step is long for a motion. The balance is that of the numbers as they are.
template <class S>
Energies reported_energies(const Solver<S>& solver);

/// Names of HistoryRow::more.
template <class S>
std::vector<std::string> more_columns(const Solver<S>& solver);
template <class S>
ProgressState progress_state(const Solver<S>& solver);
template <class S>
HistoryRow history_row(const Solver<S>& solver);
/// All fields at force_time(), in the order of the scene.
template <class S>
FieldSnapshot snapshot(const Solver<S>& solver);
/// The same of one of several ranks: of elements that are another's, and of their nodes, it may be old.
template <class S>
FieldSnapshot own_snapshot(const Solver<S>& solver);
/// Fills everything but wall_seconds, which whoever calls step() measures.
template <class S>
void fill_summary(const Solver<S>& solver, RunSummary& summary);

}  // namespace pinball
