#include "cut_graph.hpp"

#if defined(PINBALL_WITH_METIS)
#include <metis.h>
#endif

#include <cstdint>
#include <numeric>

#include <solver/base/error.hpp>

namespace pinball {

#if defined(PINBALL_WITH_METIS)

namespace {

/// METIS adds up what tiles weigh, in numbers that may have 32 bits.
constexpr std::int64_t most_work = std::int64_t{1} << 30;

}  // namespace

std::vector<std::int32_t> cut_graph(const TileGraph& tiles, int parts) {
  if (parts == 1 || tiles.work.empty()) return std::vector<std::int32_t>(tiles.work.size(), 0);
  std::vector<idx_t> first(tiles.first.begin(), tiles.first.end());
  std::vector<idx_t> neighbour(tiles.neighbour.begin(), tiles.neighbour.end());
  std::vector<idx_t> shared(tiles.shared.begin(), tiles.shared.end());
  std::vector<idx_t> work;
  const std::int64_t unit = 1 + std::reduce(tiles.work.begin(), tiles.work.end(), std::int64_t{0}) / most_work;
  for (const std::int32_t of : tiles.work) work.push_back(static_cast<idx_t>((of + unit - 1) / unit));
  std::vector<idx_t> part(work.size());
  auto count = static_cast<idx_t>(work.size());
  idx_t constraints = 1, number = parts, cut = 0;
  idx_t options[METIS_NOPTIONS];
  METIS_SetDefaultOptions(options);
  options[METIS_OPTION_SEED] = 1;
  options[METIS_OPTION_UFACTOR] = 50;  // whole tiles: within 5 %
  const int status = METIS_PartGraphKway(&count, &constraints, first.data(), neighbour.data(), work.data(), nullptr,
                                         shared.data(), &number, nullptr, nullptr, options, &cut, part.data());
  if (status != METIS_OK) throw RunError("METIS has found no partition of the tiles");
  return {part.begin(), part.end()};
}

#else

std::vector<std::int32_t> cut_graph(const TileGraph& /*tiles*/, int /*parts*/) {
  throw InputError("--partition metis: this program was built without METIS: expected tiles or random:SEED");
}

#endif

}  // namespace pinball
