#pragma once

#include <string>

namespace pinball {

/// Keeps a second run out of a folder. The lock is the system's (flock) on the file `pinball.lock`, which names the
/// process that has it: it ends with the process, however that ends, and a file left behind locks nothing.
class FolderLock {
 public:
  using System = int (*)(int descriptor, int operation);  ///< as flock(2)

  /// `folder` is there. Throws InputError that names the folder and the process where another run has it, where no
  /// file can be written, and where a file or link of that name is none of a run.
  explicit FolderLock(const std::string& folder);
  FolderLock(const std::string& folder, System system);  ///< for file systems that a test has not
  ~FolderLock();                                         ///< removes the file
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

  /// What a file system that knows no locks gives in place of one; else empty.
  const std::string& warning() const { return warning_; }

 private:
  bool lock(System system);
  void require_own_file() const;
  [[noreturn]] void throw_foreign() const;
  void name_holder() const;

  std::string folder_, path_, warning_;
  int descriptor_ = -1;
};

}  // namespace pinball
