#include "file_bytes.hpp"

#include <filesystem>
#include <fstream>

#include <solver/base/error.hpp>

namespace pinball {

std::string bytes_of_file(const std::string& path) {
  std::error_code problem;
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  if (!file || std::filesystem::is_directory(path, problem))
    throw InputError(path + ": no such file, or it cannot be read");
  std::string bytes(static_cast<std::size_t>(file.tellg()), '\0');
  file.seekg(0);
  file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (!file) throw InputError(path + ": cannot be read");
  return bytes;
}

}  // namespace pinball
