#include "info_skipped.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <solver/base/counted.hpp>
#include <solver/model/nodes_of_bodies.hpp>
#include <solver/results/skipped_work.hpp>

namespace pinball {

namespace {

void skip(const std::string& what, const std::string& why) { fmt::print("  {}: {}\n", what, why); }

/// Where the nodes of a body are, and the bounds of their velocities.
struct MovingBox {
  Point low, high, slowest, fastest;
  double margin = 0;  ///< longest edge of the box around an element: no pinball reaches further out [length]
};

template <class S>
std::vector<MovingBox> boxes_of_bodies(const Model<S>& model) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  MovingBox none;
  none.low.fill(infinite), none.slowest.fill(infinite);
  none.high.fill(-infinite), none.fastest.fill(-infinite);
  std::vector<MovingBox> boxes(model.mesh.body_names.size(), none);
  for_nodes_of_bodies(model.mesh, [&](std::int32_t b, std::int32_t n) {
    MovingBox& box = boxes[b];
    const S* velocity = model.nodes.velocity_of(model.node_of_scene_node[n]);
    for (std::size_t k = 0; k < 3; ++k) {
      const double v = velocity[k];
      box.low[k] = std::min(box.low[k], model.mesh.nodes[n][k]);
      box.high[k] = std::max(box.high[k], model.mesh.nodes[n][k]);
      box.slowest[k] = std::min(box.slowest[k], v);
      box.fastest[k] = std::max(box.fastest[k], v);
    }
  });
  for (std::size_t e = 0; e < model.mesh.hexahedra.size(); ++e) {
    double& margin = boxes[model.mesh.body[e]].margin;
    for (const double edge : element_extent(model.mesh, e)) margin = std::max(margin, edge);
  }
  return boxes;
}

/// Before this time the boxes cannot overlap, as long as nothing changes the velocities; 0 if they may at once.
double first_meeting(const MovingBox& a, const MovingBox& b) {
  double time = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto until = [k](const MovingBox& below, const MovingBox& above) {
      const double gap = above.low[k] - above.margin - below.high[k] - below.margin;
      const double closing = below.fastest[k] - above.slowest[k];
      if (gap <= 0) return 0.0;
      return closing > 0 ? gap / closing : std::numeric_limits<double>::infinity();
    };
    time = std::max({time, until(a, b), until(b, a)});
  }
  return time;
}

template <class S>
void print_bodies_apart(const Model<S>& model, const Units& units) {
  const std::vector<MovingBox> boxes = boxes_of_bodies(model);
  for (std::size_t a = 0; a < boxes.size(); ++a) {
    for (std::size_t b = a + 1; b < boxes.size(); ++b) {
      const double time = first_meeting(boxes[a], boxes[b]);
      if (time <= 0) continue;
      skip(fmt::format("pairs of {} and {}", model.mesh.body_names[a], model.mesh.body_names[b]),
           std::isfinite(time) ? fmt::format("not listed or tested as long as they cannot meet, until {:.3g}{}", time,
                                             units.time.empty() ? "" : " " + units.time)
                               : "not listed or tested as long as they do not near each other");
    }
  }
}

template <class S>
void print_element_features(const Model<S>& model) {
  const Scene& scene = model.scene;
  for (std::size_t p = 0; p < model.parts.size(); ++p) {
    if (model.parts[p].rigid) continue;
    const Material& material = scene.materials[model.parts[p].material];
    const ElementFeatures& f = model.parts[p].features;
    if (!material.plastic) skip(fmt::format("plasticity of {}", material.name), "its model is elastic");
    if (!f.erosion) {
      skip(fmt::format("erosion of {}", material.name),
           material.plastic ? "it has no erosion_strain, no limits of erosion, and an inverted element stops the run"
                            : "its model is elastic, without limits of erosion, and an inverted element stops the run");
    }
  }
  const auto none = [&model](const auto& has) { return std::ranges::none_of(model.parts, has); };
  if (none([](const Part& part) { return part.features.bulk_viscosity; }))
    skip("bulk viscosity", "off in the scene (element.bulk_viscosity)");
  if (none([](const Part& part) { return part.features.hourglass != HourglassKind::none; }))
    skip("hourglass control", "off in the scene (element.hourglass)");
  const ElementStore& store = model.elements;
  if (store.plastic_strain.empty()) skip("plastic strain array", "no material is plastic, none is eroded");
  if (store.internal_energy.empty()) skip("energy per element", "no material is eroded");
  if (store.viscous_stress.empty()) skip("viscous stress array", "no bulk viscosity");
  if (store.hourglass_state.empty()) skip("hourglass force array", "no hourglass control");
  if (const double bytes = bytes_not_stored(store); bytes > 0) {
    skip("memory of these arrays",
         fmt::format("{:.0f} bytes per element, neither stored nor read", bytes / model.element_count()));
  }
}

template <class S>
void print_contact_parts(const Solver<S>& solver, const Units& units) {
  const Model<S>& model = solver.model();
  const ContactSettings& contact = model.scene.contact;
  if (solver.contact() == nullptr) {
    const bool is_left_out = !model.look.contact_because.empty(), is_one = model.scene.bodies.size() == 1;
    skip("contact", is_left_out ? "no two bodies can meet"
                    : is_one    ? "there is one body, and contact.method is left out, or none"
                                : "off in the scene (contact.method = none)");
    return;
  }
  const std::int64_t inner = model.element_count() - solver.contact()->surface_elements();
  if (inner > 0) skip("contact of " + counted(inner, "element"), "without an exposed face");
  if (model.scene.skip.contact_search) {
    skip("search of most steps", "its lists are used again until a node has strayed from its straight way");
  }
  print_bodies_apart(model, units);
  if (!contact.self) skip("contact of a body with itself", "off in the scene (contact.self)");
  if (contact.method == ContactMethod::pinball && contact.radius == ContactRadius::initial)
    skip("update of the pinball radii", "contact.radius = initial");
  if (contact.enforcement == Enforcement::penalty && contact.damping == 0) {
    skip("contact damping", "contact.damping = 0");
  }
}

template <class S>
void print_boundary_parts(const Solver<S>& solver) {
  const Model<S>& model = solver.model();
  const Scene& scene = model.scene;
  if (scene.constraints.empty() && scene.fixed_constraints.empty()) {
    skip("constraints", "the scene has none");
  } else if (model.constraints.empty()) {
    skip("constraints", "no node lies on a plane of the scene");
  }
  if (!solver.boundary().any()) skip("boundary conditions", "no constraints, loads, damping or rigid walls");
}

}  // namespace

template <class S>
void print_what_is_skipped(const Solver<S>& solver, const Units& units) {
  const Model<S>& model = solver.model();
  const OutputSettings& output = model.scene.output;
  fmt::print("what is skipped\n");
  print_element_features(model);
  if (const std::int64_t resting = RestingTiles<S>(model).elements();
      model.scene.skip.resting && resting > 0 && solver.subcycling() == nullptr) {
    skip("stresses and forces of " + counted(resting, "element"),
         "at rest or in free uniform flight, until something reaches their tile");
  }
  if (const std::int64_t rigid = model.rigid_element_count(); rigid > 0)
    skip("stresses and forces of " + counted(rigid, "element"), "of rigid bodies, which do not deform");
  print_contact_parts(solver, units);
  print_boundary_parts(solver);
  if (output.field_interval <= 0 && output.field_times.empty()) {
    skip("field output", "no output.field_interval and no output.field_times");
  }
}

template void print_what_is_skipped(const Solver<double>&, const Units&);
template void print_what_is_skipped(const Solver<float>&, const Units&);

}  // namespace pinball
