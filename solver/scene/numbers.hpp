#pragma once

#include <solver/scene.hpp>

#include "schema/bound.hpp"

/// The numbers of each kind of table, with what they may be. Reading a file and checking a scene that a host made go
/// through the same lists: visit(key, value, bound[, need]) with a double& or a Point&.
namespace pinball {

enum class Need { optional, required };

template <class Visit>
void visit_numbers(TimeSettings& time, const Visit& visit) {
  visit("end", time.end, positive, Need::required);
  visit("cfl", time.cfl, Bound{.low = 0.0, .low_open = true, .high = 1.2});
  visit("smallest_step", time.smallest_step, not_negative);
}

template <class Visit>
void visit_numbers(ElementSettings& element, const Visit& visit) {
  visit("hourglass_coefficient", element.hourglass_coefficient, not_negative);
  visit("linear_viscosity", element.linear_viscosity, not_negative);
  visit("quadratic_viscosity", element.quadratic_viscosity, not_negative);
  visit("folding_resistance", element.folding_resistance, not_negative);
}

template <class Visit>
void visit_numbers(ContactSettings& contact, const Visit& visit) {
  visit("beta", contact.beta, not_negative);
  visit("damping", contact.damping, not_negative);
  visit("friction", contact.friction, not_negative);
  visit("static_friction", contact.static_friction, not_negative);
  visit("friction_decay", contact.friction_decay, not_negative);
  visit("radius_factor", contact.radius_factor, Bound{.low = 0.0, .low_open = true, .high = largest_radius_factor});
  visit("skin", contact.skin, Bound{.low = 0.0, .high = largest_skin});
}

/// `end` may be left out, and is then no number.
template <class Visit>
void visit_numbers(ContactPair& pair, const Visit& visit) {
  visit("friction", pair.friction, not_negative);
  visit("static_friction", pair.static_friction, not_negative);
  visit("friction_decay", pair.friction_decay, not_negative);
  visit("start", pair.start, any_number);
}

template <class Visit>
void visit_numbers(TiedContact& tied, const Visit& visit) {
  visit("start", tied.start, any_number);
}

template <class Visit>
void visit_numbers(GuardSettings& guard, const Visit& visit) {
  visit("energy_error", guard.energy_error, positive);
  visit("time_step_collapse", guard.time_step_collapse, Bound{.low = 0.0, .high = 1.0});
}

template <class Visit>
void visit_numbers(DampingSettings& damping, const Visit& visit) {
  visit("mass", damping.mass, not_negative);
}

template <class Visit>
void visit_numbers(OutputSettings& output, const Visit& visit) {
  visit("interval", output.interval, not_negative);
  visit("field_interval", output.field_interval, not_negative);
}

/// Of any material. The moduli have two forms in a file; yield and ultimate stress are asked for by model.
template <class Visit>
void visit_numbers(Material& material, const Visit& visit) {
  visit("density", material.density, positive, Need::required);
  visit("plastic_modulus", material.plastic_modulus, not_negative);
  visit("erosion_strain", material.erosion_strain, not_negative);
  visit("isotropic_share", material.isotropic_share, Bound{.low = 0.0, .high = 1.0});
  visit("rate_constant", material.rate_constant, not_negative);
  visit("rate_exponent", material.rate_exponent, not_negative);
  visit("rate_stress", material.rate_stress, not_negative);
}

template <class Visit>
void visit_numbers(Body& body, const Visit& visit) {
  visit("position", body.position, any_number);
  visit("velocity", body.velocity, any_number);
  visit("angular_velocity", body.angular_velocity, any_number);
  visit("velocity_noise", body.velocity_noise, not_negative);
}

template <class Visit>
void visit_numbers(PlaneConstraint& constraint, const Visit& visit) {
  visit("point", constraint.point, any_number);
  visit("tolerance", constraint.tolerance, not_negative);
}

template <class Visit>
void visit_numbers(RigidWall& wall, const Visit& visit) {
  visit("point", wall.plane.point, any_number);
  visit("friction", wall.friction, not_negative);
}

template <class Visit>
void visit_numbers(NodalLoad& load, const Visit& visit) {
  visit("force", load.force, any_number, Need::required);
}

template <class Visit>
void visit_numbers(Pressure& pressure, const Visit& visit) {
  visit("pressure", pressure.pressure, any_number, Need::required);
  visit("start", pressure.start, any_number);
}

template <class Visit>
void visit_numbers(Gravity& gravity, const Visit& visit) {
  visit("acceleration", gravity.acceleration, any_number, Need::required);
}

template <class Visit>
void visit_numbers(InitialVelocity& given, const Visit& visit) {
  visit("velocity", given.velocity, any_number);
  visit("angular_velocity", given.angular_velocity, any_number);
  visit("centre", given.centre, any_number);
}

template <class Visit>
void visit_numbers(Probe& probe, const Visit& visit) {
  if (!probe.number) visit("point", probe.point, any_number, Need::required);
}

}  // namespace pinball
