#pragma once

#include <pybind11/pybind11.h>

#include <string>

namespace pinball::python {

/// What Python sees of a field that is a list of numbers or texts, or of lists of them: the same list, which refuses to
/// be changed in place. It is a copy, and what would be changed in it would be lost without a word. field:
/// "Body.velocity", for the message. Anything but a list is returned as it is.
pybind11::object shown_list(pybind11::object value, const std::string& field);

}  // namespace pinball::python
