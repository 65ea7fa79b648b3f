#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace pinball {

/// Value of an arithmetic expression: numbers, names, + - * / ** ^, brackets and the functions of Fortran that
/// *PARAMETER_EXPRESSION has. Throws std::invalid_argument with what was expected.
double evaluate_expression(std::string_view text, const std::function<double(std::string_view)>& value_of);

}  // namespace pinball
