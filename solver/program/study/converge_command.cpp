#include <fmt/core.h>

#include <algorithm>
#include <cstdio>

#include <solver/base/error.hpp>
#include <solver/device/devices.hpp>
#include <solver/output/message.hpp>
#include <solver/program/commands.hpp>
#include <solver/program/result_file.hpp>
#include <solver/program/scene_input.hpp>
#include <solver/program/stop_signals.hpp>

#include "bands/kept_bands.hpp"
#include "convergence_report.hpp"

namespace pinball {

namespace {

constexpr double search_seconds = 600;  ///< for a search whose user says none

/// What each run has been warned of, once for all meshes that were.
void print_study_warnings(const ConvergenceStudy& study) {
  for (const StudyMesh& mesh : study.meshes) {
    if (!mesh.run.results) continue;
    for (const std::string& warning : mesh.run.results->warnings) {
      print_message(fmt::format("warning: mesh {}: {}", mesh.factor.text(), warning));
    }
  }
}

/// Those that --only leaves: "mesh" stands for none of them.
std::vector<ErrorSource> sources_of(const std::vector<std::string>& only) {
  std::vector<ErrorSource> sources;
  for (const auto& [name, source] : {std::pair{"step", ErrorSource::step},
                                     {"precision", ErrorSource::precision},
                                     {"hourglass", ErrorSource::hourglass},
                                     {"contact", ErrorSource::contact},
                                     {"chance", ErrorSource::chance}}) {
    if (only.empty() || std::find(only.begin(), only.end(), name) != only.end()) sources.push_back(source);
  }
  return sources;
}

void write_files(const ConvergenceStudy& study, const ConvergeOptions& options) {
  if (!options.json.empty()) write_result_file(options.json, convergence_json(study));
  if (!options.csv.empty()) write_result_file(options.csv, convergence_csv(study));
  if (!options.page.empty()) write_convergence_page(study, options.page);
}

/// Takes "2" to the options of all commands and leaves the bodies.
std::vector<RefinedBody> bodies_to_refine(ConvergeOptions& options) {
  std::vector<RefinedBody> bodies;
  for (const std::string& text : options.refine) {
    if (text.find('=') == std::string::npos) {
      options.overrides.refine = parse_refined_body("all=" + text).times;
    } else {
      bodies.push_back(parse_refined_body(text));
    }
  }
  return bodies;
}

StudyLimits limits_of(const ConvergeOptions& options) {
  StudyLimits limits;
  if (!options.error.empty()) {
    if (options.of.empty()) throw InputError("--error: expected --of QUANTITY, which number is to be so good");
    limits = {parse_error_share(options.error), search_seconds};
  }
  if (!options.budget.empty()) limits.seconds = parse_budget(options.budget);
  return limits;
}

}  // namespace

int converge_command(const ConvergeOptions& given) {
  ConvergeOptions options = given;
  const std::vector<RefinedBody> bodies = bodies_to_refine(options);
  require_device(options.device);
  check_result_path("--json", options.json);
  check_result_path("--csv", options.csv);
  check_result_path("--page", options.page);
  const std::string kept = options.keep ? kept_bands_path(path_of_scene(options.scene)) : "";
  check_result_path("--keep", kept);
  const SceneInput input = scene_input(options);
  Scene scene = input.read();
  scene.device = options.device;
  StudySettings settings;
  settings.factors = options.meshes.empty() ? default_mesh_factors(scene) : parse_mesh_factors(options.meshes);
  settings.of = options.of;
  settings.folder = {options.out.empty() ? "out/converge_" + scene.name : options.out, options.threads, options.quiet};
  settings.sources = sources_of(options.only);
  settings.ensemble = options.ensemble;
  settings.limits = limits_of(options);
  settings.bodies = bodies;
  const ConvergenceStudy study = study_convergence(scene, settings);
  if (study.stopped()) {
    print_message(fmt::format("stopped; what is done stays in {}, the same command goes on", settings.folder.out));
    return 128 + stop_signal();
  }
  write_files(study, options);
  if (options.keep) write_result_file(kept, kept_bands_json(study, scene));
  fmt::print("{}", convergence_text(study));
  std::fflush(stdout);  // before the warnings, in a log that both go to
  print_study_warnings(study);
  return study.failed() ? 1 : 0;
}

}  // namespace pinball
