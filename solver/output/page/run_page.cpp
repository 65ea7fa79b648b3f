#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include <solver/output/output_file.hpp>
#include <solver/output/run_files.hpp>
#include <solver/results/energy_checks.hpp>
#include <solver/run_page.hpp>
#include <solver/scene/given/given_scene.hpp>
#include <solver/scene/given/toml_file.hpp>
#include <solver/scene/toml/listing.hpp>
#include <solver/scene/units/units.hpp>
#include <solver/scene_rules.hpp>
#include <solver/summary.hpp>

#include "curves.hpp"
#include "page.hpp"
#include "resources.hpp"
#include "surface/surface_block.hpp"
#include "units_json.hpp"

namespace pinball {

namespace {

using Json = nlohmann::ordered_json;

/// As a shell takes it.
std::string quoted(const std::string& word) {
  const char* const plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./=,+:@%";
  if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) return word;
  std::string text = "'";
  for (const char c : word) {
    if (c == '\'') {
      text += "'\\''";
    } else {
      text += c;
    }
  }
  return text + '\'';
}

std::string command_of(const SceneSource& source, const RunSummary& summary) {
  const SceneOverrides& overrides = source.overrides;
  const bool is_deck = source.given && !source.given->file.empty();
  const std::filesystem::path path(source.path);
  std::string command =
      "pinball run " + quoted(is_deck ? (path.parent_path() / source.given->file).string() : source.path);
  if (is_deck) {
    for (const std::string& option : source.given->options) command += ' ' + quoted(option);
  }
  for (const std::string& set : overrides.set) command += " --set " + quoted(set);
  for (const std::string& vary : overrides.vary) command += " --set " + quoted(vary);
  if (overrides.refine != 1) command += fmt::format(" --refine {}", overrides.refine);
  if (overrides.precision) command += " --precision " + summary.precision;
  if (summary.device != "none") command += " --device " + summary.device;
  return command + fmt::format(" --threads {}", summary.threads);
}

Json scene_json(const Scene& scene, const Units& units, const RunPageSettings& settings, const RunSummary& summary) {
  Json keys = Json::array();
  for (const SceneEntry& entry : list_scene(scene)) {
    const std::string name = entry.table.empty() ? entry.key : entry.table + '.' + entry.key;
    keys.push_back({name, entry.value, unit_of(entry.unit, units), entry.is_default});
  }
  Json json{{"keys", keys}};
  if (settings.source != nullptr) {
    json["path"] = settings.source->path;
    json["text"] = settings.source->given ? write_toml(settings.source->given->table) : settings.source->text;
    json["command"] = command_of(*settings.source, summary);
  }
  return json;
}

/// What the energies of a sound run keep to, and where this one does not.
Json checks_json(const RunSummary& summary) {
  Json checks = Json::array();
  for (const EnergyCheck& check : energy_checks(summary)) {
    checks.push_back({{"what", check.what},
                      {"share", check.share},
                      {"bound", check.bound},
                      {"warning", check.sound() ? Json(nullptr) : Json(check.warning)}});
  }
  return checks;
}

std::string compact(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

}  // namespace

void write_run_page(const std::string& folder, const Scene& scene, const RunSummary& summary,
                    const RunPageSettings& settings) {
  Curves curves = read_history(in_folder(folder, history_name));
  thin(curves, most_rows_of_page);
  const Units units = parse_units(summary.units);
  const bool failed = !settings.error.empty();
  const char* const status = failed ? "failed" : summary.status == RunStatus::stopped ? "stopped" : "done";
  const std::string title = summary.title.empty() ? summary.scene : summary.title;
  PageContent content;
  content.title = fmt::format("{} - {}", summary.scene, failed ? "failed run" : "run");
  content.body = fill_template(
      page_resource("run.html"),
      {{"heading", html_text(title)},
       {"scene", html_text(summary.scene)},
       {"status", status},
       {"error", failed ? fmt::format("<p class=\"error\" role=\"alert\">{}</p>", html_text(settings.error)) : ""}});
  content.scripts = scripts_with_viewer({"pictures.js", "energies.js", "run.js"});
  content.blocks = {{"units", compact(units_json(units))},
                    {"summary", summary_json(summary)},
                    {"checks", compact(checks_json(summary))},
                    {"converged", settings.converged.empty() ? "null" : settings.converged},
                    {"history", curves_json(curves)},
                    {"surface", surface_json_of_run(folder, names_of(scene.bodies), settings.last, settings.base)},
                    {"scene", compact(scene_json(scene, units, settings, summary))}};
  make_folder(folder);
  OutputFile file(in_folder(folder, page_name));
  file.write(make_page(content));
  file.commit();
}

}  // namespace pinball
