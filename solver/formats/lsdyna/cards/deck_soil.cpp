#include "deck_soil.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include <solver/formats/lsdyna/layouts/definition_cards.hpp>

#include "keyword_rules.hpp"

namespace pinball {

namespace {

/// Pressures over compressions ln(V_0/V), rising from 0.
struct SoilCurve {
  std::vector<double> compression, pressure;
};

std::vector<double> ten_of_soil(const DeckData& data, Cards& cards, const CardLayout& first, const CardLayout& more) {
  std::vector<double> values;
  for (const CardLayout* layout : {&first, &more}) {
    const Card card = cards.next_or_blank();
    const Fields f = data.fields(card, *layout);
    for (std::size_t i = 0; i < layout->size(); ++i) values.push_back(f.number(i));
  }
  return values;
}

/// EPS1 to EPS10 and P1 to P10: as many as go on from the first.
SoilCurve points_of_soil(std::vector<double> eps, std::vector<double> p, const DeckPlace& place) {
  std::size_t count = 1;
  while (count < eps.size() && std::abs(eps[count]) > std::abs(eps[count - 1])) ++count;
  for (std::size_t i = count; i < eps.size(); ++i) {
    if (eps[i] != 0 || p[i] != 0)
      fail_at(place, fmt::format("eps1 to eps10: expected strains of rising compression, and 0 behind the last point, "
                                 "got {} after {}",
                                 eps[count], eps[count - 1]));
  }
  if (count < 2) fail_at(place, "eps1 to eps10: expected 2 to 10 points EPS and P, or a curve LCID");
  eps.resize(count);
  p.resize(count);
  return {eps, p};
}

/// Strains of either sign are compressions, but not of both; what begins beyond 0 begins at 0.
SoilCurve curve_of_soil(DeckData& data, const std::string& what, SoilCurve given, const DeckPlace& place) {
  const auto [low, high] = std::ranges::minmax(given.compression);
  if (low < 0 && high > 0)
    fail_at(place, fmt::format("{}: expected strains of one sign, got {} and {}", what, low, high));
  if (high > 0) data.report.understood(fmt::format("{}: strains above 0 are compressions", what));
  for (double& strain : given.compression) strain = std::abs(strain);
  if (given.compression.front() > given.compression.back()) {
    std::ranges::reverse(given.compression);
    std::ranges::reverse(given.pressure);
  }
  if (given.compression.front() > 0) {
    given.compression.insert(given.compression.begin(), 0.0);
    given.pressure.insert(given.pressure.begin(), 0.0);
    data.report.understood(fmt::format("{}: the curve begins at 0, where there is no pressure", what));
  }
  return given;
}

double steepest(const SoilCurve& curve) {
  double slope = 0;
  for (std::size_t i = 1; i < curve.pressure.size(); ++i)
    slope = std::max(slope,
                     (curve.pressure[i] - curve.pressure[i - 1]) / (curve.compression[i] - curve.compression[i - 1]));
  return slope;
}

SoilCurve read_soil_curve(DeckData& data, const KeywordBlock& block, const Fields& options, Cards& cards,
                          const Fields& f) {
  const std::vector<double> eps = ten_of_soil(data, cards, layout::soil_strains, layout::soil_strains_more),
                            p = ten_of_soil(data, cards, layout::soil_pressures, layout::soil_pressures_more);
  const std::int64_t id = options.integer("LCID");
  const std::string name = fmt::format("{} ({})", block.star_name(), f.place().text());
  if (id == 0) return curve_of_soil(data, name + ": EPS1 to EPS10", points_of_soil(eps, p, f.place()), f.place());
  const auto given = [](double one) { return one != 0; };
  if (std::ranges::any_of(eps, given) || std::ranges::any_of(p, given))
    data.report.unused(f.place(), block.star_name() + ": EPS1 to EPS10, P1 to P10", "LCID is used");
  const std::int64_t number = id + offset_of(block, &DeckTransform::curve);
  if (data.table(number) != nullptr) fail_at(f.place(), fmt::format("lcid: expected a curve, {} is a table", number));
  const DeckCurve& curve = data.curve(number, f.place());
  return curve_of_soil(data, name + ": LCID", {curve.abscissa, curve.ordinate}, f.place());
}

}  // namespace

void set_soil(DeckData& data, const KeywordBlock& block, const Fields& f, Cards& cards,
              const DeckKeys<Material>& keys) {
  const Card second = cards.next_or_blank();
  const Fields options = data.fields(second, layout::soil_options);
  const SoilCurve curve = read_soil_curve(data, block, options, cards, f);
  const double modulus = f.number("KUN"), cutoff = f.number("PC"), vcr = options.number("VCR");
  if (vcr != 0 && vcr != 1) options.fail("VCR", fmt::format("expected 0 or 1, got {}", vcr));
  keys.set("shear_modulus", f.number("G"), "g");
  InnerKeys<DruckerPragerSettings> strength;
  strength.set("constant", f.number("A0"));
  strength.set("linear", f.number("A1"));
  strength.set("quadratic", f.number("A2"));
  keys.set("drucker_prager", strength.value(), "a0, a1, a2");
  InnerKeys<EquationOfStateSettings> pressure;
  std::vector<double> strain;
  for (const double one : curve.compression) strain.push_back(0.0 - one);
  pressure.set("form", "tabulated");
  pressure.set("volume_strain", strain);
  pressure.set("pressure", curve.pressure);
  if (cutoff < 0) pressure.set("tension_limit", -cutoff);
  if (cutoff < 0 && keyword_alias(block.name) == "MAT_SOIL_AND_FOAM_FAILURE") pressure.set("tears", true);
  if (cutoff == 0) pressure.set("bears_tension", false);
  if (vcr == 1) {
    data.report.unused(f.place(), block.star_name() + ": KUN", "with VCR 1 it goes back along the curve");
  } else {
    if (!(modulus > 0)) f.fail("KUN", "expected more than 0 with VCR 0");
    pressure.set("unloading_modulus", std::vector{modulus});
    if (modulus < steepest(curve))
      data.report.understood(
          fmt::format("{} ({}): KUN is less than the steepest slope of its curve, {:.6g}: where the "
                      "way back would lie above the curve, it is the curve",
                      block.star_name(), f.place().text(), steepest(curve)));
  }
  keys.set("equation_of_state", pressure.value(), "eps, p, lcid, kun, pc");
}

}  // namespace pinball
