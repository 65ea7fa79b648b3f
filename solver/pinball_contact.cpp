#include <algorithm>
#include <cmath>
#include <pinball/kernels/exec.hpp>
#include <pinball/solver/pinball_contact.hpp>
#include <pinball/solver/pinball_pairs.hpp>

namespace pinball {

template <class S>
PinballContact<S>::PinballContact(const Model<S>& model)
    : Contact<S>(model), surface_(model), reference_centre_(static_cast<std::size_t>(model.elements.slots)) {
  const ContactSettings& contact = model.scene.contact;
  penalty_ = {static_cast<S>(contact.beta), static_cast<S>(contact.damping)};
  // A damped spring is stable for dt <= 2/w (sqrt(1 + xi^2) - xi): as an undamped one of the higher frequency.
  const double xi = contact.damping;
  damping_factor_ = 1.0 / std::pow(std::sqrt(1 + xi * xi) - xi, 2);
  for (std::size_t e = 0; e < model.mesh.hexahedra.size(); ++e) {
    Point c{};
    for (const std::int32_t node : model.mesh.hexahedra[e]) {
      for (std::size_t k = 0; k < 3; ++k) c[k] += model.mesh.nodes[static_cast<std::size_t>(node)][k] / 8;
    }
    reference_centre_[static_cast<std::size_t>(model.slot_of_element[e])] = {
        static_cast<float>(c[0]), static_cast<float>(c[1]), static_cast<float>(c[2])};
  }
  for (const Part& part : model.parts) may_erode_ = may_erode_ || part.features.erosion;
  collect_pinballs(model);
}

template <class S>
void PinballContact<S>::collect_pinballs(const Model<S>& model) {
  constexpr int W = ElementStore<S>::width;
  is_pinball_.assign(static_cast<std::size_t>(surface_.slots()), 0);
  std::int32_t n = 0;
  const auto choose = [&](std::int64_t slot) {
    std::uint8_t& chosen = is_pinball_[static_cast<std::size_t>(slot)];
    n += chosen == 0;
    chosen = 1;
  };
  for (std::int64_t slot = 0; slot < surface_.slots(); ++slot) {
    if (surface_.exposed(slot) == 0) continue;
    choose(slot);
    if (!may_erode_) continue;
    for (int f = 0; f < 6; ++f) {
      const std::int32_t behind = surface_.neighbour(slot, f);
      if (behind >= 0 && surface_.alive(behind)) choose(behind);
    }
  }
  pinballs_ = PinballStore<S>();  // not both at a time
  pinballs_ = PinballStore<S>(n, W);
  for (std::int32_t tile = 0; tile < model.tile_count(); ++tile) {
    const auto t = static_cast<std::size_t>(tile);
    pinballs_.tile_first.push_back(static_cast<std::int32_t>(pinballs_.slot.size()));
    const Material& material = model.scene.materials[static_cast<std::size_t>(model.tile_part[t])];
    for (std::int64_t slot = model.tile_packs[t] * W; slot < model.tile_packs[t + 1] * W; ++slot) {
      if (is_pinball_[static_cast<std::size_t>(slot)] == 0) continue;
      const auto p = pinballs_.slot.size();
      const auto e = static_cast<std::size_t>(model.element_of_slot[static_cast<std::size_t>(slot)]);
      pinballs_.slot.push_back(static_cast<std::int32_t>(slot));
      pinballs_.body.push_back(model.mesh.body[e]);
      const double volume = model.element_mass[e] / material.density;
      pinballs_.bulk_modulus[p] = static_cast<S>(material.bulk_modulus);
      pinballs_.centre[4 * p + 3] =
          static_cast<S>(model.scene.contact.radius_factor * std::cbrt(volume * 3.0 / (4.0 * M_PI)));  // (3.2)
      pinballs_.velocity[4 * p + 3] = static_cast<S>(model.element_mass[e]);
      for (int i = 0; i < 8; ++i) {
        pinballs_.corners[p][static_cast<std::size_t>(i)] = model.elements.corner[ElementStore<S>::at(slot, i, 8)];
      }
    }
  }
  pinballs_.tile_first.push_back(n);
  const std::int32_t padded = (n + W - 1) / W * W;
  for (std::int32_t p = 0; p < padded; ++p) {  // padding repeats the corners of the last pinball
    const std::array<std::int32_t, 8>& corners = pinballs_.corners[static_cast<std::size_t>(std::min(p, n - 1))];
    for (int i = 0; i < 8; ++i) pinballs_.corner[ElementStore<S>::at(p, i, 8)] = corners[static_cast<std::size_t>(i)];
  }
  update_exposure();
  surface_changed_ = false;
  list_.invalidate();
}

template <class S>
void PinballContact<S>::update_exposure() {
  active_ = 0;
  for (std::int32_t p = 0; p < pinballs_.count; ++p) {
    const auto i = static_cast<std::size_t>(p);
    const std::uint8_t exposed = surface_.exposed(pinballs_.slot[i]);
    for (int f = 0; f < 6; ++f) {
      pinballs_.exposed[ElementStore<S>::at(p, f, 6)] = (exposed >> f & 1) != 0 ? S(1) : S(0);
    }
    pinballs_.outward[4 * i + 3] = exposed != 0 ? pinballs_.bulk_modulus[i] * pinballs_.centre[4 * i + 3] : S(0);
    active_ += exposed != 0;
  }
}

template <class S>
void PinballContact<S>::update_surface(const Model<S>& model, const std::vector<TileResult<S>>& tiles) {
  lost_energy_ = 0;
  if (surface_.remove_eroded(model, tiles)) {
    update_exposure();
    lost_energy_ = list_.end_pairs_of_inactive(pinballs_);
    bool missing = false;
    for (std::int64_t slot = 0; slot < surface_.slots(); ++slot) {
      missing = missing || (surface_.exposed(slot) != 0 && is_pinball_[static_cast<std::size_t>(slot)] == 0);
    }
    surface_changed_ = true;
    if (missing) collect_pinballs(model);
  }
  update_geometry(model);
}

template <class S>
void PinballContact<S>::update_geometry(const Model<S>& model) {
  using T = Pack<S, native_width<S>>;
  const PinballGeometryView<S> view = pinballs_.geometry();
  const S* position = model.nodes.position.data();
  const S* velocity = model.nodes.velocity.data();
  const RangePolicy<> packs{0, (pinballs_.count + width_of<T> - 1) / width_of<T>};
  if (model.scene.contact.radius == ContactRadius::current) {
    parallel_for("pinballs", packs,
                 [&](std::int64_t pack) { update_pinball_pack<T, true>(view, position, velocity, pack); });
  } else {
    parallel_for("pinballs", packs,
                 [&](std::int64_t pack) { update_pinball_pack<T, false>(view, position, velocity, pack); });
  }
}

template <class S>
void PinballContact<S>::search(const Model<S>& model) {
  if (model.scene.skip.contact_search && list_.holds(pinballs_)) {
    ++this->searches_skipped_;
    return;
  }
  ++this->searches_;
  if (surface_changed_) {  // a good moment to take in the elements behind the new surface
    collect_pinballs(model);
    update_geometry(model);
  }
  S largest = 0;
  for (std::int32_t p = 0; p < pinballs_.count; ++p) {
    largest = std::max(largest, pinballs_.centre[4 * static_cast<std::size_t>(p) + 3]);
  }
  const S skin = model.scene.skip.contact_search ? static_cast<S>(model.scene.contact.skin) * largest : S(0);
  const S reach_factor = this->by_impulses() ? static_cast<S>(pinball_pair_margin(model.scene.contact.gap)) : S(1);
  list_.build(pinballs_, reach_factor, skin, {model.scene.contact.self, &reference_centre_});
}

template <class S>
void PinballContact<S>::prepare_impulses(const Model<S>& model, double dt) {
  this->impulses_->collect(model, pinball_pairs(model, pinballs_, list_, surface_), dt);
}

template <class S>
ContactResult PinballContact<S>::forces(const Model<S>& /*model*/, S dt) {
  using T = Pack<S, native_width<S>>;
  const PinballView<S> view = pinballs_.view();
  S* force = pinballs_.force.data();
  struct Sums {
    double stored = 0, damped = 0;
    S ratio = 0;
    std::int64_t pairs = 0;
  } sums;
  parallel_reduce(
      "contact forces", RangePolicy<>{0, pinballs_.count}, sums,
      [&](std::int64_t begin, std::int64_t end, Sums& partial) {
        for (std::int64_t i = begin; i < end; ++i) {
          const auto p = static_cast<std::int32_t>(i);
          PinballForce<S> f;
          if (view.outward[4 * i + 3] > S(0))
            f = pinball_force<T>(view, penalty_, p, list_.neighbours(p), list_.count(p), list_.offsets(p),
                                 list_.stored(p), dt);
          force[4 * i] = f.force.x;
          force[4 * i + 1] = f.force.y;
          force[4 * i + 2] = f.force.z;
          force[4 * i + 3] = f.stiffness;
          partial.stored += static_cast<double>(f.stored);
          partial.damped += static_cast<double>(f.damped);
          partial.ratio = maximum(partial.ratio, f.penetration_ratio);
          partial.pairs += f.pairs;
        }
      },
      [](Sums& result, const Sums& partial) {
        result.stored += partial.stored;
        result.damped += partial.damped;
        result.ratio = maximum(result.ratio, partial.ratio);
        result.pairs += partial.pairs;
      });
  ContactResult result;
  result.stored = sums.stored;
  result.eroded = lost_energy_;
  result.damped_power = sums.damped;
  result.penetration_ratio = static_cast<double>(sums.ratio);
  result.pairs = sums.pairs / 2;
  return result;
}

template <class S>
void PinballContact<S>::scatter(Model<S>& model, ContactResult& result) {
  if (result.pairs == 0) return;
  const Colouring& colours = model.tile_colours;
  const S* force = pinballs_.force.data();
  S* nodal_force = model.nodes.force.data();
  const auto corner = [this](std::int32_t p, int i) { return pinballs_.corner[ElementStore<S>::at(p, i, 8)]; };
  parallel_for_coloured("contact scatter", DefaultExecutionSpace{}, colours.colour_offsets.data(),
                        static_cast<std::int32_t>(colours.colour_offsets.size()) - 1, colours.items.data(),
                        [&](std::int32_t tile) {
                          const auto t = static_cast<std::size_t>(tile);
                          for (std::int32_t p = pinballs_.tile_first[t]; p < pinballs_.tile_first[t + 1]; ++p) {
                            const S* f = force + 4 * static_cast<std::int64_t>(p);
                            if (!(f[3] > S(0))) continue;
                            for (int i = 0; i < 8; ++i) {
                              S* node = nodal_force + 4 * static_cast<std::int64_t>(corner(p, i));
                              for (int k = 0; k < 3; ++k) node[k] += S(0.125) * f[k];  // (3.12)
                              node[3] += S(0.25) * f[3];
                            }
                          }
                        });
  // Gershgorin: a pair of stiffness p2 enters the row of each of its 16 nodes with p2/8 (8/8 + 8/8) / m_I.
  S largest = 0;
  parallel_reduce(
      "contact frequency", RangePolicy<>{0, pinballs_.count}, largest,
      [&](std::int64_t begin, std::int64_t end, S& partial) {
        for (std::int64_t p = begin; p < end; ++p) {
          if (!(force[4 * p + 3] > S(0))) continue;
          for (int i = 0; i < 8; ++i) {
            const auto node = static_cast<std::size_t>(corner(static_cast<std::int32_t>(p), i));
            const S row = nodal_force[4 * node + 3] * model.nodes.inverse_mass[node];
            partial = row > partial ? row : partial;
          }
        }
      },
      [](S& whole, const S& partial) { whole = partial > whole ? partial : whole; });
  result.frequency2 = damping_factor_ * static_cast<double>(largest);
}

template <class S>
void PinballContact<S>::report(const Model<S>& /*model*/, std::vector<Point>& node_force,
                               std::vector<double>& slot_radius) const {
  for (std::size_t p = 0; p < static_cast<std::size_t>(pinballs_.count); ++p) {
    if (!(pinballs_.outward[4 * p + 3] > S(0))) continue;  // behind the surface, or eroded
    slot_radius[static_cast<std::size_t>(pinballs_.slot[p])] = static_cast<double>(pinballs_.centre[4 * p + 3]);
    for (const std::int32_t node : pinballs_.corners[p]) {
      for (std::size_t k = 0; k < 3; ++k) {
        node_force[static_cast<std::size_t>(node)][k] += static_cast<double>(pinballs_.force[4 * p + k]) / 8;
      }
    }
  }
  if (this->by_impulses()) this->impulses_->add_node_forces(node_force);
}

template <class S>
std::size_t PinballContact<S>::bytes() const {
  return pinballs_.bytes() + list_.bytes() + surface_.bytes() + (this->by_impulses() ? this->impulses_->bytes() : 0);
}

template class PinballContact<double>;
template class PinballContact<float>;

}  // namespace pinball
