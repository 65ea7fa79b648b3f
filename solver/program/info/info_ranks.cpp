#include "info_ranks.hpp"

#include <fmt/core.h>

#include <string>

#include <solver/base/error.hpp>
#include <solver/parallel/planned_ranks.hpp>
#include <solver/program/text_table.hpp>
#include <solver/step/solver.hpp>

#include "info_devices.hpp"

namespace pinball {

namespace {

template <class S>
std::vector<std::string> line_of(const Scene& scene, int count) {
  PlannedRanks ranks(count, {});
  Solver<S> solver(scene, &ranks);
  const std::int64_t before = ranks.gathers();
  std::string bytes = "-", gathers = "-";
  try {
    solver.step();
    const auto all = static_cast<double>(solver.shared_work().bytes_per_step);
    bytes = readable_bytes(all);
    gathers = fmt::format("{}", ranks.gathers() - before);
  } catch (const RunError&) {  // some ranks have no elements, and no step of theirs
  }
  const SharedWork work = solver.shared_work();
  return {fmt::format("{}", count),
          fmt::format("{}", work.most_elements),
          fmt::format("{:.3f}", work.imbalance),
          fmt::format("{}", work.records),
          fmt::format("{}", work.messages),
          fmt::format("{}", work.common_nodes),
          gathers,
          bytes};
}

}  // namespace

template <class S>
void print_ranks(const Scene& scene, const std::vector<int>& counts) {
  fmt::print("on several processes (mpirun -n)\n");
  std::vector<std::vector<std::string>> lines{
      {"ranks", "most elements", "over the mean", "forces", "messages", "common nodes", "gathers", "bytes in a step"}};
  for (const int count : counts) lines.push_back(line_of<S>(scene, count));
  const std::string table = text_table(lines, std::vector<Align>(lines[0].size(), Align::right));
  fmt::print("{}", table);
}

template void print_ranks<double>(const Scene&, const std::vector<int>&);
template void print_ranks<float>(const Scene&, const std::vector<int>&);

}  // namespace pinball
