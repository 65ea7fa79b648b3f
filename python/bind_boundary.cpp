#include <pybind11/stl.h>

#include "bindings.hpp"

namespace pinball::python {

void bind_boundary(pybind11::module_& module) {
  bind_data<Plane>(module, "Plane", "plane = { point, normal }")
      .def_readwrite("point", &Plane::point)
      .def_readwrite("normal", &Plane::normal);
  bind_data<Line>(module, "Line", "line = { point, direction }")
      .def_readwrite("point", &Line::point)
      .def_readwrite("direction", &Line::direction);
  bind_data<Box>(module, "Box", "box = { low, high }")
      .def_readwrite("low", &Box::low)
      .def_readwrite("high", &Box::high);
  bind_data<NodeSelection>(module, "NodeSelection", "Nodes that fulfil everything given.")
      .def_readwrite("body", &NodeSelection::body)
      .def_readwrite("plane", &NodeSelection::plane)
      .def_readwrite("line", &NodeSelection::line)
      .def_readwrite("box", &NodeSelection::box)
      .def_readwrite("nearest", &NodeSelection::nearest);
  bind_data<TimeTable>(module, "TimeTable", "Factor over time, piecewise linear.")
      .def_readwrite("times", &TimeTable::times)
      .def_readwrite("factors", &TimeTable::factors);
  bind_data<PlaneConstraint>(module, "SymmetryPlane", "[[constraint]] type = \"symmetry\"")
      .def_readwrite("point", &PlaneConstraint::point)
      .def_readwrite("normal", &PlaneConstraint::normal)
      .def_readwrite("body", &PlaneConstraint::body);
  bind_data<FixedConstraint>(module, "Fixed", "[[constraint]] type = \"fixed\", with directions along x, y, z")
      .def_readwrite("nodes", &FixedConstraint::nodes)
      .def_readwrite("directions", &FixedConstraint::directions);
  bind_data<RigidWall>(module, "RigidWall", "[[rigid_wall]]")
      .def_readwrite("name", &RigidWall::name)
      .def_readwrite("plane", &RigidWall::plane)
      .def_readwrite("body", &RigidWall::body)
      .def_readwrite("friction", &RigidWall::friction);
  bind_data<PrescribedVelocity>(module, "PrescribedVelocity", "[[prescribed_velocity]]")
      .def_readwrite("nodes", &PrescribedVelocity::nodes)
      .def_readwrite("direction", &PrescribedVelocity::direction)
      .def_readwrite("velocity", &PrescribedVelocity::velocity)
      .def_readwrite("table", &PrescribedVelocity::table);
  bind_data<NodalLoad>(module, "Load", "[[load]]")
      .def_readwrite("nodes", &NodalLoad::nodes)
      .def_readwrite("force", &NodalLoad::force)
      .def_readwrite("table", &NodalLoad::table);
  bind_data<InitialVelocity>(module, "InitialVelocity", "[[initial_velocity]]")
      .def_readwrite("nodes", &InitialVelocity::nodes)
      .def_readwrite("velocity", &InitialVelocity::velocity);
  bind_list<PlaneConstraint>(module, "SymmetryPlanes");
  bind_list<FixedConstraint>(module, "FixedConstraints");
  bind_list<RigidWall>(module, "RigidWalls");
  bind_list<PrescribedVelocity>(module, "PrescribedVelocities");
  bind_list<NodalLoad>(module, "Loads");
  bind_list<InitialVelocity>(module, "InitialVelocities");
}

}  // namespace pinball::python
