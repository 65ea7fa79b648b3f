#pragma once

#include <memory>
#include <string>
#include <string_view>

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
  /// text has to stay. wide: whether the numbers of nodes and elements have ten columns until the file says otherwise.
  /// Throws InputError where something else stands before the first keyword.
  KeywordScanner(std::string_view text, const std::string& path, bool wide);

  /// The next keyword, but for *KEYWORD itself; false: the file, or *END, ends here. after: what stands behind the
  /// name. Throws InputError for cards of twenty columns.
  bool next(KeywordBlock& block, std::string& after);
  /// Of the keywords that come, as *KEYWORD of this file has it.
  bool wide() const { return wide_; }

 private:
  void skip_to_keyword();
  std::string_view take_line();
  void read_name(KeywordBlock& block, std::string& after);
  void read_options(KeywordBlock& block) const;
  std::string_view take_body();
  void read_formats(const std::string& after, const DeckPlace& place);

  std::string_view rest_;
  DeckPlace place_;  ///< of the line before the rest
  bool wide_;
};

}  // namespace pinball
