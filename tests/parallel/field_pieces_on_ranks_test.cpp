#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <string>

#include <solver/output/page/surface/field_frame.hpp>
#include <solver/output/rank_pieces.hpp>
#include <solver/output/run_files.hpp>
#include <tests/support/error_of.hpp>
#include <tests/support/output_case.hpp>
#include <tests/support/solver_case.hpp>
#include <tests/support/thread_ranks.hpp>

/// Ranks that each write their piece of the fields.
namespace pinball::test::field_pieces_on_ranks_test {
namespace {

/// The others go on to where rank 0 lets them go.
TEST(FieldPiecesOfRanks, ThatCannotBeWrittenEndTheRunOnRank0) {
  const TemporaryFolder folder("no_piece");
  std::filesystem::create_directories(folder.path / "fields_0001_1.vtu" / "in the way");
  Scene scene = scene_of({block("bar", {40, 8, 8}, 0.01, {})}, 1e-5, false);
  const SimulationOptions alone{.threads = 1};
  const auto options = [&alone](ThreadRanks& ranks) {
    SimulationOptions own = alone;
    own.ranks = &ranks;
    return own;
  };
  const std::string error = on_ranks(
      2, {},
      [&](ThreadRanks& ranks) {
        Simulation simulation(scene, options(ranks));
        FieldWriter fields(folder.path.string(), fields_base);
        simulation.step();
        write_pieces(simulation, fields);
        return error_of<RunError>([&] { write_pieces(simulation, fields); });
      },
      [&](ThreadRanks& ranks) {
        DefaultExecutionSpace::set_concurrency(1);
        Simulation(scene, options(ranks)).follow_rank_0(answer_with_piece(folder.path.string()));
      });
  EXPECT_THAT(error, testing::HasSubstr("fields_0001_1.vtu"));
  EXPECT_EQ(FieldFrame::of_file(folder / "fields_0000.pvtu").read<std::uint8_t>("alive").size(), 40U * 8U * 8U);
}

}  // namespace
}  // namespace pinball::test::field_pieces_on_ranks_test
