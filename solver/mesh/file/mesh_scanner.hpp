#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

namespace pinball {

/// Words and numbers of a mesh file, with the line they are in. The names of sections, and what stands before the data
/// of some, are text in every file; the data itself is text or binary. Every function that reads throws InputError
/// "NAME:LINE: expected WHAT, got ..." if there is something else; of a binary file "NAME: byte PLACE: ...".
class MeshScanner {
 public:
  MeshScanner(std::string_view text, std::string name) : text_(text), name_(std::move(name)) {}

  /// Whether nothing but white space is left.
  bool at_end();
  int line() const { return line_; }
  const std::string& name() const { return name_; }
  /// "NAME:LINE", or "NAME: byte PLACE" of binary data.
  std::string place() const;

  std::string_view word(std::string_view expected);
  /// Whether the next line begins with these characters.
  bool next_line_begins(std::string_view characters) const;
  /// The word itself must be the one expected.
  void keyword(std::string_view expected);
  std::int64_t integer(std::string_view expected);
  std::int64_t count(std::string_view expected);  ///< integer >= 0
  double number(std::string_view expected);       ///< finite
  std::string quoted(std::string_view expected);  ///< text between two "
  /// Skips the rest of a line of which something has been read.
  void skip_line(std::string_view expected);
  /// Skips all up to a word, and the word.
  void skip_to(std::string_view word);

  /// What is left of the line; passes its end.
  std::string_view rest_of_line();

  /// From here on sections may have binary data.
  void set_binary() { binary_ = true; }
  bool binary() const { return binary_; }
  /// Passes the end of the line before binary data.
  void begin_data();
  std::int64_t data_integer(std::string_view expected);                       ///< 4 bytes
  std::int64_t data_long(std::string_view expected);                          ///< 8 bytes
  std::int64_t data_count(std::string_view expected);                         ///< 8 bytes, >= 0
  double data_number(std::string_view expected);                              ///< 8 bytes, finite
  std::string_view data_bytes(std::size_t count, std::string_view expected);  ///< of binary data
  void end_data() { in_data_ = false; }

  /// A count of things must find place in what is left of the file: so that no memory is taken for what is not there.
  /// bytes: of each of them in binary data; words: in text.
  void require_room(std::int64_t count, std::int64_t bytes, std::int64_t words, std::string_view expected) const;

  [[noreturn]] void fail(std::string_view expected, std::string_view got) const;

 private:
  void skip_space();
  template <class T>
  T bytes(std::string_view expected);

  std::string_view text_;
  std::string name_;
  std::size_t at_ = 0;
  int line_ = 1;
  bool binary_ = false, in_data_ = false;
};

}  // namespace pinball
