#pragma once

#include <chrono>
#include <limits>
#include <optional>
#include <string>

namespace pinball {

/// What a study is to reach, and the time that it has for it.
struct StudyLimits {
  std::optional<double> error;    ///< of the quantities that are asked for, over their values [-]
  std::optional<double> seconds;  ///< of all runs that the command makes [s]
};

/// "1%", "0.01". Throws InputError that names --error where it is not between 0 and 1.
double parse_error_share(const std::string& text);

/// "90", "90s", "10min", "2h" [s]. Throws InputError that names --budget where it is not above 0.
double parse_budget(const std::string& text);

/// The time that is left of that of a study, from its construction on.
class StudyBudget {
 public:
  explicit StudyBudget(const StudyLimits& limits)
      : seconds_(limits.seconds.value_or(std::numeric_limits<double>::infinity())) {}

  double left() const { return seconds_ - std::chrono::duration<double>(Clock::now() - begun_).count(); }

 private:
  using Clock = std::chrono::steady_clock;
  double seconds_;
  Clock::time_point begun_ = Clock::now();
};

}  // namespace pinball
