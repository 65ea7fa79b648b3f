#pragma once

#include <pinball/solver/scene.hpp>
#include <string>
#include <vector>

/// What the program does, one function per subcommand. Each returns the exit status (0 or 1) and throws InputError or
/// RunError.
namespace pinball {

struct RunOptions {
  std::string scene;  ///< name or path, not yet looked up
  SceneOverrides overrides;
  std::string out;     ///< folder for the results; empty: out/<scene>
  int threads = 0;     ///< 0: what OpenMP takes by default
  bool quiet = false;  ///< no progress on the terminal
};

struct VerifyOptions {
  std::vector<std::string> scenes;  ///< empty: all verification scenes
  std::string json;                 ///< file for the table of results; empty: none
};

/// Runs a scene and writes its results.
int run_command(const RunOptions& options);

/// Prints what a scene holds, what will run and what is skipped.
int info_command(const RunOptions& options);

/// Runs the verification scenes and compares them with their references; 1 if one fails.
int verify_command(const VerifyOptions& options);

}  // namespace pinball
