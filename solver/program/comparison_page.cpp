#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include <solver/output/page/page.hpp>
#include <solver/output/page/resources.hpp>
#include <solver/output/page/units_json.hpp>

#include "comparison_report.hpp"
#include "others/beside_report.hpp"
#include "study/run_results.hpp"

namespace pinball {

namespace {

/// The unit of each column of histories.
std::string units_of_columns(const Curves& curves, const Units& units) {
  nlohmann::json json = nlohmann::json::object();
  for (const std::string& column : curves.columns) json[column] = unit_of_quantity(column, units);
  return json.dump();
}

}  // namespace

std::string comparison_page(const std::vector<VariantRuns>& runs, const std::vector<OtherHistory>& others) {
  const RunSummary& first = runs.front().repeats.front();
  std::string curves, surfaces, keys;
  for (const VariantRuns& variant : runs) {
    curves += (curves.empty() ? '[' : ',') + curves_json(variant.curves);
    surfaces += (surfaces.empty() ? '[' : ',') + variant.surface;
  }
  for (const std::string& setting : runs.front().settings) {
    keys += (keys.empty() ? "" : ", ") + setting.substr(0, setting.find('='));
  }
  for (const OtherHistory& other : others) {
    keys += (keys.empty() ? "beside " : ", ") + std::filesystem::path(other.path).filename().string();
  }
  const bool failed = std::any_of(runs.begin(), runs.end(), [](const VariantRuns& v) { return !v.failure.empty(); });
  const std::string heading = fmt::format("{}: {}", first.title.empty() ? first.scene : first.title, keys);
  PageContent content;
  content.title = fmt::format("{} - comparison", first.scene);
  content.body = fill_template(
      page_resource("comparison.html"),
      {{"scene", html_text(first.scene)}, {"heading", html_text(heading)}, {"status", failed ? "failed" : "done"}});
  content.scripts = scripts_with_viewer({"comparison.js"});
  content.blocks = {{"units", units_json(parse_units(first.units)).dump()},
                    {"comparison", comparison_json(runs, others)},
                    {"other_histories", beside_curves_json(runs, others)},
                    {"curves", curves + ']'},
                    {"column_units", units_of_columns(runs.front().curves, parse_units(first.units))},
                    {"surfaces", surfaces + ']'}};
  return make_page(content);
}

}  // namespace pinball
