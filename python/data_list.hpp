#pragma once

#include <pybind11/pybind11.h>

#include <cstddef>
#include <iterator>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "data_class.hpp"

namespace pinball::python {

/// A list of plain data, without its type. It outlives the module.
struct ListType {
  py::handle type;
  const MemberType* element;
  std::size_t (*size)(py::handle list);
  void* (*at)(py::handle list, std::size_t place);
  bool (*has_room)(py::handle list);                   ///< for one more at the end, without moving the others
  void (*insert)(py::handle list, std::size_t place);  ///< an element as it is made
  void (*shorten)(py::handle list, std::size_t size);
};

/// Appends copies of all items. Throws TypeError for one that is no element.
void extend_list(const ListType& type, py::handle list, const py::iterable& items);
/// What all lists do: places and slices, and with them all of collections.abc.MutableSequence, repr(), == and pickle.
void bind_list_methods(const ListType& type);

/// A list of plain data, to which Python lists convert. What it shows are its elements, not copies.
template <class Data>
void bind_list(py::module_& module, const char* name) {
  using List = std::vector<Data>;
  static_assert(std::is_nothrow_move_constructible_v<Data>, "what elements have elsewhere stays where it is");
  static ListType type;
  const std::string text = "A list of " + text_of_type(py::type::of<Data>()) + ".";
  py::class_<List> list(module, name, text.c_str());
  type = {list,
          &member_type<Data>(),
          [](py::handle self) { return self.cast<List&>().size(); },
          [](py::handle self, std::size_t place) -> void* { return &self.cast<List&>()[place]; },
          [](py::handle self) {
            const List& all = self.cast<List&>();
            return all.size() < all.capacity();
          },
          [](py::handle self, std::size_t place) {
            List& all = self.cast<List&>();
            all.emplace(std::next(all.begin(), static_cast<std::ptrdiff_t>(place)));
          },
          [](py::handle self, std::size_t size) { self.cast<List&>().resize(size); }};
  list.def(py::init([](const py::iterable& items) {
             const py::object made = py::cast(List());
             extend_list(type, made, items);
             return std::move(made.cast<List&>());
           }),
           py::arg("items") = py::tuple());
  bind_list_methods(type);
  py::implicitly_convertible<py::list, List>();
}

}  // namespace pinball::python
