#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <random>
#include <vector>

#include <solver/base/error.hpp>
#include <solver/output/checkpoint.hpp>
#include <solver/scene/given/given_scene.hpp>
#include <solver/scene/given/toml_file.hpp>
#include <tests/support/changing_scene.hpp>
#include <tests/support/cube_text.hpp>
#include <tests/support/scene_text.hpp>

#include "checkpoint_case.hpp"

/// Checkpoints of the program: what a restart gives, what is rejected, and what a killed run leaves.
namespace pinball::checkpoint_test {
namespace {

using test::Checkpoints;
using test::content;
using test::cube_scene;
using test::Finished;
using test::replaced;
using test::run;
using testing::HasSubstr;

TEST_F(Checkpoints, ARestartGoesOnInTheFolderOfItsCheckpoint) {
  const std::string scene = "two_blocks --set output.field_interval=3e-5";
  expect_done(scene + " --threads 2 --out " + whole_);
  leave_checkpoint(scene, 25);
  EXPECT_NE(content(half_ + "/history.csv"), content(whole_ + "/history.csv"));
  expect_done("--restart " + file_ + " --threads 1 --set time.steps=-1");
  expect_same_results(half_, whole_);
  EXPECT_EQ(content(half_ + "/fields_0003.vtu"), content(whole_ + "/fields_0003.vtu"));
  expect_done("--restart " + file_ + " --set time.steps=-1");  // once more: later rows and files are cut off
  expect_same_results(half_, whole_);
  std::filesystem::remove(half_ + "/fields_0000.vtu");
  const Finished f = run("run --quiet --restart " + file_ + " --set time.steps=-1");
  EXPECT_THAT(f.text, HasSubstr("warning: fields_0000.vtu of the run so far, 1 of 3, is not in " + half_));
}

TEST_F(Checkpoints, WritingThemChangesNothing) {
  expect_done("two_blocks --out " + whole_);
  expect_done("two_blocks --checkpoint-every 3 --out " + half_);
  expect_same_results(half_, whole_);
  expect_done("--restart " + file_);  // of the end: only what finishes the run is left
  expect_same_results(half_, whole_);
}

TEST_F(Checkpoints, ARestartInAnotherFolderLeavesTheFirstAlone) {
  expect_done("two_blocks --out " + whole_);
  leave_checkpoint("two_blocks", 25);
  const std::string history = content(half_ + "/history.csv");
  expect_done("--restart " + file_ + " --set time.steps=-1 --out " + other_);
  EXPECT_EQ(result(other_), result(whole_));
  EXPECT_EQ(content(half_ + "/history.csv"), history);
  const std::string rows = content(other_ + "/history.csv"), all = content(whole_ + "/history.csv");
  const auto last_row = all.rfind('\n', all.size() - 2);
  EXPECT_TRUE(rows.ends_with(all.substr(last_row)));
  EXPECT_LT(rows.size(), all.size());
}

TEST_F(Checkpoints, ARestartNeedsNeitherTheSceneFileNorItsFolder) {
  const std::string path = folder_ / "scene.toml";
  std::filesystem::copy_file(std::string(PINBALL_SOURCE_DIR) + "/data/scenes/two_blocks.toml", path);
  expect_done(path + " --set contact.beta=0.5 --refine 2 --out " + whole_);
  leave_checkpoint(path + " --set contact.beta=0.5 --refine 2", 25);
  std::filesystem::remove(path);
  expect_done("--restart " + file_ + " --set time.steps=-1");
  expect_same_results(half_, whole_);
}

TEST_F(Checkpoints, ARunCanBeMadeLonger) {
  leave_checkpoint("two_blocks --set time.end=1e-4", 1000000);
  expect_done("--restart " + file_ + " --set time.end=1.5e-4");
  EXPECT_DOUBLE_EQ(nlohmann::json::parse(content(half_ + "/summary.json"))["end_time"].get<double>(), 1.5e-4);
  expect_input_error("--restart " + file_ + " --set time.end=0.5e-4", "time.end: expected at least");
}

TEST_F(Checkpoints, KeysThatTheStateDependsOnAreRejected) {
  leave_checkpoint("two_blocks", 10);
  for (const char* change :
       {"contact.beta=2", "variant=fast", "output=1", "element.negative_volume=erode", "output.body_energies=true"}) {
    expect_input_error("--restart " + file_ + " --set " + change, "with --restart expected time.end");
  }
  expect_input_error("--restart " + file_ + " --set output.intervall=1", "nearest is output.interval");
  expect_input_error("--restart " + file_ + " --refine 2", "neither --refine");
  expect_input_error("two_blocks --restart " + file_, "expected no SCENE");
  expect_input_error("", "expected a SCENE");
  expect_input_error("two_blocks --checkpoint-every 0", "--checkpoint-every");
  expect_input_error("--restart " + file_ + "s", "no such file");
  expect_input_error("--restart " + half_, "got a folder");
  expect_input_error("--restart " + half_ + "/history.csv", "expected a checkpoint of pinball");
}

TEST_F(Checkpoints, AHistoryThatDoesNotBelongToTheCheckpointIsRejected) {
  leave_checkpoint("two_blocks", 25);
  std::ofstream(half_ + "/history.csv") << "# short\n";
  expect_input_error("--restart " + file_, "history.csv: expected the rows up to the time of the checkpoint");
  expect_done("--restart " + file_ + " --out " + other_);
}

TEST_F(Checkpoints, AnEditedHistoryIsRejectedAndLeftAlone) {
  leave_checkpoint("two_blocks", 25);
  const std::string path = half_ + "/history.csv", whole = content(path);
  const std::string cut = whole.substr(0, whole.size() / 2), more = whole + "1,2,3\n";
  std::string edited = whole;
  char& digit = edited[edited.find("\n3,") + 1];  // the number of a step
  digit = '4';
  for (const std::string& text : {edited, cut}) {
    std::ofstream(path) << text;
    expect_input_error("--restart " + file_,
                       "history.csv: expected the rows up to the time of the checkpoint, as the "
                       "run has written them");
    EXPECT_EQ(content(path), text);
  }
  std::ofstream(path) << more;  // as of a run that went further
  expect_done("--restart " + file_ + " --set time.steps=-1");
  expect_done("two_blocks --out " + whole_);
  EXPECT_EQ(content(path), content(whole_ + "/history.csv"));
}

TEST_F(Checkpoints, ADeckThatGoesOnSaysWhatItSaidAtTheStart) {
  const std::string deck = folder_ / "deck.k";
  std::ofstream(deck) << "*KEYWORD\n*NODE\n"
                      << test::cube_lines(1) << R"(99,9.,9.,9.
*ELEMENT_SOLID
10,1,1,2,3,4,5,6,7,8
*PART
cube
1,1,1
*SECTION_SOLID
1,1
*MAT_ELASTIC
1,7.85E-9,210000.,0.3
*SET_NODE_LIST
3
5,6,7,8,99
*BOUNDARY_SPC_SET
3,0,1
*CONTROL_TERMINATION
1.0E-4
*END
)";
  expect_done(deck + " --out " + whole_);
  const auto whole = nlohmann::json::parse(content(whole_ + "/summary.json"));
  EXPECT_THAT(whole["warnings"].dump(), HasSubstr("deck.k:25: *BOUNDARY_SPC_SET"));
  EXPECT_FALSE(whole["notes"].empty());
  leave_checkpoint(deck, 25);
  expect_done("--restart " + file_ + " --set time.steps=-1");
  expect_same_results(half_, whole_);
}

/// A value of each kind, one with its place.
std::shared_ptr<const GivenScene> some_of_each() {
  auto given = std::make_shared<GivenScene>();
  given->contact_said = false;
  given->file = "deck.k";
  given->options = {"--case", "2"};
  given->table.comment = "a deck";
  GivenTable time;
  time.set("end", GivenValue(0.1, GivenPlace("deck.k:7: *CONTROL_TERMINATION (endtim)")));
  time.set("steps", GivenValue(std::int64_t{-3}));
  time.set("list", GivenValue(GivenArray{GivenValue(true), GivenValue(std::string("text"))}));
  GivenValue inner(time);
  inner.is_inline = true;
  time.set("inner", inner);
  given->table.set("time", GivenValue(time));
  return given;
}

TEST_F(Checkpoints, AFileHasAllThatWasWritten) {
  CheckpointHead head;
  head.source.path = "/a/scene.toml";
  head.source.text = "[time]";
  head.source.overrides.set = {"time.end=1", "a=2"};
  head.source.overrides.refine = 3;
  head.source.overrides.vary = {"fast", "coarse"};
  head.mesh_files = {{"/a/b.msh", 11}, {"/c.k", 12}};
  head.fingerprint = 13;
  head.simd_width = 14;
  head.version = "9.8.7";
  head.deck.lines = {"one", "two"};
  head.source.given = some_of_each();
  StateBytes state(5);
  for (std::size_t i = 0; i < 5; ++i) state[i] = static_cast<std::byte>(17 + i);
  for (const std::optional<Precision> precision :
       {std::optional<Precision>(), std::optional(Precision::float64), std::optional(Precision::float32),
        std::optional(Precision::mixed)}) {
    head.source.overrides.precision = precision;
    write_checkpoint(folder_ / "a.pinball", head, state);
    const Checkpoint read = read_checkpoint(folder_ / "a.pinball");
    EXPECT_EQ(read.path, folder_ / "a.pinball");
    EXPECT_EQ(read.head.source.path, head.source.path);
    EXPECT_EQ(read.head.source.text, head.source.text);
    EXPECT_EQ(read.head.source.overrides.set, head.source.overrides.set);
    EXPECT_EQ(read.head.source.overrides.refine, 3);
    EXPECT_EQ(read.head.source.overrides.vary, head.source.overrides.vary);
    EXPECT_EQ(read.head.source.overrides.precision, precision);
    EXPECT_EQ(read.head.mesh_files, head.mesh_files);
    EXPECT_EQ(read.head.fingerprint, 13U);
    EXPECT_EQ(read.head.simd_width, 14);
    EXPECT_EQ(read.head.version, "9.8.7");
    EXPECT_EQ(read.head.deck.lines, head.deck.lines);
    ASSERT_NE(read.head.source.given, nullptr);
    EXPECT_FALSE(read.head.source.given->contact_said);
    EXPECT_EQ(read.head.source.given->file, "deck.k");
    EXPECT_EQ(read.head.source.given->options, head.source.given->options);
    const GivenTable& table = read.head.source.given->table;
    EXPECT_EQ(write_toml(table), write_toml(head.source.given->table));
    const GivenTable& time = *table.find("time")->as<GivenTable>();
    EXPECT_EQ(time.find("end")->place.text(""), "deck.k:7: *CONTROL_TERMINATION (endtim)");
    EXPECT_EQ(table.find("time")->place.text("unknown"), "unknown");
    EXPECT_EQ(std::vector<std::byte>(read.state.begin(), read.state.end()),
              std::vector<std::byte>(state.data(), state.data() + 5));
  }
}

TEST_F(Checkpoints, AChangedMeshFileIsAnError) {
  const std::string mesh = folder_ / "part.msh";
  std::string text = R"($MeshFormat
2.2 0 8
$EndMeshFormat
$Nodes
8
1 0 0 0
2 1 0 0
3 1 1 0
4 0 1 0
5 0 0 1
6 1 0 1
7 1 1 1
8 0 1 1
$EndNodes
$Elements
1
1 5 2 0 1 1 2 3 4 5 6 7 8
$EndElements
)";
  std::ofstream(mesh) << text;
  const std::string block = R"(type = "block", size = [0.1, 0.1, 0.1], elements = [1, 1, 1])";
  std::ofstream(folder_ / "scene.toml") << replaced(replaced(cube_scene, "end = 1e-4", "end = 1e-2"), block,
                                                    R"(type = "gmsh", file = "part.msh")");
  leave_checkpoint(folder_ / "scene.toml", 5);
  expect_done("--restart " + file_ + " --set time.steps=8");
  text.replace(text.find("7 1 1 1"), 7, "7 1 1 2");
  std::ofstream(mesh) << text;
  expect_input_error("--restart " + file_, "part.msh: is not what it was");
}

TEST_F(Checkpoints, DamagedFilesAreRejected) {
  leave_checkpoint("two_blocks", 25);
  const std::string whole = content(file_), damaged = folder_ / "damaged.pinball";
  EXPECT_NO_THROW(read_checkpoint(file_));
  const auto expect_error = [&](const std::string& bytes, const std::string& what) {
    std::ofstream(damaged, std::ios::binary) << bytes;
    EXPECT_THROW(read_checkpoint(damaged), InputError) << what;
  };
  std::mt19937 random(7);
  for (std::size_t length = 0; length < 64; ++length) expect_error(whole.substr(0, length), std::to_string(length));
  for (int i = 0; i < 100; ++i) {
    const std::size_t length = random() % whole.size();
    expect_error(whole.substr(0, length), "cut off at " + std::to_string(length));
  }
  for (std::size_t i = 0; i < 300; ++i) {
    std::string bytes = whole;
    const std::size_t place = i < 32 ? i : random() % whole.size();
    bytes[place] = static_cast<char>(bytes[place] ^ (1 << random() % 8));
    expect_error(bytes, "flipped at " + std::to_string(place));
  }
  expect_error(whole + 'x', "longer");
  expect_input_error("--restart " + damaged, "damaged");
}

/// Starts the program; returns its process.
pid_t start(const std::vector<std::string>& arguments) {
  const pid_t child = ::fork();
  if (child != 0) return child;
  std::vector<char*> argv{const_cast<char*>("pinball")};
  for (const std::string& a : arguments) argv.push_back(const_cast<char*>(a.c_str()));
  argv.push_back(nullptr);
  ::execv(PINBALL_PROGRAM, argv.data());
  ::_exit(127);
}

class KilledRuns : public Checkpoints {
 protected:
  void expect_kills_without_harm(const std::vector<std::string>& run);
};

/// Runs with these arguments, is killed at random moments, and comes to the results of a run without a break.
void KilledRuns::expect_kills_without_harm(const std::vector<std::string>& run) {
  std::vector<std::string> scene{"run"};
  std::string line;
  for (const std::string& word : run) {
    scene.push_back(word);
    line += word + ' ';
  }
  scene.insert(scene.end(), {"--quiet", "--checkpoint-every"});
  expect_done(line + "--threads 2 --out " + whole_);
  std::mt19937 random(3);
  using Time = std::filesystem::file_time_type;
  const auto written = [&] { return exists(file_) ? std::filesystem::last_write_time(file_) : Time{}; };
  int kills = 0, restarts = 0;
  for (bool done = false; !done;) {
    std::vector<std::string> arguments = scene;
    if (exists(file_)) {
      ASSERT_NO_THROW(read_checkpoint(file_));
      arguments = {"run", "--restart", file_, "--quiet", "--checkpoint-every"};
      ++restarts;
    }
    const std::string threads = std::to_string(1 + random() % 2);
    for (const std::string& more : {std::string("3"), std::string("--out"), half_, std::string("--threads"), threads}) {
      arguments.push_back(more);
    }
    const Time before = written();
    const pid_t child = start(arguments);
    int status = 0;
    bool ended = false;
    const auto look = [&](int how) { ended = ended || ::waitpid(child, &status, how) == child; };
    if (kills < 12) {
      // However slow the machine is, each start gets as far as its first checkpoint.
      for (; written() == before && !ended; look(WNOHANG)) ::usleep(500);
      if (!ended) {
        ::usleep(static_cast<useconds_t>(random() % 8000));
        ::kill(child, SIGKILL);
        ++kills;
      }
    }
    look(0);
    done = WIFEXITED(status);
    if (done) {
      EXPECT_EQ(WEXITSTATUS(status), 0);
    }
  }
  EXPECT_GT(restarts, 3);
  expect_same_results(half_, whole_);
  EXPECT_FALSE(exists(file_ + ".part"));
}

TEST_F(KilledRuns, GoOnFromTheirLatestCheckpoint) {
  expect_kills_without_harm({"rod_plate", "--set", "time.end=16e-6"});
}

TEST_F(KilledRuns, KnowWhatHasBegunAndEnded) {
  const std::string path = folder_ / "changing.toml";
  std::ofstream(path) << test::changing_scene;
  expect_kills_without_harm({path});
}

}  // namespace
}  // namespace pinball::checkpoint_test
