#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <solver/base/export.h>
#include <solver/parallel/ranks.hpp>
#include <solver/scene.hpp>

/// What the program does, one function per subcommand. Each returns the exit status (0 or 1) and throws InputError or
/// RunError. (Where libraries are shared, so is this part of the program: for that alone they are exported.)
namespace pinball {

/// What all that runs a scene has in common.
struct SceneOptions {
  std::string scene;  ///< name or path, not yet looked up
  SceneOverrides overrides;
  Device device = Device::none;
  int threads = 0;                            ///< 0: what the size earns
  bool quiet = false;                         ///< no progress on the terminal
  std::optional<std::int64_t> chosen_case{};  ///< of a deck: those keywords of *CASE, too
  bool lenient = false;                       ///< of a deck: unknown output and controls are ignored
};

struct RunOptions : SceneOptions {
  std::string out;                    ///< folder for the results; empty: out/SCENE, or that of the checkpoint
  std::int64_t checkpoint_every = 0;  ///< steps or cycles; 0: no checkpoints
  std::string restart;                ///< checkpoint to go on from, in place of a scene; empty: none
  Ranks* ranks = nullptr;             ///< of one mpirun; null: this process is alone
  bool pieces = false;                ///< each of the ranks writes its piece of the fields
};

struct InfoOptions : SceneOptions {
  std::string out;           ///< folder in which a run would leave its results
  bool devices = false;      ///< which there are, and what of the scene runs there
  std::vector<int> ranks{};  ///< numbers of processes, of each of which is said what they share and send
};

struct CompareOptions : SceneOptions {
  std::vector<std::string>
      vary;  ///< "KEY=V1,V2,..."; empty: contact.method=pinball,slideline, or as the scene is beside `with`
  std::vector<std::string> with{};  ///< files: histories of other programs
  std::optional<int> repeats{};     ///< 3; beside `with` 1
  std::string json;                 ///< file for the table of results; empty: none
  std::string page;                 ///< file for the page of results; empty: none
};

struct ConvergeOptions : SceneOptions {
  std::vector<std::string> of;  ///< quantities; empty: those that the scene names, and energies
  std::string meshes;           ///< "1/2,1,2": what multiplies the numbers of elements; empty: by what the scene allows
  std::vector<std::string> only;    ///< of "mesh", "step", "precision", "hourglass", "chance"; empty: all
  int ensemble = 4;                 ///< runs for chance
  std::vector<std::string> refine;  ///< "2": all bodies, "plate=2": what this body alone does
  std::string error;   ///< "1%": what the quantities are to be good to; empty: the meshes are those that are named
  std::string budget;  ///< "10min": for all runs; empty: any time, with an error 10 minutes
  std::string out;     ///< folder for the runs; empty: out/converge_SCENE
  std::string json;    ///< file for the table of results; empty: none
  bool keep = false;   ///< writes the bands beside the scene, for its runs
  std::string csv;     ///< file for the figures of all runs; empty: none
  std::string page;    ///< file for the page of results; empty: none
};

/// What of a deck of another program is to be written as a scene.
struct ConvertOptions {
  std::string deck, scene;  ///< paths
  std::optional<std::int64_t> chosen_case{};
  bool lenient = false;
  bool force = false;  ///< replaces a scene that is there
};

struct VerifyOptions {
  Device device = Device::none;
  std::vector<std::string> scenes;  ///< empty: all verification scenes
  std::string json;                 ///< file for the table of results; empty: none
  std::string page;                 ///< file for the page of results; empty: none
};

struct NewOptions {
  std::string name;    ///< of the scene, with or without ".toml"
  std::string out;     ///< folder that gets it; empty: the current one
  bool force = false;  ///< may take the place of a file
};

struct SchemaOptions {
  bool keys = false;  ///< the keys alone that --set takes
};

/// Prints what scene files may hold, as JSON Schema.
PINBALL_API int schema_command(const SchemaOptions& options);

/// Writes a first scene with comments, as a file of its own.
PINBALL_API int new_command(const NewOptions& options);

/// Runs a scene, or goes on with a run from its checkpoint, and writes its results.
PINBALL_API int run_command(const RunOptions& options);

/// On a rank that has failed before all were ready, so that the others do not wait for it. status: its exit status.
PINBALL_API void tell_ranks(Ranks& ranks, int status, const std::string& error);

/// Writes a deck as a scene of this program.
PINBALL_API int convert_command(const ConvertOptions& options);

/// Prints what a scene holds, what will run and what is skipped; or which devices there are.
PINBALL_API int info_command(const InfoOptions& options);

/// Runs a scene with each combination of values, side by side, and prints one table; 1 if a variant fails.
PINBALL_API int compare_command(const CompareOptions& options);

/// Runs a scene on several meshes and prints of each quantity how far it is from what finer meshes would say; 1 if a
/// run fails.
PINBALL_API int converge_command(const ConvergeOptions& options);

/// Runs the verification scenes and compares them with their references; 1 if one fails.
PINBALL_API int verify_command(const VerifyOptions& options);

/// Draws what a run has left: goes on as the viewer (python/view) with these arguments, and returns only by throwing.
PINBALL_API int view_command(const std::vector<std::string>& arguments);

}  // namespace pinball
