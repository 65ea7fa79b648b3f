#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <stdlib.h>
#include <unistd.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <string>
#include <thread>

#include <solver/output/progress.hpp>

namespace pinball {
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

TEST(Progress, RewritesOneLineOnATerminal) {
  const int terminal = posix_openpt(O_RDWR | O_NOCTTY);
  if (terminal < 0 || grantpt(terminal) != 0 || unlockpt(terminal) != 0) GTEST_SKIP() << "no pseudo-terminal";
  const File stream(fdopen(open(ptsname(terminal), O_RDWR | O_NOCTTY), "w"), std::fclose);
  {
    Progress progress({.end_time = 1.0, .units = "m-kg-s"}, stream.get());
    for (int i = 1; i <= 1000; ++i) progress.update({i, i * 1e-4, 1e-4, 0.0, 8});  // too fast to be shown
    std::this_thread::sleep_for(std::chrono::milliseconds(120));
    progress.update({1001, 0.25, 1e-4, 0.0, 8});
  }  // a run that fails here
  // The terminal may hand on what is written in several parts.
  std::string text;
  for (pollfd ready{terminal, POLLIN, 0}; (text.empty() || text.back() != '\n') && poll(&ready, 1, 1000) > 0;) {
    char buffer[4096];
    const auto length = read(terminal, buffer, sizeof buffer);
    if (length <= 0) break;
    text.append(buffer, static_cast<std::size_t>(length));
  }
  close(terminal);
  ASSERT_FALSE(text.empty());
  EXPECT_THAT(text, testing::StartsWith("\r 25.0 %  time 0.25 s"));
  EXPECT_EQ(std::count(text.begin(), text.end(), '%'), 2) << text;
  EXPECT_EQ(text.back(), '\n');
}

TEST(Progress, NamesDurations) {
  EXPECT_EQ(readable_duration(0.4), "0 s");
  EXPECT_EQ(readable_duration(59.6), "1 min 00 s");
  EXPECT_EQ(readable_duration(185.0), "3 min 05 s");
  EXPECT_EQ(readable_duration(7800.0), "2 h 10 min");
  EXPECT_EQ(readable_duration(std::numeric_limits<double>::quiet_NaN()), "?");
}

}  // namespace
}  // namespace pinball
