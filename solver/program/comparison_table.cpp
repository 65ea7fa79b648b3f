#include <fmt/format.h>

#include <functional>

#include <solver/scene/units/units.hpp>

#include "comparison_report.hpp"
#include "comparison_times.hpp"
#include "text_table.hpp"

namespace pinball {

namespace {

using Lines = std::vector<std::vector<std::string>>;
using Cell = std::function<std::string(const VariantRuns&)>;

void add_line(Lines& lines, const std::string& name, const std::vector<VariantRuns>& runs, const Cell& cell) {
  lines.push_back({name});
  for (const VariantRuns& variant : runs) lines.back().push_back(cell(variant));
}

std::string text(const Spread& seconds, std::size_t repeats) {
  const std::string median = fmt::format("{:.4g}", seconds.median);
  return repeats == 1 ? median : fmt::format("{} ({:.3g}..{:.3g})", median, seconds.smallest, seconds.largest);
}

/// "contact.method" in front of "pinball", "slideline": the values that tell the columns apart.
void add_settings(Lines& lines, const std::vector<VariantRuns>& runs) {
  for (std::size_t k = 0; k < runs.front().settings.size(); ++k) {
    const auto split = [k](const VariantRuns& variant) { return variant.settings[k].find('='); };
    add_line(lines, runs.front().settings[k].substr(0, split(runs.front())), runs,
             [&](const VariantRuns& variant) { return variant.settings[k].substr(split(variant) + 1); });
  }
}

void add_times(Lines& lines, const std::vector<VariantRuns>& runs) {
  const auto add_time = [&](const std::string& name, Spread VariantTimes::*time) {
    add_line(lines, name, runs,
             [time](const VariantRuns& variant) { return text(times_of(variant).*time, variant.repeats.size()); });
  };
  add_time("total time [s]", &VariantTimes::total);
  add_time("contact time [s]", &VariantTimes::contact);
  add_time("  pinballs or surface", &VariantTimes::surface);
  add_time("  search", &VariantTimes::search);
  add_time("  forces and scatter", &VariantTimes::forces);
  add_line(lines, "share of contact [%]", runs,
           [](const VariantRuns& variant) { return fmt::format("{:.1f}", 100 * times_of(variant).contact_share); });
  const auto add_ratio = [&](const std::string& name, std::optional<double> TimeRatios::*ratio) {
    add_line(lines, name, runs, [&runs, ratio](const VariantRuns& variant) {
      return number_cell(first_over(runs.front(), variant).*ratio, "{:.3f}");
    });
  };
  add_ratio("total time, first / this", &TimeRatios::total);
  add_ratio("contact time, first / this", &TimeRatios::contact);
}

void add_bodies(Lines& lines, const std::vector<VariantRuns>& runs) {
  const RunSummary& first = runs.front().repeats.front();
  const std::string unit = parse_units(first.units).velocity;
  for (const BodyResult& of_first : first.bodies) {
    const auto add = [&](const std::string& quantity, const std::function<std::string(const BodyResult&)>& cell) {
      add_line(lines, of_first.name + ": " + quantity, runs, [&](const VariantRuns& variant) {
        for (const BodyResult& body : variant.repeats.front().bodies) {
          if (body.name == of_first.name) return cell(body);
        }
        return std::string("-");
      });
    };
    add("mass remaining [%]",
        [](const BodyResult& body) { return fmt::format("{:.4g}", 100 * body.mass_remaining / body.mass_initial); });
    for (std::size_t k = 0; k < 3; ++k) {
      add(fmt::format("exit velocity {}{}", "xyz"[k], unit.empty() ? "" : " [" + unit + "]"),
          [k](const BodyResult& body) { return fmt::format("{:.6g}", body.velocity[k]); });
    }
  }
}

void add_results(Lines& lines, const std::vector<VariantRuns>& runs) {
  const auto add = [&](const std::string& name, const std::function<std::string(const RunSummary&)>& cell) {
    add_line(lines, name, runs, [&cell](const VariantRuns& variant) { return cell(variant.repeats.front()); });
  };
  add("elements", [](const RunSummary& s) { return fmt::format("{}", s.elements); });
  add("steps", [](const RunSummary& s) { return fmt::format("{}", s.steps); });
  add("largest energy error [%]", [](const RunSummary& s) { return fmt::format("{:.3g}", 100 * s.balance_error_max); });
  add_line(lines, "momentum error", runs,
           [](const VariantRuns& variant) { return number_cell(variant.momentum_error, "{:.2e}"); });
  add("deepest penetration / radii",
      [](const RunSummary& s) { return fmt::format("{:.3g}", s.max_penetration_ratio); });
  add_bodies(lines, runs);
  add("state", [](const RunSummary& s) { return fmt::format("{:016x}", s.state_hash); });
}

}  // namespace

std::string comparison_table(const std::vector<VariantRuns>& runs) {
  Lines lines;
  add_settings(lines, runs);
  add_line(lines, "outcome", runs, [](const VariantRuns& v) { return v.failure.empty() ? "done" : "FAILED"; });
  add_times(lines, runs);
  add_results(lines, runs);
  std::vector<Align> align(runs.size() + 1, Align::right);
  align.front() = Align::left;
  const std::size_t repeats = runs.front().repeats.size();
  std::string words = text_table(lines, align);
  if (repeats > 1) words += fmt::format("times: median (smallest..largest) of {} repeats\n", repeats);
  if (runs.size() > 1) words += "first / this: above 1 this variant is faster than the first one\n";
  for (const VariantRuns& variant : runs) {
    if (!variant.failure.empty()) words += fmt::format("{} failed: {}\n", name_of(variant.settings), variant.failure);
  }
  return words;
}

}  // namespace pinball
