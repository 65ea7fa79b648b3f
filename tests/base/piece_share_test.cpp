#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include <solver/base/piece_share.hpp>

/// Which process works which pieces of a loop, and what they tell each other.
namespace pinball::piece_share_test {
namespace {

/// One of some processes, of which the others are not there.
class OneOf final : public Sharers {
 public:
  OneOf(int count, int number) : count_(count), number_(number) {}
  int count() const override { return count_; }
  int number() const override { return number_; }
  std::int64_t worth_a_message() const override { return 100; }
  std::vector<std::span<const std::byte>> to_all(std::span<const std::byte> own) override {
    return std::vector<std::span<const std::byte>>(count_, own);
  }

 private:
  int count_, number_;
};

/// How many numbers each process works, when each works its pieces.
template <class Make>
std::vector<std::int64_t> worked(int processes, const std::vector<std::int64_t>& numbers_of, const Make& make) {
  std::vector<std::int64_t> of_process(processes, 0);
  std::vector<int> times(numbers_of.size(), 0);
  for (int number = 0; number < processes; ++number) {
    OneOf sharers(processes, number);
    const PieceShare share = make(&sharers);
    for (std::size_t piece = 0; piece < numbers_of.size(); ++piece) {
      if (!share.is_own(piece)) continue;
      of_process[number] += numbers_of[piece];
      ++times[piece];
    }
  }
  EXPECT_EQ(std::ranges::count(times, 1), std::ssize(times)) << "each piece is of one process";
  return of_process;
}

TEST(PieceShare, IsAllWhereThereIsNoOtherOrLittleToDo) {
  OneOf alone(1, 0), second(2, 1);
  for (const PieceShare& share : {PieceShare(), PieceShare(nullptr, 64, 1000), PieceShare(&alone, 64, 1000),
                                  PieceShare(&second, 64, 99), PieceShare(&second, {50, 49})}) {
    EXPECT_FALSE(share.is_shared());
    EXPECT_TRUE(share.is_own(0) && share.is_own(1));
    share.to_all({}, [](std::span<const std::byte>) { ADD_FAILURE() << "nothing is sent"; });
  }
  EXPECT_TRUE(PieceShare(&second, 64, 100).is_shared());
  EXPECT_TRUE(PieceShare(&second, {50, 50}).is_shared());
}

TEST(PieceShare, GivesPiecesInTurn) {
  for (const int processes : {2, 3, 7, 100}) {
    const std::vector<std::int64_t> found = worked(processes, std::vector<std::int64_t>(64, 1),
                                                   [](Sharers* sharers) { return PieceShare(sharers, 64, 6400); });
    const auto [least, most] = std::ranges::minmax(found);
    EXPECT_LE(most - least, 1) << processes;
  }
}

TEST(PieceShare, GivesEachAboutAsManyNumbers) {
  const std::vector<std::int64_t> numbers_of{500, 10, 90, 400, 0, 300, 120, 80, 1000, 60};
  for (const int processes : {2, 3, 4, 12}) {
    const std::vector<std::int64_t> found =
        worked(processes, numbers_of, [&](Sharers* sharers) { return PieceShare(sharers, numbers_of); });
    EXPECT_LE(std::ranges::max(found), std::max(1000, 2560 / processes + 10)) << processes;
  }
}

TEST(PieceShare, GivesAllWhatTheOthersHave) {
  OneOf second(3, 1);
  std::vector<std::byte> message;
  const std::vector<double> list{1, 2, 3};
  const std::vector<int> none;
  put_list(message, list);
  put_list(message, none);
  put_count(message, 7);
  int others = 0;
  PieceShare(&second, 2, 1000).to_all(message, [&](std::span<const std::byte> theirs) {
    std::vector<double> taken{0.5};
    std::vector<int> more;
    add_list(theirs, taken);
    add_list(theirs, more);
    EXPECT_EQ(taken, (std::vector<double>{0.5, 1, 2, 3}));
    EXPECT_TRUE(more.empty());
    EXPECT_EQ(get_count(theirs), 7U);
    EXPECT_TRUE(theirs.empty());
    ++others;
  });
  EXPECT_EQ(others, 2);
}

}  // namespace
}  // namespace pinball::piece_share_test
