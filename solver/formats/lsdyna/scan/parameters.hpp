#pragma once

#include <map>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <solver/formats/deck/expression.hpp>

#include "keyword_block.hpp"

namespace pinball {

/// Values of *PARAMETER and *PARAMETER_EXPRESSION, by name without regard to case. A name has one value in the whole
/// deck: of several that *PARAMETER_DUPLICATION allows the first one holds, as it does where that is not given.
class Parameters {
 public:
  /// Takes in a block of the two, or one with _LOCAL, _MUTABLE or _NOECHO. Throws InputError for an expression that
  /// cannot be evaluated, and for a value that changes on the way.
  void read(const KeywordBlock& block);
  /// *PARAMETER_DUPLICATION
  void read_duplication(const KeywordBlock& block);
  /// What a field "&name" or "-&name" stands for, as a text that a number or a text is read from. Throws InputError
  /// that names the nearest known one.
  std::string value(std::string_view reference, const DeckPlace& place) const;
  bool empty() const { return values_.empty(); }
  /// Second values that do not count.
  const std::vector<std::string>& notes() const { return notes_; }

 private:
  using Value = std::variant<std::int64_t, double, std::string>;
  struct Parameter {
    Value value;
    DeckPlace place;
  };

  void read_values(const Card& card);
  void read_expressions(Cards& cards);
  void read_expression(std::string_view declaration, std::string expression, const DeckPlace& place);
  void set(std::string_view declaration, std::string_view text, const DeckPlace& place);
  void define(const std::string& name, char kind, double number, const DeckPlace& place);
  void define(const std::string& name, Value value, const DeckPlace& place);
  ExpressionNumber number(std::string_view name, const DeckPlace& place) const;
  const Value& find(std::string_view name, const DeckPlace& place) const;

  std::map<std::string, Parameter> values_;
  std::vector<std::string> notes_;
  std::int64_t duplication_ = 1;  ///< DFLAG
  bool changes_ = false;          ///< whether the block that is being read is one of _LOCAL or _MUTABLE
};

}  // namespace pinball
