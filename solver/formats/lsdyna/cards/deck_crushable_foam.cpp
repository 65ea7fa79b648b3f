#include "deck_crushable_foam.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <solver/formats/deck/deck_foam.hpp>

namespace pinball {

namespace {

/// A damping of 0 is this.
constexpr double usual_damping = 0.1;

double steepest(const DeckFoamCurve& curve) {
  double slope = 0;
  for (std::size_t i = 1; i < curve.stress.size(); ++i)
    slope = std::max(slope, (curve.stress[i] - curve.stress[i - 1]) / (curve.compaction[i] - curve.compaction[i - 1]));
  return slope;
}

/// Strains of either sign are compactions, but not of both; stresses count without their sign.
DeckFoamCurve foam_curve(DeckData& data, const KeywordBlock& block, const Fields& f) {
  const std::string name = fmt::format("{} ({}): LCID", block.star_name(), f.place().text());
  const std::int64_t number = f.integer("LCID") + offset_of(block, &DeckTransform::curve);
  if (data.table(number) != nullptr) fail_at(f.place(), fmt::format("lcid: expected a curve, {} is a table", number));
  const DeckCurve& given = data.curve(number, f.place());
  DeckFoamCurve curve{given.abscissa, given.ordinate};
  const auto [low, high] = std::ranges::minmax(curve.compaction);
  if (low < 0 && high <= 0) {
    data.report.understood(name + ": strains below 0 are compressions");
    for (double& strain : curve.compaction) strain = std::abs(strain);
    curve.put_in_order();
  }
  for (double& stress : curve.stress) stress = std::abs(stress);
  if (curve.begin_at(0)) data.report.understood(name + ": what lies below 0 is left out");
  if (curve.end_below_one())
    data.report.understood(name + ": what lies beyond 1, which no strain reaches, is left out");
  return curve;
}

}  // namespace

void set_crushable_foam(DeckData& data, const KeywordBlock& block, const Fields& f, const DeckKeys<Material>& keys) {
  const DeckFoamCurve curve = foam_curve(data, block, f);
  const double young = f.number("E"), damping = f.number("DAMP");
  InnerKeys<CrushableFoamSettings> law;
  law.set("compaction", curve.compaction);
  law.set("yield_stress", curve.stress);
  law.set("tension_cutoff", f.number("TSC"));
  law.set("damping", damping == 0 ? usual_damping : damping);
  keys.set("crushable_foam", law.value(), "lcid, tsc, damp");
  const auto tell = [&](const std::string& what) {
    data.report.understood(fmt::format("{} ({}): {}", block.star_name(), f.place().text(), what));
  };
  if (damping == 0) tell(fmt::format("a DAMP of 0 is {}", usual_damping));
  if (steepest(curve) > young)
    tell(fmt::format("E is less than the steepest slope of its curve, {:.6g}, and stays so", steepest(curve)));
}

}  // namespace pinball
