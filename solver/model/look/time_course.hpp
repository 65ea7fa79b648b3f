#pragma once

#include <vector>

#include <solver/model/model.hpp>

namespace pinball {

/// The factor of a table and its integrals from time 0, at each of some times; the integrals are 0 before time 0.
struct TimeCourse {
  std::vector<double> value;   ///< [-]
  std::vector<double> first;   ///< [time]
  std::vector<double> second;  ///< [time^2]
};

/// times: ascending.
TimeCourse time_course(const TimeTable& table, const std::vector<double>& times);

/// A prescribed motion, as a multiple of what stands beside its table, at each of some times. It stands still before it
/// begins and, but for an acceleration, after it ends.
struct MotionCourse {
  std::vector<double> way;   ///< since it began [time of a velocity, - of a displacement, time^2 of an acceleration]
  std::vector<double> low;   ///< the least since the time before
  std::vector<double> high;  ///< the greatest since the time before
  std::vector<double> rate;  ///< of the way, 0 before it begins; after it ends its last one
  double from = 0;           ///< when it begins [time]
  double to = 0;             ///< when it ends, at the latest with the run [time]
};

/// times: ascending, from 0 to the end of the run.
MotionCourse course_of(const PrescribedVelocity& given, const std::vector<double>& times);
MotionCourse course_of(const RigidMotion& given, const std::vector<double>& times);

/// Times at which a look follows its movers: even pieces of the run and, between them, starts and ends of motions,
/// points of tables and where these change their sign. Of long tables that is a part of the points.
std::vector<double> look_times(const Scene& scene, std::size_t movers);

}  // namespace pinball
