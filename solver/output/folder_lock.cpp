#include "folder_lock.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <iterator>
#include <string_view>
#include <system_error>

#include <solver/base/error.hpp>

#include "run_files.hpp"

namespace pinball {

namespace {

/// "process 4711 on HOST", as the file says; else "another run".
std::string holder(int descriptor) {
  std::array<char, 256> text{};
  const ssize_t length = ::pread(descriptor, text.data(), text.size(), 0);
  const std::string line(text.data(), length > 0 ? length : 0);
  return line.empty() ? "another run" : line.substr(0, line.find('\n'));
}

/// Whether the path still leads to the file that is open: its owner may have removed it meanwhile.
bool is_file_at(int descriptor, const std::string& path) {
  struct stat opened {
  }, there{};
  return ::fstat(descriptor, &opened) == 0 && ::stat(path.c_str(), &there) == 0 && opened.st_dev == there.st_dev &&
         opened.st_ino == there.st_ino;
}

}  // namespace

FolderLock::FolderLock(const std::string& folder) : FolderLock(folder, ::flock) {}

FolderLock::FolderLock(const std::string& folder, System system)
    : folder_(folder), path_(in_folder(folder, lock_name)) {
  while (!lock(system)) {
  }
  name_holder();
}

FolderLock::~FolderLock() {
  ::unlink(path_.c_str());  // before another can have it
  ::close(descriptor_);
}

/// Returns whether the file that is locked is the one that others find.
bool FolderLock::lock(System system) {
  descriptor_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK, 0666);
  if (descriptor_ < 0 && errno == ELOOP) throw_foreign();
  if (descriptor_ < 0) {
    throw InputError(fmt::format("--out {}: cannot write there: {}", folder_, std::generic_category().message(errno)));
  }
  require_own_file();
  if (system(descriptor_, LOCK_EX | LOCK_NB) != 0) {
    const int error = errno;
    if (error == EWOULDBLOCK) {
      const std::string other = holder(descriptor_);
      ::close(descriptor_);
      throw InputError(fmt::format(
          "--out {}: {} is writing its results there: wait for its end, or choose another folder with --out", folder_,
          other));
    }
    warning_ = fmt::format("{}: the file system has no locks ({}): no other run may write there meanwhile", folder_,
                           std::generic_category().message(error));
    return true;
  }
  if (is_file_at(descriptor_, path_)) return true;
  ::close(descriptor_);
  return false;
}

/// What the name is that of something else, whose content would be lost.
void FolderLock::require_own_file() const {
  struct stat there {};
  constexpr std::string_view begin = "process ";
  std::array<char, begin.size()> text{};
  const bool is_file = ::fstat(descriptor_, &there) == 0 && S_ISREG(there.st_mode) && there.st_nlink <= 1;
  if (is_file && (there.st_size == 0 || (::pread(descriptor_, text.data(), text.size(), 0) == std::ssize(begin) &&
                                         std::string_view(text.data(), text.size()) == begin))) {
    return;
  }
  ::close(descriptor_);
  throw_foreign();
}

void FolderLock::throw_foreign() const {
  throw InputError(
      fmt::format("--out {}: expected {} to be the lock of a run, got something else: move it away", folder_, path_));
}

/// A name is a help, not needed: what goes wrong here is left alone.
void FolderLock::name_holder() const {
  std::array<char, 128> host{};
  if (::gethostname(host.data(), host.size() - 1) != 0) host[0] = '\0';
  const std::string text = fmt::format("process {} on {}\n", ::getpid(), host.data());
  if (::ftruncate(descriptor_, 0) != 0) return;
  [[maybe_unused]] const ssize_t written = ::pwrite(descriptor_, text.data(), text.size(), 0);
}

}  // namespace pinball
