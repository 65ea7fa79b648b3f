#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "data_line.hpp"
#include "number_text.hpp"

namespace pinball {

/// What stands in a line: in columns, or, where it has a comma, between commas. Blank fields, and those behind the end
/// of the line, have defaults. All that read throw InputError with the place of the line, its keyword, the name of the
/// field and what was expected. The line has to outlive them.
class LineFields {
 public:
  LineFields(const LineFields&) = delete;
  LineFields& operator=(const LineFields&) = delete;

  std::string text(std::size_t field) const { return std::string(meant(raw(field))); }
  bool blank(std::size_t field) const { return raw(field).empty(); }
  /// otherwise: the default; none: a blank field is an error.
  std::int64_t integer(std::size_t field, std::string_view name, std::optional<std::int64_t> otherwise = {}) const;
  double number(std::size_t field, std::string_view name, std::optional<double> otherwise = {}) const;
  const DeckPlace& place() const { return place_; }
  /// "*NODE: TC: expected 0 to 7, got 9", at its place.
  [[noreturn]] void fail(std::string_view name, const std::string& problem) const;

 protected:
  explicit LineFields(const DataLine& line) : place_(line.place), log_(line.log), line_(line.text.data()) {}
  ~LineFields() = default;

  /// What a field means that names something in the place of a number or a text.
  virtual std::string meant(std::string_view given) const { return std::string(given); }
  /// "*NODE: ", for messages; empty: they do not name it.
  virtual std::string keyword() const { return {}; }

  bool cut_at_commas(std::string_view line);
  void add(std::string_view field) { fields_[count_++] = trimmed(field); }
  /// Writes down those of which nobody has asked for what they say. says(field, text): whether that is anything.
  template <class Says>
  void write_down(const CardLayout* layout, const Says& says) const {
    if (log_ == nullptr) return;
    std::uint32_t left = 0;
    for (std::size_t i = 0; i < count_; ++i) {
      if ((asked_ >> i & 1U) == 0 && !fields_[i].empty() && says(i, fields_[i])) left |= 1U << i;
    }
    log_->left(line_, left, layout);
  }
  /// As it stands, which is asking for it.
  std::string_view raw(std::size_t field) const {
    if (field >= count_) return {};
    asked_ |= 1U << field;
    return fields_[field];
  }

  static constexpr std::size_t most_fields = 20;
  std::size_t count_ = 0;

 private:
  /// A number that begins in a field of columns and goes on in the next; empty: there is none.
  std::string spilled(std::size_t field) const;
  [[noreturn]] void fail_to_read(std::size_t field, std::string_view name, const std::string& expected) const;

  std::array<std::string_view, most_fields> fields_{};
  const DeckPlace& place_;
  ReadingLog* log_;
  const char* line_;
  mutable std::uint32_t asked_ = 0;  ///< fields by their bits
};

}  // namespace pinball
