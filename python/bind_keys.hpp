#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <solver/scene/schema/scene.hpp>
#include <solver/scene/schema/unset.hpp>

#include "bindings.hpp"

/// Classes of scenes, from the description of their keys.
namespace pinball::python {

/// What the field of a key is, in a line: "fraction of the stable time step [-]".
std::string text_of_key(const schema::AnyKey& key, std::string_view none);

/// Binds the fields of a table. Class: what Python sees of it.
template <class Class, class T = Class>
class KeyBinder {
 public:
  explicit KeyBinder(DataClass<Class>& data) : data_(data) {}

  template <class Value>
  void operator()(const schema::FileKey<Value>&) {}
  template <class Value>
  void operator()(const schema::Key<T, Value>& key) {
    bind(key.field(), key.member, text_of_key(key, none<Value>(key.about)));
  }
  template <class Part>
  void operator()(const schema::Group<T, Part>& group) {
    bind(group.field, group.member, group.meaning);
  }
  template <class Value>
  void operator()(const schema::Field<T, Value>& field) {
    bind(field.field, field.member, field.meaning);
  }
  /// Of one number Python sees the number.
  void operator()(const schema::Tables<T, DampingSettings>& damping) {
    data_.def_inner(damping.field, damping.member, &DampingSettings::mass, "damping.mass [1/time]");
  }

 private:
  /// Two keys may set one member.
  template <class Member>
  void bind(const std::string& name, Member T::*member, const std::string& text) {
    if (!schema::is_among(name, bound_)) data_.def_readwrite(name.c_str(), member, text.c_str());
    bound_.push_back(name);
  }
  /// What stands for a value that is not given.
  template <class Value>
  static std::string_view none(const schema::About& about) {
    if (!*about.otherwise || about.need != schema::Need::optional) return "";
    if (about.unset == schema::Unset::negative) return "negative";
    if (schema::HasChoices<Value> || std::is_arithmetic_v<Value>) return "";
    return schema::is_unset(Value{}, about) ? requires(Value value) { value.has_value(); }
    ? "None" : "empty" : "";
  }

  DataClass<Class>& data_;
  std::vector<std::string> bound_;
};

/// A class of the fields that a table of a scene has.
template <class T>
DataClass<T> bind_table(py::module_& module, const char* name, const char* text) {
  DataClass<T> data = bind_data<T>(module, name, text);
  describe(schema::Of<T>{}, KeyBinder<T>(data));
  return data;
}

/// An enumeration, for which the texts of a scene file do, too.
template <class Enum>
void bind_choice(py::module_& module, const char* name) {
  py::enum_<Enum> choice(module, name);
  for (const auto& one : schema::choices(schema::Of<Enum>{})) choice.value(one.name, one.value);
  choice.def(py::init([name](const std::string& given) {
    for (const auto& one : schema::choices(schema::Of<Enum>{})) {
      if (given == one.name) return one.value;
    }
    throw py::value_error(std::string(name) + ": unknown value \"" + given + "\"");
  }));
  py::implicitly_convertible<py::str, Enum>();
}

}  // namespace pinball::python
