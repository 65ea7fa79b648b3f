#include "bindings.hpp"
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
      .def_readonly("first_index", &ArrayMesh::first_index)
      .def("__eq__",
           [](const ArrayMesh& one, const py::object& other) {
             return py::isinstance<ArrayMesh>(other) && same(one, other.cast<const ArrayMesh&>());
           })
      .def("__repr__",
           [](const ArrayMesh& mesh) {
             return "ArrayMesh(" + std::to_string(mesh.coordinates.count) + " nodes, " +
                    std::to_string(mesh.hexahedra.count) + " elements)";
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
  bind_choice<Section>(
      module, "Section",
      {{"full", Section::full}, {"half", Section::half}, {"quarter", Section::quarter}, {"wedge", Section::wedge}});
  bind_data<BlockSection>(module, "BlockSection", "Layers of elements of one thickness across a block.")
      .def_readwrite("length", &BlockSection::length, "[length]")
      .def_readwrite("elements", &BlockSection::elements);
  bind_data<BlockMesh>(module, "BlockMesh", "A regular block with a corner at the origin.")
      .def_readwrite("size", &BlockMesh::size, "[length]")
      .def_readwrite("elements", &BlockMesh::elements)
      .def_readwrite("sections", &BlockMesh::sections, "per direction; empty: elements of one size");
  bind_data<RoundNosedRodMesh>(module, "RoundNosedRodMesh", "A rod along -z with a hemispherical nose at the origin.")
      .def_readwrite("length", &RoundNosedRodMesh::length, "[length]")
      .def_readwrite("radius", &RoundNosedRodMesh::radius, "[length]")
      .def_readwrite("half", &RoundNosedRodMesh::half, "only y >= 0")
      .def_readwrite("core", &RoundNosedRodMesh::core, "elements along x and y (of the half section)")
      .def_readwrite("ring", &RoundNosedRodMesh::ring, "layers of elements around the core")
      .def_readwrite("layers", &RoundNosedRodMesh::layers, "layers of elements along the axis");
  bind_data<CylinderMesh>(module, "CylinderMesh", "A cylinder along z from 0 to length, or a part of it.")
      .def_readwrite("radius", &CylinderMesh::radius, "[length]")
      .def_readwrite("length", &CylinderMesh::length, "[length]")
      .def_readwrite("section", &CylinderMesh::section)
      .def_readwrite("angle", &CylinderMesh::angle, "of the wedge [degree]")
      .def_readwrite("core", &CylinderMesh::core, "elements along each side of the full core")
      .def_readwrite("ring", &CylinderMesh::ring, "layers of elements around the core")
      .def_readwrite("radial", &CylinderMesh::radial, "elements of the wedge along the radius")
      .def_readwrite("layers", &CylinderMesh::layers, "layers of elements along the axis");
  bind_data<SphereMesh>(module, "SphereMesh", "A sphere around the origin, or a part of it.")
      .def_readwrite("radius", &SphereMesh::radius, "[length]")
      .def_readwrite("section", &SphereMesh::section)
      .def_readwrite("angle", &SphereMesh::angle, "of the wedge [degree]")
      .def_readwrite("core", &SphereMesh::core, "elements along the sides of the core")
      .def_readwrite("ring", &SphereMesh::ring, "layers of elements around the core")
      .def_readwrite("grading", &SphereMesh::grading,
                     "elements at the pole z = -radius are smaller by this factor [-]");
  bind_choice<MeshFormat>(module, "MeshFormat",
                          {{"gmsh", MeshFormat::gmsh},
                           {"keyword", MeshFormat::keyword},
                           {"exodus", MeshFormat::exodus},
                           {"vtk", MeshFormat::vtk},
                           {"abaqus", MeshFormat::abaqus}});
  bind_data<FileMesh>(module, "FileMesh", "A mesh from a file.")
      .def_readwrite("format", &FileMesh::format)
      .def_readwrite("file", &FileMesh::file)
      .def_readwrite("part", &FileMesh::part, "part or set of elements, Gmsh's physical volume; empty: all")
      .def_readwrite("chosen_case", &FileMesh::chosen_case, "of a deck; None: what belongs to no case")
      .def_readwrite("scale", &FileMesh::scale, "multiplies the coordinates [-]")
      .def_readwrite("array", &FileMesh::array,
                     "of vtk: integers of the cells that number the parts; empty: by its name");
  bind_array_mesh(module);
}

}  // namespace pinball::python
