#include <pybind11/functional.h>
#include <pybind11/stl.h>

#include <solver/scene_rules.hpp>

#include "bindings.hpp"
#include "numpy_arrays.hpp"

namespace pinball::python {

namespace {

/// Keeps NumPy arrays for as long as a scene may be read, from whatever thread lets go of it last.
std::shared_ptr<const void> keep(py::array coordinates, py::array hexahedra) {
  auto* arrays = new std::pair(std::move(coordinates), std::move(hexahedra));
  return {static_cast<const void*>(arrays), [arrays](const void*) {
            const py::gil_scoped_acquire lock;
            delete arrays;
          }};
}

void bind_settings(py::module_& module) {
  bind_choice<Precision>(module, "Precision", {{"float", Precision::float32}, {"double", Precision::float64}});
  bind_choice<HourglassControl>(module, "HourglassControl",
                                {{"none", HourglassControl::none},
                                 {"viscous", HourglassControl::viscous},
                                 {"stiffness", HourglassControl::stiffness},
                                 {"assumed_strain", HourglassControl::assumed_strain}});
  bind_choice<ContactMethod>(
      module, "ContactMethod",
      {{"none", ContactMethod::none}, {"pinball", ContactMethod::pinball}, {"slideline", ContactMethod::slideline}});
  bind_choice<Enforcement>(module, "Enforcement",
                           {{"penalty", Enforcement::penalty},
                            {"projection", Enforcement::projection},
                            {"lagrange", Enforcement::lagrange}});
  bind_choice<ContactGap>(
      module, "ContactGap",
      {{"pinball", ContactGap::pinball}, {"face", ContactGap::face}, {"not_set", ContactGap::not_set}});
  bind_choice<ContactRadius>(module, "ContactRadius",
                             {{"initial", ContactRadius::initial}, {"current", ContactRadius::current}});
  bind_choice<ContactSearch>(
      module, "ContactSearch",
      {{"automatic", ContactSearch::automatic}, {"tree", ContactSearch::tree}, {"hash", ContactSearch::hash}});
  bind_choice<NegativeVolume>(module, "NegativeVolume",
                              {{"stop", NegativeVolume::stop}, {"erode", NegativeVolume::erode}});
  bind_data<TimeSettings>(module, "TimeSettings", "[time] of a scene")
      .def_readwrite("end", &TimeSettings::end)
      .def_readwrite("cfl", &TimeSettings::cfl)
      .def_readwrite("steps", &TimeSettings::steps)
      .def_readwrite("subcycling", &TimeSettings::subcycling);
  bind_data<ElementSettings>(module, "ElementSettings", "[element] of a scene")
      .def_readwrite("hourglass", &ElementSettings::hourglass)
      .def_readwrite("hourglass_coefficient", &ElementSettings::hourglass_coefficient)
      .def_readwrite("bulk_viscosity", &ElementSettings::bulk_viscosity)
      .def_readwrite("linear_viscosity", &ElementSettings::linear_viscosity)
      .def_readwrite("quadratic_viscosity", &ElementSettings::quadratic_viscosity)
      .def_readwrite("negative_volume", &ElementSettings::negative_volume);
  bind_data<ContactSettings>(module, "ContactSettings", "[contact] of a scene")
      .def_readwrite("method", &ContactSettings::method)
      .def_readwrite("enforcement", &ContactSettings::enforcement)
      .def_readwrite("gap", &ContactSettings::gap)
      .def_readwrite("beta", &ContactSettings::beta)
      .def_readwrite("damping", &ContactSettings::damping)
      .def_readwrite("friction", &ContactSettings::friction)
      .def_readwrite("static_friction", &ContactSettings::static_friction)
      .def_readwrite("radius", &ContactSettings::radius)
      .def_readwrite("radius_factor", &ContactSettings::radius_factor)
      .def_readwrite("self", &ContactSettings::self)
      .def_readwrite("search", &ContactSettings::search)
      .def_readwrite("skin", &ContactSettings::skin);
  bind_data<SkipSettings>(module, "SkipSettings", "[skip] of a scene")
      .def_readwrite("contact_search", &SkipSettings::contact_search)
      .def_readwrite("resting", &SkipSettings::resting);
  bind_data<GuardSettings>(module, "GuardSettings", "[guard] of a scene")
      .def_readwrite("energy_error", &GuardSettings::energy_error)
      .def_readwrite("time_step_collapse", &GuardSettings::time_step_collapse);
}

void bind_meshes(py::module_& module) {
  py::class_<ArrayMesh>(module, "ArrayMesh", "The mesh of a body in NumPy arrays, read when the simulation is made.")
      .def(py::init([](const py::array& coordinates, const py::array& hexahedra, std::int64_t first_index) {
             return ArrayMesh{view_of<const void>(coordinates, "coordinates"),
                              view_of<const void>(hexahedra, "hexahedra"), first_index, keep(coordinates, hexahedra)};
           }),
           py::arg("coordinates"), py::arg("hexahedra"), py::arg("first_index") = 0,
           "coordinates: nodes x 3 [length]; hexahedra: elements x 8, places in coordinates, the first node being "
           "first_index.");
  bind_data<BlockMesh>(module, "BlockMesh", "A regular block with a corner at the origin.")
      .def_readwrite("size", &BlockMesh::size)
      .def_readwrite("elements", &BlockMesh::elements);
  // The other meshes have what files name them by: from TOML.
  py::class_<RoundNosedRodMesh>(module, "RoundNosedRodMesh");
  py::class_<CylinderMesh>(module, "CylinderMesh");
  py::class_<SphereMesh>(module, "SphereMesh");
  py::class_<GmshMesh>(module, "GmshMesh");
}

}  // namespace

void bind_scene(py::module_& module) {
  bind_settings(module);
  bind_meshes(module);
  bind_data<Material>(module, "Material", "[[material]] of a scene, with bulk and shear modulus.")
      .def_readwrite("name", &Material::name)
      .def_readwrite("plastic", &Material::plastic)
      .def_readwrite("density", &Material::density)
      .def_readwrite("bulk_modulus", &Material::bulk_modulus)
      .def_readwrite("shear_modulus", &Material::shear_modulus)
      .def_readwrite("yield_stress", &Material::yield_stress)
      .def_readwrite("plastic_modulus", &Material::plastic_modulus)
      .def_readwrite("ultimate_stress", &Material::ultimate_stress)
      .def_readwrite("erosion_strain", &Material::erosion_strain);
  bind_data<Body>(module, "Body", "[[body]] of a scene")
      .def_readwrite("name", &Body::name)
      .def_readwrite("material", &Body::material)
      .def_readwrite("mesh", &Body::mesh)
      .def_readwrite("position", &Body::position)
      .def_readwrite("axis", &Body::axis)
      .def_readwrite("velocity", &Body::velocity)
      .def_readwrite("angular_velocity", &Body::angular_velocity)
      .def_readwrite("velocity_gradient", &Body::velocity_gradient)
      .def_readwrite("velocity_noise", &Body::velocity_noise);
  bind_list<Material>(module, "Materials");
  bind_list<Body>(module, "Bodies");
  bind_boundary(module);
  bind_data<Scene>(module, "Scene", "What is to be run: the fields are those of a scene file.")
      .def_readwrite("name", &Scene::name)
      .def_readwrite("title", &Scene::title)
      .def_readwrite("units", &Scene::units)
      .def_readwrite("precision", &Scene::precision)
      .def_readwrite("time", &Scene::time)
      .def_readwrite("element", &Scene::element)
      .def_readwrite("contact", &Scene::contact)
      .def_readwrite("skip", &Scene::skip)
      .def_readwrite("guard", &Scene::guard)
      .def_readwrite("materials", &Scene::materials)
      .def_readwrite("bodies", &Scene::bodies)
      .def_property(
          "damping", [](const Scene& s) { return s.damping.mass; },
          [](Scene& s, double mass) { s.damping.mass = mass; }, "damping.mass [1/time]")
      .def_readwrite("symmetry_planes", &Scene::constraints)
      .def_readwrite("fixed", &Scene::fixed_constraints)
      .def_readwrite("rigid_walls", &Scene::rigid_walls)
      .def_readwrite("prescribed_velocities", &Scene::prescribed_velocities)
      .def_readwrite("loads", &Scene::loads)
      .def_readwrite("initial_velocities", &Scene::initial_velocities);
  module.def(
      "read_scene",
      [](const std::string& scene, const std::vector<std::string>& set, int refine) {
        SceneOverrides overrides;
        overrides.set = set;
        overrides.refine = refine;
        return read_scene(find_scene(scene), overrides);
      },
      py::arg("scene"), py::arg("set") = std::vector<std::string>{}, py::arg("refine") = 1,
      "Reads a scene file, or a scene of data/scenes by name; set: \"KEY=VALUE\" as on the command line.");
}

}  // namespace pinball::python
