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

}  // namespace pinball
