#include "mesh_scanner.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <cstring>

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

std::string MeshScanner::place() const {
  return binary_ ? fmt::format("{}: byte {}", name_, at_) : fmt::format("{}:{}", name_, line_);
}

void MeshScanner::fail(std::string_view expected, std::string_view got) const {
  const std::string what = got.empty() ? "the end of the file" : fmt::format("\"{}\"", printable(got));
  throw InputError(fmt::format("{}: expected {}, got {}", place(), expected, what));
}

void MeshScanner::skip_space() {
  for (; at_ < text_.size() && is_space(text_[at_]); ++at_) line_ += text_[at_] == '\n';
}

bool MeshScanner::at_end() {
  skip_space();
  return at_ == text_.size();
}

std::string_view MeshScanner::word(std::string_view expected) {
  if (at_end()) fail(expected, "");
  const std::size_t begin = at_;
  while (at_ < text_.size() && !is_space(text_[at_])) ++at_;
  return text_.substr(begin, at_ - begin);
}

void MeshScanner::keyword(std::string_view expected) {
  const std::string_view got = word(expected);
  if (got != expected) fail(expected, got);
}

std::int64_t MeshScanner::integer(std::string_view expected) {
  const std::string_view got = word(expected);
  std::int64_t value = 0;
  const auto [end, problem] = std::from_chars(got.data(), got.data() + got.size(), value);
  if (problem != std::errc() || end != got.data() + got.size()) fail(expected, got);
  return value;
}

std::int64_t MeshScanner::count(std::string_view expected) {
  const std::int64_t value = integer(expected);
  if (value < 0) fail(expected, std::to_string(value));
  return value;
}

double MeshScanner::number(std::string_view expected) {
  const std::string_view got = word(expected), digits = got.substr(got.front() == '+' ? 1 : 0);
  double value = 0;
  const auto [end, problem] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  // A number too small to be told from zero is zero.
  if (problem == std::errc::result_out_of_range && got.find("e-") != std::string_view::npos) return 0;
  if (problem != std::errc() || end != digits.data() + digits.size() || !std::isfinite(value)) fail(expected, got);
  return value;
}

std::string MeshScanner::quoted(std::string_view expected) {
  if (at_end()) fail(expected, "");
  const std::size_t end_of_line = std::min(text_.find('\n', at_), text_.size());
  const std::size_t close = text_.find('"', at_ + 1);
  if (text_[at_] != '"' || close >= end_of_line) fail(expected, text_.substr(at_, end_of_line - at_));
  std::string text(text_.substr(at_ + 1, close - at_ - 1));
  at_ = close + 1;
  return text;
}

void MeshScanner::skip_line(std::string_view expected) {
  if (at_ == text_.size()) fail(expected, "");
  at_ = std::min(text_.find('\n', at_), text_.size());
  at_end();
}

void MeshScanner::skip_to(std::string_view word) {
  if (!binary_) {
    while (this->word(word) != word) {
    }
    return;
  }
  const std::size_t found = text_.find(word, at_);
  at_ = std::min(found, text_.size());
  keyword(word);
}

bool MeshScanner::next_line_begins(std::string_view characters) const {
  const std::size_t next = text_.find_first_not_of(" \r\n", at_);
  return next != std::string_view::npos && text_.substr(next).starts_with(characters);
}

std::string_view MeshScanner::rest_of_line() {
  const std::size_t end = std::min(text_.find('\n', at_), text_.size());
  std::string_view rest = text_.substr(at_, end - at_);
  if (rest.ends_with('\r')) rest.remove_suffix(1);
  at_ = std::min(end + 1, text_.size());
  ++line_;
  return rest;
}

void MeshScanner::begin_data() {
  if (!binary_) return;
  while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\r')) ++at_;
  if (at_ == text_.size()) fail("the end of a line", "");
  if (text_[at_] != '\n') fail("the end of a line", text_.substr(at_, 8));
  ++at_;
  in_data_ = true;
}

template <class T>
T MeshScanner::bytes(std::string_view expected) {
  T value;
  if (text_.size() - at_ < sizeof value) fail(expected, "");
  std::memcpy(&value, text_.data() + at_, sizeof value);
  at_ += sizeof value;
  return value;
}

std::string_view MeshScanner::data_bytes(std::size_t count, std::string_view expected) {
  if (text_.size() - at_ < count) fail(expected, "");
  at_ += count;
  return text_.substr(at_ - count, count);
}

std::int64_t MeshScanner::data_integer(std::string_view expected) {
  return in_data_ ? bytes<std::int32_t>(expected) : integer(expected);
}

std::int64_t MeshScanner::data_long(std::string_view expected) {
  return in_data_ ? bytes<std::int64_t>(expected) : integer(expected);
}

std::int64_t MeshScanner::data_count(std::string_view expected) {
  const std::int64_t value = data_long(expected);
  if (value < 0) fail(expected, std::to_string(value));
  return value;
}

double MeshScanner::data_number(std::string_view expected) {
  if (!in_data_) return number(expected);
  const auto value = bytes<double>(expected);
  if (!std::isfinite(value)) fail(expected, std::to_string(value));
  return value;
}

void MeshScanner::require_room(std::int64_t count, std::int64_t bytes, std::int64_t words,
                               std::string_view expected) const {
  const auto left = static_cast<std::int64_t>(text_.size() - at_), each = in_data_ ? bytes : 2 * words;
  // The last word of a text has no space behind it.
  if (count > (left + 1) / each)
    fail(fmt::format("{} that the rest of the file can hold", expected), std::to_string(count));
}

}  // namespace pinball
