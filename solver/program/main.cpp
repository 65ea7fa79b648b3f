#include <CLI/CLI.hpp>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <limits>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>

#include <solver/base/error.hpp>
#include <solver/base/thread_count.hpp>
#include <solver/base/version.h>

#include "commands.hpp"
#include "join_ranks.hpp"
#include "process/memory_error.hpp"
#include "process/short_waits.hpp"
#include "standard_streams.hpp"
#include "stop_signals.hpp"

/// The command line: parses it and calls the library. Exit status: 0 done, 1 the run failed, 2 bad input, 128 + number
/// of a signal: ended by that.
namespace {

constexpr int run_failed = 1;
constexpr int bad_input = 2;

int report(const std::exception& error, int status) {
  // Not by fmt, which throws where nobody can read it.
  std::fputs((std::string("pinball: error: ") + error.what() + '\n').c_str(), stderr);
  return status;
}

/// An empty name is most likely a variable of a script that is not set.
std::string check_not_empty(const std::string& text) { return text.empty() ? "expected a name, got none" : ""; }

/// One that may be given several times, with one value each.
CLI::Option* repeated(CLI::Option* option) { return option->expected(1)->allow_extra_args(false)->take_all(); }

/// Of decks of other programs.
template <class Options>
void add_deck_options(CLI::App& command, Options& options) {
  command.add_option("--case", options.chosen_case, "of a deck: one of its cases (*CASE)")->type_name("N");
  command.add_flag("--lenient", options.lenient, "of a deck: leaves out output and controls that are not known");
}

void add_convert_options(CLI::App& command, pinball::ConvertOptions& options) {
  command
      .add_option("DECK", options.deck,
                  "LS-DYNA keyword file (.k, .key, .dyn), Abaqus (.inp) or Radioss input (_0000.rad)")
      ->required();
  command.add_option("SCENE", options.scene, "scene file to write (.toml)")->required();
  add_deck_options(command, options);
  command.add_flag("--force", options.force, "replaces a file that is there");
}

void add_device_option(CLI::App& command, pinball::Device& device) {
  using pinball::Device;
  command
      .add_option_function<std::string>(
          "--device",
          [&device](const std::string& name) {
            device = name == "mock"   ? Device::mock
                     : name == "cuda" ? Device::cuda
                     : name == "hip"  ? Device::hip
                                      : Device::none;
          },
          "where steps are made (default: none, on the processor)")
      ->check(CLI::IsMember({"none", "mock", "cuda", "hip"}));
}

/// Of programs that mpirun can start several of.
void add_partition_option(CLI::App& command, pinball::Partition& partition) {
  using pinball::Partition;
  const auto read = [&partition](const std::string& text) {
    const std::string random = "random:";
    partition.by = text == "metis" ? Partition::By::graph : Partition::By::tiles;
    if (!text.starts_with(random)) return;
    partition.by = Partition::By::random;
    partition.seed = std::stoull(text.substr(random.size()));
  };
  const auto check = [](const std::string& text) -> std::string {
    const bool seed = text.starts_with("random:") && text.size() > 7 && text.size() < 27 &&
                      text.find_first_not_of("0123456789", 7) == std::string::npos;
    if (text == "tiles" || text == "metis" || seed) return "";
    return "expected tiles, metis or random:SEED, got " + text;
  };
  command
      .add_option_function<std::string>("--partition", read,
                                        "which rank of mpirun works what (default: tiles, ranges of them)")
      ->type_name("tiles|metis|random:SEED")
      ->check(check);
}

void add_pieces_option(CLI::App& command, bool& pieces) {
  command.add_flag("--pieces", pieces,
                   "each rank of mpirun writes its piece of the fields (.pvtu), into a folder that all of them see, in "
                   "place of rank 0");
}

/// What `run`, `info`, `compare` and `converge` have in common.
CLI::Option* add_scene_options(CLI::App& command, pinball::SceneOptions& options) {
  CLI::Option* scene = command
                           .add_option("SCENE", options.scene,
                                       "TOML file, name of a scene in data/scenes, LS-DYNA keyword file (.k, .key, "
                                       ".dyn), Abaqus (.inp) or Radioss "
                                       "input (_0000.rad)")
                           ->required();
  add_deck_options(command, options);
  repeated(
      command.add_option("--set", options.overrides.set, "KEY=VALUE: overrides a key of the scene, or variant=NAME"));
  command
      .add_option("--threads", options.threads,
                  "number of threads (default, and 0: OMP_NUM_THREADS, else what the size earns)")
      ->check(CLI::Range(0, pinball::most_threads));
  command.add_option("--refine", options.overrides.refine, "multiplies the element counts of generated meshes")
      ->check(CLI::Range(1, 1000));
  command
      .add_option_function<std::string>(
          "--precision",
          [&options](const std::string& name) {
            using enum pinball::Precision;
            for (const pinball::Precision one : {float64, mixed, float32}) {
              if (name == pinball::name_of(one)) options.overrides.precision = one;
            }
          },
          "double, mixed or float (default: as the scene says)")
      ->check(CLI::IsMember({"double", "mixed", "float"}));
  command.add_flag("--quiet", options.quiet, "no progress");
  return scene;
}

void add_info_options(CLI::App& command, pinball::InfoOptions& options) {
  add_scene_options(command, options)->required(false);
  command.add_flag("--device", options.devices, "which devices there are, and what of SCENE, if any, runs there");
  command
      .add_option("--ranks", options.ranks,
                  "what so many processes of mpirun would share and send each other: a number, or several with commas")
      ->type_name("N,...")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::Range(2, 1000000));
  command.add_option("--out", options.out, "folder for the results (default: out/<scene>)")->check(check_not_empty);
}

void add_run_options(CLI::App& command, pinball::RunOptions& options) {
  add_scene_options(command, options)->required(false);
  add_device_option(command, options.device);
  command
      .add_option("--out", options.out,
                  "folder for the results (default: out/<scene>; with --restart the folder of FILE)")
      ->check(check_not_empty);
  command
      .add_option("--checkpoint-every", options.checkpoint_every,
                  "writes checkpoint.pinball after each N steps (with time.subcycling: cycles), and before the end")
      ->type_name("N")
      ->check(CLI::Range(std::int64_t{1}, std::numeric_limits<std::int64_t>::max()));
  command
      .add_option("--restart", options.restart,
                  "in place of SCENE: goes on from a checkpoint.pinball or last_good.pinball with the same bits; --set "
                  "then takes time.end, time.steps, time.cfl, output.* and guard.*")
      ->type_name("FILE");
}

void add_compare_options(CLI::App& command, pinball::CompareOptions& options) {
  add_scene_options(command, options);
  add_device_option(command, options.device);
  repeated(command.add_option(
      "--vary", options.vary,
      "KEY=V1,V2,...: runs the scene with each value; several --vary: with all combinations, the first one "
      "being what the others are compared with (default: contact.method=pinball,slideline)"));
  repeated(command.add_option(
               "--with", options.with,
               "a history that another program has written of the same model: LS-DYNA's glstat, nodout or binout, "
               "CalculiX' .dat, OpenRadioss' T01, a table of its th_to_csv, of Abaqus, of anything with a "
               "line of names; without "
               "--vary the scene runs once, as it is"))
      ->type_name("FILE")
      ->check(check_not_empty);
  command.add_option("--repeat", options.repeats, "runs all so often; times are medians (default: 3, with --with 1)")
      ->check(CLI::Range(1, 1000));
  command.add_option("--json", options.json, "write the table, and the times of each repeat, to this file")
      ->check(check_not_empty);
  command.add_option("--page", options.page, "write a page for a browser, with curves, to this file")
      ->check(check_not_empty);
}

void add_converge_options(CLI::App& command, pinball::ConvergeOptions& options) {
  add_scene_options(command, options);
  add_device_option(command, options.device);
  repeated(command.add_option("--of", options.of,
                              "a quantity: a column of history.csv, also with :last, :max, :min, :integral or :curve, "
                              "length(PROBE,PROBE), or a number of summary.json, such as energy.kinetic (default: "
                              "energies, velocities, forces, probes)"))
      ->check(check_not_empty);
  command
      .add_option(
          "--meshes", options.meshes,
          "K1,K2,K3,...: what multiplies the element counts, fractions such as 1/2; 1, 2, 4, ... of meshes of files "
          "(default: 1/2,1,2 where all counts can be halved, else 1,2,4)")
      ->check(check_not_empty);
  repeated(command.add_option(
               "--only", options.only,
               "leaves out what else may move a number (default: all of mesh, step, precision, hourglass, chance)"))
      ->check(CLI::IsMember({"mesh", "step", "precision", "hourglass", "contact", "chance"}));
  command.remove_option(command.get_option("--refine"));
  repeated(command.add_option("--refine", options.refine,
                              "K: multiplies the element counts of generated meshes; BODY=K: says what K times as many "
                              "elements of this body alone do, so that two of them say which to refine"))
      ->check(check_not_empty);
  command
      .add_option("--ensemble", options.ensemble, "runs with moved velocities that say what chance does (default: 4)")
      ->check(CLI::Range(1, 1000));
  command
      .add_option("--error", options.error,
                  "1%: searches for the mesh and settings that reach this error of all --of in the least time")
      ->check(check_not_empty);
  command
      .add_option(
          "--budget", options.budget,
          "90s, 10min, 2h: for all runs; what is expected to take longer is left out, and what is left goes into "
          "finer meshes (default: any time, with --error 10min)")
      ->check(check_not_empty);
  command.add_option("--out", options.out, "folder for the runs (default: out/converge_<scene>); what is there stays")
      ->check(check_not_empty);
  command.add_option("--json", options.json, "write the table to this file")->check(check_not_empty);
  command.add_flag("--keep", options.keep,
                   "writes the bands to SCENE.converged.json beside the scene: pinball run shows them from then on");
  command.add_option("--csv", options.csv, "write the figures, a line for each quantity and run, to this file")
      ->check(check_not_empty);
  command
      .add_option("--page", options.page,
                  "write a page for a browser, with pictures of the coarsest and the finest run, to this file")
      ->check(check_not_empty);
}

void add_new_options(CLI::App& command, pinball::NewOptions& options) {
  command.add_option("NAME", options.name, "name of the scene: writes NAME.toml")->required();
  command.add_option("--out", options.out, "folder that gets the file (default: the current one)");
  command.add_flag("--force", options.force, "replaces a file that is there");
}

/// At the end of --help: two examples, and where the keys of scenes are described.
void add_footer(CLI::App& command, const std::string& examples) {
  command.footer("Examples:\n" + examples +
                 "\nAll keys of a scene with units and defaults: data/scenes/README.md in the source tree,\n"
                 "share/pinball/data/scenes/README.md where the program is installed.");
}

/// Of those that one mpirun has started, rank 0 alone speaks. makes_runs: a command that is no run, but makes several.
/// Throws InputError for that.
void take_ranks(pinball::Ranks& ranks, const pinball::Partition& partition, bool makes_runs) {
  ranks.partition = partition;
  if (ranks.number() > 0) pinball::mute_output();
  if (ranks.count() > 1 && makes_runs) {
    throw pinball::InputError("mpirun: expected pinball run; compare, converge and verify work without it");
  }
}

int run_program(int argc, char** argv, std::unique_ptr<pinball::Ranks>& ranks) {
  CLI::App app("Pinball: explicit dynamics of solids in contact and impact", "pinball");
  app.set_version_flag("--version", "pinball " PINBALL_VERSION);
  app.require_subcommand(1);

  pinball::RunOptions options;
  auto* run = app.add_subcommand("run", "run a scene");
  add_run_options(*run, options);
  pinball::Partition partition;
  if (pinball::has_ranks()) {
    add_partition_option(*run, partition);
    add_pieces_option(*run, options.pieces);
  }
  pinball::InfoOptions asked;
  auto* info = app.add_subcommand("info", "what a scene or a mesh file holds, what will run, what is skipped");
  add_info_options(*info, asked);

  pinball::VerifyOptions verification;
  auto* verify = app.add_subcommand("verify", "compare the verification scenes with their references");
  verify->add_option("SCENE", verification.scenes, "only these scenes");
  add_device_option(*verify, verification.device);
  verify->add_option("--json", verification.json, "write the table of results to this file")->check(check_not_empty);
  verify->add_option("--page", verification.page, "write a page for a browser to this file")->check(check_not_empty);

  pinball::CompareOptions comparison;
  auto* compare = app.add_subcommand(
      "compare", "run a scene with several values of a key, taking turns, and compare their times and results");
  add_compare_options(*compare, comparison);

  pinball::ConvergeOptions study;
  auto* converge =
      app.add_subcommand("converge", "run a scene on several meshes, and say of each quantity how wrong it is");
  add_converge_options(*converge, study);

  // All after the word is the viewer's, which has its own --help.
  auto* view = app.add_subcommand("view", "pictures and an animation of what a run has left in a folder");
  view->set_help_flag();
  view->prefix_command();

  pinball::ConvertOptions conversion;
  auto* convert = app.add_subcommand("convert", "write a deck of another program as a scene");
  add_convert_options(*convert, conversion);

  pinball::NewOptions first;
  auto* create = app.add_subcommand("new", "write a first scene, with comments, to begin with");
  add_new_options(*create, first);

  pinball::SchemaOptions schema;
  auto* describe = app.add_subcommand("schema", "print what scene files may hold, as JSON Schema for editors");
  describe->add_flag("--keys", schema.keys, "the keys alone that --set takes, of tables of which a scene has one");

  add_footer(app, "    pinball new impact\n    pinball run impact.toml\n");
  add_footer(*run,
             "    pinball run rod_plate --out out/finer --refine 2\n"
             "    pinball run impact.toml --set time.end=0.1 --set contact.friction=0\n");
  add_footer(*info, "    pinball info rod_plate\n    pinball info impact.toml --refine 2\n    pinball info part.msh\n");
  add_footer(*compare,
             "    pinball compare two_blocks --vary time.cfl=0.9,0.45\n"
             "    pinball compare impact.toml --vary contact.friction=0,0.2 --repeat 1 --json table.json\n"
             "    pinball compare deck.k --with glstat --page beside.html\n");
  add_footer(*converge,
             "    pinball converge taylor_bar --of tail_displacement_z --of bodies.bar.max_plastic_strain\n"
             "    pinball converge impact.toml --meshes 1/2,1,3/2 --json table.json\n"
             "    pinball converge taylor_bar --of tail_displacement_z --error 1% --budget 10min\n");
  add_footer(*verify, "    pinball verify two_blocks taylor_bar\n    pinball verify --json table.json\n");
  add_footer(*convert, "    pinball convert deck.k scene.toml\n    pinball convert deck.k low.toml --case 1 --force\n");
  add_footer(*create, "    pinball new impact\n    pinball new impact --out scenes --force\n");

  add_footer(*describe, "    pinball schema > scene.schema.json\n    pinball schema --keys\n");

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // --help and --version
    const int status = report(error, bad_input);
    std::fputs("Run with --help for more information.\n", stderr);
    return status;
  }

  if (*run) pinball::start_again_with_short_waits(argv, options.threads);
  if (*compare) pinball::start_again_with_short_waits(argv, comparison.threads);
  if (*converge) pinball::start_again_with_short_waits(argv, study.threads);
  if (*info) pinball::start_again_with_short_waits(argv, 0);
  pinball::catch_stop_signals(*run || *converge ? pinball::AtSignal::ask : pinball::AtSignal::end);
  ranks = pinball::join_ranks();
  if (ranks) take_ranks(*ranks, partition, *compare || *converge || *verify);
  if (ranks && ranks->count() > 1) {
    options.ranks = ranks.get();
    if (!*run) {  // what is done once rank 0 does by itself, and has no messages to wait for
      const bool is_first = ranks->number() == 0;
      ranks.reset();
      if (!is_first) return 0;
    }
  }
  if (*run) return pinball::run_command(options);
  if (*info) return pinball::info_command(asked);
  if (*verify) return pinball::verify_command(verification);
  if (*view) return pinball::view_command(view->remaining());
  if (*convert) return pinball::convert_command(conversion);
  if (*create) return pinball::new_command(first);
  if (*describe) return pinball::schema_command(schema);
  if (*converge) return pinball::converge_command(study);
  return pinball::compare_command(comparison);
}

/// Of several ranks the lowest that has failed speaks, and rank 0 has the exit status: mpirun ends the others where it
/// sees one.
int fail(pinball::Ranks* ranks, const std::exception& error, int status) {
  if (ranks == nullptr || ranks->count() == 1) return report(error, status);
  if (!ranks->agreed) {
    pinball::tell_ranks(*ranks, status, error.what());
  } else if (ranks->number() > 0 && ranks->running) {  // in the middle of the run, which the others cannot go on with
    pinball::unmute_errors();
    ranks->give_up();
  }
  report(error, status);
  return ranks->number() == 0 ? status : 0;
}

}  // namespace

int main(int argc, char** argv) {
  pinball::open_closed_streams();
  std::unique_ptr<pinball::Ranks> ranks;
  try {
    const int status = run_program(argc, argv, ranks);
    pinball::finish_stdout();
    return status;
  } catch (const pinball::InputError& error) {
    return fail(ranks.get(), error, bad_input);
  } catch (const std::bad_alloc& error) {
    return fail(ranks.get(), std::runtime_error(pinball::memory_error(error)), run_failed);
  } catch (const std::exception& error) {  // RunError, and what nobody foresaw
    return fail(ranks.get(), error, run_failed);
  }
}
