#include "gmsh_scanner.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include <solver/base/error.hpp>

namespace pinball {
namespace {

bool is_space(char c) { return c == ' ' || c == '\n' || c == '\t' || c == '\r' || c == '\f' || c == '\v'; }

/// What a message may show of a file that can hold anything.
std::string printable(std::string_view text) {
  std::string shown;
  for (const char c : text.substr(0, 40)) shown += c >= ' ' && c <= '~' ? c : '?';
  if (text.size() > 40) shown += "...";
  return shown;
}

}  // namespace

void GmshScanner::fail(const std::string& expected, std::string_view got) const {
  const std::string what = got.empty() ? "the end of the file" : fmt::format("\"{}\"", printable(got));
  throw InputError(fmt::format("{}:{}: expected {}, got {}", name_, line_, expected, what));
}

void GmshScanner::skip_space() {
  for (; at_ < text_.size() && is_space(text_[at_]); ++at_) line_ += text_[at_] == '\n';
}

bool GmshScanner::at_end() {
  skip_space();
  return at_ == text_.size();
}

std::string_view GmshScanner::word(const std::string& expected) {
  if (at_end()) fail(expected, "");
  const std::size_t begin = at_;
  while (at_ < text_.size() && !is_space(text_[at_])) ++at_;
  return text_.substr(begin, at_ - begin);
}

void GmshScanner::keyword(std::string_view expected) {
  const std::string_view got = word(std::string(expected));
  if (got != expected) fail(std::string(expected), got);
}

std::int64_t GmshScanner::integer(const std::string& expected) {
  const std::string_view got = word(expected);
  std::int64_t value = 0;
  const auto [end, problem] = std::from_chars(got.data(), got.data() + got.size(), value);
  if (problem != std::errc() || end != got.data() + got.size()) fail(expected, got);
  return value;
}

std::int64_t GmshScanner::count(const std::string& expected) {
  const std::int64_t value = integer(expected);
  if (value < 0) fail(expected, std::to_string(value));
  return value;
}

double GmshScanner::number(const std::string& expected) {
  const std::string_view got = word(expected), digits = got.substr(got.front() == '+' ? 1 : 0);
  double value = 0;
  const auto [end, problem] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  // A number too small to be told from zero is zero.
  if (problem == std::errc::result_out_of_range && got.find("e-") != std::string_view::npos) return 0;
  if (problem != std::errc() || end != digits.data() + digits.size() || !std::isfinite(value)) fail(expected, got);
  return value;
}

std::string GmshScanner::quoted(const std::string& expected) {
  if (at_end()) fail(expected, "");
  const std::size_t end_of_line = std::min(text_.find('\n', at_), text_.size());
  const std::size_t close = text_.find('"', at_ + 1);
  if (text_[at_] != '"' || close >= end_of_line) fail(expected, text_.substr(at_, end_of_line - at_));
  std::string text(text_.substr(at_ + 1, close - at_ - 1));
  at_ = close + 1;
  return text;
}

void GmshScanner::skip_line(const std::string& expected) {
  if (at_ == text_.size()) fail(expected, "");
  at_ = std::min(text_.find('\n', at_), text_.size());
  at_end();
}

}  // namespace pinball
