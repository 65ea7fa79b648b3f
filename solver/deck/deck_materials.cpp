#include <fmt/format.h>

#include <algorithm>

#include "deck_parts.hpp"
#include "keyword_rules.hpp"

namespace pinball {

namespace {

bool is_used(const DeckData& data, std::int64_t material) {
  return std::ranges::any_of(data.parts, [material](const DeckPart& part) { return part.material == material; });
}

void write_head(std::int64_t id, const std::string& title, bool plastic, const Fields& f, TomlText& scene) {
  scene.entry("material", title);
  scene.key("name", fmt::format("mat_{}", id));
  scene.key("model", plastic ? "von_mises" : "elastic");
  scene.key("density", f.number(1, "ro"));
  scene.key("young_modulus", f.number(2, "e"));
  scene.key("poisson_ratio", f.number(3, "pr"));
}

/// E Et/(E - Et): slope over the plastic strain.
double plastic_modulus(const Fields& f, double tangent) {
  const double young = f.number(2, "e");
  if (tangent >= young)
    fail_at(f.place(), fmt::format("etan: expected less than E = {:.6g}, got {:.6g}", young, tangent));
  return young * tangent / (young - tangent);
}

void write_rate(const Fields& f, double constant, double exponent, int vp, TomlText& scene) {
  if (vp != 0 && vp != 1 && vp != -1) fail_at(f.place(), fmt::format("vp: expected 0, 1 or -1, got {}", vp));
  if (constant == 0 || exponent == 0) return;
  scene.key("rate_constant", constant);
  scene.key("rate_exponent", exponent);
  scene.key("strain_rate", vp == 1 ? "plastic" : vp == -1 ? "deviatoric" : "total");
}

/// *MAT_003
void write_plastic_kinematic(DeckData& data, const Fields& f, Cards& cards, TomlText& scene) {
  const Card card = cards.next_or_blank();
  const Fields more = data.fields(card);
  scene.key("yield_stress", f.number(4, "sigy"));
  scene.key("plastic_modulus", plastic_modulus(f, f.number(5, "etan", 0.0)));
  const double beta = f.number(6, "beta", 0.0);
  if (beta < 0 || beta > 1) fail_at(f.place(), fmt::format("beta: expected 0 to 1, got {}", beta));
  scene.key("isotropic_share", beta);
  write_rate(more, more.number(0, "src", 0.0), more.number(1, "srp", 0.0), static_cast<int>(more.integer(3, "vp", 0)),
             scene);
  const double failure = more.number(2, "fs", 0.0);
  if (failure > 0 && failure < 1e19) scene.key("erosion_strain", failure);
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

std::vector<double> card_of_numbers(const DeckData& data, Cards& cards) {
  const Card card = cards.next_or_blank();
  const Fields f = data.fields(card);
  std::vector<double> values;
  for (std::size_t i = 0; i < 8; ++i) values.push_back(f.number(i, "value", 0.0));
  return values;
}

/// Curves over the rate: of a table; or the static curve times what a curve gives for each rate.
void write_rate_curves(DeckData& data, const Fields& f, std::int64_t lcss, std::int64_t lcsr, TomlText& scene) {
  std::vector<std::string> curves;
  const auto* table = data.table(lcss);
  if (table != nullptr) {
    const bool logarithmic = !table->empty() && table->front().first < 0;
    for (const auto& [rate, id] : *table) {
      curves.push_back(curve_text(data.curve(id, f.place()), f.place(), 1.0, logarithmic ? std::exp(rate) : rate));
    }
    if (logarithmic) scene.key("rate_interpolation", "logarithmic");
  } else {
    const DeckCurve& factors = data.curve(lcsr, f.place());
    for (std::size_t i = 0; i < factors.abscissa.size(); ++i) {
      curves.push_back(curve_text(data.curve(lcss, f.place()), f.place(), factors.ordinate[i], factors.abscissa[i]));
    }
  }
  scene.raw("yield_curves", fmt::format("[{}]", fmt::join(curves, ", ")));
}

/// *MAT_024
void write_piecewise_linear(DeckData& data, const KeywordBlock& block, const Fields& f, Cards& cards, TomlText& scene) {
  const Card card = cards.next_or_blank();
  const Fields rate = data.fields(card);
  const auto to_curve = [&](std::int64_t id) { return id == 0 ? 0 : id + offset_of(block, &DeckTransform::define); };
  const std::int64_t lcss = to_curve(rate.integer(2, "lcss", 0)), lcsr = to_curve(rate.integer(3, "lcsr", 0));
  const std::vector<double> eps = card_of_numbers(data, cards), es = card_of_numbers(data, cards);
  const auto vp = static_cast<int>(rate.integer(4, "vp", 0));
  const bool points = std::ranges::any_of(es, [](double value) { return value != 0; });
  if (data.table(lcss) != nullptr || (lcss != 0 && lcsr != 0)) {
    write_rate_curves(data, f, lcss, lcsr, scene);
    if (vp != 0) scene.key("strain_rate", vp == 1 ? "plastic" : "deviatoric");
  } else if (lcss != 0) {
    scene.raw("yield_curve", curve_text(data.curve(lcss, f.place()), f.place()));
  } else if (points) {
    DeckCurve curve;
    for (std::size_t i = 0; i < eps.size(); ++i) {
      if (i > 0 && eps[i] <= eps[i - 1]) break;
      curve.abscissa.push_back(eps[i]);
      curve.ordinate.push_back(es[i]);
    }
    scene.raw("yield_curve", curve_text(curve, f.place()));
  } else {
    scene.key("yield_stress", f.number(4, "sigy"));
    scene.key("plastic_modulus", plastic_modulus(f, f.number(5, "etan", 0.0)));
  }
  if (lcsr != 0 && lcss == 0) data.report.refuse(rate.place(), "*MAT_024 with LCSR and without LCSS");
  write_rate(rate, rate.number(0, "c", 0.0), rate.number(1, "p", 0.0), vp, scene);
  const double failure = f.number(6, "fail", 0.0);
  if (failure < 0) data.report.refuse(f.place(), "*MAT_024 with a failure that the user programs (FAIL < 0)");
  if (failure > 0 && failure < 1e19) scene.key("erosion_strain", failure);
  if (f.number(7, "tdel", 0.0) != 0)
    data.report.understood(fmt::format("{}: TDEL (failure by the time step) is not used", f.place().text()));
}

}  // namespace

void translate_material(DeckData& data, const KeywordBlock& block, TomlText& scene) {
  Cards cards(block);
  const std::string title = block.title ? std::string(trimmed(cards.require("a title").text)) : "";
  const Card card = cards.require("the constants of the material");
  const Fields f = data.fields(card);
  const std::int64_t id = f.integer(0, "mid") + offset_of(block, &DeckTransform::material);
  if (!is_used(data, id)) return;
  const std::string kind = keyword_alias(block.name);
  write_head(id, title, kind != "MAT_ELASTIC", f, scene);
  if (kind == "MAT_PLASTIC_KINEMATIC") write_plastic_kinematic(data, f, cards, scene);
  if (kind == "MAT_PIECEWISE_LINEAR_PLASTICITY") write_piecewise_linear(data, block, f, cards, scene);
}

void translate_parts(DeckData& data, const std::string& mesh_file, TomlText& scene) {
  for (const DeckPart& part : data.parts) {
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
        data.report.refuse(part.place, fmt::format("*SECTION_SOLID with ELFORM {}", form->second));
    }
    scene.entry("body");
    scene.key("name", part.body);
    scene.key("material", fmt::format("mat_{}", part.material));
    scene.raw("mesh", fmt::format("{{ type = \"keyword\", file = {}, part = \"{}\" }}", toml(mesh_file), part.id));
  }
}

}  // namespace pinball
