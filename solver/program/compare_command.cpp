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
#include "result_file.hpp"

namespace pinball {

namespace {

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
  const std::vector<std::string> vary =
      options.vary.empty() ? std::vector<std::string>{"contact.method=pinball,slideline"} : options.vary;
  std::vector<Variant> variants = make_variants(find_scene(options.scene), options.overrides, vary);
  for (Variant& variant : variants) variant.scene.device = options.device;
  const std::vector<VariantRuns> runs =
      run_comparison(variants, {options.repeats, options.quiet, !options.page.empty(), options.threads});
  if (!options.json.empty()) write_result_file(options.json, comparison_json(runs));
  if (!options.page.empty()) write_result_file(options.page, comparison_page(runs));

  const RunSummary& first = runs.front().repeats.front();
  fmt::print("{}: {} thread{}, {}\n", first.scene, first.threads, first.threads == 1 ? "" : "s", processor_name());
  fmt::print("{}", comparison_table(runs));
  std::fflush(stdout);  // before the warnings, in a log that both go to
  print_warnings(runs);
  return std::all_of(runs.begin(), runs.end(), [](const VariantRuns& v) { return v.failure.empty(); }) ? 0 : 1;
}

}  // namespace pinball
