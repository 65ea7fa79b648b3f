#include "progress.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>

#include <solver/base/counted.hpp>
#include <solver/scene/units/units.hpp>

namespace pinball {

std::string readable_duration(double seconds) {
  if (!std::isfinite(seconds) || seconds > 1e9) return "?";
  const std::int64_t total = std::llround(std::max(seconds, 0.0));
  if (total < 60) return fmt::format("{} s", total);
  if (total < 3600) return fmt::format("{} min {:02} s", total / 60, total % 60);
  return fmt::format("{} h {:02} min", total / 3600, total / 60 % 60);
}

double fraction_done(const ProgressSettings& settings, const ProgressState& state) {
  double done = settings.end_time > 0.0 ? state.time / settings.end_time : 0.0;
  if (settings.steps > 0) done = std::max(done, static_cast<double>(state.step) / static_cast<double>(settings.steps));
  return done >= 0.0 ? std::min(done, 1.0) : 0.0;  // false for NaN
}

namespace {

int tenths(double done) { return static_cast<int>(done * 10.0 + 1e-9); }  // 0.1 itself may have been rounded down

}  // namespace

Progress::Progress(ProgressSettings settings, std::FILE* stream)
    : settings_(std::move(settings)),
      time_unit_(parse_units(settings_.units).time),
      stream_(stream),
      terminal_(!settings_.quiet && isatty(fileno(stream)) != 0),
      start_(Clock::now()),
      last_shown_(start_) {}

Progress::~Progress() {
  if (!line_open_) return;
  std::fputc('\n', stream_);
  std::fflush(stream_);
}

void Progress::begin(const ProgressState& state) {
  done_before_ = fraction_done(settings_, state);
  steps_before_ = state.step;
  start_ = Clock::now();
  if (settings_.quiet) return;
  next_tenth_ = tenths(done_before_) + 1;
  show(state, done_before_);
}

void Progress::update(const ProgressState& state) {
  if (settings_.quiet) return;
  const double since = std::chrono::duration<double>(Clock::now() - last_shown_).count();
  const double done = fraction_done(settings_, state);
  if (terminal_ ? since < 0.1 : since < settings_.log_seconds && tenths(done) < next_tenth_) return;
  next_tenth_ = std::max(next_tenth_, tenths(done) + 1);
  show(state, done);
}

void Progress::say(const std::string& text) {
  if (settings_.quiet) return;
  std::fputs((terminal_ ? "\r" + text + "\x1b[K\n" : text + '\n').c_str(), stream_);
  std::fflush(stream_);
  line_open_ = false;
}

void Progress::finish(const ProgressState& state) {
  if (settings_.quiet) return;
  if (terminal_) {
    show(state, fraction_done(settings_, state));
    std::fputc('\n', stream_);
    std::fflush(stream_);
    line_open_ = false;
  } else if (next_tenth_ <= 10) {
    next_tenth_ = 11;
    show(state, fraction_done(settings_, state));
  }
}

std::string Progress::time_left(double done, double elapsed) const {
  if (done >= 1.0) return "took " + readable_duration(elapsed);
  const double made = done - done_before_;
  return "ETA " + (made > 0.0 ? readable_duration(elapsed * (1.0 - done) / made) : "?");
}

/// As element_steps_per_second in summary.json, of the steps since the beginning.
std::string Progress::speed(const ProgressState& state, double elapsed) const {
  const double steps = state.step - steps_before_;
  if (!settings_.alone || steps <= 0 || elapsed <= 0) return "";
  return fmt::format("  {:.3g} M element steps/s", state.elements * steps / elapsed * 1e-6);
}

/// What matters most comes first: a narrow terminal cuts off the rest.
std::string Progress::line(const ProgressState& state, double done) const {
  const double elapsed = std::chrono::duration<double>(Clock::now() - start_).count();
  const std::string unit = time_unit_.empty() ? "" : " " + time_unit_;
  std::string line = fmt::format("{:5.1f} %  time {:.4g}{}  dt {:.3g}{}  energy error {:.2g} %  {}  {}", 100.0 * done,
                                 state.time, unit, state.dt, unit, 100.0 * state.balance_error,
                                 time_left(done, elapsed), counted(state.active_elements, "element"));
  if (state.pairs >= 0) line += "  " + counted(state.pairs, "pair");
  return line + speed(state, elapsed);
}

void Progress::show(const ProgressState& state, double done) {
  last_shown_ = Clock::now();
  std::string line = this->line(state, done);
  if (terminal_) {
    winsize size{};
    // A line longer than the window would wrap, and then not be rewritten in place.
    if (ioctl(fileno(stream_), TIOCGWINSZ, &size) == 0 && size.ws_col > 1) {
      line.resize(std::min<std::size_t>(line.size(), size.ws_col - 1U));
    }
    line = "\r" + line + "\x1b[K";
    line_open_ = true;
  } else {
    line += '\n';
  }
  std::fputs(line.c_str(), stream_);  // a failure is no reason to end the run
  std::fflush(stream_);
}

}  // namespace pinball
