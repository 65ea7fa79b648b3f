#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <solver/mesh.hpp>
#include <solver/scene/given/given.hpp>
#include <solver/scene/schema/bound.hpp>
#include <solver/scene_rules.hpp>

/// Typed access to the tables of a scene as it is given. Every error is an InputError that reads
/// "FILE:LINE:COLUMN: KEY: expected ..., got ...", or "--set KEY=VALUE: expected ..., got ...", with --vary as with
/// --set, or names a card of a deck in their place.
namespace pinball {

/// The keys that one kind of table may hold.
struct TableKeys {
  std::string_view kind;               ///< "body"
  std::string_view shown;              ///< how a message names such a table: "body.NAME"; empty for the top level
  std::vector<std::string_view> keys;  ///< in the order of the scene format
};

/// All kinds of tables of the scene format: the one list against which unknown keys are found.
const std::vector<TableKeys>& scene_keys();

/// Throws InputError "WHERE: KEY: PROBLEM". A KEY that WHERE, being "--set KEY=...", already names is left out.
[[noreturn]] void fail(const std::string& where, const std::string& key, const std::string& problem);

/// The texts in quotes, joined as in: "a", "b" or "c".
std::string alternatives(const std::vector<std::string>& texts);

struct TextOrTable;

/// One table of the scene. A key that is read and missing is an error, where nothing else is said.
class SceneTable {
 public:
  /// `path` is the dotted name of the table, "" for the top level; `where` its location, used for missing keys.
  /// Throws InputError if the table holds a key that its kind does not know.
  SceneTable(const GivenTable& table, std::string path, std::string where, std::string_view kind);

  bool has(std::string_view key) const { return table_->contains(key); }
  bool is_text(std::string_view key) const { return has(key) && find(key)->as<std::string>() != nullptr; }
  std::string key_path(std::string_view key) const;
  /// "FILE:LINE:COLUMN: PATH", for messages about what it says that come later.
  std::string place() const;

  /// Location of the value of a key; of the table if the key is missing.
  std::string where(std::string_view key) const;
  [[noreturn]] void fail(std::string_view key, const std::string& problem) const;
  /// Fails where there is a problem.
  void require_none(const std::optional<Problem>& problem) const;
  [[noreturn]] void fail_missing(std::string_view key, const std::string& expected) const;

  double number(std::string_view key, const Bound& bound) const;
  std::int64_t integer(std::string_view key, std::int64_t low) const;
  bool boolean(std::string_view key) const;
  std::string text(std::string_view key) const;
  std::string name(std::string_view key) const;
  Point point(std::string_view key, const Bound& bound) const;
  std::array<Point, 3> matrix(std::string_view key) const;  ///< 3 x 3, rows

  /// These are empty where the key is missing.
  std::vector<double> numbers(std::string_view key, const Bound& bound) const;
  std::vector<std::string> texts(std::string_view key, const std::vector<std::string>& allowed) const;
  /// Unit vectors, each given as one of the three names or by its components: ["x", [0, 1, 1]]; "all" stands for the
  /// three of the names. Required, at least one.
  std::vector<Point> directions(std::string_view key, const std::array<const char*, 3>& names) const;
  /// A text or a table, or an array of them, the tables all of one kind; `expected` says what. Required.
  std::vector<TextOrTable> texts_or_tables(std::string_view key, std::string_view kind,
                                           const std::string& expected) const;
  /// Any number of integers >= low.
  std::vector<std::int64_t> integers(std::string_view key, std::int64_t low) const;
  /// `count` integers >= low; required.
  std::vector<std::int64_t> integers(std::string_view key, std::size_t count, std::int64_t low) const;
  /// Any number of faces of four corners, integers >= 0.
  std::vector<std::array<std::int64_t, 4>> faces(std::string_view key) const;
  /// Three numbers, or lists of numbers in their places: [1, 1, [0.4, 0.2, 0.4]]; required.
  std::array<std::vector<double>, 3> lists(std::string_view key, const Bound& bound) const;
  /// The same of integers >= low.
  std::array<std::vector<std::int64_t>, 3> integer_lists(std::string_view key, std::int64_t low) const;

  /// One of the named values.
  template <class Value>
  Value choice(std::string_view key, const std::vector<std::pair<std::string, Value>>& values) const {
    std::vector<std::string> names;
    for (const auto& value : values) names.push_back(value.first);
    return values[choice_index(key, names)].second;
  }
  /// This table, checked once more as one of a narrower kind.
  SceneTable as(std::string_view kind) const { return SceneTable(*table_, path_, where_, kind); }
  /// Table under a key; an empty one with this table's location if the key is missing.
  SceneTable table(std::string_view key, std::string_view kind) const;
  /// Elements of an array of tables, each with the path KEY.NAME, or KEY.NUMBER where it has no name.
  std::vector<SceneTable> tables(std::string_view key, std::string_view kind) const;

 private:
  const GivenValue* find(std::string_view key) const;
  /// Fails where the key is missing.
  const GivenValue& find(std::string_view key, const std::string& expected) const;
  std::size_t choice_index(std::string_view key, const std::vector<std::string>& names) const;
  double number_of(const GivenValue& node, const std::string& key, const Bound& bound) const;
  std::int64_t integer_of(const GivenValue& node, const std::string& key, std::int64_t low) const;
  Point point_of(const GivenValue& node, const std::string& key, const Bound& bound) const;
  template <class Value, class Read>
  std::array<std::vector<Value>, 3> lists_of(std::string_view key, const std::string& expected, const Read& read) const;
  const GivenArray& array_of(const GivenValue& node, const std::string& key, const std::string& expected,
                             std::optional<std::size_t> count) const;

  const GivenTable* table_;
  std::string path_;
  std::string where_;
};

struct TextOrTable {
  std::string text;  ///< empty: it is a table
  std::optional<SceneTable> table;
};

}  // namespace pinball
