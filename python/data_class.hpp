#pragma once

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <functional>
#include <string>
#include <vector>

namespace pinball::python {

namespace py = pybind11;

/// "Name(field=value, ...)" with the fields of `object` that are not what they are in `other`.
std::string text_of_fields(const py::object& object, const py::object& other, const std::vector<std::string>& names);
bool same_fields(const py::object& one, const py::object& other, const std::vector<std::string>& names);

/// A class of plain data. From its fields follow repr(), ==, pickle and copies; a field that is bound is in all of
/// them.
template <class Data>
class DataClass : public py::class_<Data> {
 public:
  DataClass(const py::handle& scope, const char* name, const char* text) : py::class_<Data>(scope, name, text) {
    this->def("__repr__", [](const py::object& self) { return text_of_fields(self, py::cast(Data{}), names()); });
    this->def("__eq__",
              [](const py::object& self, const py::object& other) { return same_fields(self, other, names()); });
    this->def(py::pickle(
        [](const Data& data) {
          py::dict values;
          for (const Field& field : fields()) values[field.name.c_str()] = field.get(data);
          return values;
        },
        [](const py::dict& values) {
          Data data{};
          for (const Field& field : fields()) field.set(data, values[field.name.c_str()]);
          return data;
        }));
  }

  /// Fields by name: Material(name="steel", density=7850).
  DataClass& made_by_fields() {
    this->def(py::init([](const py::kwargs& values) {
      py::object made = py::cast(Data{});
      for (const auto& [field, value] : values) py::setattr(made, field, value);
      return made.cast<Data>();
    }));
    return *this;
  }
  template <class Class, class Member>
  DataClass& def_readwrite(const char* name, Member Class::*member, const char* text = "") {
    py::class_<Data>::def_readwrite(name, member, text);
    return add(name, member);
  }
  template <class Class, class Member>
  DataClass& def_readonly(const char* name, Member Class::*member, const char* text = "") {
    py::class_<Data>::def_readonly(name, member, text);
    return add(name, member);
  }
  /// A field that Python sees as a member of one of the members.
  template <class Class, class Outer, class Member>
  DataClass& def_inner(const char* name, Outer Class::*outer, Member Outer::*member, const char* text = "") {
    const auto get = [=](const Data& data) { return data.*outer.*member; };
    const auto set = [=](Data& data, const Member& value) { data.*outer.*member = value; };
    py::class_<Data>::def_property(name, get, set, text);
    fields().push_back({name, [get](const Data& data) { return py::cast(get(data)); },
                        [set](Data& data, const py::handle& value) { set(data, value.cast<Member>()); }});
    return *this;
  }

 private:
  struct Field {
    std::string name;
    std::function<py::object(const Data&)> get;  ///< a copy
    std::function<void(Data&, const py::handle&)> set;
  };
  static std::vector<Field>& fields() {
    static std::vector<Field> all;
    return all;
  }
  static std::vector<std::string> names() {
    std::vector<std::string> all;
    for (const Field& field : fields()) all.push_back(field.name);
    return all;
  }
  template <class Class, class Member>
  DataClass& add(const char* name, Member Class::*member) {
    fields().push_back({name, [member](const Data& data) { return py::cast(Member(data.*member)); },
                        [member](Data& data, const py::handle& value) { data.*member = value.cast<Member>(); }});
    return *this;
  }
};

}  // namespace pinball::python
