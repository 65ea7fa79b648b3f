#include "data_class.hpp"

namespace pinball::python {

std::string text_of_fields(const py::object& object, const py::object& other, const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) {
    const py::object value = object.attr(name.c_str());
    if (value.equal(other.attr(name.c_str()))) continue;
    text += (text.empty() ? "" : ", ") + name + "=" + std::string(py::repr(value));
  }
  return std::string(py::str(py::type::of(object).attr("__name__"))) + "(" + text + ")";
}

bool same_fields(const py::object& one, const py::object& other, const std::vector<std::string>& names) {
  if (!py::type::of(one).is(py::type::of(other))) return false;
  for (const std::string& name : names) {
    if (!one.attr(name.c_str()).equal(other.attr(name.c_str()))) return false;
  }
  return true;
}

}  // namespace pinball::python
