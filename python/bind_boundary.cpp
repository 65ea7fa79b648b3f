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
      .def_readwrite("file", &NodeSelection::file, "the mesh file of the set or the numbers")
      .def_readwrite("without", &NodeSelection::without, "a set whose nodes are left out")
      .def_readwrite("tolerance", &NodeSelection::tolerance, "0: by the mesh [length]");
  bind_data<TimeSpan>(module, "TimeSpan", "When something acts.")
      .def_readwrite("start", &TimeSpan::start, "[time]")
      .def_readwrite("end", &TimeSpan::end, "[time]");
  bind_data<TimeTable>(module, "TimeTable", "Factor over time, piecewise linear.")
      .def_readwrite("times", &TimeTable::times, "increasing [time]")
      .def_readwrite("factors", &TimeTable::factors, "[-]");
  bind_data<PlaneConstraint>(module, "SymmetryPlane", "[[constraint]] type = \"symmetry\"")
      .def_readwrite("point", &PlaneConstraint::point, "[length]")
      .def_readwrite("normal", &PlaneConstraint::normal)
      .def_readwrite("body", &PlaneConstraint::body)
      .def_readwrite("set", &PlaneConstraint::set, "these nodes, in the place of those on the plane")
      .def_readwrite("tolerance", &PlaneConstraint::tolerance, "0: by the mesh [length]")
      .def_readwrite("where", &PlaneConstraint::where, "for messages")
      .def_readwrite("name", &PlaneConstraint::name, "of its force in history.csv; empty: not asked for");
  bind_data<FixedConstraint>(module, "Fixed", "[[constraint]] type = \"fixed\", with directions along x, y, z")
      .def_readwrite("nodes", &FixedConstraint::nodes)
      .def_readwrite("directions", &FixedConstraint::directions)
      .def_readwrite("frame", &FixedConstraint::frame)
      .def_readwrite("axis", &FixedConstraint::axis, "of the cylindrical frame")
      .def_readwrite("when", &FixedConstraint::when, "start, end")
      .def_readwrite("name", &FixedConstraint::name, "of its force in history.csv; empty: not asked for");
  bind_data<RigidWall>(module, "RigidWall", "[[rigid_wall]]")
      .def_readwrite("name", &RigidWall::name)
      .def_readwrite("plane", &RigidWall::plane)
      .def_readwrite("body", &RigidWall::body)
      .def_readwrite("where", &RigidWall::where, "for messages")
      .def_readwrite("friction", &RigidWall::friction, "Coulomb coefficient [-]")
      .def_readwrite("sliding", &RigidWall::sliding, "False: nodes do not move along the wall while they touch it")
      .def_readwrite("nodes", &RigidWall::nodes, "only these; nothing given: all")
      .def_readwrite("when", &RigidWall::when, "start, end")
      .def_readwrite("edge", &RigidWall::edge, "direction of the first side of a rectangle; None: without end")
      .def_readwrite("size", &RigidWall::size, "of the sides of the rectangle [length]")
      .def_readwrite("mass", &RigidWall::mass, "of a wall that is pushed [mass]")
      .def_readwrite("speed", &RigidWall::speed, "along the normal [length/time]")
      .def_readwrite("table", &RigidWall::table, "factors of the speed");
  bind_data<PrescribedVelocity>(module, "PrescribedVelocity", "[[prescribed_velocity]]")
      .def_readwrite("nodes", &PrescribedVelocity::nodes)
      .def_readwrite("direction", &PrescribedVelocity::direction, "only along this; None: all three components")
      .def_readwrite("velocity", &PrescribedVelocity::velocity, "[length/time]")
      .def_readwrite("table", &PrescribedVelocity::table)
      .def_readwrite("quantity", &PrescribedVelocity::quantity, "what the factors give")
      .def_readwrite("when", &PrescribedVelocity::when, "start, end")
      .def_readwrite("name", &PrescribedVelocity::name, "of its force in history.csv; empty: not asked for");
  bind_data<NodalLoad>(module, "Load", "[[load]]")
      .def_readwrite("nodes", &NodalLoad::nodes)
      .def_readwrite("force", &NodalLoad::force, "total [force]")
      .def_readwrite("table", &NodalLoad::table)
      .def_readwrite("each", &NodalLoad::each, "the force is that on each of the nodes");
  bind_data<Pressure>(module, "Pressure", "[[pressure]]")
      .def_readwrite("name", &Pressure::name)
      .def_readwrite("faces", &Pressure::faces)
      .def_readwrite("corners", &Pressure::corners, "faces by numbers of the mesh file's nodes, four each")
      .def_readwrite("pressure", &Pressure::pressure, "[stress]")
      .def_readwrite("table", &Pressure::table)
      .def_readwrite("start", &Pressure::start, "[time]");
  bind_data<Gravity>(module, "Gravity", "[[gravity]]")
      .def_readwrite("acceleration", &Gravity::acceleration, "[length/time^2]")
      .def_readwrite("table", &Gravity::table)
      .def_readwrite("bodies", &Gravity::bodies, "empty: all")
      .def_readwrite("name", &Gravity::name, "of its force in history.csv; empty: not asked for");
  bind_data<InitialVelocity>(module, "InitialVelocity", "[[initial_velocity]]")
      .def_readwrite("nodes", &InitialVelocity::nodes)
      .def_readwrite("velocity", &InitialVelocity::velocity, "[length/time]")
      .def_readwrite("angular_velocity", &InitialVelocity::angular_velocity, "adds w x (x - centre) [1/time]")
      .def_readwrite("centre", &InitialVelocity::centre, "[length]")
      .def_readwrite("components", &InitialVelocity::components, "those that are set");
  bind_data<Probe>(module, "Probe", "[[probe]]: a node or an element, by a point at the start or by its number")
      .def_readwrite("name", &Probe::name)
      .def_readwrite("kind", &Probe::kind)
      .def_readwrite("point", &Probe::point, "[length]")
      .def_readwrite("body", &Probe::body, "empty: any")
      .def_readwrite("quantities", &Probe::quantities, "empty: all of the kind")
      .def_readwrite("where", &Probe::where, "for messages")
      .def_readwrite("number", &Probe::number, "in the mesh file of its body, in the place of a point");
  bind_list<PlaneConstraint>(module, "SymmetryPlanes");
  bind_list<FixedConstraint>(module, "FixedConstraints");
  bind_list<RigidWall>(module, "RigidWalls");
  bind_list<PrescribedVelocity>(module, "PrescribedVelocities");
  bind_list<NodalLoad>(module, "Loads");
  bind_list<Pressure>(module, "Pressures");
  bind_list<Gravity>(module, "Gravities");
  bind_list<InitialVelocity>(module, "InitialVelocities");
  bind_list<Probe>(module, "Probes");
}

}  // namespace pinball::python
