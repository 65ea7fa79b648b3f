#include "result_file.hpp"

#include <unistd.h>

#include <filesystem>

#include <solver/base/error.hpp>
#include <solver/output/output_file.hpp>

namespace pinball {

void check_result_path(const std::string& option, const std::string& path) {
  if (path.empty()) return;
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) {
    throw InputError(option + ' ' + path + ": expected a file, got a folder");
  }
  if (is_device(path)) {  // whose reader would take the look for the end
    if (::access(path.c_str(), W_OK) != 0) throw InputError(option + ' ' + path + ": cannot write there");
    return;
  }
  try {
    const OutputFile file(path);
  } catch (const RunError& failure) {
    throw InputError(option + ": " + failure.what());
  }
}

void write_result_file(const std::string& path, const std::string& text) {
  OutputFile file(path);
  file.write(text);
  file.commit();
}

}  // namespace pinball
