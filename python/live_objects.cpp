#include "live_objects.hpp"

#include <algorithm>

namespace pinball::python {

LiveObjects::LiveObjects(const void* begin, std::size_t bytes) : begin_(static_cast<const char*>(begin)) {
  const auto& all = py::detail::get_internals().registered_instances;
  if (all.size() < bytes) {
    for (const auto& [place, instance] : all) {
      const std::less<> less;
      const char* const at = static_cast<const char*>(place);
      if (!less(at, begin_) && less(at, begin_ + bytes)) add(instance, at, bytes);
    }
  } else {
    for (const char* at = begin_; at != begin_ + bytes; ++at) {
      const auto [first, last] = all.equal_range(at);
      for (auto found = first; found != last; ++found) add(found->second, at, bytes);
    }
  }
}

void LiveObjects::add(py::detail::instance* instance, const char* at, std::size_t bytes) {
  if (instance->owned) return;
  for (const py::detail::value_and_holder& value : py::detail::values_and_holders(instance)) {
    // What begins at the same place and is larger has the data in it.
    if (value.value_ptr() != at || value.type->type_size > bytes) continue;
    objects_.push_back({instance, value.type, static_cast<std::size_t>(at - begin_)});
  }
}

bool LiveObjects::have(py::handle object) const {
  return std::ranges::any_of(
      objects_, [&](const Object& one) { return reinterpret_cast<PyObject*>(one.instance) == object.ptr(); });
}

void LiveObjects::move(const std::function<Place(std::size_t offset)>& place_of) const {
  for (const Object& object : objects_) {
    const Place place = place_of(object.offset);
    void*& data = object.instance->get_value_and_holder(object.type).value_ptr();
    py::detail::deregister_instance(object.instance, data, object.type);
    data = place.data;
    py::detail::register_instance(object.instance, data, object.type);
    if (place.keeper) py::detail::keep_alive_impl(reinterpret_cast<PyObject*>(object.instance), place.keeper);
  }
}

}  // namespace pinball::python
