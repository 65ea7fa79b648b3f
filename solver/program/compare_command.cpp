#include <fmt/core.h>

#include <algorithm>

#include <kernels/exec.hpp>
#include <solver/output/output_file.hpp>
#include <solver/scene/machine.hpp>

#include "commands.hpp"
#include "comparison.hpp"
#include "comparison_report.hpp"

namespace pinball {

int compare_command(const CompareOptions& options) {
  if (options.threads > 0) DefaultExecutionSpace::set_concurrency(options.threads);
  const std::vector<std::string> vary =
      options.vary.empty() ? std::vector<std::string>{"contact.method=pinball,slideline"} : options.vary;
  const std::vector<Variant> variants = make_variants(find_scene(options.scene), options.overrides, vary);
  const std::vector<VariantRuns> runs =
      run_comparison(variants, {options.repeats, options.quiet, !options.page.empty()});

  const RunSummary& first = runs.front().repeats.front();
  fmt::print("{}: {} thread{}, {}\n", first.scene, first.threads, first.threads == 1 ? "" : "s", processor_name());
  fmt::print("{}", comparison_table(runs));
  if (!options.json.empty()) {
    OutputFile file(options.json);
    file.write(comparison_json(runs));
    file.commit();
  }
  if (!options.page.empty()) {
    OutputFile file(options.page);
    file.write(comparison_page(runs));
    file.commit();
  }
  return std::all_of(runs.begin(), runs.end(), [](const VariantRuns& v) { return v.failure.empty(); }) ? 0 : 1;
}

}  // namespace pinball
