#include "read_keys.hpp"

#include <cmath>

namespace pinball {

namespace {

std::vector<std::string> texts_of(const schema::AnyKey& key) {
  return {key.about.texts.begin(), key.about.texts.end()};
}

[[noreturn]] void fail_too_many(const SceneTable& table, std::string_view key, double count) {
  table.fail(key, fmt::format("{} elements in one direction are more than a mesh can hold", count));
}

}  // namespace

int to_count(const SceneTable& table, std::string_view key, std::int64_t count) {
  if (count > std::numeric_limits<int>::max()) fail_too_many(table, key, count);
  return count;
}

void read_value(const SceneTable& table, const schema::AnyKey& key, double& value) {
  value = table.number(key.name, key.about.bound);
}

void read_value(const SceneTable& table, const schema::AnyKey& key, std::int64_t& value) {
  value = table.integer(key.name, schema::lowest(key.about));
}

void read_value(const SceneTable& table, const schema::AnyKey& key, int& value) {
  value = to_count(table, key.name, table.integer(key.name, schema::lowest(key.about)));
}

void read_value(const SceneTable& table, const schema::AnyKey& key, bool& value) {
  if (*key.about.yes) {
    value = table.choice<bool>(key.name, {{key.about.no, false}, {key.about.yes, true}});
  } else {
    value = table.boolean(key.name);
  }
}

void read_value(const SceneTable& table, const schema::AnyKey& key, std::string& value) {
  value = key.about.form == schema::Form::name ? table.name(key.name) : table.text(key.name);
}

void read_value(const SceneTable& table, const schema::AnyKey& key, Point& value) {
  value = table.point(key.name, key.about.bound);
  if (key.about.form != schema::Form::direction) return;
  table.require_none(direction_problem(key.name, value));
  const double length = std::hypot(value[0], value[1], value[2]);
  for (double& component : value) component /= length;
}

void read_value(const SceneTable& table, const schema::AnyKey& key, std::array<Point, 3>& value) {
  value = table.matrix(key.name);
}

void read_value(const SceneTable& table, const schema::AnyKey& key, std::array<int, 2>& value) {
  const std::vector<std::int64_t> counts = table.integers(key.name, 2, schema::lowest(key.about));
  for (std::size_t k = 0; k < 2; ++k) value[k] = to_count(table, key.name, counts[k]);
}

void read_value(const SceneTable& table, const schema::AnyKey& key, std::vector<double>& value) {
  value = table.numbers(key.name, key.about.bound);
}

void read_value(const SceneTable& table, const schema::AnyKey& key, std::vector<std::string>& value) {
  value = table.texts(key.name, texts_of(key));
}

void read_value(const SceneTable& table, const schema::AnyKey& key, std::vector<std::int64_t>& value) {
  value = table.integers(key.name, schema::lowest(key.about));
}

void read_value(const SceneTable& table, const schema::AnyKey& key, std::vector<std::array<std::int64_t, 4>>& value) {
  value = table.faces(key.name);
}

void refine_count(const SceneTable& table, std::string_view key, int refine, int& count) {
  if (count > std::numeric_limits<int>::max() / refine) fail_too_many(table, key, static_cast<double>(count) * refine);
  count *= refine;
}

void refine_count(const SceneTable& table, std::string_view key, int refine, std::array<int, 2>& counts) {
  for (int& count : counts) refine_count(table, key, refine, count);
}

}  // namespace pinball
