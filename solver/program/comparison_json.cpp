#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include <kernels/exec.hpp>
#include <solver/model/stores.hpp>
#include <solver/scene/machine.hpp>
#include <solver/summary.hpp>

#include "comparison_report.hpp"
#include "comparison_times.hpp"
#include "others/beside_report.hpp"

namespace pinball {

namespace {

using Json = nlohmann::ordered_json;

Json spread_json(const Spread& s) { return {{"median", s.median}, {"min", s.smallest}, {"max", s.largest}}; }

Json optional_json(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

Json variant_json(const VariantRuns& variant, const TimeRatios& ratios) {
  Json settings = Json::object();
  for (const std::string& setting : variant.settings) {
    const auto equals = setting.find('=');
    settings[setting.substr(0, equals)] = setting.substr(equals + 1);
  }
  Json repeats = Json::array();
  for (const RunSummary& run : variant.repeats) {
    const Json whole = Json::parse(summary_json(run));
    repeats.push_back({{"wall_seconds", whole["wall_seconds"]}, {"phase_seconds", whole["phase_seconds"]}});
  }
  Json summary = Json::parse(summary_json(variant.repeats.front()));
  for (const char* key : {"wall_seconds", "phase_seconds", "element_steps_per_second", "skipped_seconds"})
    summary.erase(key);
  const VariantTimes times = times_of(variant);
  return {{"settings", settings},
          {"failure", variant.failure.empty() ? Json(nullptr) : Json(variant.failure)},
          {"seconds",
           {{"total", spread_json(times.total)},
            {"contact", spread_json(times.contact)},
            {"contact_surface", spread_json(times.surface)},
            {"contact_search", spread_json(times.search)},
            {"contact_forces", spread_json(times.forces)}}},
          {"contact_share", times.contact_share},
          {"first_over_this", {{"total", optional_json(ratios.total)}, {"contact", optional_json(ratios.contact)}}},
          {"momentum_error", optional_json(variant.momentum_error)},
          {"summary", summary},
          {"repeats", repeats}};
}

}  // namespace

std::string comparison_json(const std::vector<VariantRuns>& runs, const std::vector<OtherHistory>& others) {
  Json variants = Json::array();
  for (const VariantRuns& variant : runs) variants.push_back(variant_json(variant, first_over(runs.front(), variant)));
  const RunSummary& first = runs.front().repeats.front();
  Json json = {
      {"scene", first.scene},
      {"version", first.version},
      {"machine",
       {{"cpu", processor_name()},
        {"threads", first.threads},
        {"simd_width", {{"double", ElementStore::width_in(false)}, {"float", ElementStore::width_in(true)}}}}},
      {"repeats", runs.front().repeats.size()},
      {"variants", variants},
  };
  if (!others.empty()) json["beside"] = beside_json(runs, others);
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace pinball
