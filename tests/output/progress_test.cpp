#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <stdlib.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <limits>
#include <memory>
#include <string>
#include <thread>

#include <solver/output/progress.hpp>

namespace pinball::progress_test {
namespace {

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

std::string content(std::FILE* file) {
  std::rewind(file);
  std::string text;
  for (int c = std::fgetc(file); c != EOF; c = std::fgetc(file)) text += static_cast<char>(c);
  return text;
}

std::string run_of_1000_steps(const ProgressSettings& settings) {
  const File file(std::tmpfile(), std::fclose);
  Progress progress(settings, file.get());
  progress.begin({0, 0, 0, 0, 1842, 1842, 0});
  for (int i = 1; i <= 1000; ++i) progress.update({i, 5.4e-5 * i / 1000, 5.4e-8, -1.25e-3, 1842 - i, 1842, 7});
  progress.finish({1000, 5.4e-5, 5.4e-8, -1.25e-3, 842, 1842, 7});
  return content(file.get());
}

TEST(Progress, WritesALineAtOnceAndAtEveryTenthToALogFile) {
  const std::string text = run_of_1000_steps({.end_time = 5.4e-5, .units = "in-lbf-s"});
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 11);
  EXPECT_EQ(text.find('\r'), std::string::npos);
  EXPECT_THAT(text,
              testing::StartsWith("  0.0 %  time 0 s  dt 0 s  energy error 0 %  ETA ?  1842 elements  0 pairs\n"));
  EXPECT_THAT(text, testing::ContainsRegex("\n 10.0 %  time 5.4e-06 s  dt 5.4e-08 s  energy error -0.12 %  ETA [0-9]+ s"
                                           "  1742 elements  7 pairs  [0-9.e+]+ M element steps/s\n"));
  EXPECT_THAT(text, testing::HasSubstr("100.0 %  time 5.4e-05 s"));
}

TEST(Progress, WritesToALogFileAfterEveryMinute) {
  const File file(std::tmpfile(), std::fclose);
  Progress progress({.end_time = 1e6, .units = "m-kg-s", .log_seconds = 0.02}, file.get());
  progress.begin({});
  for (int i = 1; i <= 3; ++i) {
    progress.update({i, 0.5 * i});  // a step that ends before the time is over shows nothing
    std::this_thread::sleep_for(std::chrono::milliseconds(25));
    progress.update({i, static_cast<double>(i)});
  }
  const std::string text = content(file.get());
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 4) << text;
  EXPECT_THAT(text, testing::HasSubstr("  0.0 %  time 3 s"));
}

TEST(Progress, CountsFromWhereARestartBegins) {
  const File file(std::tmpfile(), std::fclose);
  Progress progress({.end_time = 100, .units = ""}, file.get());
  progress.begin({1000000, 85, 1e-4, 0, 8, 8});
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  progress.update({1000001, 90.5, 1e-4, 0, 8, 8});
  const std::string text = content(file.get());
  EXPECT_THAT(text, testing::HasSubstr(" 90.5 %"));
  EXPECT_THAT(text, testing::Not(testing::HasSubstr("pairs"))) << "no contact";
  const auto end = text.rfind(" M element steps/s");
  ASSERT_NE(end, std::string::npos) << text;
  EXPECT_LE(std::stod(text.substr(text.rfind("  ", end))), 8e-5) << "one step of 8 elements in at least 0.1 s";
}

TEST(Progress, TellsNoSpeedOfRunsThatShareTheTime) {
  EXPECT_THAT(run_of_1000_steps({.end_time = 5.4e-5, .units = "", .alone = false}),
              testing::Not(testing::HasSubstr("steps/s")));
}

TEST(Progress, CountsStepsWhereTheyEndTheRun) {
  const std::string text = run_of_1000_steps({.end_time = 1.0, .steps = 1000, .units = "free units"});
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 11);
  EXPECT_THAT(text, testing::HasSubstr("time 5.4e-06  dt"));
}

TEST(Progress, IsQuietWhenAsked) { EXPECT_EQ(run_of_1000_steps({.end_time = 5.4e-5, .units = "", .quiet = true}), ""); }

/// What a terminal gets that progress is shown on; empty: there is none. show: is given the progress.
template <class Show>
std::string shown_on_a_terminal(const ProgressSettings& settings, const Show& show) {
  const int terminal = posix_openpt(O_RDWR | O_NOCTTY);
  if (terminal < 0 || grantpt(terminal) != 0 || unlockpt(terminal) != 0) return "";
  const File stream(fdopen(open(ptsname(terminal), O_RDWR | O_NOCTTY), "w"), std::fclose);
  {
    Progress progress(settings, stream.get());
    show(progress);
  }
  std::fputs("over", stream.get());
  std::fflush(stream.get());
  // The terminal may hand on what is written in several parts.
  std::string text;
  for (pollfd ready{terminal, POLLIN, 0}; !text.ends_with("over") && poll(&ready, 1, 1000) > 0;) {
    char buffer[4096];
    const auto length = read(terminal, buffer, sizeof buffer);
    if (length <= 0) break;
    text.append(buffer, static_cast<std::size_t>(length));
  }
  close(terminal);
  EXPECT_TRUE(text.ends_with("over")) << text;
  return text.substr(0, text.size() - 4);
}

void wait_until_shown() { std::this_thread::sleep_for(std::chrono::milliseconds(120)); }

TEST(Progress, RewritesOneLineOnATerminal) {
  const std::string text = shown_on_a_terminal({.end_time = 1.0, .units = "m-kg-s"}, [](Progress& progress) {
    for (int i = 1; i <= 1000; ++i) progress.update({i, i * 1e-4, 1e-4, 0.0, 8});  // too fast to be shown
    wait_until_shown();
    progress.update({1001, 0.25, 1e-4, 0.0, 8});
  });  // a run that fails here
  if (text.empty()) GTEST_SKIP() << "no pseudo-terminal";
  EXPECT_THAT(text, testing::StartsWith("\r 25.0 %  time 0.25 s"));
  EXPECT_EQ(std::count(text.begin(), text.end(), '%'), 2) << text;
  EXPECT_THAT(text, testing::EndsWith("\x1b[K\r\n")) << "what follows has a line of its own";
}

TEST(Progress, EndsTheLineOnATerminalOnce) {
  const std::string text = shown_on_a_terminal({.end_time = 1.0, .units = "m-kg-s"}, [](Progress& progress) {
    progress.begin({0, 0, 1e-4, 0.0, 8});
    progress.say("a note");
    wait_until_shown();
    progress.update({1001, 0.25, 1e-4, 0.0, 8});
    progress.finish({4000, 1, 1e-4, 0.0, 8});
  });
  if (text.empty()) GTEST_SKIP() << "no pseudo-terminal";
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 2) << text;
  EXPECT_THAT(text, testing::StartsWith("\r  0.0 %"));
  EXPECT_THAT(text, testing::HasSubstr("\x1b[K\ra note\x1b[K\r\n\r 25.0 %"));
  EXPECT_THAT(text, testing::ContainsRegex("\r100.0 %.*took 0 s.*\r\n$"));
}

TEST(Progress, LeavesNoEmptyLineAfterANoteOnATerminal) {
  const std::string text = shown_on_a_terminal({.end_time = 1.0, .units = ""}, [](Progress& progress) {
    progress.begin({0, 0, 1e-4, 0.0, 8});
    progress.say("a note");
  });
  if (text.empty()) GTEST_SKIP() << "no pseudo-terminal";
  EXPECT_THAT(text, testing::EndsWith("\ra note\x1b[K\r\n"));
}

/// The number before a text.
double number_before(const std::string& text, const std::string& what) {
  const auto end = text.rfind(what);
  EXPECT_NE(end, std::string::npos) << text;
  return end == std::string::npos ? 0 : std::stod(text.substr(text.find_last_of(' ', end - 1)));
}

/// By the clock of the test around it and within it: however long it takes, it is in between.
TEST(Progress, SpeedAndWhatIsLeftAreOfTheTimeSinceItBegan) {
  using Clock = std::chrono::steady_clock;
  const File file(std::tmpfile(), std::fclose);
  Progress progress({.end_time = 1, .units = ""}, file.get());
  std::this_thread::sleep_for(std::chrono::milliseconds(60));  // before it begins
  const auto before = Clock::now();
  progress.begin({100, 0.5, 1e-4, 0, 8, 8});
  const auto begun = Clock::now();
  std::this_thread::sleep_for(std::chrono::milliseconds(240));
  const auto then = Clock::now();
  progress.update({1100, 0.6, 1e-4, 0, 8'000'000, 8'000'000});
  const auto after = Clock::now();
  const double least = std::chrono::duration<double>(then - begun).count();
  const double most = std::chrono::duration<double>(after - before).count();
  const double speed = number_before(content(file.get()), " M element steps/s"), made = 1000 * 8.0;
  EXPECT_LE(speed, 1.006 * made / least) << "three digits";
  EXPECT_GE(speed, made / most / 1.006);

  progress.update({1101, 0.6 + 1e-9, 1e-4, 0, 8, 8});  // not due
  EXPECT_EQ(number_before(content(file.get()), " M element steps/s"), speed);
}

TEST(Progress, WhatIsLeftIsInProportionToWhatWasMade) {
  using Clock = std::chrono::steady_clock;
  const File file(std::tmpfile(), std::fclose);
  Progress progress({.end_time = 1, .units = "", .log_seconds = 0.01}, file.get());
  const auto before = Clock::now();
  progress.begin({0, 0, 1e-4});
  const auto begun = Clock::now();
  std::this_thread::sleep_for(std::chrono::milliseconds(200));
  const auto then = Clock::now();
  progress.update({1, 1.0 / 5001, 1e-4});  // 5,000 times as much is left
  const auto after = Clock::now();
  const std::string text = content(file.get());
  const auto at = text.rfind("ETA ");
  ASSERT_NE(at, std::string::npos) << text;
  int minutes = 0, seconds = 0;
  ASSERT_EQ(std::sscanf(text.c_str() + at, "ETA %d min %d s", &minutes, &seconds), 2) << text;
  const double left = 60.0 * minutes + seconds;
  EXPECT_GE(left, 5000 * std::chrono::duration<double>(then - begun).count() - 1);
  EXPECT_LE(left, 5000 * std::chrono::duration<double>(after - before).count() + 1);
}

TEST(Progress, TheFractionIsOfTheLimitThatEndsTheRunFirst) {
  const auto done = [](double time, std::int64_t step, double end, std::int64_t steps) {
    return fraction_done({.end_time = end, .steps = steps, .units = ""}, {step, time});
  };
  EXPECT_DOUBLE_EQ(done(0.03e-6, 7, 1e-6, -1), 0.03);
  EXPECT_DOUBLE_EQ(done(0.03, 7, 1, 100), 0.07);
  EXPECT_DOUBLE_EQ(done(0.03, 2, 1, 100), 0.03);
  EXPECT_EQ(done(0.03, 7, 0, -1), 0) << "nothing ends it";
  EXPECT_EQ(done(2, 7, 1, -1), 1);
  EXPECT_EQ(done(-2, 0, 1, -1), 0);
  EXPECT_EQ(done(std::numeric_limits<double>::quiet_NaN(), 0, 1, -1), 0);
}

TEST(Progress, NamesDurations) {
  EXPECT_EQ(readable_duration(0.4), "0 s");
  EXPECT_EQ(readable_duration(59.6), "1 min 00 s");
  EXPECT_EQ(readable_duration(185.0), "3 min 05 s");
  EXPECT_EQ(readable_duration(7800.0), "2 h 10 min");
  EXPECT_EQ(readable_duration(std::numeric_limits<double>::quiet_NaN()), "?");
}

}  // namespace
}  // namespace pinball::progress_test
