#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include <solver/base/error.hpp>
#include <solver/output/checkpoint.hpp>
#include <solver/output/folder_lock.hpp>
#include <solver/output/history.hpp>
#include <solver/output/out_of_memory.hpp>
#include <solver/output/recorder.hpp>
#include <solver/output/run_folder.hpp>
#include <solver/recorded_run.hpp>
#include <tests/support/error_of.hpp>
#include <tests/support/output_case.hpp>
#include <tests/support/program.hpp>
#include <tests/support/scene_text.hpp>

/// What a recorded run makes of its folder: whose files are there, and what summary.json says at any time.
namespace pinball::run_folder_test {
namespace {

using Json = nlohmann::json;
using test::content;
using test::error_of;
using testing::HasSubstr;
using testing::MatchesRegex;
using testing::StartsWith;

class RunFolders : public testing::Test {
 protected:
  static SceneSource source_of(const std::string& scene, const std::vector<std::string>& set = {}) {
    return read_scene_source(find_scene(scene), {.set = set});
  }
  RunSummary run(const SceneSource& source, const std::function<bool()>& stop = {}, const std::string& out = "out") {
    return run_recorded(read_scene(source), {folder_ / out, true, 0, &source, nullptr, stop});
  }
  /// A cube alone, whose steps are unstable above a cfl of 1.
  SceneSource unstable() {
    std::ofstream(folder_ / "scene.toml") << test::replaced(test::cube_scene, "end = 1e-4", "end = 1e-2\ncfl = 1.2");
    return source_of(folder_ / "scene.toml");
  }
  /// All nodes are behind its wall, which only the mesh shows.
  static SceneSource behind_a_wall() {
    return source_of("two_blocks", {"rigid_wall=[{ plane = { point = [0, 0, 9], normal = [0, 0, 1] } }]"});
  }
  void leave(const std::string& name, const std::string& text = "earlier") {
    std::filesystem::create_directories(folder_ / "out");
    std::ofstream(folder_ / ("out/" + name)) << text;
  }
  bool exists(const std::string& name) const { return std::filesystem::exists(folder_ / ("out/" + name)); }
  Json summary(const std::string& out = "out") const { return Json::parse(content(folder_ / (out + "/summary.json"))); }

  test::TemporaryFolder folder_{testing::UnitTest::GetInstance()->current_test_info()->name()};
};

TEST_F(RunFolders, ARunThatGoesOnSaysSoAndGivesNoNumbersOfItsStart) {
  leave("summary.json", R"({"status": "done", "state_hash": "0"})");
  Json during;
  run(source_of("two_blocks"), [&] {
    if (during.is_null()) during = summary();
    return false;
  });
  EXPECT_EQ(during["status"], "running");
  EXPECT_EQ(during["scene"], "two_blocks");
  EXPECT_EQ(during["elements"], 128);
  EXPECT_TRUE(during["error"].is_null());
  EXPECT_FALSE(during.contains("state_hash"));
  const Json after = summary();
  EXPECT_EQ(after["status"], "done");
  EXPECT_EQ(after["started"], during["started"]);
  EXPECT_EQ(after["steps"], 74);
}

TEST_F(RunFolders, WhatAnEarlierRunHasLeftIsRemovedAndNothingElse) {
  const std::vector<std::string> of_run{
      "fields.pvd",         "fields_0007.vtu", "fields_12345.vtu",     "last_good.vtu",     "last_good.pinball",
      "checkpoint.pinball", "fields.png",      "history.png",          "index.html.part",   "animation.webp",
      "fields_paraview.py", "view.png",        "fields_0001.vtu.part", "summary.json.part", "checkpoint.pinball.part"};
  const std::vector<std::string> others{"notes.txt",     "fields_.vtu", "fields_a.vtu",
                                        "my_index.html", "view.txt",    "a.part"};
  for (const std::string& name : of_run) leave(name);
  for (const std::string& name : others) leave(name);
  leave("summary.json", "{}");
  run(source_of("two_blocks", {"output.field_interval=0"}));
  for (const std::string& name : of_run) EXPECT_FALSE(exists(name)) << name;
  for (const std::string& name : others) EXPECT_TRUE(exists(name)) << name;
  EXPECT_FALSE(exists(".earlier"));
  EXPECT_FALSE(exists("pinball.lock"));
}

TEST_F(RunFolders, PicturesBesideNoRunBelongToSomebodyElse) {
  leave("fields.png");
  leave("view.png");
  run(source_of("two_blocks"));
  EXPECT_TRUE(exists("fields.png"));
  EXPECT_TRUE(exists("view.png"));
}

TEST_F(RunFolders, BadInputThatTheMeshShowsLeavesTheFolderAsItWas) {
  const auto message = [&] { return error_of<InputError>([&] { run(behind_a_wall()); }); };
  EXPECT_THAT(message(), HasSubstr("rigid_wall"));
  EXPECT_FALSE(exists("")) << "the folder was not there";
  run(source_of("two_blocks", {"output.field_times=[0]"}));
  leave("history.png");
  const std::string before = content(folder_ / "out/summary.json");
  EXPECT_THAT(message(), HasSubstr("rigid_wall"));
  EXPECT_EQ(content(folder_ / "out/summary.json"), before);
  for (const char* name : {"history.csv", "fields.pvd", "fields_0000.vtu", "history.png"}) EXPECT_TRUE(exists(name));
  EXPECT_FALSE(exists(".earlier"));
}

TEST_F(RunFolders, WhatIsInThePlaceOfAFileIsToldBeforeTheRun) {
  leave("history.csv");
  for (const char* name : {"summary.json", "index.html", "fields_0003.vtu", "checkpoint.pinball.part"}) {
    std::filesystem::create_directories(folder_ / (std::string("out/") + name));
    EXPECT_THAT(
        error_of<InputError>([&] { run(source_of("two_blocks")); }),
        MatchesRegex(fmt::format("--out .*out: expected .*out/{} to be a file of a run, got a folder: .*", name)));
    EXPECT_EQ(content(folder_ / "out/history.csv"), "earlier");
    EXPECT_FALSE(exists("pinball.lock"));
    std::filesystem::remove(folder_ / (std::string("out/") + name));
  }
  ASSERT_EQ(::mkfifo((folder_ / "out/history.csv.part").c_str(), 0600), 0);
  EXPECT_THAT(error_of<InputError>([&] { run(source_of("two_blocks")); }), HasSubstr("got something else"));
  std::filesystem::remove(folder_ / "out/history.csv.part");
  leave(".earlier", "of somebody");
  EXPECT_THAT(error_of<InputError>([&] { run(source_of("two_blocks")); }), HasSubstr("to be a folder of a run"));
  EXPECT_EQ(content(folder_ / "out/.earlier"), "of somebody");
}

/// As files of another user in a folder like /tmp.
TEST_F(RunFolders, WhatAnEarlierRunHasLeftAndCannotBeMovedStaysAndIsTold) {
  leave("summary.json");
  leave("history.csv");
  leave("fields_0000.vtu");
  std::filesystem::create_directories(folder_ / "out/.earlier/history.csv/in the way");
  EXPECT_THAT(error_of<InputError>([&] { run(source_of("two_blocks")); }),
              HasSubstr("history.csv of an earlier run: "));
  for (const char* name : {"summary.json", "history.csv", "fields_0000.vtu"})
    EXPECT_EQ(content(folder_ / (std::string("out/") + name)), "earlier") << name;
}

TEST_F(RunFolders, ARunWithoutOneLeavesNothing) {
  const std::filesystem::path here = std::filesystem::current_path();
  std::filesystem::current_path(folder_.path);
  const SceneSource source = source_of("two_blocks");
  const RunSummary summary = run_recorded(read_scene(source), {"", true, 0, &source});
  std::filesystem::current_path(here);
  EXPECT_EQ(summary.status, RunStatus::done);
  EXPECT_TRUE(std::filesystem::is_empty(folder_.path));
}

/// While the scene is built, for one.
TEST_F(RunFolders, AFailureBeforeTheRunHasBegunIsKept) {
  const SceneSource source = source_of("two_blocks");
  leave("summary.json", "{}");
  { RunFolder(read_scene(source), {folder_ / "out", true, 0, &source}).fail("no memory"); }
  EXPECT_EQ(summary()["status"], "failed");
  EXPECT_EQ(summary()["error"], "no memory");
  { RunFolder(read_scene(source), {folder_ / "out", true, 0, &source}); }
  EXPECT_EQ(summary()["error"], "no memory") << "what neither has begun nor failed leaves the folder as it was";
}

TEST_F(RunFolders, AFailedRunSaysWhy) {
  const std::string error = error_of<RunError>([&] { run(unstable()); });
  const Json json = summary();
  EXPECT_EQ(json["status"], "failed");
  EXPECT_THAT(json["error"].get<std::string>(), HasSubstr("energy balance"));
  EXPECT_THAT(error, StartsWith(json["error"].get<std::string>()));
  EXPECT_GT(json["steps"], 0);
}

TEST_F(RunFolders, WhatWasComputedIsKeptWhereThePageCannotBeWritten) {
  const std::string error = error_of<RunError>([&] {
    run(source_of("two_blocks"), [&] {
      std::filesystem::create_directories(folder_ / "out/index.html");
      return false;
    });
  });
  EXPECT_THAT(error, HasSubstr("index.html"));
  EXPECT_EQ(summary()["status"], "failed");
  EXPECT_EQ(summary()["steps"], 74);
  EXPECT_TRUE(summary().contains("state_hash"));
}

TEST_F(RunFolders, AnErrorInTheMiddleThatIsNoneOfTheRunIsToldToo) {
  const std::string error =
      error_of<std::bad_alloc>([&] { run(source_of("two_blocks"), []() -> bool { throw std::bad_alloc(); }); });
  EXPECT_THAT(error, MatchesRegex("out of memory in step 1 at time [0-9.e-]+, which takes at least [0-9]+ MiB: the "
                                  "program had up to [0-9]+ MiB of the [0-9]+ MiB of this machine, and .*"));
  EXPECT_EQ(summary()["status"], "failed");
  EXPECT_EQ(summary()["error"], error);
}

/// Both numbers in MiB; what a mesh of a file takes nobody knows before it is read.
TEST(OutOfMemoryText, HasWhatTheSystemSaysAndWhatIsKnown) {
  Scene scene;
  Body body;
  body.mesh = FileMesh{};
  scene.bodies = {body};
  EXPECT_EQ(least_bytes(scene), 0);
  const auto most_held = [] {
    struct rusage usage {};
    ::getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024;
  };
  { const std::string much(std::size_t{256} << 20U, 'x'); }  // so that a part of it is more than it is rounded by
  const double before = most_held();
  EXPECT_GT(before, 200);
  const std::string text = OutOfMemory("while it was tried", 3.4 * 1024 * 1024).what();
  EXPECT_THAT(text, StartsWith("out of memory while it was tried, which takes at least 3 MiB: the program had up to "));
  const double told = std::stod(text.substr(text.find("had up to ") + 10));
  EXPECT_GE(told, std::floor(before));
  EXPECT_LE(told, std::ceil(most_held()));
  EXPECT_THAT(OutOfMemory("").what(), StartsWith("out of memory: the program had up to "));
}

TEST_F(RunFolders, WhatCannotBeSavedAfterAFailureComesAfterTheError) {
  const std::string error = error_of<RunError>([&] {
    run(unstable(), [&] {  // while it goes on: before, the run is refused
      std::filesystem::create_directories(folder_ / "out/last_good.pinball.part");
      return false;
    });
  });
  EXPECT_THAT(error, StartsWith("the energy balance"));
  EXPECT_THAT(error, HasSubstr("; the last good state is lost: cannot write " + (folder_ / "out/last_good.pinball")));
  EXPECT_EQ(summary()["status"], "failed");
}

TEST_F(RunFolders, AStoppedRunGoesOnWithTheSameBits) {
  for (const char* scene : {"two_blocks", "refined_layer"}) {  // the second one with subcycling
    const SceneSource source = source_of(scene, {"time.steps=60", "output.field_interval=3e-5", "precision=float"});
    const RunSummary whole = run(source, {}, "whole");
    int steps = 0;
    const RunSummary half = run(source, [&steps] { return ++steps == 3; });
    EXPECT_EQ(half.status, RunStatus::stopped);
    EXPECT_LT(half.steps, whole.steps);
    EXPECT_EQ(summary()["status"], "stopped");
    EXPECT_THAT(content(folder_ / "out/history.csv"), HasSubstr("\n" + std::to_string(half.steps) + ","));
    EXPECT_THAT(content(folder_ / "out/fields.pvd"), HasSubstr("fields_0001.vtu"));
    leave("history.png");

    const Checkpoint checkpoint = read_checkpoint(folder_ / "out/checkpoint.pinball");
    const RunSummary end = run_recorded(read_scene(checkpoint.head.source),
                                        {folder_ / "out", true, 0, &checkpoint.head.source, &checkpoint});
    EXPECT_EQ(end.status, RunStatus::done);
    EXPECT_EQ(end.state_hash, whole.state_hash);
    EXPECT_EQ(end.steps, whole.steps);
    for (const char* name : {"history.csv", "fields.pvd"}) {
      EXPECT_EQ(content(folder_ / ("out/" + std::string(name))), content(folder_ / ("whole/" + std::string(name))));
    }
    EXPECT_FALSE(exists("history.png")) << "of half a run";
  }
}

/// As if the first part had taken a day.
TEST_F(RunFolders, TheTimeOfARunThatGoesOnIsThatOfBothParts) {
  const SceneSource source = source_of("two_blocks");
  const RunSummary half = run(source, [] { return true; });
  const std::string path = folder_ / "out/checkpoint.pinball";
  Checkpoint checkpoint = read_checkpoint(path);
  StateArchive archive = StateArchive::reading(checkpoint.state);
  RunRecord record;
  record.persist(archive);
  EXPECT_GT(record.wall_seconds, 0);
  EXPECT_LE(record.wall_seconds, half.wall_seconds);
  record.wall_seconds = 86400;
  const std::span<const std::byte> rest = archive.rest();
  StateBytes later;
  StateArchive::save(later, [&](StateArchive& to) {
    record.persist(to);
    for (const std::byte byte : rest) {
      std::byte one = byte;
      to(one);
    }
  });
  write_checkpoint(path, checkpoint.head, later);
  checkpoint = read_checkpoint(path);
  const RunSummary end = run_recorded(read_scene(checkpoint.head.source),
                                      {folder_ / "out", true, 0, &checkpoint.head.source, &checkpoint});
  EXPECT_GT(end.wall_seconds, 86400);
  EXPECT_EQ(summary()["wall_seconds"], end.wall_seconds);
}

TEST_F(RunFolders, ARestartThatIsRefusedLeavesItsFolderAsItWas) {
  const SceneSource source = source_of("two_blocks");
  run(source, [] { return true; });
  const std::string before = content(folder_ / "out/summary.json");
  const Checkpoint checkpoint = read_checkpoint(folder_ / "out/checkpoint.pinball");
  SceneSource shorter = source;
  change_scene(shorter, {"time.end=1e-9"});
  EXPECT_THAT(error_of<InputError>([&] {
                run_recorded(read_scene(shorter), {folder_ / "out", true, 0, &shorter, &checkpoint});
              }),
              HasSubstr("time.end"));
  EXPECT_EQ(content(folder_ / "out/summary.json"), before);
  EXPECT_TRUE(exists("checkpoint.pinball"));
}

TEST_F(RunFolders, TwoRunsCannotHaveOne) {
  const SceneSource source = source_of("two_blocks");
  std::string refused;
  run(source, [&] {
    if (refused.empty()) refused = error_of<InputError>([&] { run(source); });
    return false;
  });
  EXPECT_THAT(refused, StartsWith("--out " + (folder_ / "out") + ": process " + std::to_string(::getpid()) + " on "));
  EXPECT_EQ(summary()["status"], "done");
  EXPECT_EQ(summary()["steps"], 74);
  run(source);  // and another one afterwards
}

TEST_F(RunFolders, ALockWritesIntoNoFileOfOthers) {
  const std::string kept = folder_ / "kept", lock = folder_ / "out/pinball.lock";
  std::filesystem::create_directories(folder_ / "out");
  std::ofstream(kept) << "mine";
  const auto refusal = [&] { return error_of([&] { run(source_of("two_blocks")); }); };
  const auto refused = HasSubstr(": expected " + lock + " to be the lock of a run, got something else");
  std::filesystem::create_symlink(kept, lock);
  EXPECT_THAT(refusal(), refused);
  std::filesystem::remove(lock);
  std::filesystem::create_symlink(folder_ / "none", lock);
  EXPECT_THAT(refusal(), refused);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "none"));
  std::filesystem::remove(lock);
  std::filesystem::create_hard_link(kept, lock);
  EXPECT_THAT(refusal(), refused);
  std::filesystem::remove(lock);
  std::filesystem::create_directory(lock);
  EXPECT_THAT(refusal(), HasSubstr("--out "));
  std::filesystem::remove(lock);
  leave("pinball.lock", "notes of somebody");
  EXPECT_THAT(refusal(), refused);
  EXPECT_EQ(content(lock), "notes of somebody");
  EXPECT_EQ(content(kept), "mine");
  for (const char* dead : {"", "process 1 on here\n"}) {  // of runs that were killed
    leave("pinball.lock", dead);
    EXPECT_EQ(refusal(), test::no_error) << dead;
  }
}

TEST_F(RunFolders, AFileBeingWrittenIsNoLinkToAnother) {
  const std::string kept = folder_ / "kept";
  std::filesystem::create_directories(folder_ / "out");
  std::ofstream(kept) << "mine";
  for (const char* name : {"summary.json.part", "index.html.part", "history.csv"})
    std::filesystem::create_symlink(kept, folder_ / (std::string("out/") + name));
  run(source_of("two_blocks"));
  EXPECT_EQ(content(kept), "mine");
  EXPECT_EQ(summary()["status"], "done");
}

TEST_F(RunFolders, AFileSystemWithoutLocksGivesAWarning) {
  const FolderLock lock(folder_.path.string(), [](int, int) {
    errno = ENOLCK;
    return -1;
  });
  EXPECT_THAT(lock.warning(), HasSubstr("has no locks"));
  EXPECT_EQ(FolderLock(folder_.path.string()).warning(), "");
}

TEST_F(RunFolders, AHistoryThatCannotBeOpenedIsNamed) {
  std::filesystem::create_directory(folder_ / "history.csv");
  EXPECT_THAT(error_of<RunError>([&] { HistoryWriter(folder_.path.string(), {}); }),
              testing::AllOf(HasSubstr("history.csv: "), HasSubstr("directory")));
}

TEST_F(RunFolders, ALinkToNothingIsNamed) {
  std::filesystem::create_directory_symlink("nowhere", folder_ / "link");
  EXPECT_THAT(error_of<InputError>([&] { run(source_of("two_blocks"), {}, "link"); }),
              HasSubstr("link: is a link to nowhere, which is not there"));
}

}  // namespace
}  // namespace pinball::run_folder_test
