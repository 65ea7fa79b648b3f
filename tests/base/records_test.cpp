#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include <solver/base/records.hpp>
#include <solver/base/thread_count.hpp>

namespace pinball::records_test {
namespace {

TEST(NodeRecords, GivesTheRecordOfANode) {
  float position[12], velocity[12], force[12];
  for (int i = 0; i < 12; ++i) {
    position[i] = static_cast<float>(i);
    velocity[i] = static_cast<float>(100 + i);
    force[i] = 0;
  }
  const NodeRecords<float> nodes{position, velocity, force};
  EXPECT_EQ(nodes.x(2), position + 8);
  EXPECT_EQ(nodes.v(1)[3], 107);
  nodes.f(1)[2] = 5;
  EXPECT_EQ(force[6], 5);
  const Vec3<float> x = vector_of(nodes.x(1));
  EXPECT_EQ(x.x, 4);
  EXPECT_EQ(x.y, 5);
  EXPECT_EQ(x.z, 6);
  const Vec3<double> v = double_vector_of(record(velocity, 2));
  EXPECT_EQ(v.x, 108);
  EXPECT_EQ(v.z, 110);
}

TEST(ThreadCount, IsWhatTheSizeEarnsAtMostWhatOpenMPTakes) {
  const char* const said = std::getenv("OMP_NUM_THREADS");
  const std::string before = said != nullptr ? said : "";
  ::unsetenv("OMP_NUM_THREADS");
  {
    const ThreadCount most(4);
    EXPECT_EQ(earned_threads(0), 1);
    EXPECT_EQ(earned_threads(2 * elements_of_thread - 1), 1);
    EXPECT_EQ(earned_threads(2 * elements_of_thread), 2);
    EXPECT_EQ(earned_threads(3 * elements_of_thread), 3);
    EXPECT_EQ(earned_threads(std::int64_t(1) << 40), 4);
    ::setenv("OMP_NUM_THREADS", "4", 1);
    EXPECT_EQ(earned_threads(0), 4) << "who says how many is obeyed";
    ::setenv("OMP_NUM_THREADS", "", 1);
    EXPECT_EQ(earned_threads(0), 1);
  }
  before.empty() ? ::unsetenv("OMP_NUM_THREADS") : ::setenv("OMP_NUM_THREADS", before.c_str(), 1);
}

TEST(ThreadCount, PutsBackWhatItHasChanged) {
  const int before = DefaultExecutionSpace::concurrency();
  {
    const ThreadCount as_they_are(0);
    EXPECT_EQ(DefaultExecutionSpace::concurrency(), before);
    const ThreadCount threads(before + 2);
    EXPECT_EQ(DefaultExecutionSpace::concurrency(), before + 2);
  }
  EXPECT_EQ(DefaultExecutionSpace::concurrency(), before);
}

}  // namespace
}  // namespace pinball::records_test
