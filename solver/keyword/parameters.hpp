#pragma once

#include <map>
#include <string>
#include <string_view>
#include <variant>

#include "keyword_block.hpp"

namespace pinball {

/// Values of *PARAMETER and *PARAMETER_EXPRESSION, by name without regard to case.
class Parameters {
 public:
  /// Takes in a block of one of the two. Throws InputError for an expression that cannot be evaluated.
  void read(const KeywordBlock& block);
  /// What a field "&name" or "-&name" stands for, as a text that a number or a text is read from. Throws InputError
  /// that names the nearest known one.
  std::string value(std::string_view reference, const DeckPlace& place) const;
  bool empty() const { return values_.empty(); }

 private:
  using Value = std::variant<std::int64_t, double, std::string>;

  void read_values(const Card& card);
  void read_expression(std::string_view declaration, std::string expression, const DeckPlace& place);
  void set(std::string_view declaration, std::string_view text, const DeckPlace& place);
  double number(std::string_view name, const DeckPlace& place) const;
  const Value& find(std::string_view name, const DeckPlace& place) const;

  std::map<std::string, Value> values_;
};

}  // namespace pinball
