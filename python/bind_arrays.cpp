#include "numpy_arrays.hpp"
#include "simulation_object.hpp"

namespace pinball::python {

namespace {

using Self = py::object;  // the Python object of a simulation: arrays keep it

SimulationObject& object_of(const Self& self) { return self.cast<SimulationObject&>(); }
Simulation& of(const Self& self) { return object_of(self).use(); }

template <class Index>
py::array indices(std::span<const Index> numbers, const Self& self) {
  return shown(view_records(numbers.data(), static_cast<std::int64_t>(numbers.size()), 1), self);
}

/// A copy in the order of the scene, into an array of the caller's or a new one.
template <class Field>
py::array copied(const Simulation& simulation, Field field, std::int64_t count, std::int64_t components,
                 const std::optional<py::array>& out) {
  std::vector<py::ssize_t> shape{count};
  if (components > 1) shape.push_back(components);
  py::array to = out ? *out : py::array(py::dtype::of<double>(), shape);
  simulation.copy(field, view_of<void>(to, "out"));
  return to;
}

void bind_copies(py::class_<SimulationObject>& simulation) {
  const auto node_copy = [&](const char* name, NodeField field, std::int64_t components, const char* text) {
    simulation.def(
        name,
        [field, components](SimulationObject& s, const std::optional<py::array>& out) {
          return copied(s.use(), field, s.use().nodes(), components, out);
        },
        py::arg("out") = py::none(), text);
  };
  const auto element_copy = [&](const char* name, ElementField field, std::int64_t components, const char* text) {
    simulation.def(
        name,
        [field, components](SimulationObject& s, const std::optional<py::array>& out) {
          return copied(s.use(), field, s.use().elements(), components, out);
        },
        py::arg("out") = py::none(), text);
  };
  node_copy("position", NodeField::position, 3,
            "Copy of the positions, (nodes, 3) in the order of the scene [length].");
  node_copy("velocity", NodeField::velocity, 3,
            "Copy of the velocities, (nodes, 3) in the order of the scene [length/time].");
  node_copy("mass", NodeField::mass, 1, "Copy of the masses, (nodes,) in the order of the scene [mass].");
  node_copy("initial_position", NodeField::initial_position, 3,
            "Copy of where the nodes began, (nodes, 3) in the order of the scene [length].");
  element_copy("stress", ElementField::stress, 6,
               "Copy of the stresses, (elements, 6): xx yy zz xy yz zx, in the order of the scene [stress].");
  element_copy("plastic_strain", ElementField::plastic_strain, 1,
               "Copy of the effective plastic strains, (elements,) in the order of the scene [-].");
  element_copy("element_mass", ElementField::mass, 1,
               "Copy of the masses, (elements,) in the order of the scene, 0 once eroded [mass].");
}

}  // namespace

void bind_arrays(py::class_<SimulationObject>& simulation) {
  simulation
      .def_property_readonly(
          "positions", [](const Self& self) { return shown(of(self).positions(), self); },
          "(nodes, 3), the solver's own, in its order: node n of the scene is positions[place_of_node[n]] [length].")
      .def_property_readonly(
          "velocities", [](const Self& self) { return shown(of(self).velocities(), self); },
          "(nodes, 3), the solver's own, in its order [length/time].")
      .def_property_readonly(
          "masses", [](const Self& self) { return shown(of(self).masses(), self); },
          "(nodes,), the solver's own, in its order [mass].")
      .def_property_readonly(
          "plastic_strains", [](const Self& self) { return shown(of(self).plastic_strains(), self); },
          "(places,), the solver's own: element e of the scene is plastic_strains[place_of_element[e]] [-].")
      .def_property_readonly(
          "place_of_node", [](const Self& self) { return indices(of(self).place_of_node(), self); },
          "(nodes,), places in the solver's arrays of nodes, in the order of the scene.")
      .def_property_readonly(
          "place_of_element", [](const Self& self) { return indices(of(self).place_of_element(), self); },
          "(elements,), places in the solver's arrays of elements, in the order of the scene.")
      .def(
          "velocities_to_change", [](const Self& self) { return shown(of(self).velocities_to_change(), self); },
          "The velocities, (nodes, 3), to be written before the next step; to be asked for again before each change.")
      .def(
          "external_forces", [](const Self& self) { return shown(object_of(self).forces(), self); },
          "Forces on the nodes, (nodes, 3), that are added in every step, zero until they are written [force].");
  bind_copies(simulation);
}

}  // namespace pinball::python
