#include <gtest/gtest.h>

#include <solver/program/text_table.hpp>

namespace pinball::text_table_test {
namespace {

TEST(TextTable, ColumnsAreAsWideAsTheirWidestCell) {
  EXPECT_EQ(text_table({{"a", "1", "x"}, {"bcd", "20.5", ""}, {"e"}}, {Align::left, Align::right, Align::left}),
            "a       1  x\n"
            "bcd  20.5\n"
            "e\n");
}

TEST(TextTable, CellsOfSharesAndDurations) {
  EXPECT_EQ(percent_cell(0.0123), "1.2 %");
  EXPECT_EQ(percent_cell(-12.34), "1234 %");
  EXPECT_EQ(duration_cell(0.123), "0.12 s");
  EXPECT_EQ(duration_cell(185), "3 min 05 s");
}

}  // namespace
}  // namespace pinball::text_table_test
