#pragma once

#include <optional>
#include <string>
#include <vector>

#include <solver/output/page/curves.hpp>
#include <solver/results.hpp>
#include <solver/scene.hpp>

#include "others/last_state.hpp"

/// One scene with several values of some of its keys, run side by side. The speed of a machine may change by a factor
/// of two within minutes: variants that take turns all meet the same minutes, and the ratio of their times is what
/// counts.
namespace pinball {

/// One value, or combination of values.
struct Variant {
  std::vector<std::string> settings;  ///< "KEY=VALUE", one per --vary
  Scene scene;
};

/// All combinations of the values, those of the last key changing fastest. source: of a scene or deck; vary:
/// "KEY=V1,V2". Throws InputError that names the --vary, and for a scene that a combination makes invalid.
std::vector<Variant> make_variants(const SceneSource& source, const std::vector<std::string>& vary);

/// What running one variant has given.
struct VariantRuns {
  std::vector<std::string> settings;
  std::vector<RunSummary> repeats;       ///< alike in all but their times
  std::optional<double> momentum_error;  ///< see momentum_error.hpp
  std::string failure;                   ///< what stopped the run, and when; empty: it came to its end
  Curves curves{};                       ///< of the first repeat, a row at each of equal parts; empty: not asked for
  LastState last{};                      ///< of its nodes by number; empty: not asked for
  std::string surface{};                 ///< the same, as of surface_json_of_frames at nine equal parts
};

struct ComparisonSettings {
  int repeats = 1;      ///< the whole is done so often
  bool quiet = false;   ///< no progress
  bool curves = false;  ///< keep what the variants are over time, and how they end
  int rows = 200;       ///< of these curves
  int threads = 0;      ///< of all variants; 0: what the largest earns
};

/// Runs all variants to their ends; each ends in the state that a Simulation gives. Within a repeat all of them are in
/// memory and take turns by a fiftieth of their run (or a few steps, where that is more), in an order that is reversed
/// from round to round. Times are those of a variant's own steps, from the first on; no files are written.
/// A variant that fails drops out. Throws RunError if two repeats of one variant differ: see check_repeat.
std::vector<VariantRuns> run_comparison(const std::vector<Variant>& variants, const ComparisonSettings& settings);

/// Throws RunError that names the variant and both state hashes if two of its runs differ in anything but times.
void check_repeat(const std::string& variant, const RunSummary& first, const RunSummary& again);

/// "KEY=VALUE, KEY=VALUE"; "as it is" without any.
std::string name_of(const std::vector<std::string>& settings);

}  // namespace pinball
