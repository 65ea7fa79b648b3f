#pragma once

#include <cstddef>
#include <string>

namespace pinball {

/// The device on which runs are made, as its runtime has it.
struct GpuReport {
  std::string problem;  ///< what the runtime says where there is none; empty: there is one
  std::string name;
  std::size_t memory = 0;  ///< [bytes]
};

GpuReport gpu_report();

struct ChosenGpu {
  std::string problem;  ///< what the runtime says where there is none
  int number = -1, count = 0;
};

/// Makes one of the devices of this machine that of the calling thread: `number` modulo how many there are.
ChosenGpu choose_gpu(int number);

}  // namespace pinball
