#include "expression.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <map>
#include <stdexcept>
#include <vector>

#include "fields.hpp"

namespace pinball {

namespace {

using Arguments = std::vector<double>;

struct Function {
  std::size_t least, most;
  double (*apply)(const Arguments&);
};

double smallest(const Arguments& a) { return *std::min_element(a.begin(), a.end()); }
double largest(const Arguments& a) { return *std::max_element(a.begin(), a.end()); }

const std::map<std::string, Function>& functions() {
  static const std::map<std::string, Function> table{
      {"abs", {1, 1, [](const Arguments& a) { return std::abs(a[0]); }}},
      {"int", {1, 1, [](const Arguments& a) { return std::trunc(a[0]); }}},
      {"aint", {1, 1, [](const Arguments& a) { return std::trunc(a[0]); }}},
      {"nint", {1, 1, [](const Arguments& a) { return std::round(a[0]); }}},
      {"anint", {1, 1, [](const Arguments& a) { return std::round(a[0]); }}},
      {"float", {1, 1, [](const Arguments& a) { return a[0]; }}},
      {"mod", {2, 2, [](const Arguments& a) { return std::fmod(a[0], a[1]); }}},
      {"sign", {2, 2, [](const Arguments& a) { return std::copysign(a[0], a[1]); }}},
      {"min", {1, 64, smallest}},
      {"max", {1, 64, largest}},
      {"sqrt", {1, 1, [](const Arguments& a) { return std::sqrt(a[0]); }}},
      {"exp", {1, 1, [](const Arguments& a) { return std::exp(a[0]); }}},
      {"log", {1, 1, [](const Arguments& a) { return std::log(a[0]); }}},
      {"log10", {1, 1, [](const Arguments& a) { return std::log10(a[0]); }}},
      {"sin", {1, 1, [](const Arguments& a) { return std::sin(a[0]); }}},
      {"cos", {1, 1, [](const Arguments& a) { return std::cos(a[0]); }}},
      {"tan", {1, 1, [](const Arguments& a) { return std::tan(a[0]); }}},
      {"asin", {1, 1, [](const Arguments& a) { return std::asin(a[0]); }}},
      {"acos", {1, 1, [](const Arguments& a) { return std::acos(a[0]); }}},
      {"atan", {1, 1, [](const Arguments& a) { return std::atan(a[0]); }}},
      {"atan2", {2, 2, [](const Arguments& a) { return std::atan2(a[0], a[1]); }}},
      {"sinh", {1, 1, [](const Arguments& a) { return std::sinh(a[0]); }}},
      {"cosh", {1, 1, [](const Arguments& a) { return std::cosh(a[0]); }}},
      {"tanh", {1, 1, [](const Arguments& a) { return std::tanh(a[0]); }}},
  };
  return table;
}

/// sum = term {(+|-) term};  term = factor {(*|/) factor};  factor = [+|-] power;  power = atom [(**|^) factor]
class Parser {
 public:
  Parser(std::string_view text, const std::function<double(std::string_view)>& value_of)
      : rest_(text), value_of_(value_of) {}

  double whole() {
    const double value = sum();
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
  double sum() {
    if (++depth_ > deepest) fail("fewer brackets");
    double value = term();
    for (;;) {
      if (take("+")) {
        value += term();
      } else if (take("-")) {
        value -= term();
      } else {
        --depth_;
        return value;
      }
    }
  }
  double term() {
    double value = factor();
    for (;;) {
      if (take("*")) {
        value *= factor();
      } else if (take("/")) {
        value /= factor();
      } else {
        return value;
      }
    }
  }
  double factor() {
    if (++depth_ > deepest) fail("fewer signs");
    const bool minus = take("-");
    if (!minus) take("+");
    const double value = power();
    --depth_;
    return minus ? -value : value;
  }
  double power() {
    const double base = atom();
    if (take("**") || take("^")) return std::pow(base, factor());
    return base;
  }
  double atom() {
    if (take("(")) {
      const double value = sum();
      if (!take(")")) fail("a closing bracket");
      return value;
    }
    take("&");
    const char first = peek();
    if (std::isdigit(static_cast<unsigned char>(first)) != 0 || first == '.') return constant();
    if (std::isalpha(static_cast<unsigned char>(first)) == 0 && first != '_') fail("a number, a name or a bracket");
    std::size_t length = 1;
    while (length < rest_.size() &&
           (std::isalnum(static_cast<unsigned char>(rest_[length])) != 0 || rest_[length] == '_'))
      ++length;
    const std::string name = lower_case(rest_.substr(0, length));
    rest_.remove_prefix(length);
    return peek() == '(' ? call(name) : name == "pi" ? std::acos(-1.0) : value_of_(name);
  }
  static bool is_sign(char c) { return c == '+' || c == '-'; }
  double constant() {
    double value = 0;
    // Of the constant alone: how far ahead a library looks for its end is the library's own.
    std::size_t length = std::min(rest_.find_first_not_of("0123456789."), rest_.size());
    if (length < rest_.size() && (rest_[length] == 'e' || rest_[length] == 'E')) {
      const std::size_t digits = length + (length + 1 < rest_.size() && is_sign(rest_[length + 1]) ? 2 : 1);
      length = std::min(rest_.find_first_not_of("0123456789", digits), rest_.size());
    }
    const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + length, value);
    if (error != std::errc()) fail("a number");
    rest_.remove_prefix(end - rest_.data());
    return value;
  }
  double call(const std::string& name) {
    const auto found = functions().find(name);
    if (found == functions().end()) throw std::invalid_argument("no function is named " + name);
    take("(");
    Arguments arguments{sum()};
    while (take(",")) arguments.push_back(sum());
    if (!take(")")) fail("a closing bracket");
    if (arguments.size() < found->second.least || arguments.size() > found->second.most)
      throw std::invalid_argument("wrong number of arguments of " + name);
    return found->second.apply(arguments);
  }

  std::string_view rest_;
  const std::function<double(std::string_view)>& value_of_;
  int depth_ = 0;
};

}  // namespace

double evaluate_expression(std::string_view text, const std::function<double(std::string_view)>& value_of) {
  return Parser(text, value_of).whole();
}

}  // namespace pinball
