#pragma once

#include "contact.hpp"
#include "key.hpp"
#include "material.hpp"
#include "meshes.hpp"
#include "scene.hpp"

/// The kinds of tables that a scene has.
namespace pinball::schema {

struct Kind {
  const char* name;   ///< one of its own
  const char* shown;  ///< how a message names such a table; empty: the top level
};

constexpr Kind kind(Of<Scene>) { return {"scene", ""}; }
constexpr Kind kind(Of<TimeSettings>) { return {"time", "time"}; }
constexpr Kind kind(Of<ElementSettings>) { return {"element", "element"}; }
constexpr Kind kind(Of<ContactSettings>) { return {"contact", "contact"}; }
constexpr Kind kind(Of<ContactPair>) { return {"contact_pair", "contact.pair.NAME"}; }
constexpr Kind kind(Of<TiedContact>) { return {"contact_tied", "contact.tied.NAME"}; }
constexpr Kind kind(Of<SideOfSet>) { return {"contact_side", "{ elements, faces or nodes }"}; }
constexpr Kind kind(Of<SkipSettings>) { return {"skip", "skip"}; }
constexpr Kind kind(Of<GuardSettings>) { return {"guard", "guard"}; }
constexpr Kind kind(Of<OutputSettings>) { return {"output", "output"}; }
constexpr Kind kind(Of<Material>) { return {"material", "material.NAME"}; }
constexpr Kind kind(Of<OneYieldCurve>) { return {"yield_curve", "material.NAME.yield_curve"}; }
constexpr Kind kind(Of<YieldCurve>) { return {"yield_curves", "material.NAME.yield_curves"}; }
constexpr Kind kind(Of<PowerHardeningSettings>) { return {"power_hardening", "material.NAME.power_hardening"}; }
constexpr Kind kind(Of<JohnsonCookSettings>) { return {"johnson_cook", "material.NAME.johnson_cook"}; }
constexpr Kind kind(Of<JohnsonHolmquistSettings>) { return {"johnson_holmquist", "material.NAME.johnson_holmquist"}; }
constexpr Kind kind(Of<DruckerPragerSettings>) { return {"drucker_prager", "material.NAME.drucker_prager"}; }
constexpr Kind kind(Of<CrushableFoamSettings>) { return {"crushable_foam", "material.NAME.crushable_foam"}; }
constexpr Kind kind(Of<MooneyRivlinSettings>) { return {"mooney_rivlin", "material.NAME.mooney_rivlin"}; }
constexpr Kind kind(Of<OgdenSettings>) { return {"ogden", "material.NAME.ogden"}; }
constexpr Kind kind(Of<OrthotropicSettings>) { return {"orthotropic", "material.NAME.orthotropic"}; }
constexpr Kind kind(Of<FluidSettings>) { return {"fluid", "material.NAME.fluid"}; }
constexpr Kind kind(Of<EquationOfStateSettings>) { return {"equation_of_state", "material.NAME.equation_of_state"}; }
constexpr Kind kind(Of<ErosionSettings>) { return {"erosion", "material.NAME.erosion"}; }
constexpr Kind kind(Of<Body>) { return {"body", "body.NAME"}; }
constexpr Kind kind(Of<BlockMesh>) { return {"block", "body.NAME.mesh"}; }
constexpr Kind kind(Of<RoundNosedRodMesh>) { return {"round_nosed_rod", "body.NAME.mesh"}; }
constexpr Kind kind(Of<CylinderMesh>) { return {"cylinder", "body.NAME.mesh"}; }
constexpr Kind kind(Of<SphereMesh>) { return {"sphere", "body.NAME.mesh"}; }
constexpr Kind kind(Of<RigidBody>) { return {"rigid_body", "rigid_body.NAME"}; }
constexpr Kind kind(Of<AttachedNodes>) { return {"rigid_nodes", "rigid_nodes.NUMBER"}; }
constexpr Kind kind(Of<RigidMotion>) { return {"rigid_motion", "rigid_motion.NUMBER"}; }
constexpr Kind kind(Of<Joint>) { return {"joint", "joint.NAME"}; }
constexpr Kind kind(Of<PlaneConstraint>) { return {"symmetry", "constraint.NUMBER"}; }
constexpr Kind kind(Of<FixedConstraint>) { return {"fixed", "constraint.NUMBER"}; }
constexpr Kind kind(Of<EquationTerm>) { return {"equation", "equation.NUMBER"}; }
constexpr Kind kind(Of<Plane>) { return {"plane", "plane"}; }
constexpr Kind kind(Of<Line>) { return {"line", "line"}; }
constexpr Kind kind(Of<Box>) { return {"box", "box"}; }
constexpr Kind kind(Of<RigidWall>) { return {"rigid_wall", "rigid_wall.NAME"}; }
constexpr Kind kind(Of<PrescribedVelocity>) { return {"prescribed_velocity", "prescribed_velocity.NUMBER"}; }
constexpr Kind kind(Of<NodalLoad>) { return {"load", "load.NUMBER"}; }
constexpr Kind kind(Of<Pressure>) { return {"pressure", "pressure.NUMBER"}; }
constexpr Kind kind(Of<Gravity>) { return {"gravity", "gravity.NUMBER"}; }
constexpr Kind kind(Of<PointMass>) { return {"point_mass", "point_mass.NUMBER"}; }
constexpr Kind kind(Of<InitialVelocity>) { return {"initial_velocity", "initial_velocity.NUMBER"}; }
constexpr Kind kind(Of<InitialStress>) { return {"initial_stress", "initial_stress.NUMBER"}; }
constexpr Kind kind(Of<DampingSettings>) { return {"damping", "damping"}; }
constexpr Kind kind(Of<Probe>) { return {"probe", "probe.NAME"}; }

/// body.NAME.element, which has the keys of [element].
inline constexpr Kind element_of_body{"element of a body", "body.NAME.element"};

}  // namespace pinball::schema
