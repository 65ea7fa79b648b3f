#pragma once

#include <solver/model/model.hpp>

#include "element_parts.hpp"

namespace pinball {

/// An element at the start.
struct ElementStart {
  double volume, face_area, sound_speed;  ///< the last of the material as it is, whatever mass is added
  /// Whose largest eigenvalues the stable step follows from: of stiffness over mass, and of half of the linear bulk
  /// viscosity over mass, both without added mass.
  double frequency2, half_damping;

  /// With linear bulk viscosity, as the kernel finds it at rest, where the element has so many times its mass [time].
  double stable_step(double mass_factor = 1) const;
  /// How many times its mass gives it this stable step: the inverse of the above.
  double mass_factor(double stable_step) const;
};

/// part: that the element belongs to.
ElementStart element_start(const ModelMesh& mesh, std::size_t element, const Material& material,
                           const ElementPart& part);

/// The smallest stable step of all elements at the start [time]. mass_factor: per element; empty: 1.
double smallest_stable_step(const Scene& scene, const ModelMesh& mesh, const ElementParts& parts,
                            const std::vector<double>& mass_factor);

}  // namespace pinball
