#include "output_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <system_error>

#include <solver/base/error.hpp>

namespace pinball {

void throw_write_error(const std::string& path, int error) {
  const std::string reason = error == 0 ? "unknown reason" : std::generic_category().message(error);
  throw RunError(fmt::format("cannot write {}: {}", path, reason));
}

void make_folder(const std::string& folder) {
  if (folder.empty()) return;
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw RunError(fmt::format("cannot create the output folder {}: {}", folder, error.message()));
}

bool is_device(const std::string& path) {
  std::error_code error;
  const std::filesystem::file_type kind = std::filesystem::status(path, error).type();
  using enum std::filesystem::file_type;
  return kind == character || kind == block || kind == fifo || kind == socket;
}

OutputFile::OutputFile(std::string path)
    : path_(std::move(path)), device_(is_device(path_)), part_(device_ ? path_ : path_ + ".part") {
  // What a killed run has left, or a link to a file of somebody else, which would be written in its place.
  std::error_code error;
  if (!device_ && (!std::filesystem::exists(part_, error) || std::filesystem::is_regular_file(part_, error)))
    std::filesystem::remove(part_, error);
  file_ = std::fopen(part_.c_str(), "wb");
  if (file_ == nullptr) throw_write_error(path_, errno);
}

OutputFile::~OutputFile() {
  if (file_ == nullptr) return;
  std::fclose(file_);
  remove_part();
}

void OutputFile::remove_part() const {
  if (!device_) std::remove(part_.c_str());
}

void OutputFile::write(const void* data, std::size_t bytes) {
  if (bytes == 0) return;
  errno = 0;
  if (std::fwrite(data, 1, bytes, file_) != bytes) throw_write_error(path_, errno);
}

void OutputFile::commit() {
  errno = 0;
  // A full disk may show only here, when the last buffer leaves.
  if (std::fflush(file_) != 0) throw_write_error(path_, errno);
  close_and_rename();
}

void OutputFile::commit_durably() {
  errno = 0;
  if (std::fflush(file_) != 0 || (!device_ && ::fsync(fileno(file_)) != 0)) throw_write_error(path_, errno);
  close_and_rename();
  const std::string folder = std::filesystem::path(path_).parent_path().string();
  const int descriptor = ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY);
  if (descriptor < 0) return;  // the file is there; how soon its name is on the disk is up to the system
  ::fsync(descriptor);
  ::close(descriptor);
}

void OutputFile::close_and_rename() {
  std::FILE* const file = file_;
  file_ = nullptr;
  if (std::fclose(file) != 0 || (!device_ && std::rename(part_.c_str(), path_.c_str()) != 0)) {
    const int error = errno;
    remove_part();
    throw_write_error(path_, error);
  }
}

}  // namespace pinball
