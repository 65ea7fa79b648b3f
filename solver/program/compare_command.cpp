#include <fmt/core.h>

#include <algorithm>
#include <cstdio>

#include <solver/device/devices.hpp>
#include <solver/output/message.hpp>
#include <solver/results/warnings.hpp>
#include <solver/scene/machine.hpp>

#include "commands.hpp"
#include "comparison.hpp"
#include "comparison_report.hpp"
#include "others/beside_report.hpp"
#include "others/watched_numbers.hpp"
#include "result_file.hpp"
#include "scene_input.hpp"

namespace pinball {

namespace {

/// Of a run beside another program's: between them its curve is taken for straight.
constexpr int rows_beside_others = 2000;

/// What each variant's run would have been warned of, by the variant's name; what a failed one reports stands in the
/// table.
void print_warnings(const std::vector<VariantRuns>& runs) {
  for (const VariantRuns& variant : runs) {
    for (const std::string& warning : warnings(variant.repeats.front())) {
      print_message(fmt::format("warning: {}: {}", name_of(variant.settings), warning));
    }
  }
}

}  // namespace

int compare_command(const CompareOptions& options) {
  require_device(options.device);
  check_result_path("--json", options.json);
  check_result_path("--page", options.page);
  std::vector<OtherHistory> others;
  for (const std::string& path : options.with) others.push_back(read_other_history(path));
  std::vector<std::string> vary = options.vary;
  if (vary.empty() && others.empty()) vary = {"contact.method=pinball,slideline"};
  std::vector<Variant> variants = make_variants(scene_input(options).source, vary);
  std::vector<std::string> not_watched;
  for (Variant& variant : variants) {
    variant.scene.device = options.device;
    not_watched = watch_numbers(others, variant.scene);
  }
  ComparisonSettings settings{options.repeats.value_or(others.empty() ? 3 : 1), options.quiet};
  settings.curves = !options.page.empty() || !others.empty();
  if (!others.empty()) settings.rows = rows_beside_others;
  settings.threads = options.threads;
  const std::vector<VariantRuns> runs = run_comparison(variants, settings);
  if (!options.json.empty()) write_result_file(options.json, comparison_json(runs, others));
  if (!options.page.empty()) write_result_file(options.page, comparison_page(runs, others));

  const RunSummary& first = runs.front().repeats.front();
  fmt::print("{}: {} thread{}, {}\n", first.scene, first.threads, first.threads == 1 ? "" : "s", processor_name());
  fmt::print("{}{}", comparison_table(runs), beside_table(runs, others));
  for (const std::string& sentence : not_watched) fmt::print("{}\n", sentence);
  std::fflush(stdout);  // before the warnings, in a log that both go to
  print_warnings(runs);
  return std::all_of(runs.begin(), runs.end(), [](const VariantRuns& v) { return v.failure.empty(); }) ? 0 : 1;
}

}  // namespace pinball
