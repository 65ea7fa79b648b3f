#include "bind_keys.hpp"

namespace pinball::python {

void bind_boundary(py::module_& module) {
  bind_choice<Frame>(module, "Frame");
  bind_choice<MotionQuantity>(module, "MotionQuantity");
  bind_choice<JointKind>(module, "JointKind");
  bind_choice<ProbeKind>(module, "ProbeKind");
  bind_table<Plane>(module, "Plane", "plane = { point, normal }");
  bind_table<Line>(module, "Line", "line = { point, direction }");
  bind_table<Box>(module, "Box", "box = { low, high }");
  bind_table<NodeSelection>(module, "NodeSelection", "Nodes that fulfil everything given.");
  bind_table<TimeSpan>(module, "TimeSpan", "When something acts.");
  bind_table<TimeTable>(module, "TimeTable", "Factor over time, piecewise linear.");
  bind_table<PlaneConstraint>(module, "SymmetryPlane", "[[constraint]] type = \"symmetry\"");
  bind_table<FixedConstraint>(module, "Fixed", "[[constraint]] type = \"fixed\", with directions along x, y, z");
  bind_table<EquationTerm>(module, "EquationTerm", "[[equation]]: a term of an equation among displacements");
  bind_table<RigidWall>(module, "RigidWall", "[[rigid_wall]]");
  bind_table<PrescribedVelocity>(module, "PrescribedVelocity", "[[prescribed_velocity]]");
  bind_table<NodalLoad>(module, "Load", "[[load]]");
  bind_table<Pressure>(module, "Pressure", "[[pressure]]");
  bind_table<Gravity>(module, "Gravity", "[[gravity]]");
  bind_table<PointMass>(module, "PointMass", "[[point_mass]]");
  bind_table<InitialVelocity>(module, "InitialVelocity", "[[initial_velocity]]");
  bind_table<InitialStress>(module, "InitialStress", "[[initial_stress]]");
  bind_table<Probe>(module, "Probe", "[[probe]]: a node or an element, by a point at the start or by its number");
  bind_table<RigidBody>(module, "RigidBody", "[[rigid_body]]");
  bind_table<AttachedNodes>(module, "AttachedNodes", "[[rigid_nodes]]");
  bind_table<RigidMotion>(module, "RigidMotion", "[[rigid_motion]]");
  bind_table<Joint>(module, "Joint", "[[joint]]");
  bind_list<RigidBody>(module, "RigidBodies");
  bind_list<AttachedNodes>(module, "AttachedNodesList");
  bind_list<RigidMotion>(module, "RigidMotions");
  bind_list<Joint>(module, "Joints");
  bind_list<PlaneConstraint>(module, "SymmetryPlanes");
  bind_list<FixedConstraint>(module, "FixedConstraints");
  bind_list<EquationTerm>(module, "EquationTerms");
  bind_list<RigidWall>(module, "RigidWalls");
  bind_list<PrescribedVelocity>(module, "PrescribedVelocities");
  bind_list<NodalLoad>(module, "Loads");
  bind_list<Pressure>(module, "Pressures");
  bind_list<Gravity>(module, "Gravities");
  bind_list<PointMass>(module, "PointMasses");
  bind_list<InitialVelocity>(module, "InitialVelocities");
  bind_list<InitialStress>(module, "InitialStresses");
  bind_list<Probe>(module, "Probes");
}

}  // namespace pinball::python
