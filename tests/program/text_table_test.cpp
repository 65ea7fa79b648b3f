#include <gtest/gtest.h>

#include <solver/program/text_table.hpp>

namespace pinball {
namespace {

TEST(TextTable, ColumnsAreAsWideAsTheirWidestCell) {
  EXPECT_EQ(text_table({{"a", "1", "x"}, {"bcd", "20.5", ""}, {"e"}}, {Align::left, Align::right, Align::left}),
            "a       1  x\n"
            "bcd  20.5\n"
            "e\n");
}

}  // namespace
}  // namespace pinball
