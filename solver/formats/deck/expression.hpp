#pragma once

#include <functional>
#include <string_view>

namespace pinball {

/// Of an expression, or of a name in it.
struct ExpressionNumber {
  double value = 0;
  bool is_whole = false;  ///< of whole numbers alone
};

/// Value of an arithmetic expression: numbers, names, + - * / ** ^, brackets and the functions of Fortran that
/// *PARAMETER_EXPRESSION has. Names come in lower case. As in Fortran a division of whole numbers leaves out the rest:
/// 2/5 is 0. Throws std::invalid_argument with what was expected.
double evaluate_expression(std::string_view text, const std::function<ExpressionNumber(std::string_view)>& value_of);

/// Value of an expression of Python, as *PARAMETER of Abaqus has them: names as they are written, no ^ and no pi, and
/// functions of its own and of its module math. A division of whole numbers that has a rest is refused: one version of
/// Python leaves it out, and another one does not.
ExpressionNumber evaluate_python(std::string_view text,
                                 const std::function<ExpressionNumber(std::string_view)>& value_of);

}  // namespace pinball
