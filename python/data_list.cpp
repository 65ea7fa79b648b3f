#include "data_list.hpp"

#include <algorithm>
#include <string>

namespace pinball::python {

namespace {

/// `key` counts from the end where it is negative. Throws TypeError where it is no whole number.
std::size_t place_of(const ListType& type, py::handle list, py::handle key) {
  py::ssize_t index = PyNumber_AsSsize_t(key.ptr(), PyExc_IndexError);
  if (index == -1 && PyErr_Occurred() != nullptr) throw py::error_already_set();
  const auto size = static_cast<py::ssize_t>(type.size(list));
  if (index < 0) index += size;
  if (index < 0 || index >= size) throw py::index_error(text_of_type(type.type) + ": no such place");
  return static_cast<std::size_t>(index);
}

void set_place(const ListType& type, py::handle list, std::size_t place, py::handle value) {
  if (type.element->set(type.at(list, place), value)) return;
  throw py::type_error(text_of_type(type.type) + ": " + wrong_type(*type.element, value));
}

/// Before `index`, as Python's lists do: any number goes.
void insert(const ListType& type, py::handle list, py::ssize_t index, py::handle value) {
  const auto size = static_cast<py::ssize_t>(type.size(list));
  if (index < 0) index = std::max<py::ssize_t>(0, index + size);
  const auto place = static_cast<std::size_t>(std::min(index, size));
  // The list may move what `value` refers to.
  const py::object copy = py::module_::import("copy").attr("copy")(value);
  type.insert(list, place);
  try {
    set_place(type, list, place, copy);
  } catch (...) {
    type.erase(list, place);
    throw;
  }
}

/// Changes a Python list of copies, which then is the list.
void change_copies(const ListType& type, py::handle list, const char* method, const py::args& arguments) {
  py::list items;
  for (std::size_t i = 0; i < type.size(list); ++i) items.append(type.element->copy(type.at(list, i)));
  items.attr(method)(*arguments);
  const py::object changed = type.type(items);  // throws before anything is lost
  while (type.size(list) > 0) type.erase(list, type.size(list) - 1);
  extend_list(type, list, changed);
}

}  // namespace

void extend_list(const ListType& type, py::handle list, const py::iterable& items) {
  for (const py::handle item : items) {
    type.insert(list, type.size(list));
    set_place(type, list, type.size(list) - 1, item);
  }
}

void bind_list_methods(const ListType& list_type) {
  const ListType* type = &list_type;
  const auto bind = [type](const char* name, auto function) {
    py::setattr(type->type, name, py::cpp_function(function, py::name(name), py::is_method(type->type)));
  };
  const py::object sequence = py::module_::import("collections.abc").attr("MutableSequence");
  for (const char* name :
       {"append", "clear", "count", "index", "pop", "remove", "__contains__", "__iadd__", "__iter__", "__reversed__"}) {
    py::setattr(type->type, name, sequence.attr(name));
  }
  sequence.attr("register")(type->type);
  bind("__len__", [type](const py::object& self) { return type->size(self); });
  bind("__getitem__", [type](const py::object& self, const py::object& key) -> py::object {
    if (py::isinstance<py::slice>(key)) return type->type(py::list(self).attr("__getitem__")(key));
    return type->element->show(type->at(self, place_of(*type, self, key)), self);
  });
  bind("__setitem__", [type](const py::object& self, const py::object& key, const py::object& value) {
    if (py::isinstance<py::slice>(key)) {
      change_copies(*type, self, "__setitem__", py::make_tuple(key, value));
    } else {
      set_place(*type, self, place_of(*type, self, key), value);
    }
  });
  bind("__delitem__", [type](const py::object& self, const py::object& key) {
    if (py::isinstance<py::slice>(key)) {
      change_copies(*type, self, "__delitem__", py::make_tuple(key));
    } else {
      type->erase(self, place_of(*type, self, key));
    }
  });
  bind("insert", [type](const py::object& self, py::ssize_t index, const py::object& value) {
    insert(*type, self, index, value);
  });
  bind("extend", [type](const py::object& self, const py::iterable& items) {
    extend_list(*type, self,
                type->type(items));  // copies: the list may move its elements, which may be among the items
  });
  bind("reverse", [type](const py::object& self) { change_copies(*type, self, "reverse", py::args()); });
  bind("__repr__", [](const py::object& self) { return py::repr(py::list(self)); });
  bind("__eq__", [](const py::object& self, const py::object& other) {
    return py::isinstance<py::sequence>(other) && py::list(self).equal(py::list(other));
  });
  bind("__reduce__",
       [](const py::object& self) { return py::make_tuple(py::type::of(self), py::make_tuple(py::list(self))); });
}

}  // namespace pinball::python
