#pragma once

#include <string>
#include <utility>

#include <solver/scene/schema/unset.hpp>

#include "value_schema.hpp"

/// Tables as JSON Schema says it, by the description of their keys.
namespace pinball {

/// What a key is where it is not given: a value as in a file, where there is one.
template <class Value>
SchemaJson default_of(const Value& value, const schema::AnyKey& key) {
  if (key.about.need != schema::Need::optional || schema::is_unset(value, key.about)) return nullptr;
  if constexpr (schema::HasChoices<Value>) {
    return schema::name_of(value);
  } else if constexpr (std::is_same_v<Value, bool>) {
    return *key.about.yes ? SchemaJson(value ? key.about.yes : key.about.no) : SchemaJson(value);
  } else if constexpr (std::is_same_v<Value, std::string> || requires { std::tuple_size<Value>::value; } ||
                       std::is_arithmetic_v<Value> || std::is_same_v<Value, std::vector<std::string>> ||
                       std::is_same_v<Value, std::vector<double>>) {
    return value;
  } else {
    return nullptr;
  }
}

/// Adds the keys of a table to its properties.
template <class T>
class KeySchemas {
 public:
  /// some: of which object; none: of all.
  KeySchemas(SchemaJson& table, const T* some) : table_(table), some_(some) {}

  template <class Value>
  void operator()(const schema::FileKey<Value>& key) const {
    add(key, value_schema(schema::Of<Value>{}, key), nullptr, true);
  }
  template <class Value>
  void operator()(const schema::Key<T, Value>& key) const {
    if (some_ != nullptr && key.applies != nullptr && !key.applies(*some_)) return;
    add(key, value_schema(schema::Of<Value>{}, key), default_of(T{}.*key.member, key), key.applies == nullptr);
  }
  template <class Part>
  void operator()(const schema::Group<T, Part>& group) const {
    visit_group(group, KeySchemas<Part>(table_, nullptr));
  }
  template <class Value>
  void operator()(const schema::Field<T, Value>&) const {}
  template <class Part>
  void operator()(const schema::Tables<T, Part>& tables) const {
    SchemaJson& property = table_["properties"][tables.name];
    const SchemaJson value = value_schema(schema::Of<Part>{}, schema::AnyKey{tables.name, tables.meaning, {}});
    if (!property.is_null()) {  // tables of one name and two kinds
      property["items"] = any_of({property["items"], value["items"]});
      return;
    }
    property = value;
    property["description"] = tables.meaning;
  }

 private:
  void add(const schema::AnyKey& key, SchemaJson value, const SchemaJson& otherwise, bool of_all) const {
    const std::string unit = key.about.unit;
    value["description"] = unit.empty() ? key.meaning : key.meaning + (" [" + unit + "]");
    if (!unit.empty()) value["x-unit"] = unit;
    if (!otherwise.is_null()) value["default"] = otherwise;
    if (*key.about.otherwise) value["x-default"] = key.about.otherwise;
    table_["properties"][key.name] = std::move(value);
    if (key.required() && of_all) table_["required"].push_back(key.name);
  }

  SchemaJson& table_;
  const T* some_;
};

template <class T>
SchemaJson table_schema(const T* some = nullptr) {
  SchemaJson table{{"type", "object"}, {"properties", SchemaJson::object()}};
  describe(schema::Of<T>{}, KeySchemas<T>(table, some));
  table["additionalProperties"] = false;
  return table;
}

}  // namespace pinball
