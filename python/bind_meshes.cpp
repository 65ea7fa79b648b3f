#include <solver/base/counted.hpp>

#include "bind_keys.hpp"
#include "interpreter_lock.hpp"
#include "numpy_arrays.hpp"

namespace pinball::python {

namespace {

/// Keeps NumPy arrays for as long as a scene may be read, from whatever thread lets go of it last.
std::shared_ptr<const void> keep(py::array coordinates, py::array hexahedra) {
  auto* arrays = new std::pair(std::move(coordinates), std::move(hexahedra));
  return {static_cast<const void*>(arrays), [arrays](const void*) {
            const TakenLock lock;
            delete arrays;
          }};
}

ArrayMesh make_array_mesh(const py::array& coordinates, const py::array& hexahedra, std::int64_t first_index) {
  return {view_of<const void>(coordinates, "coordinates"), view_of<const void>(hexahedra, "hexahedra"), first_index,
          keep(coordinates, hexahedra)};
}

/// What the mesh reads, to be read only. It keeps the arrays of the mesh.
py::array shown(const ConstArrayView& view, const std::shared_ptr<const void>& owner) {
  const py::capsule keeper(new std::shared_ptr<const void>(owner),
                           [](void* kept) { delete static_cast<std::shared_ptr<const void>*>(kept); });
  return python::shown(view, keeper);
}
py::array coordinates_of(const ArrayMesh& mesh) { return shown(mesh.coordinates, mesh.owner); }
py::array hexahedra_of(const ArrayMesh& mesh) { return shown(mesh.hexahedra, mesh.owner); }

bool same(const ArrayMesh& one, const ArrayMesh& other) {
  const py::object equal = py::module_::import("numpy").attr("array_equal");
  return one.first_index == other.first_index && equal(coordinates_of(one), coordinates_of(other)).cast<bool>() &&
         equal(hexahedra_of(one), hexahedra_of(other)).cast<bool>();
}

void bind_array_mesh(py::module_& module) {
  py::class_<ArrayMesh>(module, "ArrayMesh", "The mesh of a body in NumPy arrays, read when the simulation is made.")
      .def(py::init(&make_array_mesh), py::arg("coordinates"), py::arg("hexahedra"), py::arg("first_index") = 0,
           "coordinates: (nodes, 3), float32 or float64 [length]; hexahedra: (elements, 8), int32 or int64, places in "
           "coordinates, the first node being first_index.")
      .def_property_readonly("coordinates", &coordinates_of, "(nodes, 3) [length]")
      .def_property_readonly("hexahedra", &hexahedra_of, "(elements, 8)")
      .def_readonly("first_index", &ArrayMesh::first_index, "what hexahedra calls the first node")
      .def("__eq__",
           [](const ArrayMesh& one, const py::object& other) {
             return py::isinstance<ArrayMesh>(other) && same(one, other.cast<const ArrayMesh&>());
           })
      .def("__repr__",
           [](const ArrayMesh& mesh) {
             return "ArrayMesh(" + counted(mesh.coordinates.count, "node") + ", " +
                    counted(mesh.hexahedra.count, "element") + ")";
           })
      .def(py::pickle(
          [](const ArrayMesh& mesh) {
            return py::make_tuple(coordinates_of(mesh), hexahedra_of(mesh), mesh.first_index);
          },
          [](const py::tuple& state) {
            return make_array_mesh(state[0].cast<py::array>(), state[1].cast<py::array>(),
                                   state[2].cast<std::int64_t>());
          }));
}

}  // namespace

void bind_meshes(py::module_& module) {
  bind_choice<Section>(module, "Section");
  bind_data<BlockSection>(module, "BlockSection", "Layers of elements of one thickness across a block.")
      .def_readwrite("length", &BlockSection::length, "[length]")
      .def_readwrite("elements", &BlockSection::elements, "layers");
  bind_table<BlockMesh>(module, "BlockMesh", "A regular block with a corner at the origin.");
  bind_table<RoundNosedRodMesh>(module, "RoundNosedRodMesh", "A rod along -z with a hemispherical nose at the origin.");
  bind_table<CylinderMesh>(module, "CylinderMesh", "A cylinder along z from 0 to length, or a part of it.");
  bind_table<SphereMesh>(module, "SphereMesh", "A sphere around the origin, or a part of it.");
  bind_choice<MeshFormat>(module, "MeshFormat");
  bind_table<FileMesh>(module, "FileMesh", "A mesh from a file.");
  bind_array_mesh(module);
}

}  // namespace pinball::python
