#pragma once

#include <string>

#include <solver/scene.hpp>

namespace pinball::bench {

inline constexpr double plate_element = 0.01;  // of an element [m]

inline Body plate(const std::string& name, int per_side, double size, const Point& corner, const Point& velocity) {
  Body body;
  body.name = name;
  body.material = "steel";
  body.mesh = BlockMesh{{per_side * size, per_side * size, 2 * size}, {per_side, per_side, 2}};
  body.position = corner;
  body.velocity = velocity;
  return body;
}

inline NodalLoad pressing(const std::string& body, double force) {
  NodalLoad load;
  load.nodes.body = body;
  load.force = {0, 0, force};
  return load;
}

/// The kernels are those of rod_plate: plasticity, erosion, bulk viscosity, stiffness hourglass control, contact by
/// penalty.
inline Scene sliding_plates(int per_side, ContactMethod method) {
  Material steel;
  steel.name = "steel";
  steel.density = 7850;
  steel.bulk_modulus = 1.75e11;
  steel.shear_modulus = 8.1e10;
  steel.plastic = true;
  steel.yield_stress = 1e9;
  steel.erosion_strain = 2;
  Scene scene;
  scene.name = "plates";
  scene.units = "kg-m-s";
  scene.time.end = 1;
  scene.element.hourglass = HourglassControl::stiffness;
  scene.element.hourglass_coefficient = 0.05;
  scene.contact.method = method;
  scene.contact.enforcement = Enforcement::penalty;
  scene.contact.gap = ContactGap::pinball;
  scene.skip.resting = false;  // what is counted is what is worked
  scene.materials = {steel};
  // Faces touch from the start, balls overlap each other by a fifth. A step is about 1.5e-6 s: elements pass each other
  // in 70.
  const double gap = -0.01 * plate_element;
  const double size = 0.97 * plate_element;  // no two nodes above each other
  scene.bodies = {plate("lower", per_side, plate_element, {0, 0, 0}, {0, 0, 0}),
                  plate("upper", per_side, size, {0.3 * plate_element, 0.2 * plate_element, 2 * plate_element + gap},
                        {100, 0, -1})};
  const double force = 1e7 * per_side * plate_element * per_side * plate_element;
  scene.loads = {pressing("lower", force), pressing("upper", -force)};
  return scene;
}

}  // namespace pinball::bench
