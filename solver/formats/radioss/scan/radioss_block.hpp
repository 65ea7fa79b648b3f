#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <solver/formats/deck/data_line.hpp>

namespace pinball {

/// Data lines as they stand in one file, comments among them.
struct RadiossText {
  std::string_view text;
  DeckPlace before;  ///< the line before the first
};

/// A keyword of Radioss input with its lines, which may come from several files.
struct RadiossBlock {
  std::string name;                   ///< its words in upper case, a law by its name: "MAT/ELAST" of "/MAT/LAW1/3"
  std::string title;                  ///< for people, as written: "/MAT/LAW1/3"
  std::vector<std::int64_t> numbers;  ///< behind the words
  std::vector<RadiossText> data;
  DeckPlace place;
  bool engine = false;        ///< whether it is of the engine's input
  bool titled = false;        ///< whether its first line is a title
  ReadingLog* log = nullptr;  ///< where it is written down what of it is read; null: nowhere

  /// The number of what it defines. Throws InputError where there is none.
  std::int64_t id() const;
  /// The number of its units, behind that of what it defines, which /NODE and /INIBRI have not; 0: those of the deck.
  std::int64_t unit() const {
    const std::size_t at = name == "NODE" || name.starts_with("INIBRI/") ? 0 : 1;
    return numbers.size() > at ? numbers[at] : 0;
  }
};

/// The lines of a block that are no comments, one after the other. A title is not among them.
class RadiossLines {
 public:
  explicit RadiossLines(const RadiossBlock& block);
  RadiossLines(const RadiossLines&) = delete;
  RadiossLines& operator=(const RadiossLines&) = delete;
  ~RadiossLines() {
    if (block_->log != nullptr) block_->log->reached(block_, lines_);
  }

  std::optional<DataLine> next();
  /// The next line that is not blank.
  std::optional<DataLine> next_filled();
  /// The next line. Throws InputError naming what was expected where the block ends before it.
  DataLine require(const std::string& expected);
  /// The next line, or a blank one where the block ends: those of defaults may be left out.
  DataLine next_or_blank();
  /// What stands in the first line of a block that has a title.
  const std::string& title() const { return title_; }

 private:
  void open(std::size_t segment);
  bool take(std::string_view& line);

  const RadiossBlock* block_;
  std::size_t segment_ = 0, lines_ = 0;  ///< lines_: that were taken, the title among them
  std::string_view rest_;
  DeckPlace place_;
  std::string title_;
};

/// Whether a line of Radioss input is a comment.
inline bool is_radioss_comment(std::string_view line) {
  return !line.empty() && (line.front() == '#' || line.front() == '$');
}

}  // namespace pinball
