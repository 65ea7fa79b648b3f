#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "keyword_block.hpp"
#include "parameters.hpp"

namespace pinball {

/// A file that a deck includes.
struct IncludedFile {
  std::string name;  ///< as it is written
  DeckPlace place;   ///< of the card that names it
  std::shared_ptr<const DeckTransform> transform;
};

/// A line that is read when the deck is put together, and the fields of it that say something and were not asked for.
struct UnreadLine {
  std::string star_name;  ///< of its keyword
  DeckPlace place;
  ReadingLog::Left left;
};

/// Where included files are looked for: *INCLUDE_PATH, and the folders of the including file and of the deck.
class IncludedFiles {
 public:
  explicit IncludedFiles(const std::string& deck) : folder_(std::filesystem::path(deck).parent_path()) {}

  /// The files of a keyword, which may be none (*INCLUDE_PATH). outer: of the file that the keyword stands in. Throws
  /// InputError for transformations that are not read.
  std::vector<IncludedFile> read(const KeywordBlock& block, const Parameters& parameters,
                                 const std::shared_ptr<const DeckTransform>& outer);
  /// The path of a file that another one names.
  std::string find(const std::string& name, const std::string& including) const;
  /// Whether a keyword is one of those.
  static bool reads(const std::string& name);
  /// Lines of *INCLUDE_TRANSFORM.
  const std::vector<UnreadLine>& unread() const { return unread_; }

 private:
  std::filesystem::path folder_;
  std::vector<std::filesystem::path> paths_;
  std::vector<UnreadLine> unread_;
};

}  // namespace pinball
