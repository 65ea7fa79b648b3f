#include <fmt/format.h>

#include <algorithm>

#include <solver/base/error.hpp>
#include <solver/base/thread_count.hpp>

#include "simulation_implementation.hpp"

namespace pinball {

namespace {

/// The first three of each record of four.
template <class S>
ConstArrayView vectors(const Array<S>& array) {
  ConstArrayView view = view_records(array.data(), array.size() / 4, 4);
  view.components = 3;
  return view;
}
template <class S>
ArrayView vectors_to_change(Array<S>& array) {
  ArrayView view = view_records(array.data(), array.size() / 4, 4);
  view.components = 3;
  return view;
}

void check_target(const ArrayView& to, std::int64_t count, std::int64_t components) {
  const bool floating = to.type == NumberType::float32 || to.type == NumberType::float64;
  if (to.data == nullptr) throw InputError("copy: to: expected an array, got a null pointer");
  if (!floating) throw InputError("copy: to: expected floating-point numbers, got integers");
  if (to.count != count || to.components != components) {
    throw InputError(
        fmt::format("copy: to: expected {} records of {}, got {} of {}", count, components, to.count, to.components));
  }
}

void put(const ArrayView& to, std::int64_t record, std::int64_t component, double value) {
  if (to.type == NumberType::float32) {
    *to.at<float>(record, component) = static_cast<float>(value);
  } else {
    *to.at<double>(record, component) = value;
  }
}

void copy_initial_positions(std::span<const Point> nodes, const ArrayView& to) {
  check_target(to, nodes.size(), 3);
  for (std::int64_t n = 0; n < to.count; ++n) {
    for (std::int64_t k = 0; k < 3; ++k) put(to, n, k, nodes[n][k]);
  }
}

/// The numbers of a body in a list that is sorted by bodies.
IndexRange range_of(const ModelMesh& mesh, const std::vector<std::int32_t>& owner, const std::string& body) {
  const auto name = std::find(mesh.body_names.begin(), mesh.body_names.end(), body);
  if (name == mesh.body_names.end()) throw InputError(fmt::format("body: there is no body named \"{}\"", body));
  const std::int32_t number = name - mesh.body_names.begin();
  const auto [first, last] = std::equal_range(owner.begin(), owner.end(), number);
  return {first - owner.begin(), last - first};
}

}  // namespace

std::int64_t Simulation::nodes() const {
  return implementation_->read([](const auto& s) { return static_cast<std::int64_t>(s.mesh().nodes.size()); });
}
std::int64_t Simulation::elements() const {
  return implementation_->read([](const auto& s) { return s.element_count(); });
}
IndexRange Simulation::nodes_of(const std::string& body) const {
  return implementation_->read([&](const auto& s) { return range_of(s.mesh(), s.mesh().body_of_node, body); });
}
IndexRange Simulation::elements_of(const std::string& body) const {
  return implementation_->read([&](const auto& s) { return range_of(s.mesh(), s.mesh().body, body); });
}

ConstArrayView Simulation::positions() const {
  return implementation_->read([](const auto& s) { return vectors(s.model().nodes.position); });
}
ConstArrayView Simulation::velocities() const {
  return implementation_->read([](const auto& s) { return vectors(s.model().nodes.velocity); });
}
ConstArrayView Simulation::masses() const {
  return implementation_->read([](const auto& s) -> ConstArrayView {
    return view_records(s.model().node_mass.data(), s.model().nodes.count, 1);
  });
}
std::span<const std::int32_t> Simulation::place_of_node() const {
  return implementation_->read([](const auto& s) { return std::span(s.model().node_of_scene_node); });
}
ArrayView Simulation::velocities_to_change() {
  const ThreadCount threads(implementation_->threads());
  return implementation_->change([](auto& s) { return vectors_to_change(s.change_velocities()); });
}
ArrayView Simulation::external_forces() {
  return implementation_->change([](auto& s) { return vectors_to_change(s.host_forces()); });
}

ConstArrayView Simulation::plastic_strains() const {
  return implementation_->read([](const auto& s) -> ConstArrayView {
    const auto& strains = s.model().elements.plastic_strain;
    return strains.visit([](const auto& numbers) { return view_records(numbers.data(), numbers.size(), 1); });
  });
}
std::span<const std::int64_t> Simulation::place_of_element() const {
  return implementation_->read([](const auto& s) { return std::span(s.model().slot_of_element); });
}

void Simulation::copy(NodeField field, const ArrayView& to) const {
  if (field == NodeField::initial_position) {
    copy_initial_positions(implementation_->read([](const auto& s) { return std::span(s.mesh().nodes); }), to);
    return;
  }
  const ConstArrayView from = field == NodeField::position   ? positions()
                              : field == NodeField::velocity ? velocities()
                                                             : masses();
  const std::span<const std::int32_t> places = place_of_node();
  check_target(to, nodes(), from.components);
  for (std::int64_t n = 0; n < to.count; ++n) {
    const std::int64_t place = places[n];
    for (std::int64_t k = 0; k < to.components; ++k) put(to, n, k, from.number(place, k));
  }
}

void Simulation::copy(ElementField field, const ArrayView& to) const {
  check_target(to, elements(), field == ElementField::stress ? 6 : 1);
  implementation_->read([&]<class S>(const Solver<S>& solver) {
    const Model<S>& model = solver.model();
    for (std::int64_t e = 0; e < to.count; ++e) {
      const std::int64_t slot = model.slot_of_element[e];
      switch (field) {
        case ElementField::stress:
          for (int c = 0; c < 6; ++c) put(to, e, c, model.elements.stress_of(slot, c));
          break;
        case ElementField::plastic_strain:
          put(to, e, 0, model.elements.plastic_strain.empty() ? 0.0 : model.elements.plastic_strain[slot]);
          break;
        case ElementField::mass:
          put(to, e, 0, model.elements.alive(slot) ? model.element_mass[e] : 0.0);
          break;
      }
    }
  });
}

}  // namespace pinball
