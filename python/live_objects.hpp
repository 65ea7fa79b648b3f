#pragma once

#include <pybind11/pybind11.h>

#include <cstddef>
#include <functional>
#include <vector>

namespace pinball::python {

namespace py = pybind11;

/// The Python objects that refer to plain data in a range of memory, without keeping them. Where the data move, the
/// objects have to be told; otherwise they would refer to whatever comes to be there.
class LiveObjects {
 public:
  LiveObjects(const void* begin, std::size_t bytes);
  bool empty() const { return objects_.empty(); }
  /// Whether it is one of them.
  bool have(py::handle object) const;

  /// Where data are that were in the range, and what has them; no keeper: what had them before.
  struct Place {
    void* data;
    py::handle keeper;
  };
  /// The data moved. place_of: of each offset from where the range began. The objects keep the keepers alive.
  void move(const std::function<Place(std::size_t offset)>& place_of) const;

 private:
  struct Object {
    py::detail::instance* instance;
    const py::detail::type_info* type;
    std::size_t offset;
  };

  void add(py::detail::instance* instance, const char* at, std::size_t bytes);

  const char* begin_;
  std::vector<Object> objects_;
};

}  // namespace pinball::python
