#include "cut_graph.hpp"

#if defined(PINBALL_WITH_METIS)
#include <metis.h>
#endif

#include <solver/base/error.hpp>

namespace pinball {

#if defined(PINBALL_WITH_METIS)

std::vector<std::int32_t> cut_graph(const TileGraph& tiles, int parts) {
  if (parts == 1 || tiles.elements.empty()) return std::vector<std::int32_t>(tiles.elements.size(), 0);
  std::vector<idx_t> first(tiles.first.begin(), tiles.first.end());
  std::vector<idx_t> neighbour(tiles.neighbour.begin(), tiles.neighbour.end());
  std::vector<idx_t> shared(tiles.shared.begin(), tiles.shared.end());
  std::vector<idx_t> elements(tiles.elements.begin(), tiles.elements.end());
  std::vector<idx_t> part(elements.size());
  auto count = static_cast<idx_t>(elements.size());
  idx_t constraints = 1, number = parts, cut = 0;
  idx_t options[METIS_NOPTIONS];
  METIS_SetDefaultOptions(options);
  options[METIS_OPTION_SEED] = 1;
  options[METIS_OPTION_UFACTOR] = 50;  // whole tiles: within 5 %
  const int status = METIS_PartGraphKway(&count, &constraints, first.data(), neighbour.data(), elements.data(), nullptr,
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
