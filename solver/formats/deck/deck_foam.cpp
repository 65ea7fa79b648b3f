#include "deck_foam.hpp"

#include <algorithm>

namespace pinball {

namespace {

constexpr double last_compaction = 0.999;

}  // namespace

void DeckFoamCurve::put_in_order() {
  if (compaction.empty() || compaction.front() <= compaction.back()) return;
  std::reverse(compaction.begin(), compaction.end());
  std::reverse(stress.begin(), stress.end());
}

double DeckFoamCurve::at(double x) const {
  if (compaction.size() < 2) return stress.front();
  std::size_t k = 1;
  while (k + 1 < compaction.size() && x > compaction[k]) ++k;
  return stress[k - 1] + (stress[k] - stress[k - 1]) * (x - compaction[k - 1]) / (compaction[k] - compaction[k - 1]);
}

bool DeckFoamCurve::begin_at(double first) {
  const auto before = std::ranges::lower_bound(compaction, first) - compaction.begin();
  if (before == 0) return false;
  const double there = at(first);
  compaction.erase(compaction.begin(), compaction.begin() + before);
  stress.erase(stress.begin(), stress.begin() + before);
  if (!compaction.empty() && compaction.front() == first) return true;
  compaction.insert(compaction.begin(), first);
  stress.insert(stress.begin(), there);
  return true;
}

bool DeckFoamCurve::end_below_one() {
  const auto kept = std::ranges::upper_bound(compaction, last_compaction) - compaction.begin();
  if (kept == static_cast<std::ptrdiff_t>(compaction.size())) return false;
  const double there = at(last_compaction);
  compaction.erase(compaction.begin() + kept, compaction.end());
  stress.erase(stress.begin() + kept, stress.end());
  if (compaction.empty() || compaction.back() < last_compaction) {
    compaction.push_back(last_compaction);
    stress.push_back(there);
  }
  return true;
}

}  // namespace pinball
