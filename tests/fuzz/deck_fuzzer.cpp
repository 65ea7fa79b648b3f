#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

#include "../formats/lsdyna/deck_trial.hpp"

/// A target of libFuzzer: any bytes as a deck.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::string path =
      (std::filesystem::temp_directory_path() / ("pinball_fuzz_" + std::to_string(::getpid()) + ".k")).string();
  std::ofstream(path, std::ios::binary).write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  pinball::test::try_deck(path);
  return 0;
}
