#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <solver/scene/schema/choices.hpp>
#include <solver/scene/schema/kinds.hpp>

/// The values that keys have in files, as JSON Schema says it: one function for each type.
namespace pinball {

using SchemaJson = nlohmann::ordered_json;

inline SchemaJson reference(const std::string& name) { return {{"$ref", "#/definitions/" + name}}; }
template <class T>
SchemaJson reference_to(schema::Of<T>) {
  return reference(kind(schema::Of<T>{}).name);
}

/// A number of a bound; whole: an integer.
SchemaJson number_schema(const Bound& bound, bool whole = false);
SchemaJson array_schema(const SchemaJson& items, std::optional<std::size_t> count = {});
SchemaJson texts_schema(std::span<const std::string_view> texts);
inline SchemaJson any_of(std::vector<SchemaJson> all) { return {{"anyOf", std::move(all)}}; }

inline SchemaJson value_schema(schema::Of<double>, const schema::AnyKey& key) {
  const SchemaJson number = number_schema(key.about.bound);
  return *key.about.also ? any_of({number, {{"const", key.about.also}}}) : number;
}
template <class Integer>
requires std::is_same_v<Integer, int> || std::is_same_v<Integer, std::int64_t> SchemaJson
value_schema(schema::Of<Integer>, const schema::AnyKey& key) {
  return number_schema(key.about.bound, true);
}
inline SchemaJson value_schema(schema::Of<bool>, const schema::AnyKey& key) {
  if (*key.about.yes) return {{"enum", {key.about.no, key.about.yes}}};
  return {{"type", "boolean"}};
}
inline SchemaJson value_schema(schema::Of<std::string>, const schema::AnyKey& key) {
  if (!key.about.texts.empty()) return texts_schema(key.about.texts);
  SchemaJson text{{"type", "string"}};
  if (key.about.form == schema::Form::name) text["pattern"] = "^[A-Za-z0-9_-]+$";
  return text;
}
template <schema::HasChoices Value>
SchemaJson value_schema(schema::Of<Value>, const schema::AnyKey&) {
  SchemaJson names = SchemaJson::array();
  for (const auto& choice : schema::choices(schema::Of<Value>{})) {
    if (choice.in_files) names.push_back(choice.name);
  }
  return {{"enum", names}};
}
inline SchemaJson value_schema(schema::Of<Point>, const schema::AnyKey& key) {
  SchemaJson point = array_schema(number_schema(key.about.bound), 3);
  if (key.about.form == schema::Form::direction) point["not"] = {{"items", {{"const", 0}}}};
  return point;
}
inline SchemaJson value_schema(schema::Of<std::array<Point, 3>>, const schema::AnyKey& key) {
  return array_schema(array_schema(number_schema(key.about.bound), 3), 3);
}
inline SchemaJson value_schema(schema::Of<std::array<int, 2>>, const schema::AnyKey& key) {
  return array_schema(number_schema(key.about.bound, true), 2);
}
inline SchemaJson value_schema(schema::Of<std::array<double, 2>>, const schema::AnyKey& key) {
  return array_schema(number_schema(key.about.bound), 2);
}
inline SchemaJson value_schema(schema::Of<schema::OneOrTwoCounts>, const schema::AnyKey& key) {
  const SchemaJson count = number_schema(key.about.bound, true);
  return any_of({count, array_schema(count, 2)});
}
inline SchemaJson value_schema(schema::Of<std::vector<double>>, const schema::AnyKey& key) {
  return array_schema(number_schema(key.about.bound));
}
inline SchemaJson value_schema(schema::Of<std::vector<std::int64_t>>, const schema::AnyKey& key) {
  return array_schema(number_schema(key.about.bound, true));
}
inline SchemaJson value_schema(schema::Of<std::vector<std::array<std::int64_t, 4>>>, const schema::AnyKey& key) {
  return array_schema(array_schema(number_schema(key.about.bound, true), 4));
}
inline SchemaJson value_schema(schema::Of<std::vector<std::string>>, const schema::AnyKey& key) {
  SchemaJson list =
      array_schema(key.about.texts.empty() ? SchemaJson{{"type", "string"}} : texts_schema(key.about.texts));
  list["minItems"] = 1;
  return list;
}
template <class Number>
SchemaJson value_schema(schema::Of<schema::ListsOf<Number>>, const schema::AnyKey& key) {
  const SchemaJson number = number_schema(key.about.bound, std::is_same_v<Number, int>);
  SchemaJson list = array_schema(number);
  list["minItems"] = 1;
  return array_schema(any_of({number, list}), 3);
}
/// Directions along which nodes are held.
inline SchemaJson value_schema(schema::Of<std::vector<Point>>, const schema::AnyKey& key) {
  schema::AnyKey one = key;
  one.about.form = schema::Form::direction;
  SchemaJson names{{"enum", {"x", "y", "z", "radial", "circumferential", "axial"}}};
  SchemaJson list = array_schema(any_of({names, value_schema(schema::Of<Point>{}, one)}));
  list["minItems"] = 1;
  return any_of({{{"const", "all"}}, list});
}
inline SchemaJson value_schema(schema::Of<ContactSide>, const schema::AnyKey&) {
  const SchemaJson one =
      any_of({{{"type", "string"}, {"minLength", 1}}, reference_to(schema::Of<schema::SideOfSet>{})});
  SchemaJson list = array_schema(one);
  list["minItems"] = 1;
  return {{"anyOf", {one["anyOf"][0], one["anyOf"][1], list}}};
}
inline SchemaJson value_schema(schema::Of<MeshSettings>, const schema::AnyKey&) { return reference("mesh"); }
inline SchemaJson value_schema(schema::Of<schema::Variants>, const schema::AnyKey&) {
  return {{"type", "object"}, {"additionalProperties", {{"type", "object"}}}};
}
template <class T>
SchemaJson value_schema(schema::Of<std::vector<T>>, const schema::AnyKey&) {
  return array_schema(reference_to(schema::Of<T>{}));
}
template <class T>
SchemaJson value_schema(schema::Of<std::optional<T>>, const schema::AnyKey& key) {
  return value_schema(schema::Of<T>{}, key);
}
/// A table within a table.
template <class T>
SchemaJson value_schema(schema::Of<T>, const schema::AnyKey&) {
  return reference_to(schema::Of<T>{});
}

}  // namespace pinball
