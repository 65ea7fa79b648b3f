#include <fmt/format.h>

#include <filesystem>
#include <map>
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

std::string kind_of(const SceneEntry& entry) { return entry.table.substr(0, entry.table.find('.')); }

/// A deck may have a load, or a stress, for each of a million nodes or elements: of each kind of table the first.
Json keys_json(const Scene& scene, const Units& units) {
  constexpr std::size_t most_of_kind = 20'000;
  Json keys = Json::array();
  std::map<std::string, std::size_t> counts;
  for (const SceneEntry& entry : list_scene(scene)) {
    if (++counts[kind_of(entry)] > most_of_kind) continue;
    const std::string name = entry.table.empty() ? entry.key : entry.table + '.' + entry.key;
    keys.push_back({name, entry.value, unit_of(entry.unit, units), entry.is_default});
  }
  for (const auto& [kind, count] : counts) {
    if (count > most_of_kind) keys.push_back({kind, fmt::format("and {} keys more", count - most_of_kind), "", false});
  }
  return keys;
}

/// What a browser shows at once; cut at the end of a line.
std::string beginning_of(std::string text) {
  constexpr std::size_t most = 1'000'000;
  if (text.size() <= most) return text;
  const std::size_t size = text.size();
  text.resize(text.find_last_of('\n', most) == std::string::npos ? most : text.find_last_of('\n', most) + 1);
  return text + fmt::format("# ... and {} characters more", size - text.size());
}

Json scene_json(const Scene& scene, const Units& units, const RunPageSettings& settings, const RunSummary& summary) {
  Json json{{"keys", keys_json(scene, units)}};
  if (settings.source != nullptr) {
    json["path"] = settings.source->path;
    json["text"] =
        beginning_of(settings.source->given ? write_toml(settings.source->given->table) : settings.source->text);
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
