#include <solver/scene_rules.hpp>

#include "bind_keys.hpp"

namespace pinball::python {

namespace {

SourcedScene read(const std::string& scene, const std::vector<std::string>& set, int refine) {
  SceneOverrides overrides;
  overrides.set = set;
  overrides.refine = refine;
  SceneSource source = read_scene_source(find_scene(scene), overrides);
  SourcedScene made{read_scene(source), {}};
  made.source = std::move(source);
  return made;
}

void bind_sources(py::module_& module) {
  bind_data<SceneOverrides>(module, "SceneOverrides", "What the command line adds to a scene file.")
      .def_readwrite("set", &SceneOverrides::set, "\"KEY=VALUE\", in order")
      .def_readwrite("refine", &SceneOverrides::refine, "times as many elements along each direction")
      .def_readwrite("precision", &SceneOverrides::precision, "in place of the scene's; None: that")
      .def_readwrite("vary", &SceneOverrides::vary, "as set, and after it");
  bind_data<SceneSource>(module, "SceneSource", "What a scene was read from.")
      .def_readwrite("path", &SceneSource::path, "of the file")
      .def_readwrite("text", &SceneSource::text, "of the file when it was read")
      .def_readwrite("overrides", &SceneSource::overrides, "what was added to it")
      .def(
          "__repr__", [](const SceneSource& source) { return "SceneSource(path='" + source.path + "')"; },
          py::prepend());
}

void bind_contact_parts(py::module_& module) {
  bind_data<MeshSetName>(module, "MeshSetName", "A set of a mesh file.")
      .def_readwrite("set", &MeshSetName::set, "its name or number")
      .def_readwrite("file", &MeshSetName::file, "the mesh file that has it; empty: the only one");
  bind_list<MeshSetName>(module, "MeshSetNames");
  bind_data<ContactSide>(module, "ContactSide", "Bodies and sets on one side of a contact.")
      .def_readwrite("bodies", &ContactSide::bodies, "names")
      .def_readwrite("elements", &ContactSide::elements, "sets of elements")
      .def_readwrite("faces", &ContactSide::faces, "sets of faces")
      .def_readwrite("nodes", &ContactSide::nodes, "sets of nodes");
  bind_table<ContactPair>(module, "ContactPair", "[[contact.pair]] of a scene");
  bind_table<TiedContact>(module, "TiedContact", "[[contact.tied]] of a scene");
  bind_list<ContactPair>(module, "ContactPairs");
  bind_list<TiedContact>(module, "TiedContacts");
}

void bind_parts(py::module_& module) {
  bind_table<YieldCurve>(module, "YieldCurve", "Yield stress over plastic strain, at a strain rate.");
  bind_list<YieldCurve>(module, "YieldCurves");
  bind_table<PowerHardeningSettings>(module, "PowerHardening", "Yield stress as a power of the plastic strain.");
  bind_table<JohnsonCookSettings>(module, "JohnsonCook", "Strength and failure after Johnson and Cook.");
  bind_table<JohnsonHolmquistSettings>(module, "JohnsonHolmquist", "Brittle material after Johnson and Holmquist.");
  bind_table<DruckerPragerSettings>(module, "DruckerPrager", "Strength that grows with the pressure.");
  bind_table<CrushableFoamSettings>(module, "CrushableFoam", "Foam whose principal stresses yield each by itself.");
  bind_table<MooneyRivlinSettings>(module, "MooneyRivlin", "Rubber after Mooney and Rivlin.");
  bind_table<OgdenSettings>(module, "Ogden", "Rubber and foam after Ogden.");
  bind_table<OrthotropicSettings>(module, "Orthotropic", "Elastic moduli that differ with the direction.");
  bind_table<FluidSettings>(module, "Fluid", "No strength, and the viscosity of Newton.");
  bind_table<EquationOfStateSettings>(module, "EquationOfState", "Pressure over compression and energy.");
  bind_table<ErosionSettings>(module, "Erosion", "Limits beyond which elements are eroded.");
  bind_table<Material>(module, "Material", "[[material]] of a scene, with bulk and shear modulus.");
  bind_table<Body>(module, "Body", "[[body]] of a scene");
  bind_list<Material>(module, "Materials");
  bind_list<Body>(module, "Bodies");
}

}  // namespace

void bind_scene(py::module_& module) {
  bind_settings(module);
  bind_meshes(module);
  bind_parts(module);
  bind_contact_parts(module);
  bind_boundary(module);
  bind_sources(module);
  auto scene = bind_data<SourcedScene>(module, "Scene", "What is to be run: the fields are those of a scene file.");
  describe(schema::Of<Scene>{}, KeyBinder<SourcedScene, Scene>(scene));
  scene.def_readwrite("source", &SourcedScene::source, "of a scene that was read, None of one that was made");
  module.def("read_scene", &read, py::arg("scene"), py::arg("set") = std::vector<std::string>{}, py::arg("refine") = 1,
             "Reads a scene file, or a scene of data/scenes by name; set: \"KEY=VALUE\" as on the command line.");
}

}  // namespace pinball::python
