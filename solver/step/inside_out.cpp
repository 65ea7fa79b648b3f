#include "inside_out.hpp"

#include <algorithm>

#include <kernels/folding.hpp>
#include <solver/base/hexahedron_of_points.hpp>

#include "places.hpp"

namespace pinball {

namespace {

InsideOut policy_of(const Scene& scene, const Body& body) {
  return (body.element ? *body.element : scene.element).inside_out;
}

}  // namespace

bool may_stop_inside_out(const Scene& scene) {
  return std::any_of(scene.bodies.begin(), scene.bodies.end(),
                     [&scene](const Body& body) { return policy_of(scene, body) == InsideOut::stop; });
}

template <class S>
FoldedElement most_folded(const Model<S>& model, double dt, bool of_bodies_that_stop) {
  FoldedElement most;
  for (const std::int64_t slot : model.slot_of_element) {  // the first in the order of the scene
    if (!model.elements.alive(slot)) continue;
    const Body& body = model.scene.bodies[model.mesh.body[model.element_of_slot[slot]]];
    if (of_bodies_that_stop && policy_of(model.scene, body) != InsideOut::stop) continue;
    const double share = least_corner_share(corners_at_forces(model, slot, dt));
    if (most.slot >= 0 && !(share < most.share)) continue;
    most = {slot, share};
  }
  return most;
}

template FoldedElement most_folded(const Model<double>&, double, bool);
template FoldedElement most_folded(const Model<float>&, double, bool);

}  // namespace pinball
