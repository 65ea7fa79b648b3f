#include <gtest/gtest.h>

#include <cstring>
#include <vector>

#include <tests/support/saved_state.hpp>

/// Pages of zeros are not written where there are zeros: what was there before has to go all the same.
namespace pinball::test::state_archive_test {
namespace {

struct Numbers {
  std::vector<double> numbers = std::vector<double>(500'001);
  void persist(StateArchive& archive) { archive(numbers); }
};

TEST(StateArchive, WritesZerosOverWhatWasThere) {
  Numbers full, zero, mixed;
  for (std::size_t i = 0; i < full.numbers.size(); ++i) full.numbers[i] = 1.0 + static_cast<double>(i);
  mixed.numbers[100'000] = 3;
  mixed.numbers.back() = -0.0;  // differs from 0 in its sign alone
  StateBytes bytes;
  for (Numbers* from : {&full, &zero, &full, &mixed, &zero, &mixed}) {
    StateArchive::save(bytes, [&](StateArchive& archive) { from->persist(archive); });
    for (Numbers into : {full, Numbers{}}) {
      StateArchive archive = StateArchive::reading({bytes.data(), bytes.size()});
      into.persist(archive);
      EXPECT_EQ(archive.left(), 0U);
      EXPECT_EQ(std::memcmp(into.numbers.data(), from->numbers.data(), 8 * into.numbers.size()), 0);
    }
  }
}

}  // namespace
}  // namespace pinball::test::state_archive_test
