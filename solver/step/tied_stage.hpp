#pragma once

#include <vector>

#include <solver/base/error.hpp>
#include <solver/contact/tied/tied_nodes.hpp>
#include <solver/model/model.hpp>

namespace pinball {

/// The tied contacts of a scene in a step. A scene without them has none of it.
template <class S>
class TiedStage {
 public:
  /// model: has to stay where it is; its tied nodes are taken over.
  explicit TiedStage(Model<S>& model) : nodes_(std::move(model.tied_nodes), times_of(model.scene), model.nodes.count) {
    if (!nodes_.any()) return;
    if (model.scene.time.subcycling) {
      throw InputError(model.scene.tied_contacts.front().where +
                       ": expected time.subcycling = false, with which nodes cannot be tied in this version");
    }
    nodes_.remember_masses(motion_of(model));
    model.contact_inverse_mass = nodes_.free_inverse_mass();
    model.masses_without_ties = &nodes_.masses_without();
  }
  TiedStage(const TiedStage&) = delete;  // the model points to it
  TiedStage& operator=(const TiedStage&) = delete;

  bool any() const { return nodes_.any(); }
  const TiedNodes<S>& nodes() const { return nodes_; }
  /// Ties and lets go; returns whether anything has changed. time: of the forces of the step.
  bool update(Model<S>& model, double time) {
    return nodes_.update(motion_of(model), time, [&model](std::int64_t slot) { return model.elements.alive(slot); });
  }
  bool begin(double from, double to) const { return nodes_.any() && nodes_.begin(from, to); }
  double leap_of_begun(const Model<S>& model, double from, double to) const {
    return nodes_.leap_of_begun(model.nodes.velocity.data(), from, to);
  }
  /// Kinetic energy that this has cost [energy].
  double take_lost_energy() { return nodes_.take_lost_energy(); }
  void distribute(Model<S>& model) const { nodes_.distribute(model.nodes.force.data()); }
  void put_accelerations(Model<S>& model) const {
    nodes_.put_accelerations(model.nodes.inverse_mass.data(), model.nodes.force.data());
  }
  void keep_velocities(Model<S>& model) { nodes_.keep_velocities(motion_of(model)); }
  void take_velocities(Model<S>& model) { nodes_.take_velocities(motion_of(model)); }
  void follow(Model<S>& model) const { nodes_.follow(motion_of(model)); }
  void persist(StateArchive& archive, Model<S>& model) { nodes_.persist(archive, motion_of(model)); }
  std::size_t bytes() const { return nodes_.bytes(); }

 private:
  static TiedMotion<S> motion_of(Model<S>& model) {
    return {model.nodes.position.data(), model.nodes.velocity.data(), model.nodes.inverse_mass.data(),
            &model.node_mass};
  }
  static std::vector<TieTimes> times_of(const Scene& scene) {
    std::vector<TieTimes> times;
    for (const TiedContact& tied : scene.tied_contacts) times.push_back({tied.start, tied.end});
    return times;
  }

  TiedNodes<S> nodes_;
};

}  // namespace pinball
