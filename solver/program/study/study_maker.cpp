#include "study_maker.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <future>

#include <solver/base/error.hpp>
#include <solver/base/thread_count.hpp>
#include <solver/program/shown_states.hpp>
#include <solver/scene_rules.hpp>

#include "costs/run_times.hpp"
#include "quantities.hpp"
#include "study_quantities.hpp"

namespace pinball {

namespace {

constexpr double largest_side_by_side = 4e6;  ///< elements of all runs that go side by side: some 4 GB
constexpr double half_steps = 2;              ///< times as many of them, as long as no run has shown it

std::string folder_of(const MeshFactor& factor) {
  std::string name = "mesh_" + factor.text();
  std::replace(name.begin(), name.end(), '/', '_');
  return name;
}

bool came_to_its_end(const StudyMesh& mesh) { return mesh.run.results.has_value(); }

double number_of(const StudyRun& run, const char* key) { return run.results->value(key).value_or(0); }

/// Of one thread: as if all of several were busy all the time.
double work_of(const StudyRun& run) { return run.results->seconds() * std::max(1.0, number_of(run, "threads")); }

RunTimes times_of(const ConvergenceStudy& study) {
  std::vector<MadeRun> made;
  for (const StudyMesh& mesh : study.meshes) {
    if (!came_to_its_end(mesh)) continue;
    made.push_back(
        {mesh.factor.value(), number_of(mesh.run, "elements"), number_of(mesh.run, "steps"), work_of(mesh.run)});
  }
  return RunTimes(std::move(made));
}

}  // namespace

StudyMaker::StudyMaker(const Scene& scene, const StudySettings& settings)
    : scene_(scene), settings_(settings), budget_(settings.limits), folder_(settings.folder) {
  if (settings.limits.seconds) folder_.budget = &budget_;
  study_.scene = scene.name;
  study_.title = scene.title;
  study_.units = scene.units;
  study_.bodies = names_of(scene.bodies);
  study_.limits = settings.limits;
}

StudyRun StudyMaker::run(const Scene& scene, const std::string& name, const std::string& what,
                         const StudyFolder& folder, std::optional<double> expected) {
  try {
    return make_study_run(scene, name, what, folder, expected);
  } catch (const InputError& error) {  // not with this scene
    StudyRun failed;
    failed.failure = error.what();
    return failed;
  }
}

void StudyMaker::run_mesh(const MeshFactor& factor) {
  const Scene refined = refined_by(scene_, factor);
  const std::string counts = element_counts(refined);
  const auto asked = std::find(settings_.factors.begin(), settings_.factors.end(), factor);
  const bool is_asked = asked != settings_.factors.end();
  const std::string which =
      is_asked ? fmt::format("mesh {} of {}", asked - settings_.factors.begin() + 1, settings_.factors.size())
               : "one more mesh";
  const auto place = std::find_if(study_.meshes.begin(), study_.meshes.end(),
                                  [&factor](const StudyMesh& mesh) { return mesh.factor.value() > factor.value(); });
  const bool is_before_sources = place - study_.meshes.begin() <= static_cast<std::ptrdiff_t>(study_.sources_mesh);
  if (has_sources_mesh_ && is_before_sources) ++study_.sources_mesh;
  const std::string what = fmt::format("{}, elements {} times: {}", which, factor.text(), counts);
  const auto expected = expected_seconds(factor);
  StudyFolder shown = folder_;  // the coarsest and the finest are
  shown.states = states_to_show(refined, factor);
  const StudyRun made = is_asked ? make_study_run(refined, folder_of(factor), what, shown, expected)
                                 : run(refined, folder_of(factor), what, shown, expected);
  study_.meshes.insert(place, {factor, counts, made});
  if (made.results) require_quantities(settings_.of, *made.results);
}

int StudyMaker::states_to_show(const Scene& refined, const MeshFactor& factor) const {
  auto elements = times_of(study_).elements(factor.value());
  if (!elements) elements = study_results_to_come(refined, folder_).value("elements");
  return elements.value_or(0) > static_cast<double>(most_elements_shown) ? 1 : shown_states;
}

void StudyMaker::run_sources() {
  const auto own = study_.own_mesh();
  const auto first = std::find_if(study_.meshes.begin(), study_.meshes.end(), came_to_its_end);
  if (first == study_.meshes.end()) return;
  has_sources_mesh_ = true;
  study_.sources_mesh = own && came_to_its_end(study_.meshes[*own]) ? *own : (first - study_.meshes.begin());
  const Scene refined = refined_by(scene_, study_.meshes[study_.sources_mesh].factor);
  std::vector<ErrorSource> sources = settings_.sources;
  const bool touched = number_of(study_.meshes[study_.sources_mesh].run, "contact.pairs_max") > 0;
  if (!touched) std::erase(sources, ErrorSource::contact);
  std::vector<SourceVariation> variations = vary_sources(refined, sources, settings_.ensemble);
  for (SourceVariation& body : vary_bodies(refined, settings_.bodies)) variations.push_back(std::move(body));
  for (const SourceVariation& variation : variations) {
    run_source(variation);
    if (study_.stopped()) return;
  }
}

void StudyMaker::run_source(const SourceVariation& variation) {
  const MeshFactor factor = study_.meshes[study_.sources_mesh].factor;
  study_.sources.push_back({variation.source, variation.name, variation.what, {}});
  auto expected = expected_seconds(factor, study_.sources.size() - 1);
  const std::size_t count = variation.scenes.size();
  std::vector<StudyRun> runs(count);
  StudyFolder folder = folder_;
  const int lanes = runs_side_by_side(variation);
  if (lanes > 1) {
    folder.threads = 1;
    if (expected) *expected *= lanes;
  }
  std::atomic<std::size_t> next = 0;
  const auto make_runs = [&] {
    for (std::size_t k = next++; k < count; k = next++) {
      runs[k] = run_variation(variation, k, folder, expected);
      if (runs[k].stopped) next = count;
    }
  };
  std::vector<std::future<void>> beside;
  for (int lane = 1; lane < lanes; ++lane) beside.push_back(std::async(std::launch::async, make_runs));
  make_runs();
  for (std::future<void>& lane : beside) lane.get();
  study_.sources.back().runs = std::move(runs);
}

StudyRun StudyMaker::run_variation(const SourceVariation& variation, std::size_t number, const StudyFolder& folder,
                                   std::optional<double> expected) {
  const MeshFactor factor = study_.meshes[study_.sources_mesh].factor;
  const std::string which = variation.source == ErrorSource::chance ? fmt::format("{}", number + 1) : "";
  const std::string what = fmt::format("mesh {}, {}{}: {}", factor.text(), variation.name, which, variation.what);
  return run(variation.scenes[number], folder_of(factor) + '_' + variation.folder + which, what, folder, expected);
}

int StudyMaker::runs_side_by_side(const SourceVariation& ensemble) const {
  // Libraries of Exodus complain in each thread but the first, and a device has one run at a time.
  const bool any_exodus = std::any_of(scene_.bodies.begin(), scene_.bodies.end(), [](const Body& body) {
    const auto* mesh = std::get_if<FileMesh>(&body.mesh);
    return mesh != nullptr && mesh->format == MeshFormat::exodus;
  });
  if (ensemble.source != ErrorSource::chance || any_exodus || scene_.device != Device::none) return 1;
  const int threads = settings_.folder.threads > 0 ? settings_.folder.threads : DefaultExecutionSpace::concurrency();
  const double fit =
      largest_side_by_side / std::max(1.0, number_of(study_.meshes[study_.sources_mesh].run, "elements"));
  return static_cast<int>(std::clamp<double>(fit, 1, std::min<double>(threads, ensemble.scenes.size())));
}

void StudyMaker::run_trial(std::size_t source, const MeshFactor& factor) {
  const StudySource& of = study_.sources[source];
  const Scene refined = refined_by(scene_, factor);
  for (const SourceVariation& variation : vary_sources(refined, {of.source}, 1)) {
    if (variation.name != of.name) continue;
    const std::string what = fmt::format("mesh {}, {}: {}", factor.text(), of.name, of.what);
    study_.trials.push_back({source, factor, element_counts(refined),
                             run(variation.scenes.front(), folder_of(factor) + '_' + variation.folder, what, folder_,
                                 expected_seconds(factor, source))});
  }
}

void StudyMaker::draw() {
  const auto fine = std::find_if(study_.meshes.rbegin(), study_.meshes.rend(), came_to_its_end);
  if (fine == study_.meshes.rend()) return;
  draw_quantities(scene_, settings_.of.empty() ? default_quantities(scene_, *fine->run.results) : settings_.of, study_);
}

double StudyMaker::work_of_source(const StudySource& source) const {
  if (source.source == ErrorSource::step) return half_steps;
  const StudyRun& plain = study_.meshes[study_.sources_mesh].run;
  for (const RefinedBody& refined : settings_.bodies) {
    if (source.source != ErrorSource::body || source.name != name_of(refined) || !plain.results) continue;
    const double own = plain.results->value(fmt::format("bodies.{}.elements", refined.body)).value_or(0);
    const double share = own / std::max(1.0, number_of(plain, "elements"));
    return refined.times * (1 + share * (std::pow(refined.times, 3) - 1));
  }
  return 1;
}

std::optional<double> StudyMaker::expected_seconds(const MeshFactor& factor, std::optional<std::size_t> source) const {
  const RunTimes times = times_of(study_);
  const auto work = times.expected(factor.value());
  if (!work) return std::nullopt;
  const int threads = settings_.folder.threads > 0
                          ? settings_.folder.threads
                          : earned_threads(static_cast<std::int64_t>(*times.elements(factor.value())));
  const double seconds = *work / threads;
  if (!source) return seconds;
  const StudySource& of = study_.sources[*source];
  const StudyRun& plain = study_.meshes[study_.sources_mesh].run;
  if (of.runs.empty() || !of.runs.front().results) return seconds * work_of_source(of);
  return seconds * work_of(of.runs.front()) / std::max(work_of(plain), 1e-4);
}

}  // namespace pinball
