#pragma once

#include <solver/program/study/study_maker.hpp>

namespace pinball {

/// Makes the runs that say which settings reach the error of the study's limits in all of its quantities for the least
/// time: meshes between the finest that does not and the coarsest that does, or finer ones; then other precisions
/// and hourglass controls, each on the mesh on which it should reach it by what it errs on that of the sources, where
/// it is expected to be faster. Without an error: finer meshes, as far as the time lasts, and those between where fewer
/// than three came to their ends. Does nothing without limits, or where chance decides.
void search_settings(StudyMaker& maker);

}  // namespace pinball
