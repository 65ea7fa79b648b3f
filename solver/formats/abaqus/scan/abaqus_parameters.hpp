#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <solver/formats/deck/deck_place.hpp>
#include <solver/formats/deck/expression.hpp>

#include "abaqus_block.hpp"

namespace pinball {

/// Names of *PARAMETER, which stand between < and > where their values are meant: in data lines and in the lines of
/// keywords behind them. Names are as they are written, in upper or in lower case.
class AbaqusParameters {
 public:
  /// The lines of one *PARAMETER: NAME = EXPRESSION, of Python, or a text in quotes; behind # nothing counts. Of a name
  /// that stands there twice the last value holds, as in Python, which is a note. Throws InputError at a line that is
  /// none, and for a name that has another value in another *PARAMETER.
  void read(const AbaqusBlock& block);

  /// A line with values in the place of names. Throws InputError at `place` for a name that no *PARAMETER before it
  /// has.
  std::string replaced(std::string_view line, const DeckPlace& place);
  /// The same of many lines, of which those that are comments stay.
  std::string replaced_lines(std::string_view lines, DeckPlace before);

  /// What is to be told of them when all is read: names that stand twice, and names that nothing has named.
  std::vector<std::string> notes() const;

 private:
  struct Parameter {
    std::string text;
    std::optional<ExpressionNumber> number{};  ///< none: it is a text
    DeckPlace place{};
    int block = 0;  ///< the *PARAMETER that it is of
    bool is_used = false;
  };

  void define(std::string_view name, std::string_view expression, const DeckPlace& place);
  Parameter evaluated(std::string_view name, std::string_view expression, const DeckPlace& place);
  Parameter& find(std::string_view name, const DeckPlace& place);

  std::map<std::string, Parameter> parameters_;
  std::vector<std::string> notes_;
  int blocks_ = 0;
};

}  // namespace pinball
