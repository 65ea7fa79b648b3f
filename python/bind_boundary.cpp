#include "bindings.hpp"

namespace pinball::python {

void bind_boundary(py::module_& module) {
  bind_choice<Frame>(module, "Frame", {{"global", Frame::global}, {"cylindrical", Frame::cylindrical}});
  bind_choice<MotionQuantity>(module, "MotionQuantity",
                              {{"velocity", MotionQuantity::velocity},
                               {"displacement", MotionQuantity::displacement},
                               {"acceleration", MotionQuantity::acceleration}});
  bind_choice<ProbeKind>(module, "ProbeKind", {{"node", ProbeKind::node}, {"element", ProbeKind::element}});
  bind_data<Plane>(module, "Plane", "plane = { point, normal }")
      .def_readwrite("point", &Plane::point, "[length]")
      .def_readwrite("normal", &Plane::normal);
  bind_data<Line>(module, "Line", "line = { point, direction }")
      .def_readwrite("point", &Line::point, "[length]")
      .def_readwrite("direction", &Line::direction);
  bind_data<Box>(module, "Box", "box = { low, high }")
      .def_readwrite("low", &Box::low, "[length]")
      .def_readwrite("high", &Box::high, "[length]");
  bind_data<NodeSelection>(module, "NodeSelection", "Nodes that fulfil everything given.")
      .def_readwrite("where", &NodeSelection::where, "for messages")
      .def_readwrite("body", &NodeSelection::body, "empty: all bodies")
      .def_readwrite("plane", &NodeSelection::plane)
      .def_readwrite("line", &NodeSelection::line)
      .def_readwrite("box", &NodeSelection::box)
      .def_readwrite("nearest", &NodeSelection::nearest, "the node nearest to this point [length]")
      .def_readwrite("set", &NodeSelection::set, "name or number of a set of nodes in a mesh file")
      .def_readwrite("nodes", &NodeSelection::nodes, "numbers that the mesh file gives the nodes")
      .def_readwrite("file", &NodeSelection::file, "the mesh file of the set or the numbers");
  bind_data<TimeTable>(module, "TimeTable", "Factor over time, piecewise linear.")
      .def_readwrite("times", &TimeTable::times, "increasing [time]")
      .def_readwrite("factors", &TimeTable::factors, "[-]");
  bind_data<PlaneConstraint>(module, "SymmetryPlane", "[[constraint]] type = \"symmetry\"")
      .def_readwrite("point", &PlaneConstraint::point, "[length]")
      .def_readwrite("normal", &PlaneConstraint::normal)
      .def_readwrite("body", &PlaneConstraint::body);
  bind_data<FixedConstraint>(module, "Fixed", "[[constraint]] type = \"fixed\", with directions along x, y, z")
      .def_readwrite("nodes", &FixedConstraint::nodes)
      .def_readwrite("directions", &FixedConstraint::directions)
      .def_readwrite("frame", &FixedConstraint::frame)
      .def_readwrite("axis", &FixedConstraint::axis, "of the cylindrical frame");
  bind_data<RigidWall>(module, "RigidWall", "[[rigid_wall]]")
      .def_readwrite("name", &RigidWall::name)
      .def_readwrite("plane", &RigidWall::plane)
      .def_readwrite("body", &RigidWall::body)
      .def_readwrite("where", &RigidWall::where, "for messages")
      .def_readwrite("friction", &RigidWall::friction, "Coulomb coefficient [-]");
  bind_data<PrescribedVelocity>(module, "PrescribedVelocity", "[[prescribed_velocity]]")
      .def_readwrite("nodes", &PrescribedVelocity::nodes)
      .def_readwrite("direction", &PrescribedVelocity::direction, "only along this; None: all three components")
      .def_readwrite("velocity", &PrescribedVelocity::velocity, "[length/time]")
      .def_readwrite("table", &PrescribedVelocity::table)
      .def_readwrite("quantity", &PrescribedVelocity::quantity, "what the factors give");
  bind_data<NodalLoad>(module, "Load", "[[load]]")
      .def_readwrite("nodes", &NodalLoad::nodes)
      .def_readwrite("force", &NodalLoad::force, "total [force]")
      .def_readwrite("table", &NodalLoad::table)
      .def_readwrite("each", &NodalLoad::each, "the force is that on each of the nodes");
  bind_data<Gravity>(module, "Gravity", "[[gravity]]")
      .def_readwrite("acceleration", &Gravity::acceleration, "[length/time^2]")
      .def_readwrite("table", &Gravity::table);
  bind_data<InitialVelocity>(module, "InitialVelocity", "[[initial_velocity]]")
      .def_readwrite("nodes", &InitialVelocity::nodes)
      .def_readwrite("velocity", &InitialVelocity::velocity, "[length/time]");
  bind_data<Probe>(module, "Probe", "[[probe]]: the node or element nearest to a point at the start")
      .def_readwrite("name", &Probe::name)
      .def_readwrite("kind", &Probe::kind)
      .def_readwrite("point", &Probe::point, "[length]")
      .def_readwrite("body", &Probe::body, "empty: any")
      .def_readwrite("quantities", &Probe::quantities, "empty: all of the kind")
      .def_readwrite("where", &Probe::where, "for messages");
  bind_list<PlaneConstraint>(module, "SymmetryPlanes");
  bind_list<FixedConstraint>(module, "FixedConstraints");
  bind_list<RigidWall>(module, "RigidWalls");
  bind_list<PrescribedVelocity>(module, "PrescribedVelocities");
  bind_list<NodalLoad>(module, "Loads");
  bind_list<Gravity>(module, "Gravities");
  bind_list<InitialVelocity>(module, "InitialVelocities");
  bind_list<Probe>(module, "Probes");
}

}  // namespace pinball::python
