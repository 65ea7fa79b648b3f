#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "abaqus_text.hpp"

namespace pinball {

/// Data lines as they stand in one file, comments among them.
struct DataText {
  std::string_view text;
  DeckPlace before;  ///< the line before the first
};

/// A keyword of Abaqus input with its parameters and data lines, which may come from several files.
struct AbaqusBlock {
  std::string name;                                             ///< without case and blanks: "SOLIDSECTION"
  std::string title;                                            ///< for people: "SOLID SECTION"
  std::vector<std::pair<std::string, std::string>> parameters;  ///< names without case and blanks; values as written
  std::vector<DataText> data;
  DeckPlace place;

  std::string part, instance;  ///< labels of those that it stands in; empty: none
  bool assembly = false;       ///< whether it stands in *ASSEMBLY
  int step = 0;                ///< number of the step that it belongs to; 0: to the model
  ReadingLog* log = nullptr;   ///< where it is written down what of it is read; null: nowhere

  /// Whether its data lines, a mesh, are too many to follow them one by one.
  bool is_mesh() const { return name == "NODE" || name == "ELEMENT"; }
  bool has(const char* parameter) const { return find(parameter) != nullptr; }
  /// Value as written; none: not given.
  std::optional<std::string> value(const char* parameter) const;
  /// Value without case and blanks; empty: not given, or without a value.
  std::string option(const char* parameter) const;
  /// Value as written. Throws InputError where it is not given.
  std::string require(const char* parameter) const;
  /// Throws InputError for a value that is no number.
  double number(const char* parameter, double otherwise) const;
  std::string star_name() const { return '*' + title; }

 private:
  const std::string* find(const char* parameter) const;
};

/// The data lines of a block that are no comments and not empty, one after the other.
class DataLines {
 public:
  explicit DataLines(const AbaqusBlock& block) : block_(&block) { open(0); }
  DataLines(const DataLines&) = delete;
  DataLines& operator=(const DataLines&) = delete;
  ~DataLines() {
    if (block_->log != nullptr) block_->log->reached(block_, lines_);
  }
  std::optional<DataLine> next();
  /// The next line. Throws InputError naming what was expected where there is none.
  DataLine require(const std::string& expected);

 private:
  void open(std::size_t segment);

  const AbaqusBlock* block_;
  std::size_t segment_ = 0;
  std::string_view rest_;
  DeckPlace place_;
  std::size_t lines_ = 0;  ///< that were taken
};

}  // namespace pinball
