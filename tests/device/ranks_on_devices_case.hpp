#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include <tests/parallel/outcome.hpp>
#include <tests/parallel/shared_scenes.hpp>
#include <tests/support/changing_scene.hpp>
#include <tests/support/folder_case.hpp>

#include "device_case.hpp"

/// Several ranks with a device each beside one process on that device.
namespace pinball::test {

class RanksOnDevicesTest : public FolderTest, public testing::WithParamInterface<Device> {
 protected:
  explicit RanksOnDevicesTest(std::vector<Shared> ranks) : ranks_(std::move(ranks)) {}

  Scene on_device(Scene scene) const {
    scene.device = GetParam();
    return scene;
  }
  template <class S>
  Outcome expect_same(const Scene& scene) const {
    return expect_same_on<S>(ranks_, on_device(scene));
  }
  Scene changing() const {
    const std::string path = folder_ / "changing.toml";
    std::ofstream(path) << changing_scene;
    return read_scene(path);
  }
  /// From a state that three ranks have saved, alone and with two.
  void expect_to_go_on(const Scene& of) const {
    const Scene scene = on_device(of);
    Solver<double> alone(scene);
    const StateBytes bytes = state_of_three_ranks(scene, alone);
    const auto outcome = [](Solver<double>& solver) { return outcome_of(solver); };
    const Outcome expected = outcome_of(alone);
    Solver<double> other(scene);
    load(other, bytes);
    EXPECT_TRUE(outcome_of(other) == expected);
    EXPECT_TRUE(solved_on<double>(2, {}, scene, outcome, bytes) == expected);
  }

 private:
  std::vector<Shared> ranks_;
};

}  // namespace pinball::test
