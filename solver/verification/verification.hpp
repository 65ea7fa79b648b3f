#pragma once

#include <string>
#include <vector>

#include <solver/scene.hpp>

/// Verification: scenes whose answer is known exactly, or from an independent source, run through the library and
/// compared with it. Tolerances are justified where they are set.
namespace pinball {

/// One comparison. `error` is relative to the reference where that is not zero, else absolute; `pass` is error <=
/// tolerance, false for a value that is not finite.
struct VerificationRow {
  std::string scene;
  std::string quantity;  ///< with its unit
  double value = 0.0;
  double reference = 0.0;
  std::string source;  ///< where the reference comes from
  double error = 0.0;
  double tolerance = 0.0;
  bool pass = false;
};

/// Compares with a reference other than 0, relatively.
VerificationRow compare(const std::string& quantity, double value, double reference, double tolerance,
                        const std::string& source);

/// Compares something that is exactly 0: a drift, a residual, already divided by its scale.
VerificationRow compare_with_zero(const std::string& quantity, double value, double tolerance,
                                  const std::string& source);

/// A scene of data/scenes and what is checked in it.
struct VerificationCase {
  std::string scene;
  std::vector<VerificationRow> (*run)(const Scene& scene);
  /// Names, in the order in which `run` knows the bodies and materials by their numbers. Others come after them; empty
  /// where it looks for each by its name.
  std::vector<std::string> bodies = {};
  std::vector<std::string> materials = {};
};

const std::vector<VerificationCase>& verification_cases();

/// Runs one case on a device; a run that fails becomes a row that does not pass.
std::vector<VerificationRow> verify_scene(const VerificationCase& verification, Device device = Device::none);

/// The rows of a case for its scene as somebody has edited it: in whatever order. Throws InputError where it lacks what
/// the case compares.
std::vector<VerificationRow> compare_scene(const VerificationCase& verification, Scene scene);

}  // namespace pinball
