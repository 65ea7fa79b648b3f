#include <fmt/format.h>

#include <algorithm>

#include <solver/formats/lsdyna/layouts/definition_cards.hpp>

#include "deck_parts.hpp"
#include "keyword_rules.hpp"

namespace pinball {

namespace {

void write_head(std::int64_t id, const std::string& title, const KeywordBlock& block, const Fields& f,
                TomlText& scene) {
  const bool plastic = keyword_alias(block.name) != "MAT_ELASTIC";
  scene.entry("material", title);
  scene.from(block.star_name(), f.place().text());
  scene.key("name", fmt::format("mat_{}", id));
  scene.key("model", plastic ? "von_mises" : "elastic");
  scene.key("density", f.number("RO"));
  scene.key("young_modulus", f.number("E"));
  scene.key("poisson_ratio", f.number("PR"));
}

const CardLayout& layout_of(const KeywordBlock& block) {
  const std::string kind = keyword_alias(block.name);
  if (kind == "MAT_ELASTIC") return layout::elastic;
  return kind == "MAT_PLASTIC_KINEMATIC" ? layout::kinematic : layout::piecewise;
}

/// Fields that have a value and no effect are told.
void not_used(DeckData& data, const KeywordBlock& block, const Fields& f, std::string_view fields, const char* reason) {
  data.report.unused(f.place(), fmt::format("{}: {}", block.star_name(), fields), reason);
}

double yield_stress(const Fields& f) {
  if (f.blank("SIGY")) f.fail("SIGY", "expected a number, got nothing");
  return f.number("SIGY");
}

/// E Et/(E - Et): slope over the plastic strain.
double plastic_modulus(const Fields& f) {
  const double young = f.number("E"), tangent = f.number("ETAN");
  if (tangent >= young) f.fail("ETAN", fmt::format("expected less than E = {:.6g}, got {:.6g}", young, tangent));
  return young * tangent / (young - tangent);
}

struct DeckRate {
  double constant = 0, exponent = 0;  ///< C and P; 0: no such law
  int vp = 0;                         ///< VP

  DeckRate(const Fields& f, const char* constant_name, const char* exponent_name)
      : constant(f.number(constant_name)), exponent(f.number(exponent_name)), vp(static_cast<int>(f.integer("VP"))) {}
  bool is_law() const { return constant != 0 && exponent != 0; }
};

void write_strain_rate(const DeckRate& rate, TomlText& scene) {
  scene.key("strain_rate", rate.vp == 1 ? "plastic" : rate.vp == -1 ? "deviatoric" : "total");
}

/// Cowper and Symonds.
void write_rate(DeckData& data, const KeywordBlock& block, const Fields& f, const DeckRate& rate, TomlText& scene) {
  if (!rate.is_law() && (rate.constant != 0 || rate.exponent != 0))
    not_used(data, block, f, rate.constant != 0 ? f.name(0) : f.name(1),
             "a law of the strain rate has both of its constants");
  if (!rate.is_law()) return;
  scene.key("rate_constant", rate.constant);
  scene.key("rate_exponent", rate.exponent);
  write_strain_rate(rate, scene);
}

void write_failure(const Fields& f, const char* name, TomlText& scene) {
  const double strain = f.number(name);
  if (strain < 0) f.fail(name, fmt::format("expected a strain >= 0, got {}", strain));
  if (strain > 0 && strain < 1e19) scene.key("erosion_strain", strain);
}

/// *MAT_003
void write_plastic_kinematic(DeckData& data, const KeywordBlock& block, const Fields& f, Cards& cards,
                             TomlText& scene) {
  const Card card = cards.next_or_blank();
  const Fields more = data.fields(card, layout::kinematic_rate);
  scene.key("yield_stress", yield_stress(f));
  scene.key("plastic_modulus", plastic_modulus(f));
  scene.key("isotropic_share", f.number("BETA"));
  write_rate(data, block, more, DeckRate(more, "SRC", "SRP"), scene);
  write_failure(more, "FS", scene);
}

std::string curve_text(const DeckCurve& curve, const DeckPlace& place, double factor = 1.0, double rate = -1.0) {
  std::vector<double> strain = curve.abscissa, stress = curve.ordinate;
  if (strain.front() > 0) {  // a curve begins at zero strain with its first stress
    strain.insert(strain.begin(), 0.0);
    stress.insert(stress.begin(), stress.front());
  }
  if (strain.front() < 0) fail_at(place, "yield stresses over plastic strain: expected no strain below 0");
  for (double& value : stress) value *= factor;
  return fmt::format("{{ {}plastic_strain = {}, stress = {} }}", rate < 0 ? "" : fmt::format("rate = {}, ", toml(rate)),
                     toml(strain), toml(stress));
}

std::vector<double> card_of_numbers(const DeckData& data, Cards& cards, const CardLayout& layout) {
  const Card card = cards.next_or_blank();
  const Fields f = data.fields(card, layout);
  std::vector<double> values;
  for (std::size_t i = 0; i < layout.size(); ++i) values.push_back(f.number(i));
  return values;
}

/// A table: a curve for each rate.
void write_table(DeckData& data, const Fields& f, std::int64_t lcss, TomlText& scene) {
  const DeckTable& table = *data.table(lcss);
  std::vector<std::string> curves;
  for (const auto& [rate, id] : table.curves) {
    curves.push_back(curve_text(data.yield_curve(id, f.place()), f.place(), 1.0, rate));
  }
  if (table.logarithmic) scene.key("rate_interpolation", "logarithmic");
  scene.raw("yield_curves", fmt::format("[{}]", fmt::join(curves, ", ")));
}

/// LCSR: the static curve times what that curve gives for each rate.
void write_scaled_curves(const DeckCurve& factors, const DeckCurve& curve, const Fields& f, TomlText& scene) {
  std::vector<std::string> curves;
  for (std::size_t i = 0; i < factors.abscissa.size(); ++i) {
    curves.push_back(curve_text(curve, f.place(), factors.ordinate[i], factors.abscissa[i]));
  }
  scene.raw("yield_curves", fmt::format("[{}]", fmt::join(curves, ", ")));
}

/// EPS1 to EPS8 and ES1 to ES8: as many as ascend, in the units of the deck; none: all stresses are blank.
std::optional<DeckCurve> curve_of_points(const std::vector<double>& eps, const std::vector<double>& es,
                                         const DeckPlace& place) {
  const auto given = [](double value) { return value != 0; };
  if (std::ranges::none_of(es, given)) return {};
  DeckCurve curve;
  std::size_t i = 0;
  for (; i < eps.size() && (i == 0 || eps[i] > eps[i - 1]); ++i) {
    curve.abscissa.push_back(eps[i]);
    curve.ordinate.push_back(es[i]);
  }
  if (std::any_of(eps.begin() + static_cast<std::ptrdiff_t>(i), eps.end(), given) ||
      std::any_of(es.begin() + static_cast<std::ptrdiff_t>(i), es.end(), given))
    fail_at(place, fmt::format("eps1 to eps8: expected ascending strains, got {} after {}", eps[i], eps[i - 1]));
  return curve;
}

/// SIGY and ETAN as a curve, whose slope goes on.
DeckCurve linear_curve(const Fields& f) {
  const double yield = yield_stress(f);
  return {{0, 1}, {yield, yield + plastic_modulus(f)}};
}

/// *MAT_024. Of several forms of hardening LCSS counts before EPS and ES, and these before SIGY and ETAN.
void write_piecewise_linear(DeckData& data, const KeywordBlock& block, const Fields& f, Cards& cards, TomlText& scene) {
  const Card card = cards.next_or_blank();
  const Fields second = data.fields(card, layout::piecewise_rate);
  const auto to_curve = [&](std::int64_t id) { return id == 0 ? 0 : id + offset_of(block, &DeckTransform::define); };
  const std::int64_t lcss = to_curve(second.integer("LCSS")), lcsr = to_curve(second.integer("LCSR"));
  const std::vector<double> eps = card_of_numbers(data, cards, layout::piecewise_strains),
                            es = card_of_numbers(data, cards, layout::piecewise_stresses);
  const auto points = curve_of_points(eps, es, f.place());
  if (!points && std::ranges::any_of(eps, [](double strain) { return strain != 0; }))
    not_used(data, block, f, "EPS1 to EPS8", "they have no stresses ES1 to ES8");
  const DeckRate rate(second, "C", "P");
  const bool is_table = data.table(lcss) != nullptr, by_curves = is_table || lcsr != 0;
  if (lcss != 0 && points) not_used(data, block, f, "EPS1 to EPS8, ES1 to ES8", "LCSS is used");
  if ((lcss != 0 || points) && f.number("ETAN") != 0)
    not_used(data, block, f, "ETAN", "hardening is that of the curve");
  if (is_table && lcsr != 0)
    data.report.refuse(f.place(), "*MAT_024 with a table (LCSS) and with LCSR", "give one of both");
  if (by_curves && rate.is_law())
    data.report.refuse(f.place(), "*MAT_024 with curves of the strain rate (LCSS, LCSR) and with C and P",
                       "give one of both");
  if (is_table) {
    write_table(data, f, lcss, scene);
  } else if (lcsr != 0) {
    const DeckCurve curve = lcss != 0 ? data.yield_curve(lcss, f.place()) : points ? *points : linear_curve(f);
    write_scaled_curves(data.rate_curve(lcsr, f.place()), curve, f, scene);
  } else if (lcss != 0) {
    scene.raw("yield_curve", curve_text(data.yield_curve(lcss, f.place()), f.place()));
  } else if (points) {
    scene.raw("yield_curve", curve_text(*points, f.place()));
  } else {
    scene.key("yield_stress", yield_stress(f));
    scene.key("plastic_modulus", plastic_modulus(f));
  }
  if (by_curves) {
    write_strain_rate(rate, scene);
  } else {
    write_rate(data, block, second, rate, scene);
    // VP = 1: the law adds a multiple of SIGY; without SIGY, and with other VP, one of the static yield stress.
    if (rate.is_law() && rate.vp == 1 && f.number("SIGY") > 0) scene.key("rate_stress", yield_stress(f));
  }
  if (f.number("FAIL") < 0) {
    data.report.refuse(f.place(), "*MAT_024 with a failure that the user programs (FAIL < 0)", "give a strain");
  } else {
    write_failure(f, "FAIL", scene);
  }
}

}  // namespace

std::int64_t material_number(const DeckData& data, const KeywordBlock& block) {
  Cards cards(block);
  if (block.title) cards.next();
  const Card card = cards.require("the constants of the material");
  return data.fields(card, layout_of(block)).integer("MID") + offset_of(block, &DeckTransform::material);
}

void translate_material(DeckData& data, const KeywordBlock& block, TomlText& scene) {
  Cards cards(block);
  const std::string title = block.title ? std::string(trimmed(cards.require("a title").text)) : "";
  const Card card = cards.require("the constants of the material");
  const Fields f = data.fields(card, layout_of(block));
  const std::int64_t id = material_number(data, block);
  if (!data.is_used(id)) {
    data.report.unused(block.place,
                       fmt::format("{}, material {}, which no part with solids has", block.star_name(), id));
    if (block.log != nullptr) block.log->done(&block);
    return;
  }
  const std::string kind = keyword_alias(block.name);
  write_head(id, title, block, f, scene);
  if (kind == "MAT_PLASTIC_KINEMATIC") write_plastic_kinematic(data, block, f, cards, scene);
  if (kind == "MAT_PIECEWISE_LINEAR_PLASTICITY") write_piecewise_linear(data, block, f, cards, scene);
}

void translate_parts(DeckData& data, const std::string& mesh, TomlText& scene) {
  for (std::size_t p = 0; p < data.parts.size(); ++p) {
    const DeckPart& part = data.parts[p];
    const auto form = data.section_form.find(part.section);
    if (form == data.section_form.end())
      fail_at(part.place, fmt::format("no *SECTION_SOLID has the number {}", part.section));
    switch (form->second) {
      case 0:
      case 1:
        break;
      case 2:
      case -1:
      case -2:
        data.report.understood(fmt::format(
            "part {}: ELFORM {}, full integration: elements of assumed strain in its place", part.id, form->second));
        break;
      default:
        data.report.refuse(part.place, fmt::format("*SECTION_SOLID with ELFORM {}", form->second), "give 1 or 2",
                           static_cast<int>(part.solids));
    }
    scene.entry("body");
    scene.from("*PART", part.place.text());
    scene.key("name", part.body);
    scene.key("material", fmt::format("mat_{}", part.material));
    scene.raw("mesh", fmt::format("{{ type = \"keyword\", {}, part = \"{}\" }}", mesh, part.id));
    if (data.part_elements[p] != data.part_elements.front()) write_body_element(data.part_elements[p], scene);
  }
}

}  // namespace pinball
