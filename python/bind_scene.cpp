#include <solver/scene_rules.hpp>

#include "bindings.hpp"

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
      .def_readwrite("refine", &SceneOverrides::refine)
      .def_readwrite("precision", &SceneOverrides::precision)
      .def_readwrite("vary", &SceneOverrides::vary);
  bind_data<SceneSource>(module, "SceneSource", "What a scene was read from.")
      .def_readwrite("path", &SceneSource::path)
      .def_readwrite("text", &SceneSource::text)
      .def_readwrite("overrides", &SceneSource::overrides)
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
      .def_readwrite("bodies", &ContactSide::bodies)
      .def_readwrite("elements", &ContactSide::elements)
      .def_readwrite("faces", &ContactSide::faces)
      .def_readwrite("nodes", &ContactSide::nodes);
  bind_data<ContactPair>(module, "ContactPair", "[[contact.pair]] of a scene")
      .def_readwrite("name", &ContactPair::name)
      .def_readwrite("first", &ContactPair::first)
      .def_readwrite("second", &ContactPair::second, "empty: the members of the first among each other")
      .def_readwrite("friction", &ContactPair::friction, "[-]; negative: that of the scene")
      .def_readwrite("static_friction", &ContactPair::static_friction, "[-]; negative: as friction")
      .def_readwrite("friction_decay", &ContactPair::friction_decay, "[time/length]; negative: none")
      .def_readwrite("start", &ContactPair::start, "[time]")
      .def_readwrite("end", &ContactPair::end, "[time]")
      .def_readwrite("where", &ContactPair::where, "for messages");
  bind_data<TiedContact>(module, "TiedContact", "[[contact.tied]] of a scene")
      .def_readwrite("name", &TiedContact::name)
      .def_readwrite("first", &TiedContact::first, "whose nodes follow")
      .def_readwrite("second", &TiedContact::second, "whose faces they follow")
      .def_readwrite("tolerance", &TiedContact::tolerance, "[length]; negative: 0.05 of a face's shorter diagonal")
      .def_readwrite("start", &TiedContact::start, "[time]")
      .def_readwrite("end", &TiedContact::end, "[time]")
      .def_readwrite("where", &TiedContact::where, "for messages");
  bind_list<ContactPair>(module, "ContactPairs");
  bind_list<TiedContact>(module, "TiedContacts");
}

void bind_parts(py::module_& module) {
  bind_data<YieldCurve>(module, "YieldCurve", "Yield stress over plastic strain, at a strain rate.")
      .def_readwrite("rate", &YieldCurve::rate, "[1/time]")
      .def_readwrite("plastic_strain", &YieldCurve::plastic_strain, "from 0, ascending")
      .def_readwrite("stress", &YieldCurve::stress, "[stress]");
  bind_list<YieldCurve>(module, "YieldCurves");
  bind_data<Material>(module, "Material", "[[material]] of a scene, with bulk and shear modulus.")
      .def_readwrite("name", &Material::name)
      .def_readwrite("plastic", &Material::plastic)
      .def_readwrite("density", &Material::density, "[mass/length^3]")
      .def_readwrite("bulk_modulus", &Material::bulk_modulus, "[stress]")
      .def_readwrite("shear_modulus", &Material::shear_modulus, "[stress]")
      .def_readwrite("yield_stress", &Material::yield_stress, "[stress]")
      .def_readwrite("plastic_modulus", &Material::plastic_modulus, "of hardening [stress]")
      .def_readwrite("ultimate_stress", &Material::ultimate_stress, "where hardening ends [stress]")
      .def_readwrite("erosion_strain", &Material::erosion_strain, "[-]; 0: never")
      .def_readwrite("isotropic_share", &Material::isotropic_share, "of hardening; the rest is kinematic [-]")
      .def_readwrite("yield_curves", &Material::yield_curves, "in the place of yield_stress, of ascending rates")
      .def_readwrite("rate_interpolation", &Material::rate_interpolation, "between yield curves")
      .def_readwrite("strain_rate", &Material::strain_rate, "of which the yield stress depends")
      .def_readwrite("rate_constant", &Material::rate_constant, "C of Cowper and Symonds; 0: no such law [1/time]")
      .def_readwrite("rate_exponent", &Material::rate_exponent, "p of that law [-]")
      .def_readwrite("rate_stress", &Material::rate_stress, "what the law multiplies; 0: the yield stress [stress]");
  bind_data<Body>(module, "Body", "[[body]] of a scene")
      .def_readwrite("name", &Body::name)
      .def_readwrite("material", &Body::material, "name of a Material")
      .def_readwrite("mesh", &Body::mesh)
      .def_readwrite("position", &Body::position, "translation of the mesh, after the rotation [length]")
      .def_readwrite("axis", &Body::axis, "onto which z of the mesh is turned; None: no rotation")
      .def_readwrite("velocity", &Body::velocity, "[length/time]")
      .def_readwrite("angular_velocity", &Body::angular_velocity, "about the centroid [1/time]")
      .def_readwrite("velocity_gradient", &Body::velocity_gradient, "3 x 3, about the centroid [1/time]")
      .def_readwrite("velocity_noise", &Body::velocity_noise, "amplitude [length/time]")
      .def_readwrite("element", &Body::element, "in place of the scene's; None: as there");
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
  bind_data<SourcedScene>(module, "Scene", "What is to be run: the fields are those of a scene file.")
      .def_readwrite("name", &Scene::name)
      .def_readwrite("path", &Scene::path, "the file it was read from")
      .def_readwrite("title", &Scene::title)
      .def_readwrite("units", &Scene::units, "named in any order, never converted")
      .def_readwrite("precision", &Scene::precision)
      .def_readwrite("device", &Scene::device, "where steps are made: of no file")
      .def_readwrite("refine", &Scene::refine, "already in the numbers of elements")
      .def_readwrite("of_deck", &Scene::of_deck, "of a deck that says nothing of contact")
      .def_readwrite("time", &Scene::time)
      .def_readwrite("element", &Scene::element)
      .def_readwrite("contact", &Scene::contact)
      .def_readwrite("contact_pairs", &Scene::contact_pairs)
      .def_readwrite("tied_contacts", &Scene::tied_contacts)
      .def_readwrite("skip", &Scene::skip)
      .def_readwrite("guard", &Scene::guard)
      .def_readwrite("materials", &Scene::materials)
      .def_readwrite("bodies", &Scene::bodies)
      .def_inner("damping", &Scene::damping, &DampingSettings::mass, "damping.mass [1/time]")
      .def_readwrite("symmetry_planes", &Scene::constraints)
      .def_readwrite("fixed", &Scene::fixed_constraints)
      .def_readwrite("rigid_walls", &Scene::rigid_walls)
      .def_readwrite("prescribed_velocities", &Scene::prescribed_velocities)
      .def_readwrite("loads", &Scene::loads)
      .def_readwrite("pressures", &Scene::pressures)
      .def_readwrite("gravities", &Scene::gravities)
      .def_readwrite("initial_velocities", &Scene::initial_velocities)
      .def_readwrite("probes", &Scene::probes)
      .def_readwrite("output", &Scene::output)
      .def_readwrite("source", &SourcedScene::source, "of a scene that was read, None of one that was made");
  module.def("read_scene", &read, py::arg("scene"), py::arg("set") = std::vector<std::string>{}, py::arg("refine") = 1,
             "Reads a scene file, or a scene of data/scenes by name; set: \"KEY=VALUE\" as on the command line.");
}

}  // namespace pinball::python
