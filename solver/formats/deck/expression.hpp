#pragma once

#include <functional>
#include <string_view>

namespace pinball {

/// Value of an arithmetic expression: numbers, names, + - * / ** ^, brackets and the functions of Fortran that
/// *PARAMETER_EXPRESSION has. Names come in lower case. Throws std::invalid_argument with what was expected.
double evaluate_expression(std::string_view text, const std::function<double(std::string_view)>& value_of);

/// Of Python, whose division of whole numbers leaves out the rest in one version and not in another one.
struct PythonNumber {
  double value = 0;
  bool is_whole = false;
};

/// Value of an expression of Python, as *PARAMETER of Abaqus has them: names as they are written, no ^ and no pi, and
/// functions of its own and of its module math. A division of whole numbers that has a rest is refused.
PythonNumber evaluate_python(std::string_view text, const std::function<PythonNumber(std::string_view)>& value_of);

}  // namespace pinball
