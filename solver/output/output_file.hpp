#pragma once

#include <cstddef>
#include <cstdio>
#include <string>
#include <string_view>

namespace pinball {

/// Creates a folder and its parents where missing. Throws RunError that names the folder.
void make_folder(const std::string& folder);

/// A file that appears complete or not at all: it is written as `path.part` beside `path` and renamed by commit(), so
/// that a reader of a running job never meets half a file. Without commit() nothing is left behind. What is no file,
/// such as /dev/stdout, is written as it is: a file in its place would be the end of it.
/// Every member throws RunError "cannot write PATH: reason" when the disk is full, the folder not writable, ...
class OutputFile {
 public:
  explicit OutputFile(std::string path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  void write(const void* data, std::size_t bytes);
  void write(std::string_view text) { write(text.data(), text.size()); }
  void commit();
  /// The same, and waits until the disk has it: what was there before is not given up for less.
  void commit_durably();

 private:
  void close_and_rename();
  void remove_part() const;

  std::string path_;
  bool device_ = false;  ///< is_device(path_)
  std::string part_;
  std::FILE* file_ = nullptr;
};

/// Whether the path leads to a device, a pipe or a socket.
bool is_device(const std::string& path);

/// Throws RunError "cannot write PATH: reason", the reason taken from `error` (an errno; 0: unknown).
[[noreturn]] void throw_write_error(const std::string& path, int error);

}  // namespace pinball
