#pragma once

#include <fmt/format.h>

#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <solver/scene/schema/choices.hpp>
#include <solver/scene/schema/kinds.hpp>

#include "table.hpp"

/// From a table of a file to its object, by the description of its keys. What is missing and not required leaves the
/// object as it is; keys that a table reads by hand are left to it.
namespace pinball {

/// Under a key that is there or required.
void read_value(const SceneTable& table, const schema::AnyKey& key, double& value);
void read_value(const SceneTable& table, const schema::AnyKey& key, std::int64_t& value);
void read_value(const SceneTable& table, const schema::AnyKey& key, int& value);
void read_value(const SceneTable& table, const schema::AnyKey& key, bool& value);
void read_value(const SceneTable& table, const schema::AnyKey& key, std::string& value);
void read_value(const SceneTable& table, const schema::AnyKey& key, Point& value);
void read_value(const SceneTable& table, const schema::AnyKey& key, std::array<Point, 3>& value);
void read_value(const SceneTable& table, const schema::AnyKey& key, std::array<int, 2>& value);
void read_value(const SceneTable& table, const schema::AnyKey& key, std::vector<double>& value);
void read_value(const SceneTable& table, const schema::AnyKey& key, std::vector<std::string>& value);
void read_value(const SceneTable& table, const schema::AnyKey& key, std::vector<std::int64_t>& value);
void read_value(const SceneTable& table, const schema::AnyKey& key, std::vector<std::array<std::int64_t, 4>>& value);

template <schema::HasChoices Value>
void read_value(const SceneTable& table, const schema::AnyKey& key, Value& value) {
  std::vector<std::pair<std::string, Value>> values;
  for (const auto& choice : schema::choices(schema::Of<Value>{})) {
    if (choice.in_files) values.emplace_back(choice.name, choice.value);
  }
  value = table.choice<Value>(key.name, values);
}

template <class T>
void read_keys(const SceneTable& table, T& object, int refine = 1);

template <schema::InnerTable Part>
requires(!requires(Part part) { part.has_value(); }) void read_value(const SceneTable& table, const schema::AnyKey& key,
                                                                     Part& value) {
  const SceneTable part = table.table(key.name, kind(schema::Of<Part>{}).name);
  read_keys(part, value);
  if constexpr (requires { problem_of(value); }) part.require_none(problem_of(value));
}

template <class Value>
void read_value(const SceneTable& table, const schema::AnyKey& key, std::optional<Value>& value) requires
    requires(Value& one) {
  read_value(table, key, one);
}
{ read_value(table, key, value.emplace()); }

/// As int. Throws InputError if it is none.
int to_count(const SceneTable& table, std::string_view key, std::int64_t count);
/// Times `refine`, as int. Throws InputError if that overflows.
void refine_count(const SceneTable& table, std::string_view key, int refine, int& count);
void refine_count(const SceneTable& table, std::string_view key, int refine, std::array<int, 2>& counts);

template <class T>
class KeyReader {
 public:
  KeyReader(const SceneTable& table, T& object, int refine) : table_(table), object_(object), refine_(refine) {}

  template <class Value>
  void operator()(const schema::FileKey<Value>&) const {}
  template <class Value>
  void operator()(const schema::Field<T, Value>&) const {}
  template <class Value>
  void operator()(const schema::Key<T, Value>& key) const {
    if constexpr (requires(Value & value) { read_value(table_, key, value); }) {
      if (is_left_out(key) || key.about.done != schema::Done::by_visitors) return;
      Value& value = object_.*key.member;
      if (table_.has(key.name) || key.required()) read_value(table_, key, value);
      if constexpr (requires { refine_count(table_, key.name, refine_, value); }) {
        if (key.about.form == schema::Form::count) refine_count(table_, key.name, refine_, value);
      }
    }
  }
  template <class Part>
  void operator()(const schema::Group<T, Part>& group) const {
    visit_group(group, KeyReader<Part>(table_, object_.*group.member, refine_));
  }

 private:
  /// A key that this object has not.
  template <class Value>
  bool is_left_out(const schema::Key<T, Value>& key) const {
    if (key.may_be_of(object_)) return false;
    if (table_.has(key.name)) table_.fail(key.name, fmt::format("not used {}", key.rejected));
    return true;
  }

  const SceneTable& table_;
  T& object_;
  int refine_;
};

/// refine: what multiplies counts of elements.
template <class T>
void read_keys(const SceneTable& table, T& object, int refine) {
  describe(schema::Of<T>{}, KeyReader<T>(table, object, refine));
}

}  // namespace pinball
