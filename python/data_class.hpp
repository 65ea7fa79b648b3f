#pragma once

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <type_traits>
#include <typeinfo>
#include <utility>
#include <vector>

namespace pinball::python {

namespace py = pybind11;

/// What Python does with the members of a type. Functions of a type, not of a field: there are hundreds of fields, and
/// each function that is bound takes as long to compile as a small file.
struct MemberType {
  py::object (*show)(const void* member, py::handle owner);  ///< an object refers to the member, a number is a copy
  py::object (*copy)(const void* member);
  bool (*set)(void* member, py::handle value);  ///< false: `value` is none of the type
  std::string (*name)();                        ///< in Python's words
  std::size_t size;
  void* (*make)();  ///< on the heap
  void (*swap)(void* one, void* other);
  void (*drop)(void* made);
  bool nests_objects;  ///< what it shows has objects of memory that is not the member's own: elements of vectors
};

template <class Member>
inline constexpr bool nests_objects = false;
template <class Element, std::size_t size>
inline constexpr bool nests_objects<std::array<std::vector<Element>, size>> = std::is_class_v<Element>;

/// A field of a class of plain data.
struct DataField {
  std::string name;
  std::function<void*(void* data)> member_of;
  const MemberType* type;
};

/// The class of a field and how its data are found. They outlive the module.
struct DataType {
  py::handle type;
  void* (*data_of)(py::handle object);
  std::vector<DataField> fields;
};

/// Gives a member a value; false: it is none of the type. Python objects that refer to what the member was, or to parts
/// of it, do so further on, as to any object whose place another one took.
/// owner: the object that the member is of; null: a list's element.
bool set_member(const MemberType& type, void* member, py::handle value, py::handle owner = {});
/// "Material", of a class.
std::string text_of_type(py::handle type);
/// "float expected, str given"
std::string wrong_type(const MemberType& expected, py::handle given);
/// Python's name of a type that pybind11 describes by a text with a % for each class in it.
std::string name_of_type(const char* text, const std::type_info* const* classes);
/// "Name(field=value, ...)" with the fields of `object` that are not what they are in `other`.
std::string text_of_fields(const DataType& type, const py::object& object, const py::object& other);
bool same_fields(const DataType& type, const py::object& one, const py::object& other);
py::dict copies_of_fields(const DataType& type, py::handle object);
/// Throws TypeError where a value is none of its field.
void set_fields(const DataType& type, py::handle object, const py::dict& values);
/// A property of the class, which goes with it.
void bind_field(DataType& type, DataField field, const char* text, bool writable);
/// Types of all fields that were bound, as annotations of their classes: Body.__annotations__["mesh"]. For when all
/// classes have names.
void annotate_fields();

template <class Member>
const MemberType& member_type() {
  static const MemberType type{
      [](const void* member, py::handle owner) {
        return py::cast(*static_cast<const Member*>(member), py::return_value_policy::reference_internal, owner);
      },
      [](const void* member) { return py::cast(*static_cast<const Member*>(member), py::return_value_policy::copy); },
      [](void* member, py::handle value) {
        py::detail::make_caster<Member> caster;
        if (!caster.load(value, true)) return false;
        *static_cast<Member*>(member) = py::detail::cast_op<const Member&>(caster);
        return true;
      },
      [] {
        const auto& name = py::detail::make_caster<Member>::name;
        return name_of_type(name.text, name.types().data());
      },
      sizeof(Member),
      []() -> void* { return new Member(); },
      [](void* one, void* other) { std::swap(*static_cast<Member*>(one), *static_cast<Member*>(other)); },
      [](void* made) { delete static_cast<Member*>(made); },
      nests_objects<Member>};
  return type;
}

/// A class of plain data. From its fields follow repr(), ==, pickle and copies; a field that is bound is in all of
/// them.
template <class Data>
class DataClass : public py::class_<Data> {
 public:
  DataClass(const py::handle& scope, const char* name, const char* text) : py::class_<Data>(scope, name, text) {
    type() = {*this, [](py::handle self) -> void* { return self.cast<Data*>(); }, {}};
    this->def("__repr__", [](const py::object& self) { return text_of_fields(type(), self, py::cast(Data{})); });
    this->def("__eq__",
              [](const py::object& self, const py::object& other) { return same_fields(type(), self, other); });
    this->def(py::pickle([](const py::object& self) { return copies_of_fields(type(), self); },
                         [](const py::dict& values) { return made_of(values); }));
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
    return add(name, member, text, true);
  }
  template <class Class, class Member>
  DataClass& def_readonly(const char* name, Member Class::*member, const char* text = "") {
    return add(name, member, text, false);
  }
  /// A field that Python sees as a member of one of the members.
  template <class Class, class Outer, class Member>
  DataClass& def_inner(const char* name, Outer Class::*outer, Member Outer::*member, const char* text = "") {
    const auto member_of = [=](void* data) -> void* { return &(static_cast<Data*>(data)->*outer.*member); };
    bind_field(type(), {name, member_of, &member_type<Member>()}, text, true);
    return *this;
  }

 private:
  static DataType& type() {
    static DataType one;
    return one;
  }
  static Data made_of(const py::dict& values) {
    const py::object made = py::cast(Data{});
    set_fields(type(), made, values);
    return made.cast<Data>();
  }
  template <class Class, class Member>
  DataClass& add(const char* name, Member Class::*member, const char* text, bool writable) {
    const auto member_of = [member](void* data) -> void* { return &(static_cast<Data*>(data)->*member); };
    bind_field(type(), {name, member_of, &member_type<Member>()}, text, writable);
    return *this;
  }
};

}  // namespace pinball::python
