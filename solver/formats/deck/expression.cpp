#include "expression.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "number_text.hpp"

namespace pinball {

namespace {

using Number = ExpressionNumber;
using Arguments = std::vector<Number>;

enum class Language : std::uint8_t { fortran, python };

/// What a function gives of whole numbers; chosen: one of its arguments as it is.
enum class Gives : std::uint8_t { real, as_given, chosen, power, whole };

struct Function {
  std::size_t least, most;
  double (*apply)(const Arguments&);
  Gives gives = Gives::real;
};

using Functions = std::map<std::string, Function>;

bool is_less(const Number& a, const Number& b) { return a.value < b.value; }
double smallest(const Arguments& a) { return std::ranges::min_element(a, is_less)->value; }
double largest(const Arguments& a) { return std::ranges::max_element(a, is_less)->value; }

const Functions& common_functions() {
  static const Functions table{
      {"abs", {1, 1, [](const Arguments& a) { return std::abs(a[0].value); }, Gives::as_given}},
      {"int", {1, 1, [](const Arguments& a) { return std::trunc(a[0].value); }, Gives::whole}},
      {"float", {1, 1, [](const Arguments& a) { return a[0].value; }}},
      {"min", {1, 64, smallest, Gives::chosen}},
      {"max", {1, 64, largest, Gives::chosen}},
      {"sqrt", {1, 1, [](const Arguments& a) { return std::sqrt(a[0].value); }}},
      {"exp", {1, 1, [](const Arguments& a) { return std::exp(a[0].value); }}},
      {"log", {1, 1, [](const Arguments& a) { return std::log(a[0].value); }}},
      {"log10", {1, 1, [](const Arguments& a) { return std::log10(a[0].value); }}},
      {"sin", {1, 1, [](const Arguments& a) { return std::sin(a[0].value); }}},
      {"cos", {1, 1, [](const Arguments& a) { return std::cos(a[0].value); }}},
      {"tan", {1, 1, [](const Arguments& a) { return std::tan(a[0].value); }}},
      {"asin", {1, 1, [](const Arguments& a) { return std::asin(a[0].value); }}},
      {"acos", {1, 1, [](const Arguments& a) { return std::acos(a[0].value); }}},
      {"atan", {1, 1, [](const Arguments& a) { return std::atan(a[0].value); }}},
      {"atan2", {2, 2, [](const Arguments& a) { return std::atan2(a[0].value, a[1].value); }}},
      {"sinh", {1, 1, [](const Arguments& a) { return std::sinh(a[0].value); }}},
      {"cosh", {1, 1, [](const Arguments& a) { return std::cosh(a[0].value); }}},
      {"tanh", {1, 1, [](const Arguments& a) { return std::tanh(a[0].value); }}},
  };
  return table;
}

const Functions& own_functions(Language language) {
  static const Functions fortran{
      {"aint", {1, 1, [](const Arguments& a) { return std::trunc(a[0].value); }}},
      {"nint", {1, 1, [](const Arguments& a) { return std::round(a[0].value); }, Gives::whole}},
      {"anint", {1, 1, [](const Arguments& a) { return std::round(a[0].value); }}},
      {"mod", {2, 2, [](const Arguments& a) { return std::fmod(a[0].value, a[1].value); }, Gives::as_given}},
      {"sign", {2, 2, [](const Arguments& a) { return std::copysign(a[0].value, a[1].value); }, Gives::as_given}},
  };
  static const Functions python{
      {"fabs", {1, 1, [](const Arguments& a) { return std::abs(a[0].value); }}},
      {"floor", {1, 1, [](const Arguments& a) { return std::floor(a[0].value); }}},
      {"ceil", {1, 1, [](const Arguments& a) { return std::ceil(a[0].value); }}},
      {"pow", {2, 2, [](const Arguments& a) { return std::pow(a[0].value, a[1].value); }, Gives::power}},
      {"radians", {1, 1, [](const Arguments& a) { return a[0].value * std::acos(-1.0) / 180; }}},
      {"degrees", {1, 1, [](const Arguments& a) { return a[0].value * 180 / std::acos(-1.0); }}},
  };
  return language == Language::fortran ? fortran : python;
}

/// sum = term {(+|-) term};  term = factor {(*|/) factor};  factor = [+|-] power;  power = atom [(**|^) factor]
class Parser {
 public:
  using Names = std::function<Number(std::string_view)>;

  Parser(std::string_view text, Language language, const Names& value_of)
      : rest_(text), language_(language), value_of_(value_of) {}

  Number whole() {
    const Number value = sum();
    if (peek() != '\0') fail("an operator");
    return value;
  }

 private:
  static constexpr int deepest = 100;

  [[noreturn]] void fail(const std::string& expected) const {
    throw std::invalid_argument("expected " + expected + ", got \"" + std::string(rest_.substr(0, 20)) + '"');
  }
  char peek() {
    while (!rest_.empty() && std::isspace(static_cast<unsigned char>(rest_.front())) != 0) rest_.remove_prefix(1);
    return rest_.empty() ? '\0' : rest_.front();
  }
  bool take(std::string_view sign) {
    peek();
    if (rest_.substr(0, sign.size()) != sign) return false;
    rest_.remove_prefix(sign.size());
    return true;
  }
  Number sum() {
    if (++depth_ > deepest) fail("fewer brackets");
    Number value = term();
    for (;;) {
      const bool adds = take("+");
      if (!adds && !take("-")) break;
      const Number other = term();
      value = {adds ? value.value + other.value : value.value - other.value, value.is_whole && other.is_whole};
    }
    --depth_;
    return value;
  }
  Number term() {
    Number value = factor();
    for (;;) {
      if (take("*")) {
        const Number other = factor();
        value = {value.value * other.value, value.is_whole && other.is_whole};
      } else if (take("/")) {
        value = quotient(value, factor());
      } else {
        return value;
      }
    }
  }
  Number quotient(const Number& a, const Number& b) const {
    const bool whole = a.is_whole && b.is_whole;
    if (whole && language_ == Language::fortran) return {std::trunc(a.value / b.value), true};
    if (whole && std::fmod(a.value, b.value) != 0)
      throw std::invalid_argument("expected a point in one of two whole numbers, of which one divides the other");
    return {a.value / b.value, whole};
  }
  Number factor() {
    if (++depth_ > deepest) fail("fewer signs");
    const bool minus = take("-");
    if (!minus) take("+");
    const Number value = power();
    --depth_;
    return {minus ? -value.value : value.value, value.is_whole};
  }
  /// A whole number to the power of one below 0 is none.
  static bool is_whole_power(const Number& base, const Number& exponent) {
    return base.is_whole && exponent.is_whole && exponent.value >= 0;
  }
  Number power() {
    const Number base = atom();
    const bool raised = take("**") || (language_ == Language::fortran && take("^"));
    if (!raised) return base;
    const Number exponent = factor();
    if (language_ == Language::fortran && base.is_whole && exponent.is_whole && exponent.value < 0)
      throw std::invalid_argument("expected a point in a whole number that is raised to one below 0");
    return {std::pow(base.value, exponent.value), is_whole_power(base, exponent)};
  }
  Number atom() {
    if (take("(")) {
      const Number value = sum();
      if (!take(")")) fail("a closing bracket");
      return value;
    }
    if (language_ == Language::fortran) take("&");
    const char first = peek();
    if (std::isdigit(static_cast<unsigned char>(first)) != 0 || first == '.') return constant();
    if (std::isalpha(static_cast<unsigned char>(first)) == 0 && first != '_') fail("a number, a name or a bracket");
    std::size_t length = 1;
    while (length < rest_.size() &&
           (std::isalnum(static_cast<unsigned char>(rest_[length])) != 0 || rest_[length] == '_'))
      ++length;
    const std::string_view written = rest_.substr(0, length);
    const std::string name = language_ == Language::fortran ? lower_case(written) : std::string(written);
    rest_.remove_prefix(length);
    if (peek() == '(') return call(name);
    return name == "pi" && language_ == Language::fortran ? Number{std::acos(-1.0)} : value_of_(name);
  }
  static bool is_sign(char c) { return c == '+' || c == '-'; }
  Number constant() {
    double value = 0;
    // Of the constant alone: how far ahead a library looks for its end is the library's own.
    std::size_t length = std::min(rest_.find_first_not_of("0123456789."), rest_.size());
    if (length < rest_.size() && (rest_[length] == 'e' || rest_[length] == 'E')) {
      const std::size_t digits = length + (length + 1 < rest_.size() && is_sign(rest_[length + 1]) ? 2 : 1);
      length = std::min(rest_.find_first_not_of("0123456789", digits), rest_.size());
    }
    const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + length, value);
    if (error != std::errc()) fail("a number");
    const std::string_view digits = rest_.substr(0, length);
    const bool is_whole = digits.find_first_not_of("0123456789") == std::string_view::npos;
    if (is_whole && language_ == Language::python && digits.front() == '0' && value != 0)
      fail("a whole number without a zero before it");  // of base 8 in one version of Python, nothing in another one
    rest_.remove_prefix(end - rest_.data());
    return {value, is_whole};
  }
  /// Whether a function of these gives a whole number.
  static bool is_whole(const Function& function, const Arguments& arguments) {
    switch (function.gives) {
      case Gives::real:
        return false;
      case Gives::as_given:
        return std::ranges::all_of(arguments, &Number::is_whole);
      case Gives::power:
        return is_whole_power(arguments[0], arguments[1]);
      case Gives::chosen: {
        const auto chosen = std::ranges::find(arguments, function.apply(arguments), &Number::value);
        return chosen != arguments.end() && chosen->is_whole;
      }
      case Gives::whole:
        return true;
    }
    return false;
  }
  Number call(const std::string& name) {
    const Functions& own = own_functions(language_);
    auto found = own.find(name);
    if (found == own.end()) found = common_functions().find(name);
    if (found == common_functions().end()) throw std::invalid_argument("no function is named " + name);
    take("(");
    Arguments arguments{sum()};
    while (take(",")) arguments.push_back(sum());
    if (!take(")")) fail("a closing bracket");
    const Function& function = found->second;
    if (arguments.size() < function.least || arguments.size() > function.most)
      throw std::invalid_argument("wrong number of arguments of " + name);
    return {function.apply(arguments), is_whole(function, arguments)};
  }

  std::string_view rest_;
  Language language_;
  const Names& value_of_;
  int depth_ = 0;
};

}  // namespace

double evaluate_expression(std::string_view text, const std::function<ExpressionNumber(std::string_view)>& value_of) {
  return Parser(text, Language::fortran, value_of).whole().value;
}

ExpressionNumber evaluate_python(std::string_view text,
                                 const std::function<ExpressionNumber(std::string_view)>& value_of) {
  return Parser(text, Language::python, value_of).whole();
}

}  // namespace pinball
