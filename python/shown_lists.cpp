#include "shown_lists.hpp"

namespace pinball::python {

namespace py = pybind11;

namespace {

constexpr const char* changes[] = {"__setitem__", "__delitem__", "append", "extend", "insert",
                                   "pop",         "remove",      "clear",  "sort",   "reverse"};

[[noreturn]] void refuse(const py::object& self) {
  const std::string field = py::str(self.attr("_field"));
  throw py::type_error(field + " shows a copy: nothing of it is changed in place; give " + field +
                       " a new list (list(...) of this one can be changed)");
}

/// A class of Python: lists that refuse what would change them. `scene.field += [...]` gives the field a new list, and
/// so it goes on to do what it says; copies and pickles are plain lists.
py::object make_type() {
  const py::module_ builtins = py::module_::import("builtins");
  const py::object list = builtins.attr("list");
  py::dict members;
  members["__module__"] = "pinball";
  members["__doc__"] = "A list that a field shows; a copy, which cannot be changed in place.";
  const py::object type = builtins.attr("type")("ShownList", py::make_tuple(list), members);
  const py::is_method method(type);
  const auto add = [&](const char* name, const py::cpp_function& function) { py::setattr(type, name, function); };
  for (const char* name : changes) {
    add(name,
        py::cpp_function([](const py::object& self, const py::args&, const py::kwargs&) { refuse(self); }, method));
  }
  add("__iadd__", py::cpp_function([](const py::list& self, const py::list& more) { return self + more; }, method));
  add("__imul__", py::cpp_function([](const py::list& self, const py::int_& times) { return self * times; }, method));
  add("__reduce__", py::cpp_function(
                        [list](const py::list& self) {
                          py::list plain;
                          for (const py::handle each : self) plain.append(each);
                          return py::make_tuple(list, py::make_tuple(plain));
                        },
                        method));
  return type;
}

}  // namespace

py::object shown_list(py::object value, const std::string& field) {
  if (!PyList_CheckExact(value.ptr())) return value;
  static const py::handle type = make_type().release();  // goes with the interpreter
  py::list items;
  for (const py::handle each : value) items.append(shown_list(py::reinterpret_borrow<py::object>(each), field));
  py::object shown = type(items);
  py::setattr(shown, "_field", py::str(field));
  return shown;
}

}  // namespace pinball::python
