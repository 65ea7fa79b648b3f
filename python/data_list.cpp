#include "data_list.hpp"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <map>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "live_objects.hpp"

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

[[noreturn]] void throw_wrong_type(const ListType& type, py::handle value) {
  throw py::type_error(text_of_type(type.type) + ": " + wrong_type(*type.element, value));
}

void set_place(const ListType& type, py::handle list, std::size_t place, py::handle value) {
  if (!set_member(*type.element, type.at(list, place), value)) throw_wrong_type(type, value);
}

/// The objects that refer to elements of a list from a place on, or to what is in them.
class LiveElements {
 public:
  LiveElements(const ListType& type, py::handle list, std::size_t first = 0)
      : first_(first),
        size_(type.element->size),
        live_(first < type.size(list) ? type.at(list, first) : nullptr, (type.size(list) - first) * size_) {}

  /// The elements are elsewhere now: place_of says of each place where its element is, and what has it.
  void move(const std::function<LiveObjects::Place(std::size_t place)>& place_of) const {
    live_.move([&](std::size_t offset) {
      const LiveObjects::Place element = place_of(first_ + offset / size_);
      return LiveObjects::Place{static_cast<char*>(element.data) + offset % size_, element.keeper};
    });
  }

 private:
  std::size_t first_, size_;
  LiveObjects live_;
};

void insert_new(const ListType& type, py::handle list, std::size_t place) {
  if (place == type.size(list) && type.has_room(list)) return type.insert(list, place);  // nothing moves
  const LiveElements live(type, list);
  type.insert(list, place);
  live.move([&](std::size_t i) { return LiveObjects::Place{type.at(list, i < place ? i : i + 1), {}}; });
}

/// Takes elements out. What refers to one keeps it.
void erase(const ListType& type, py::handle list, std::vector<std::size_t> places) {
  if (places.empty()) return;
  std::ranges::sort(places);
  const std::size_t first = places.front(), count = type.size(list) - first;
  const LiveElements live(type, list, first);
  const auto at = [&](std::size_t place) { return type.at(list, first + place); };
  const auto is_erased = [&](std::size_t element) { return std::ranges::binary_search(places, first + element); };
  // Of the elements from the first of them on: each one's place now, and the other way round.
  std::vector<std::size_t> place_of(count), element_at(count);
  std::iota(place_of.begin(), place_of.end(), std::size_t{0});
  std::iota(element_at.begin(), element_at.end(), std::size_t{0});
  std::size_t left = 0;
  for (std::size_t element = 0; element < count; ++element) {
    if (is_erased(element)) continue;
    const std::size_t other = element_at[left];
    type.element->swap(at(left), at(place_of[element]));
    std::swap(element_at[left], element_at[place_of[element]]);
    std::swap(place_of[element], place_of[other]);
    ++left;
  }
  std::map<std::size_t, py::capsule> kept;
  live.move([&](std::size_t place) -> LiveObjects::Place {
    const std::size_t element = place - first;
    if (!is_erased(element)) return {at(place_of[element]), {}};
    auto found = kept.find(element);
    if (found == kept.end()) {
      found = kept.emplace(element, py::capsule(type.element->make(), type.element->drop)).first;
      type.element->swap(found->second.get_pointer(), at(place_of[element]));
    }
    return {found->second.get_pointer(), found->second};
  });
  type.shorten(list, first + left);
}

void reverse(const ListType& type, py::handle list) {
  const LiveElements live(type, list);
  const std::size_t size = type.size(list);
  for (std::size_t i = 0; i < size / 2; ++i) type.element->swap(type.at(list, i), type.at(list, size - 1 - i));
  live.move([&](std::size_t i) { return LiveObjects::Place{type.at(list, size - 1 - i), {}}; });
}

/// Before `index`, as Python's lists do: any number goes.
void insert(const ListType& type, py::handle list, py::ssize_t index, py::handle value) {
  const auto size = static_cast<py::ssize_t>(type.size(list));
  if (index < 0) index = std::max<py::ssize_t>(0, index + size);
  const auto place = static_cast<std::size_t>(std::min(index, size));
  insert_new(type, list, place);
  try {
    if (!type.element->set(type.at(list, place), value)) throw_wrong_type(type, value);
  } catch (...) {
    erase(type, list, {place});
    throw;
  }
}

/// The places of a slice, in its order.
struct Places {
  Places(const ListType& type, py::handle list, const py::slice& slice) {
    if (!slice.compute(static_cast<py::ssize_t>(type.size(list)), &start, &stop, &step, &count))
      throw py::error_already_set();
  }
  std::size_t operator[](py::ssize_t i) const { return static_cast<std::size_t>(start + i * step); }

  py::ssize_t start = 0, stop = 0, step = 0, count = 0;
};

void erase_slice(const ListType& type, py::handle list, const py::slice& slice) {
  const Places places(type, list, slice);
  std::vector<std::size_t> all;
  for (py::ssize_t i = 0; i < places.count; ++i) all.push_back(places[i]);
  erase(type, list, std::move(all));
}

void set_slice(const ListType& type, py::handle list, const py::slice& slice, py::handle values) {
  const py::object items = type.type(values);  // copies: throws before anything is lost
  const Places places(type, list, slice);
  const auto count = static_cast<py::ssize_t>(type.size(items));
  if (places.step == 1) {
    erase_slice(type, list, slice);
    for (py::ssize_t i = 0; i < count; ++i) insert(type, list, places.start + i, items[py::int_(i)]);
    return;
  }
  if (count != places.count) {
    throw py::value_error("attempt to assign sequence of size " + std::to_string(count) +
                          " to extended slice of size " + std::to_string(places.count));
  }
  for (py::ssize_t i = 0; i < count; ++i) set_place(type, list, places[i], items[py::int_(i)]);
}

}  // namespace

void extend_list(const ListType& type, py::handle list, const py::iterable& items) {
  for (const py::handle item : items) {
    insert(type, list, static_cast<py::ssize_t>(type.size(list)), item);
  }
}

void bind_list_methods(const ListType& list_type) {
  const ListType* type = &list_type;
  const auto bind = [type](const char* name, auto function) {
    py::setattr(type->type, name, py::cpp_function(function, py::name(name), py::is_method(type->type)));
  };
  const py::object sequence = py::module_::import("collections.abc").attr("MutableSequence");
  for (const char* name :
       {"append", "count", "index", "pop", "remove", "__contains__", "__iadd__", "__iter__", "__reversed__"}) {
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
      set_slice(*type, self, key, value);
    } else {
      set_place(*type, self, place_of(*type, self, key), value);
    }
  });
  bind("__delitem__", [type](const py::object& self, const py::object& key) {
    if (py::isinstance<py::slice>(key)) {
      erase_slice(*type, self, key);
    } else {
      erase(*type, self, {place_of(*type, self, key)});
    }
  });
  bind("insert", [type](const py::object& self, py::ssize_t index, const py::object& value) {
    insert(*type, self, index, value);
  });
  bind("extend", [type](const py::object& self, const py::iterable& items) {
    extend_list(*type, self, type->type(items));  // copies: the items may be this list
  });
  bind("clear", [type](const py::object& self) { erase_slice(*type, self, py::slice(0, PY_SSIZE_T_MAX, 1)); });
  bind("reverse", [type](const py::object& self) { reverse(*type, self); });
  bind("__repr__", [](const py::object& self) { return py::repr(py::list(self)); });
  bind("__eq__", [](const py::object& self, const py::object& other) {
    return py::isinstance<py::sequence>(other) && py::list(self).equal(py::list(other));
  });
  bind("__reduce__",
       [](const py::object& self) { return py::make_tuple(py::type::of(self), py::make_tuple(py::list(self))); });
}

}  // namespace pinball::python
