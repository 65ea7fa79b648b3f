#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include <solver/formats/deck/behind_end.hpp>

#include "keyword_block.hpp"

namespace pinball {

/// The bytes of a file as text: without a byte order mark, and with "\n" at the end of each line, whatever system wrote
/// it ("\r\n" stays as it is).
std::shared_ptr<const std::string> deck_text_of(std::string text);

/// Takes an ending such as "_TITLE" off a name.
bool take_ending(std::string& name, std::string_view ending);

/// Cuts the text of one file into keywords with their lines.
class KeywordScanner {
 public:
  /// How wide columns are until the file says otherwise.
  struct Widths {
    bool wide = false, twenty = false;  ///< as of a KeywordBlock
  };
  /// text has to stay. Throws InputError where something else stands before the first keyword.
  KeywordScanner(std::string_view text, const std::string& path, Widths widths);

  /// The next keyword, but for *KEYWORD itself; false: the file, or *END, ends here. after: what stands behind the
  /// name. Throws InputError for a format of *KEYWORD that is none.
  bool next(KeywordBlock& block, std::string& after);
  /// What has not been read once next has told the end.
  std::optional<DeckPlace> behind_end() const { return first_behind_end(rest_, place_, "*END", "$"); }

 private:
  void skip_to_keyword();
  std::string_view take_line();
  void read_name(KeywordBlock& block, std::string& after);
  void read_options(KeywordBlock& block) const;
  std::string_view take_body();
  void read_formats(const std::string& after, const DeckPlace& place);

  std::string_view rest_;
  DeckPlace place_;  ///< of the line before the rest
  Widths widths_;
};

}  // namespace pinball
