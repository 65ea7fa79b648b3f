#include "run_folder.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <ctime>

#include <solver/base/error.hpp>
#include <solver/base/version.h>
#include <solver/device/devices.hpp>
#include <solver/summary.hpp>

#include "checkpoint.hpp"
#include "output_file.hpp"
#include "run_files.hpp"
#include "summary_head.hpp"

namespace pinball {

namespace {

namespace fs = std::filesystem;

constexpr const char* earlier_name = ".earlier";  ///< folder for what is set aside

bool same_file(const fs::path& a, const fs::path& b) {
  std::error_code error;
  return fs::equivalent(a, b, error);
}

std::string time_now() { return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr))); }

RunSummary known_of(const Scene& scene) {
  RunSummary head;
  head.scene = scene.name;
  head.title = scene.title;
  head.units = scene.units;
  head.version = PINBALL_VERSION;
  head.precision = name_of(scene.precision);
  head.device = device_name(scene.device);
  head.started = time_now();
  return head;
}

}  // namespace

RunFolder::RunFolder(const Scene& scene, const RecordOptions& options)
    : folder_(options.out), converged_(options.converged), head_(known_of(scene)) {
  if (folder_.empty()) return;
  if (options.restart != nullptr && same_file(fs::absolute(options.restart->path).parent_path(), folder_)) {
    restarted_ = options.restart->path;
  }
  open();
  if (continues()) return;  // the summary of the run so far holds until this one goes on
  set_aside();
  try {
    write_head(head_);
  } catch (...) {
    put_back();
    throw;
  }
}

void RunFolder::open() {
  std::error_code error;
  if (fs::is_symlink(folder_, error) && !fs::exists(folder_, error)) {
    throw InputError(fmt::format("--out {}: is a link to {}, which is not there", folder_,
                                 fs::read_symlink(folder_, error).string()));
  }
  made_ = fs::create_directories(folder_, error);
  if (error) throw InputError(fmt::format("--out {}: cannot make this folder: {}", folder_, error.message()));
  lock_.emplace(folder_);
  require_own_names();
}

/// What a run would lose, or end with, when it comes to write these files.
void RunFolder::require_own_names() const {
  std::error_code error;
  const auto refuse = [this](const fs::path& path, const char* expected, const char* got) {
    throw NoFileError(fmt::format("--out {}: expected {} to be {} of a run, got {}: move it away", folder_,
                                  path.string(), expected, got));
  };
  const fs::path taken = no_file_in(folder_), earlier = fs::path(folder_) / earlier_name;
  if (!taken.empty()) refuse(taken, "a file", fs::is_directory(taken, error) ? "a folder" : "something else");
  const fs::file_type kind = fs::symlink_status(earlier, error).type();
  if (kind != fs::file_type::directory && kind != fs::file_type::not_found)
    refuse(earlier, "a folder", "something else");
}

RunFolder::~RunFolder() {
  if (folder_.empty() || begun_ || ended_) return;
  put_back();
  lock_.reset();
  std::error_code error;
  if (made_) fs::remove(folder_, error);  // empty by now
}

void RunFolder::set_aside() const {
  remove_earlier();  // of a run that was killed while its scene was built
  const auto found = results_in(folder_);
  const fs::path earlier = fs::path(folder_) / earlier_name;
  std::error_code error;
  if (!found.empty()) fs::create_directory(earlier, error);
  for (const fs::path& path : found) {
    if (!error) fs::rename(path, earlier / path.filename(), error);
    if (error) {  // of another user, in a folder in which each may only move what is his
      restore_earlier();
      throw InputError(
          fmt::format("--out {}: cannot move {} of an earlier run: {}", folder_, path.string(), error.message()));
    }
  }
}

void RunFolder::put_back() const {
  if (continues()) return;
  std::error_code error;
  for (const fs::path& path : files_of(folder_, is_run_file)) fs::remove(path, error);
  restore_earlier();
}

void RunFolder::restore_earlier() const {
  std::error_code error;
  const fs::path earlier = fs::path(folder_) / earlier_name;
  for (const auto takes : {is_run_file, is_made_of_run}) {
    for (const fs::path& path : files_of(earlier, takes)) fs::rename(path, fs::path(folder_) / path.filename(), error);
  }
  fs::remove(earlier, error);
}

void RunFolder::remove_earlier() const {
  const fs::path earlier = fs::path(folder_) / earlier_name;
  std::error_code error;
  for (const auto takes : {is_run_file, is_made_of_run}) {
    for (const fs::path& path : files_of(earlier, takes)) fs::remove(path, error);
  }
  fs::remove(earlier, error);
}

void RunFolder::begin(const RunSummary& summary) {
  begun_ = true;
  if (folder_.empty()) return;
  if (!continues()) {
    remove_earlier();
  } else {
    for (const fs::path& path : results_in(folder_)) {
      const std::string name = path.filename().string();
      const bool follows =
          is_made_of_run(name) || name == page_name || name.starts_with("last_good.") || name.ends_with(".part");
      if (follows && !same_file(path, restarted_)) fs::remove(path);
    }
  }
  const std::string started = head_.started;
  head_ = summary;
  head_.started = started;
  head_.status = RunStatus::running;
  write_head(head_);
}

void RunFolder::end(const RunSummary& summary) {
  if (!folder_.empty()) write_summary(folder_, summary, converged_);
  ended_ = true;
}

void RunFolder::fail(const std::string& error) noexcept {
  if (folder_.empty() || ended_ || (continues() && !begun_)) return;
  try {
    if (!begun_) remove_earlier();
    head_.status = RunStatus::failed;
    head_.error = error;
    write_head(head_);
    ended_ = true;
  } catch (const std::exception&) {
    // The error itself is on its way to the user, and says more than that it could not be written.
  }
}

const std::string& RunFolder::warning() const {
  static const std::string none;
  return lock_ ? lock_->warning() : none;
}

void RunFolder::write_head(const RunSummary& summary) const {
  OutputFile file(in_folder(folder_, summary_name));
  file.write(summary_head_json(summary));
  file.commit();
}

}  // namespace pinball
