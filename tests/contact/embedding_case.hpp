#pragma once

#include <gtest/gtest.h>

#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

#include <kernels/node_update.hpp>
#include <solver/contact/embedded_contact.hpp>
#include <solver/elements/internal_forces.hpp>
#include <solver/model/model_surface.hpp>
#include <tests/support/solver_case.hpp>

/// A host that embeds contact: its own time loop over the solver's model and internal forces, with contact through the
/// public interface alone. On a scene without boundary conditions its states are those of the solver.
namespace pinball::test {

enum class Layout { records, interleaved, separate };

inline pinball_contact_options options_of(const ContactSettings& settings) {
  pinball_contact_options options = contact_options();
  options.method = settings.method == ContactMethod::slideline ? PINBALL_CONTACT_SLIDELINE : PINBALL_CONTACT_PINBALL;
  options.enforcement = settings.enforcement == Enforcement::penalty      ? PINBALL_CONTACT_PENALTY
                        : settings.enforcement == Enforcement::projection ? PINBALL_CONTACT_PROJECTION
                                                                          : PINBALL_CONTACT_LAGRANGE;
  options.gap = settings.gap == ContactGap::face ? PINBALL_CONTACT_GAP_FACE : PINBALL_CONTACT_GAP_PINBALL;
  options.radius =
      settings.radius == ContactRadius::current ? PINBALL_CONTACT_RADIUS_CURRENT : PINBALL_CONTACT_RADIUS_INITIAL;
  options.self = settings.self;
  options.beta = settings.beta;
  options.damping = settings.damping;
  options.friction = settings.friction;
  options.static_friction = settings.static_friction;
  options.radius_factor = settings.radius_factor;
  options.skin = settings.skin;
  return options;
}

template <class S, class Index = std::int32_t>
class EmbeddingHost {
 public:
  /// threads: as the option of that name.
  explicit EmbeddingHost(const Scene& scene, Layout layout = Layout::records, std::int32_t first_index = 0,
                         std::int32_t threads = 1)
      : model_(build_model<S>(scene)),
        internal_(model_),
        schedule_(model_),
        layout_(layout),
        contact_(make(first_index, threads)) {}

  void step(double dt_after) {
    internal_.compute(model_, schedule_, {}, {static_cast<S>(dt_before_)});
    flag_elements();
    const pinball_contact_arrays arrays = load();
    contact_.update(arrays, dt_before_);
    result_ = contact_.add_forces(arrays, dt_after);
    store();
    const auto velocity_step = static_cast<S>(0.5 * (dt_before_ + dt_after));
    for (std::size_t n = 0; n < model_.node_mass.size(); ++n) {
      integrate_node(&model_.nodes.position[4 * n], &model_.nodes.velocity[4 * n], &model_.nodes.force[4 * n],
                     model_.nodes.inverse_mass[n], velocity_step, static_cast<S>(dt_after), static_cast<S>(dt_before_));
    }
    dt_before_ = dt_after;
  }
  /// Takes an element of the scene out of contact.
  void erode(std::size_t element) { out_[element] = true; }

  const Model<S>& model() const { return model_; }
  const pinball_contact_result& result() const { return result_; }
  std::int64_t eroded_elements() const { return eroded_; }
  /// Positions and velocities, x, y, z of each node.
  std::vector<S> state() const { return state_of(model_); }
  static std::vector<S> state_of(const Model<S>& model) {
    std::vector<S> state;
    for (std::size_t n = 0; n < model.node_mass.size(); ++n) {
      for (const Array<S>* records : {&model.nodes.position, &model.nodes.velocity}) {
        state.insert(state.end(), records->data() + 4 * n, records->data() + 4 * n + 3);
      }
    }
    return state;
  }

 private:
  EmbeddedContact make(std::int32_t first_index, std::int32_t threads) {
    const SurfaceTopology topology = surface_topology(model_);
    const ModelSurface<S> of_model(model_);
    for (std::size_t slot = 0; slot < model_.element_of_slot.size(); ++slot) {
      if (slot % static_cast<std::size_t>(native_width<S>) == 0 &&
          model_.tile_packs[tile_first_.size()] * native_width<S> == static_cast<std::int64_t>(slot)) {
        tile_first_.push_back(static_cast<std::int64_t>(slots_.size()));
      }
      if (model_.element_of_slot[slot] < 0) continue;
      const ContactElement element = of_model.element(static_cast<std::int64_t>(slot));
      slots_.push_back(static_cast<std::int64_t>(slot));
      for (const std::int32_t node : element.corners) corners_.push_back(node + first_index);
      body_.push_back(element.body);
      bulk_modulus_.push_back(static_cast<S>(element.bulk_modulus));
      mass_.push_back(static_cast<S>(element.mass));
      volume_.push_back(static_cast<S>(element.volume));
      hidden_.push_back(static_cast<std::uint8_t>(~topology.exposed[slot] & 0x3F));
    }
    tile_first_.push_back(static_cast<std::int64_t>(slots_.size()));
    alive_.assign(slots_.size(), 1);
    out_.assign(slots_.size(), false);
    std::vector<S> node_mass(model_.node_mass.begin(), model_.node_mass.end());

    pinball_contact_mesh mesh = contact_mesh();
    mesh.node_count = model_.nodes.count;
    mesh.mass = node_mass.data();
    mesh.element_count = static_cast<std::int64_t>(slots_.size());
    mesh.corners = corners_.data();
    mesh.body = body_.data();
    mesh.bulk_modulus = bulk_modulus_.data();
    mesh.element_mass = mass_.data();
    mesh.element_volume = volume_.data();
    mesh.hidden_faces = hidden_.data();
    mesh.tile_offsets = tile_first_.data();
    mesh.tile_count = static_cast<std::int64_t>(tile_first_.size()) - 1;
    pinball_contact_options options = options_of(model_.scene.contact);
    options.number = std::is_same_v<S, float> ? PINBALL_CONTACT_FLOAT : PINBALL_CONTACT_DOUBLE;
    options.index = sizeof(Index) == 8 ? PINBALL_CONTACT_INT64 : PINBALL_CONTACT_INT32;
    options.first_index = first_index;
    options.threads = threads;
    const std::size_t n = node_mass.size();
    for (std::vector<S>* array : {&position_, &velocity_, &force_}) array->resize(3 * n);
    return {options, mesh, load().position};
  }

  void flag_elements() {
    const ModelSurface<S> of_model(model_);
    eroded_ = 0;
    for (std::size_t i = 0; i < slots_.size(); ++i) {
      const auto slot = static_cast<std::size_t>(slots_[i]);
      const bool dead =
          !(model_.elements.mass[slot] > S(0)) || out_[static_cast<std::size_t>(model_.element_of_slot[slot])];
      alive_[i] = dead ? 0 : of_model.may_soon_erode(slots_[i]) ? 2 : 1;
      eroded_ += dead;
    }
  }

  /// Place of component k of a node in the arrays of the layout that are not records.
  std::size_t place(std::size_t node, std::size_t k) const {
    return layout_ == Layout::separate ? k * model_.node_mass.size() + node : 3 * node + k;
  }
  template <class Vectors, class Records>
  Vectors vectors(Records& records, std::vector<S>& mirror) {
    if (layout_ == Layout::records) return {records.data(), records.data() + 1, records.data() + 2, 4};
    for (std::size_t n = 0; n < model_.node_mass.size(); ++n) {
      for (std::size_t k = 0; k < 3; ++k) mirror[place(n, k)] = records[4 * n + k];
    }
    return {mirror.data() + place(0, 0), mirror.data() + place(0, 1), mirror.data() + place(0, 2),
            layout_ == Layout::separate ? 1 : 3};
  }
  pinball_contact_arrays load() {
    pinball_contact_arrays arrays = contact_arrays();
    arrays.position = vectors<pinball_contact_input>(model_.nodes.position, position_);
    arrays.velocity = vectors<pinball_contact_input>(model_.nodes.velocity, velocity_);
    arrays.force = vectors<pinball_contact_output>(model_.nodes.force, force_);
    arrays.force_records = layout_ == Layout::records;
    arrays.alive = alive_.data();
    return arrays;
  }
  void store() {
    if (layout_ == Layout::records) return;
    for (std::size_t n = 0; n < model_.node_mass.size(); ++n) {
      for (std::size_t k = 0; k < 3; ++k) model_.nodes.force[4 * n + k] = force_[place(n, k)];
    }
  }

  Model<S> model_;
  InternalForces<S> internal_;
  Schedule<S> schedule_;
  Layout layout_;
  std::vector<std::int64_t> slots_;  ///< of the elements handed over
  std::vector<Index> corners_;
  std::vector<std::int32_t> body_;
  std::vector<S> bulk_modulus_, mass_, volume_;
  std::vector<std::uint8_t> hidden_, alive_;
  std::vector<bool> out_;
  std::vector<std::int64_t> tile_first_;
  std::vector<S> position_, velocity_, force_;
  double dt_before_ = 0;
  std::int64_t eroded_ = 0;
  pinball_contact_result result_{};
  EmbeddedContact contact_;  ///< the last: it reads the arrays above
};

/// A rod hits a plate and breaks through: self-contact, erosion, and lists that are built anew.
inline Scene breaking_plate(ContactMethod method, Enforcement enforcement, ContactGap gap) {
  const double h = 0.1;
  Scene scene = scene_of(
      {block("plate", {8, 8, 3}, h, {0, 0, 0}), block("rod", {2, 2, 8}, h, {0.27, 0.31, 3.1 * h}, {300, 0, -2000})},
      4e-4);
  scene.materials = {plastic_material("steel", 1e9, 0.6)};
  scene.contact.method = method;
  scene.contact.enforcement = enforcement;
  scene.contact.gap = gap;
  return scene;
}

}  // namespace pinball::test
