#include <fmt/core.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include <kernels/exec.hpp>
#include <solver/base/error.hpp>
#include <solver/base/text_distance.hpp>
#include <solver/base/version.h>
#include <solver/device/device_run.hpp>
#include <solver/device/devices.hpp>
#include <solver/output/page/page.hpp>
#include <solver/output/page/resources.hpp>
#include <solver/verification/verification.hpp>

#include "commands.hpp"
#include "result_file.hpp"
#include "text_table.hpp"

namespace pinball {

namespace {

/// The cases asked for, in the order in which they were; all of them if none was.
std::vector<VerificationCase> chosen_cases(const std::vector<std::string>& scenes) {
  const std::vector<VerificationCase>& all = verification_cases();
  if (scenes.empty()) return all;
  std::vector<VerificationCase> chosen;
  for (const std::string& scene : scenes) {
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const VerificationCase& c) { return c.scene == scene; });
    if (found == all.end()) {
      std::vector<std::string> names;
      std::string list;
      for (const VerificationCase& c : all) {
        names.push_back(c.scene);
        list += (list.empty() ? "" : ", ") + c.scene;
      }
      throw InputError(fmt::format("{}: no such verification scene, nearest is {}; known scenes: {}", scene,
                                   nearest(scene, names), list));
    }
    chosen.push_back(*found);
  }
  return chosen;
}

/// The source comes last, so that long ones spoil nothing.
void print_table(const std::vector<VerificationRow>& rows) {
  std::vector<std::vector<std::string>> table{
      {"scene", "quantity", "value", "reference", "error", "tolerance", "", "source"}};
  for (const VerificationRow& r : rows) {
    table.push_back({r.scene, r.quantity, fmt::format("{:.8g}", r.value), fmt::format("{:.8g}", r.reference),
                     fmt::format("{:.2e}", r.error), fmt::format("{:.0e}", r.tolerance), r.pass ? "pass" : "FAIL",
                     r.source});
  }
  constexpr Align left = Align::left, right = Align::right;
  fmt::print("{}", text_table(table, {left, left, right, right, right, right, left, left}));
}

nlohmann::ordered_json rows_json(const std::vector<VerificationRow>& rows, bool pass) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const VerificationRow& r : rows) {
    list.push_back({{"scene", r.scene},
                    {"quantity", r.quantity},
                    {"value", r.value},
                    {"reference", r.reference},
                    {"source", r.source},
                    {"error", r.error},
                    {"tolerance", r.tolerance},
                    {"pass", r.pass}});
  }
  return {{"version", PINBALL_VERSION}, {"pass", pass}, {"rows", list}};
}

std::string rows_page(const std::vector<VerificationRow>& rows, bool pass) {
  PageContent content;
  content.title = "Verification of pinball " PINBALL_VERSION;
  content.body = fill_template(page_resource("verification.html"), {{"status", pass ? "pass" : "FAIL"}});
  content.scripts = {"format.js", "verification.js"};
  content.blocks = {{"verification", rows_json(rows, pass).dump()}};
  return make_page(content);
}

}  // namespace

int verify_command(const VerifyOptions& options) {
  // Small scenes of many steps: threads would wait for each other most of the time.
  DefaultExecutionSpace::set_concurrency(1);
  require_device(options.device);
  check_result_path("--json", options.json);
  check_result_path("--page", options.page);
  std::vector<VerificationRow> rows;
  std::string left_out;
  for (const VerificationCase& verification : chosen_cases(options.scenes)) {
    try {
      const std::vector<VerificationRow> more = verify_scene(verification, options.device);
      rows.insert(rows.end(), more.begin(), more.end());
    } catch (const MissingOnDevice& none) {  // of the scene, or of what is done with it
      if (!options.scenes.empty()) throw;
      left_out += fmt::format("{}{} ({})", left_out.empty() ? "" : ", ", verification.scene, none.missing);
    }
  }
  if (!left_out.empty()) fmt::print("not on a device yet: {}\n", left_out);
  const auto failed = std::count_if(rows.begin(), rows.end(), [](const VerificationRow& r) { return !r.pass; });
  if (!options.json.empty()) write_result_file(options.json, rows_json(rows, failed == 0).dump(2) + '\n');
  if (!options.page.empty()) write_result_file(options.page, rows_page(rows, failed == 0));
  print_table(rows);
  fmt::print("{} of {} pass\n", static_cast<std::ptrdiff_t>(rows.size()) - failed, rows.size());
  return failed == 0 ? 0 : 1;
}

}  // namespace pinball
