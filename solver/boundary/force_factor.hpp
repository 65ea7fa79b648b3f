#pragma once

#include <kernels/boundary/external_work.hpp>
#include <solver/scene_boundary.hpp>

namespace pinball {

/// What a table makes of a force in a step; time: of the forces. Where points of the table lie within the time over
/// which the force changes velocities, the mean over it: a pulse that is shorter than a step gives its impulse.
double force_factor(const TimeTable& table, double time, const StepLengths& step);

/// The same of a force that begins at `start`, from which the times of the table count; none before, where that is
/// above 0.
double force_factor(const TimeTable& table, double start, double time, const StepLengths& step);

}  // namespace pinball
