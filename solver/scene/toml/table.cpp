#include "table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <limits>

#include <solver/base/error.hpp>
#include <solver/base/text_distance.hpp>

namespace pinball {

namespace {

const TableKeys& keys_of(std::string_view kind) {
  const auto& all = scene_keys();
  const auto found = std::find_if(all.begin(), all.end(), [&](const TableKeys& keys) { return keys.kind == kind; });
  assert(found != all.end());
  return *found;
}

std::string join(std::string_view path, std::string_view key) {
  return path.empty() ? std::string(key) : fmt::format("{}.{}", path, key);
}

/// What other programs, and other tables here, call a key: the name of a file, the part of a mesh that is the body.
bool is_another_name(std::string_view key, std::string_view candidate) {
  return (key == "path" && candidate == "file") || (key == "part" && candidate == "physical") ||
         (key == "physical" && candidate == "part");
}

/// A slip inside the same table is likelier than a key in the wrong table, which is likelier than two slips.
std::string nearest_key(std::string_view key, std::string_view path, const TableKeys& own) {
  std::string best;
  int lowest = std::numeric_limits<int>::max();
  auto consider = [&](std::string_view table, std::string_view candidate, int penalty) {
    const int cost = 2 * edit_distance(key.substr(0, 100), candidate) + penalty;  // no key is so long
    if (cost < lowest) {
      lowest = cost;
      best = join(table, candidate);
    }
  };
  for (const auto candidate : own.keys) consider(path, candidate, is_another_name(key, candidate) ? -100 : 0);
  for (const auto& other : scene_keys()) {
    // The other kinds of mesh share their place with this one: their keys would be just as wrong here.
    if (other.shown == own.shown) continue;
    if (other.shown.starts_with('{')) continue;  // a table without a name is no place that one could be sent to
    for (const auto candidate : other.keys) consider(other.shown, candidate, 1);
  }
  return best;
}

std::string element_path(const std::string& key, std::size_t index) { return fmt::format("{}[{}]", key, index); }

}  // namespace

void fail(const std::string& where, const std::string& key, const std::string& problem) {
  const bool named = where.starts_with("--set " + key + "=") || where.starts_with("--vary " + key + "=");
  if (key.empty() || named) throw InputError(where + ": " + problem);
  throw InputError(where + ": " + key + ": " + problem);
}

std::string alternatives(const std::vector<std::string>& texts) {
  std::string joined;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    if (i > 0) joined += i + 1 == texts.size() ? " or " : ", ";
    joined += '"' + texts[i] + '"';
  }
  return joined;
}

SceneTable::SceneTable(const GivenTable& table, std::string path, std::string where, std::string_view kind)
    : table_(&table), path_(std::move(path)), where_(std::move(where)) {
  const TableKeys& known = keys_of(kind);
  for (const auto& [key, place, value] : table.entries()) {
    if (std::find(known.keys.begin(), known.keys.end(), key) != known.keys.end()) continue;
    pinball::fail(place.text(where_), key_path(key), "unknown key, nearest is " + nearest_key(key, path_, known));
  }
}

std::string SceneTable::key_path(std::string_view key) const { return join(path_, key); }

std::string SceneTable::place() const { return fmt::format("{}: {}", where_, path_); }

const GivenValue* SceneTable::find(std::string_view key) const { return table_->find(key); }

std::string SceneTable::where(std::string_view key) const {
  const GivenValue* node = find(key);
  return node ? node->place.text(where_) : where_;
}

void SceneTable::fail(std::string_view key, const std::string& problem) const {
  pinball::fail(where(key), key_path(key), problem);
}

void SceneTable::require_none(const std::optional<Problem>& problem) const {
  if (problem) fail(problem->key, problem->text);
}

void SceneTable::fail_missing(std::string_view key, const std::string& expected) const {
  fail(key, "missing, expected " + expected);
}

double SceneTable::number_of(const GivenValue& node, const std::string& key, const Bound& bound) const {
  const std::optional<double> value = node.number();
  if (!value || !bound.holds(*value)) {
    pinball::fail(node.place.text(where_), key,
                  fmt::format("expected {}, got {}", bound.describe(), pinball::describe(node)));
  }
  return *value;
}

const GivenValue& SceneTable::find(std::string_view key, const std::string& expected) const {
  const GivenValue* node = find(key);
  if (!node) fail_missing(key, expected);
  return *node;
}

double SceneTable::number(std::string_view key, const Bound& bound) const {
  return number_of(find(key, bound.describe()), key_path(key), bound);
}

std::int64_t SceneTable::integer_of(const GivenValue& node, const std::string& key, std::int64_t low) const {
  const auto* value = node.as<std::int64_t>();
  if (!value || *value < low) {
    pinball::fail(node.place.text(where_), key,
                  fmt::format("expected an integer >= {}, got {}", low, pinball::describe(node)));
  }
  return *value;
}

std::int64_t SceneTable::integer(std::string_view key, std::int64_t low) const {
  return integer_of(find(key, fmt::format("an integer >= {}", low)), key_path(key), low);
}

bool SceneTable::boolean(std::string_view key) const {
  const GivenValue& node = find(key, "true or false");
  const bool* value = node.as<bool>();
  if (!value) fail(key, "expected true or false, got " + pinball::describe(node));
  return *value;
}

std::string SceneTable::text(std::string_view key) const {
  const GivenValue& node = find(key, "a text in quotes");
  const auto* value = node.as<std::string>();
  if (!value) fail(key, "expected a text in quotes, got " + pinball::describe(node));
  return *value;
}

std::string SceneTable::name(std::string_view key) const {
  const std::string name = text(key);
  require_none(name_problem(name));
  return name;
}

const GivenArray& SceneTable::array_of(const GivenValue& node, const std::string& key, const std::string& expected,
                                       std::optional<std::size_t> count) const {
  const auto* array = node.as<GivenArray>();
  if (!array || (count && array->size() != *count)) {
    pinball::fail(node.place.text(where_), key, fmt::format("expected {}, got {}", expected, pinball::describe(node)));
  }
  return *array;
}

Point SceneTable::point_of(const GivenValue& node, const std::string& key, const Bound& bound) const {
  const auto& array = array_of(node, key, "an array of 3 numbers", 3);
  Point point{};
  for (std::size_t i = 0; i < 3; ++i) point[i] = number_of(array[i], element_path(key, i), bound);
  return point;
}

Point SceneTable::point(std::string_view key, const Bound& bound) const {
  return point_of(find(key, "an array of 3 numbers"), key_path(key), bound);
}

std::array<Point, 3> SceneTable::matrix(std::string_view key) const {
  const std::string expected = "an array of 3 rows of 3 numbers";
  const auto& rows = array_of(find(key, expected), key_path(key), expected, 3);
  std::array<Point, 3> matrix{};
  for (std::size_t i = 0; i < 3; ++i) {
    matrix[i] = point_of(rows[i], element_path(key_path(key), i), any_number);
  }
  return matrix;
}

std::vector<double> SceneTable::numbers(std::string_view key, const Bound& bound) const {
  std::vector<double> values;
  const GivenValue* node = find(key);
  if (!node) return values;
  const auto& array = array_of(*node, key_path(key), "an array of numbers", std::nullopt);
  for (std::size_t i = 0; i < array.size(); ++i) {
    values.push_back(number_of(array[i], element_path(key_path(key), i), bound));
  }
  return values;
}

std::vector<std::int64_t> SceneTable::integers(std::string_view key, std::int64_t low) const {
  const GivenValue* node = find(key);
  if (!node) return {};
  const std::string expected = fmt::format("an array of integers >= {}", low);
  const auto& array = array_of(*node, key_path(key), expected, std::nullopt);
  std::vector<std::int64_t> values;
  values.reserve(array.size());
  for (std::size_t i = 0; i < array.size(); ++i) {
    values.push_back(integer_of(array[i], element_path(key_path(key), i), low));
  }
  return values;
}

std::vector<std::int64_t> SceneTable::integers(std::string_view key, std::size_t count, std::int64_t low) const {
  const std::string expected = fmt::format("an array of {} integers >= {}", count, low);
  const auto& array = array_of(find(key, expected), key_path(key), expected, count);
  std::vector<std::int64_t> values;
  for (std::size_t i = 0; i < count; ++i) {
    values.push_back(integer_of(array[i], element_path(key_path(key), i), low));
  }
  return values;
}

template <class Value, class Read>
std::array<std::vector<Value>, 3> SceneTable::lists_of(std::string_view key, const std::string& expected,
                                                       const Read& read) const {
  const auto& array = array_of(find(key, expected), key_path(key), expected, 3);
  std::array<std::vector<Value>, 3> lists;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string path = element_path(key_path(key), i);
    const auto* list = array[i].as<GivenArray>();
    if (!list) {
      lists[i].push_back(read(array[i], path));
      continue;
    }
    if (list->empty()) pinball::fail(array[i].place.text(where_), path, "expected at least one number, got none");
    for (std::size_t j = 0; j < list->size(); ++j) lists[i].push_back(read((*list)[j], element_path(path, j)));
  }
  return lists;
}

std::array<std::vector<double>, 3> SceneTable::lists(std::string_view key, const Bound& bound) const {
  return lists_of<double>(key, "an array of 3 numbers", [&](const GivenValue& node, const std::string& path) {
    return number_of(node, path, bound);
  });
}

std::array<std::vector<std::int64_t>, 3> SceneTable::integer_lists(std::string_view key, std::int64_t low) const {
  return lists_of<std::int64_t>(
      key, fmt::format("an array of 3 integers >= {}", low),
      [&](const GivenValue& node, const std::string& path) { return integer_of(node, path, low); });
}

std::vector<std::string> SceneTable::texts(std::string_view key, const std::vector<std::string>& allowed) const {
  std::vector<std::string> values;
  const GivenValue* node = find(key);
  if (!node) return values;
  const auto& array = array_of(*node, key_path(key), "an array of texts", std::nullopt);
  for (std::size_t i = 0; i < array.size(); ++i) {
    const GivenValue& element = array[i];
    const auto* value = element.as<std::string>();
    if (!value || std::find(allowed.begin(), allowed.end(), *value) == allowed.end()) {
      pinball::fail(element.place.text(where_), element_path(key_path(key), i),
                    fmt::format("expected {}, got {}", alternatives(allowed), pinball::describe(element)));
    }
    values.push_back(*value);
  }
  // None at all is not none of them: where the key is left out, all are meant.
  if (values.empty()) fail(key, fmt::format("expected at least one of {}, got none", alternatives(allowed)));
  return values;
}

std::vector<TextOrTable> SceneTable::texts_or_tables(std::string_view key, std::string_view kind,
                                                     const std::string& expected) const {
  const GivenValue* node = find(key);
  if (!node) fail_missing(key, expected);
  std::vector<TextOrTable> values;
  const auto take = [&](const GivenValue& one, const std::string& path) {
    const auto* text = one.as<std::string>();
    if (text && !text->empty()) {
      values.push_back({*text, {}});
    } else if (one.is_table()) {
      values.push_back({"", SceneTable(*one.as<GivenTable>(), path, one.place.text(where_), kind)});
    } else {
      pinball::fail(one.place.text(where_), path, fmt::format("expected {}, got {}", expected, pinball::describe(one)));
    }
  };
  if (node->as<GivenArray>() == nullptr) {
    take(*node, key_path(key));
    return values;
  }
  const GivenArray& array = *node->as<GivenArray>();
  for (std::size_t i = 0; i < array.size(); ++i) take(array[i], element_path(key_path(key), i));
  if (values.empty()) fail(key, fmt::format("expected {}, got none", expected));
  return values;
}

std::size_t SceneTable::choice_index(std::string_view key, const std::vector<std::string>& names) const {
  const GivenValue& node = find(key, alternatives(names));
  if (const auto* text = node.as<std::string>()) {
    const auto found = std::find(names.begin(), names.end(), *text);
    if (found != names.end()) return found - names.begin();
  }
  fail(key, fmt::format("expected {}, got {}", alternatives(names), pinball::describe(node)));
}

SceneTable SceneTable::table(std::string_view key, std::string_view kind) const {
  static const GivenTable empty;
  const GivenValue* node = find(key);
  if (node && !node->is_table()) fail(key, "expected a table, got " + pinball::describe(*node));
  return SceneTable(node ? *node->as<GivenTable>() : empty, key_path(key), where(key), kind);
}

std::vector<SceneTable> SceneTable::tables(std::string_view key, std::string_view kind) const {
  std::vector<SceneTable> tables;
  const GivenValue* node = find(key);
  if (!node) return tables;
  const std::string expected = fmt::format("tables [[{}]]", key);
  const auto& array = array_of(*node, key_path(key), expected, std::nullopt);
  for (std::size_t i = 0; i < array.size(); ++i) {
    const auto* element = array[i].as<GivenTable>();
    if (!element) {
      pinball::fail(array[i].place.text(where_), element_path(key_path(key), i),
                    fmt::format("expected {}, got {}", expected, pinball::describe(array[i])));
    }
    const GivenValue* named = element->find("name");
    const auto* name = named ? named->as<std::string>() : nullptr;
    tables.emplace_back(*element, fmt::format("{}.{}", key_path(key), name ? *name : std::to_string(i)),
                        array[i].place.text(where_), kind);
  }
  return tables;
}

}  // namespace pinball
