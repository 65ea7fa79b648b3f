#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <solver/scene.hpp>

#include "data_class.hpp"
#include "data_list.hpp"

/// Lists of a scene are objects of their own, so that scene.bodies.append(...) changes the scene. Every file of the
/// module has to know that.
PYBIND11_MAKE_OPAQUE(std::vector<pinball::YieldCurve>)
PYBIND11_MAKE_OPAQUE(std::vector<pinball::Material>)
PYBIND11_MAKE_OPAQUE(std::vector<pinball::Body>)
PYBIND11_MAKE_OPAQUE(std::vector<pinball::RigidBody>)
PYBIND11_MAKE_OPAQUE(std::vector<pinball::AttachedNodes>)
PYBIND11_MAKE_OPAQUE(std::vector<pinball::RigidMotion>)
PYBIND11_MAKE_OPAQUE(std::vector<pinball::Joint>)
PYBIND11_MAKE_OPAQUE(std::vector<pinball::PlaneConstraint>)
PYBIND11_MAKE_OPAQUE(std::vector<pinball::FixedConstraint>)
PYBIND11_MAKE_OPAQUE(std::vector<pinball::EquationTerm>)
PYBIND11_MAKE_OPAQUE(std::vector<pinball::RigidWall>)
PYBIND11_MAKE_OPAQUE(std::vector<pinball::PrescribedVelocity>)
PYBIND11_MAKE_OPAQUE(std::vector<pinball::NodalLoad>)
PYBIND11_MAKE_OPAQUE(std::vector<pinball::Pressure>)
PYBIND11_MAKE_OPAQUE(std::vector<pinball::Gravity>)
PYBIND11_MAKE_OPAQUE(std::vector<pinball::PointMass>)
PYBIND11_MAKE_OPAQUE(std::vector<pinball::InitialVelocity>)
PYBIND11_MAKE_OPAQUE(std::vector<pinball::InitialStress>)
PYBIND11_MAKE_OPAQUE(std::vector<pinball::Probe>)
PYBIND11_MAKE_OPAQUE(std::vector<pinball::ContactPair>)
PYBIND11_MAKE_OPAQUE(std::vector<pinball::TiedContact>)
PYBIND11_MAKE_OPAQUE(std::vector<pinball::MeshSetName>)

namespace pinball::python {

/// A scene that knows what it was read from, which checkpoints need.
struct SourcedScene : Scene {
  std::optional<SceneSource> source;
};

void bind_settings(py::module_& module);
void bind_meshes(py::module_& module);
void bind_boundary(py::module_& module);
void bind_scene(py::module_& module);
void bind_results(py::module_& module);
void bind_simulation(py::module_& module);
void bind_contact(py::module_& module);
void bind_runs(py::module_& module);

/// A class of plain data: made without arguments or with its fields by name, Material(name="steel", density=7850).
template <class Data>
DataClass<Data> bind_data(py::module_& module, const char* name, const char* text) {
  DataClass<Data> data(module, name, text);
  data.made_by_fields();
  return data;
}

}  // namespace pinball::python
