#include "kept_bands.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <nlohmann/json.hpp>

#include <solver/base/state_hash.hpp>
#include <solver/base/version.h>
#include <solver/program/study/convergence_report.hpp>
#include <solver/program/study/sources_report.hpp>

namespace pinball {

namespace {

using OrderedJson = nlohmann::ordered_json;

std::string hash_of_settings(const Scene& scene) {
  const std::string text = study_settings_text(scene);
  StateHash hash;
  hash.add(text.data(), text.size());
  return fmt::format("{:016x}", hash.value());
}

/// error: of the value, by all sources together.
OrderedJson band_json(const StudyQuantity& quantity, double value, double error) {
  const GridConvergence& c = *quantity.convergence;
  return {
      {"name", quantity.name},          {"unit", quantity.unit}, {"value", value}, {"error", error},
      {"extrapolated", c.extrapolated}, {"low", c.low},          {"high", c.high}, {"verdict", verdict_word(quantity)}};
}

/// Whether a file holds what kept_bands_json writes.
bool is_kept_bands(const OrderedJson& json) {
  if (!json.is_object() || !json.contains("settings") || !json["settings"].is_string()) return false;
  if (!json.contains("quantities") || !json["quantities"].is_array()) return false;
  const auto is_band = [](const OrderedJson& q) {
    const auto all_are = [&q](std::initializer_list<const char*> names, bool (OrderedJson::*is)() const noexcept) {
      return std::all_of(names.begin(), names.end(),
                         [&](const char* name) { return q.contains(name) && (q[name].*is)(); });
    };
    return q.is_object() && all_are({"name", "unit", "verdict"}, &OrderedJson::is_string) &&
           all_are({"value", "error", "extrapolated", "low", "high"}, &OrderedJson::is_number);
  };
  const auto& quantities = json["quantities"];
  return std::all_of(quantities.begin(), quantities.end(), is_band);
}

}  // namespace

std::string kept_bands_path(const std::string& scene_path) {
  return std::filesystem::path(scene_path).replace_extension(".converged.json").string();
}

std::string kept_bands_json(const ConvergenceStudy& study, const Scene& scene) {
  OrderedJson quantities = OrderedJson::array();
  const auto own = study.own_mesh();
  for (const StudyQuantity& quantity : study.quantities) {
    const auto error = own == study.sources_mesh ? error_together(study, quantity) : std::nullopt;
    if (error) quantities.push_back(band_json(quantity, *quantity.values[*own], *error));
  }
  const OrderedJson json = {{"scene", study.scene},
                            {"version", PINBALL_VERSION},
                            {"settings", hash_of_settings(scene)},
                            {"quantities", quantities}};
  return json.dump(2, ' ', false, OrderedJson::error_handler_t::replace) + '\n';
}

std::string kept_bands_of(const std::string& scene_path, const Scene& scene, std::string& note) {
  const std::string path = kept_bands_path(scene_path);
  std::ifstream file(path);
  if (!file) return "";
  const OrderedJson json = OrderedJson::parse(file, nullptr, false);
  const bool sound = is_kept_bands(json);
  if (sound && json["settings"] == hash_of_settings(scene)) return json["quantities"].dump();
  note = fmt::format("{} is {}: no bands are shown; pinball converge --keep writes it anew", path,
                     sound ? "of other settings, or another version" : "no file of bands");
  return "";
}

std::string kept_bands_text(const std::string& quantities) {
  std::string text;
  for (const OrderedJson& q : OrderedJson::parse(quantities)) {
    const std::string name = q["name"], unit = q["unit"];
    text += fmt::format("  {}{}: {:.6g} +- {:.2g}, with finer meshes {:.6g} .. {:.6g}\n", name,
                        unit.empty() ? "" : " [" + unit + "]", q["value"].get<double>(), q["error"].get<double>(),
                        q["low"].get<double>(), q["high"].get<double>());
  }
  return text;
}

}  // namespace pinball
