#include "face_pressures.hpp"

#include <algorithm>

#include <solver/model/selection/pressed_faces.hpp>

#include "force_factor.hpp"

namespace pinball {

namespace {

template <class S>
FaceList faces_of(const Model<S>& model, const Pressure& given) {
  FaceList faces;
  std::vector<std::pair<std::int32_t, std::int32_t>> places;  // node, number of the corner
  for (const PressedFace& face : pressed_faces(model.mesh, model.scene.constraints, given)) {
    faces.element.push_back(model.slot_of_element[face.element]);
    for (const std::int32_t corner : face.corners) {
      const std::int32_t node = model.node_of_scene_node[corner];
      places.emplace_back(node, static_cast<std::int32_t>(places.size()));
      faces.corners.push_back(node);
    }
  }
  std::sort(places.begin(), places.end());
  for (const auto& [node, place] : places) {
    if (faces.nodes.empty() || faces.nodes.back() != node) {
      faces.nodes.push_back(node);
      faces.first.push_back(faces.places.size());
    }
    faces.places.push_back(place);
  }
  faces.first.push_back(faces.places.size());
  return faces;
}

}  // namespace

template <class S>
FacePressures<S>::FacePressures(const Model<S>& model, const BoundaryKernels<S>& kernels) {
  for (const Pressure& given : model.scene.pressures) {
    Load& load = loads_.emplace_back();
    load.given = given;
    load.faces = kernels.pressure(faces_of(model, given));
  }
}

template <class S>
void FacePressures<S>::apply(const NodeArrays<S>& nodes, double time, const StepLengths& step, bool begins_cycle) {
  for (Load& load : loads_) {
    const Point last = begins_cycle ? Point{} : force_of_step(load);
    for (std::size_t k = 0; k < 3; ++k) load.cycle[k].begin_step(begins_cycle, last[k]);
    const Pressure& given = load.given;
    const auto pressure = static_cast<S>(force_factor(given.table, given.start, time, step) * given.pressure);
    load.acts = pressure != S(0);
    load.force_read.reset();
    if (load.acts) load.faces->add(nodes, pressure);
  }
}

template <class S>
ExternalWork FacePressures<S>::work(const NodeArrays<S>& nodes, const StepLengths& step) {
  ExternalWork sum;
  for (Load& load : loads_) {
    load.done += load.last.now + load.last.later;
    load.last = {};
    if (load.acts) load.faces->add_work(nodes, step, load.last);
    sum.join(load.last);
  }
  return sum;
}

template <class S>
std::vector<PressureResult> FacePressures<S>::results() const {
  std::vector<PressureResult> results;
  for (const Load& load : loads_) {
    PressureResult& result = results.emplace_back();
    result.name = load.given.name;
    result.work = load.done + load.last.now;
    result.force = mean_force(load);
  }
  return results;
}

template <class S>
Point FacePressures<S>::force_of_step(const Load& load) {
  if (!load.acts) return {};
  const VectorSum force = load.faces->force();
  return {force.x, force.y, force.z};
}

template <class S>
Point FacePressures<S>::mean_force(const Load& load) {
  if (load.force_read) return *load.force_read;
  Point force = force_of_step(load);
  for (std::size_t k = 0; k < 3; ++k) force[k] = load.cycle[k].with(force[k]);
  return force;
}

/// The forces on the faces are those of a step, and are made anew in the next one: their sum is what is saved.
template <class S>
void FacePressures<S>::persist(StateArchive& archive) {
  for (Load& load : loads_) {
    Point force = archive.reads() ? Point{} : mean_force(load);
    archive(load.done, load.last, force);
    if (archive.reads()) load.force_read = force;
  }
}

template <class S>
std::size_t FacePressures<S>::bytes() const {
  std::size_t sum = 0;
  for (const Load& load : loads_) sum += load.faces->bytes();
  return sum;
}

template class FacePressures<double>;
template class FacePressures<float>;

}  // namespace pinball
