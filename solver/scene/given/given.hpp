#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

/// A scene as it is given: tables of keys with values, and where each of them stands. A file of TOML is one, and what
/// the cards of a deck say is one; what keys there are, and what their values have to be, only the reader knows.
namespace pinball {

/// Where something is given, as messages name it.
class GivenPlace {
 public:
  GivenPlace() = default;  ///< not known
  GivenPlace(std::shared_ptr<const std::string> file, std::uint32_t line, std::uint32_t column)
      : source_(std::move(file)), line_(line), column_(column) {}
  /// A text that says it all: "--set time.end=2", "deck.k:12: *MAT_ELASTIC (ro)".
  explicit GivenPlace(std::string text) : source_(std::make_shared<const std::string>(std::move(text))) {}

  /// "FILE:LINE:COLUMN", or the text; otherwise: where it is not known.
  std::string text(const std::string& otherwise) const;
  /// Whether it stands before another one of the same file.
  bool before(const GivenPlace& other) const {
    return std::pair(line_, column_) < std::pair(other.line_, other.column_);
  }

 private:
  std::shared_ptr<const std::string> source_;
  std::uint32_t line_ = 0, column_ = 0;  ///< 0: the source is the text
};

/// A date or a time, which no key is.
struct GivenDate {};

class GivenValue;
struct GivenEntry;
using GivenArray = std::vector<GivenValue>;

/// Keys with their values, in the order in which they are given.
class GivenTable {
 public:
  std::string comment{};  ///< for people, where it is written as text

  GivenTable();  // these are defined where an entry is: Clang needs to know it for them
  GivenTable(const GivenTable&);
  GivenTable(GivenTable&&) noexcept;
  GivenTable& operator=(const GivenTable&);
  GivenTable& operator=(GivenTable&&) noexcept;
  ~GivenTable();

  /// Null: there is no such key.
  const GivenValue* find(std::string_view key) const;
  GivenValue* find(std::string_view key);
  bool contains(std::string_view key) const { return find(key) != nullptr; }
  /// In the place of what the key has so far. place: of the key itself. Returns the value where it is now.
  GivenValue& set(std::string_view key, GivenValue value, GivenPlace place = {});
  const std::vector<GivenEntry>& entries() const { return entries_; }
  std::vector<GivenEntry>& entries() { return entries_; }

 private:
  std::vector<GivenEntry> entries_;
};

class GivenValue {
 public:
  using Any = std::variant<bool, std::int64_t, double, std::string, GivenDate, GivenArray, GivenTable>;

  GivenValue() = default;
  explicit GivenValue(Any any_, GivenPlace place_ = {}) : any(std::move(any_)), place(std::move(place_)) {}

  Any any = false;
  GivenPlace place{};
  bool is_inline = false;  ///< of a table: it is written as a value, { ... }

  template <class T>
  const T* as() const {
    return std::get_if<T>(&any);
  }
  template <class T>
  T* as() {
    return std::get_if<T>(&any);
  }
  bool is_table() const { return as<GivenTable>() != nullptr; }
  /// An integer, too, that a double has exactly; none: it is no number.
  std::optional<double> number() const;
};

struct GivenEntry {
  std::string key;
  GivenPlace place;  ///< of the key
  GivenValue value;
};

inline GivenTable::GivenTable() = default;
inline GivenTable::GivenTable(const GivenTable&) = default;
inline GivenTable::GivenTable(GivenTable&&) noexcept = default;
inline GivenTable& GivenTable::operator=(const GivenTable&) = default;
inline GivenTable& GivenTable::operator=(GivenTable&&) noexcept = default;
inline GivenTable::~GivenTable() = default;

/// A value as a message shows it after "got": -1, "text", true, an array of 2 values, a table.
std::string describe(const GivenValue& value);

}  // namespace pinball
