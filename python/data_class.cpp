#include "data_class.hpp"

#include <utility>

#include "live_objects.hpp"
#include "shown_lists.hpp"

namespace pinball::python {

namespace {

/// Of which fields were bound; they outlive the module.
std::vector<const DataType*>& types_with_fields() {
  static std::vector<const DataType*> all;
  return all;
}

py::object get(const DataType& type, const DataField& field, py::handle object) {
  return field.type->copy(field.member_of(type.data_of(object)));
}

void set(const DataType& type, const DataField& field, py::handle object, py::handle value) {
  if (set_member(*field.type, field.member_of(type.data_of(object)), value, object)) return;
  throw py::type_error(text_of_type(type.type) + "." + field.name + ": " + wrong_type(*field.type, value));
}

}  // namespace

bool set_member(const MemberType& type, void* member, py::handle value, py::handle owner) {
  void* const made = type.make();
  const py::capsule keeper(made, type.drop);
  if (!type.set(made, value)) return false;
  const LiveObjects live(member, type.size);
  if (live.have(value)) return true;  // `scene.bodies += others` ends with scene.bodies = scene.bodies
  type.swap(member, made);            // what the member was is there now
  if (type.nests_objects && owner) py::detail::keep_alive_impl(owner, keeper);
  live.move([&](std::size_t offset) { return LiveObjects::Place{static_cast<char*>(made) + offset, keeper}; });
  return true;
}

std::string text_of_type(py::handle type) { return py::str(type.attr("__name__")); }

std::string wrong_type(const MemberType& expected, py::handle given) {
  return expected.name() + " expected, " + text_of_type(py::type::of(given)) + " given";
}

std::string name_of_type(const char* text, const std::type_info* const* classes) {
  std::string name;
  for (; *text != '\0'; ++text) {
    if (*text == '%') {
      const py::handle known = py::detail::get_type_handle(**classes, false);
      name += known ? text_of_type(known) : std::string("another type");
      ++classes;
    } else {
      name += *text;
    }
  }
  return name;
}

std::string text_of_fields(const DataType& type, const py::object& object, const py::object& other) {
  std::string text;
  for (const DataField& field : type.fields) {
    const py::object value = object.attr(field.name.c_str());
    if (value.equal(other.attr(field.name.c_str()))) continue;
    text += (text.empty() ? "" : ", ") + field.name + "=" + std::string(py::repr(value));
  }
  return text_of_type(py::type::of(object)) + "(" + text + ")";
}

bool same_fields(const DataType& type, const py::object& one, const py::object& other) {
  if (!py::type::of(one).is(py::type::of(other))) return false;
  for (const DataField& field : type.fields) {
    if (!one.attr(field.name.c_str()).equal(other.attr(field.name.c_str()))) return false;
  }
  return true;
}

py::dict copies_of_fields(const DataType& type, py::handle object) {
  py::dict values;
  for (const DataField& field : type.fields) values[field.name.c_str()] = get(type, field, object);
  return values;
}

void set_fields(const DataType& type, py::handle object, const py::dict& values) {
  for (const DataField& field : type.fields) set(type, field, object, values[field.name.c_str()]);
}

void bind_field(DataType& type, DataField field, const char* text, bool writable) {
  const py::is_method method(type.type);
  const DataType* data_type = &type;
  const py::cpp_function getter(
      [data_type, field, writable](const py::object& self) {
        py::object shown = field.type->show(field.member_of(data_type->data_of(self)), self);
        if (!writable) return shown;
        return shown_list(std::move(shown), text_of_type(data_type->type) + "." + field.name);
      },
      method);
  py::object setter = py::none();
  if (writable) {
    setter = py::cpp_function(
        [data_type, field](const py::object& self, const py::object& value) { set(*data_type, field, self, value); },
        method);
  }
  const py::object property = py::module_::import("builtins").attr("property");
  py::setattr(type.type, field.name.c_str(), property(getter, setter, py::none(), text));
  if (type.fields.empty()) types_with_fields().push_back(&type);
  type.fields.push_back(std::move(field));
}

void annotate_fields() {
  for (const DataType* type : types_with_fields()) {
    py::dict annotations;
    for (const DataField& field : type->fields) annotations[field.name.c_str()] = field.type->name();
    py::setattr(type->type, "__annotations__", annotations);
  }
}

}  // namespace pinball::python
