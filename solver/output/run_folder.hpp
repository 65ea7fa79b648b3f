#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include <solver/base/error.hpp>
#include <solver/base/export.h>
#include <solver/recorded_run.hpp>

#include "folder_lock.hpp"

namespace pinball {

/// Something in the folder of a run has the name of one of its files and is none. A study of several runs goes on with
/// the others.
struct NoFileError : InputError {
  using InputError::InputError;
};

/// The folder of a run, from before its scene is built to its end: no other run writes there, what an earlier one has
/// left goes, and summary.json says what has become of this one. Does nothing where nothing is to be written.
///
/// What an earlier run has left is set aside first and removed when the scene is built: bad input leaves the folder as
/// it was. A restart in the folder of its checkpoint keeps all but what follows from results: pictures, pages, the
/// last good state, and what a study says of the run.
class RunFolder {
 public:
  /// Throws InputError that names the folder where it cannot be used (NoFileError: for what is in it), RunError where
  /// the summary cannot be written.
  RunFolder(const Scene& scene, const RecordOptions& options);
  /// Puts back what was there where the run has not begun.
  ~RunFolder();
  RunFolder(const RunFolder&) = delete;
  RunFolder& operator=(const RunFolder&) = delete;

  /// The scene is built and what is to be gone on from has been read.
  void begin(const RunSummary& summary);
  /// Writes the summary of a run that has ended, however it has.
  void end(const RunSummary& summary);
  /// Writes that the run has failed, unless end() has said more; error: why.
  void fail(const std::string& error) noexcept;

  const std::string& started() const { return head_.started; }  ///< RunSummary::started
  bool begun() const { return begun_; }
  /// Whether it holds the files of the run that is restarted.
  bool continues() const { return !restarted_.empty(); }

  /// What the user should know of the folder; else empty.
  const std::string& warning() const;

 private:
  void open();
  void require_own_names() const;
  void set_aside() const;
  void put_back() const;
  void restore_earlier() const;
  void remove_earlier() const;
  void write_head(const RunSummary& summary) const;

  std::string folder_;     ///< empty: nothing is written
  std::string converged_;  ///< as in RecordOptions
  std::string restarted_;  ///< file from which the run goes on in this folder; empty: it is a new run
  bool made_ = false;      ///< the folder was not there
  bool begun_ = false, ended_ = false;
  std::optional<FolderLock> lock_;
  RunSummary head_;  ///< what is known of the run before it has begun
};

}  // namespace pinball
