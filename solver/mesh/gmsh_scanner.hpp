#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace pinball {

/// Words and numbers of a text, with the line they are in. Every function that reads throws InputError
/// "NAME:LINE: expected WHAT, got ..." if there is something else.
class GmshScanner {
 public:
  GmshScanner(std::string_view text, std::string name) : text_(text), name_(std::move(name)) {}

  /// Whether nothing but white space is left.
  bool at_end();
  int line() const { return line_; }
  const std::string& name() const { return name_; }

  std::string_view word(const std::string& expected);
  /// The word itself must be the one expected.
  void keyword(std::string_view expected);
  std::int64_t integer(const std::string& expected);
  std::int64_t count(const std::string& expected);  ///< integer >= 0
  double number(const std::string& expected);       ///< finite
  std::string quoted(const std::string& expected);  ///< text between two "
  /// Skips the rest of a line of which something has been read.
  void skip_line(const std::string& expected);

  [[noreturn]] void fail(const std::string& expected, std::string_view got) const;

 private:
  void skip_space();

  std::string_view text_;
  std::string name_;
  std::size_t at_ = 0;
  int line_ = 1;
};

}  // namespace pinball
