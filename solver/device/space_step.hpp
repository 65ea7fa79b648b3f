#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <kernels/corner_sums.hpp>
#include <kernels/node_update.hpp>

#include "device_step.hpp"
#include "space_elements.hpp"
#include "space_halo.hpp"
#include "space_records.hpp"
#include "space_resting.hpp"
#include "space_volumes.hpp"

/// DeviceStep on an execution space. Its functors hold pointers and numbers alone, and are handed over by value.
namespace pinball {

template <class S>
struct SumsCornerForces {
  CornersOfNodes corners;
  const S* corner_force;
  S* force;
  PINBALL_FUNCTION void operator()(std::int64_t n) const {
    add_corner_forces<device_row>(corners, corner_force, n, force + 4 * n);
  }
};

/// Nodes as integration sees them.
template <class S>
struct MovingNodes {
  S *position, *velocity, *force;
  const S* inverse_mass;
  const double* mass;
  S velocity_step, position_step, energy_step;

  PINBALL_FUNCTION void integrate(std::int64_t n, S* with_force, MotionEnergy& sum) const {
    sum.add(mass[n], integrate_node(position + 4 * n, velocity + 4 * n, with_force, inverse_mass[n], velocity_step,
                                    position_step, energy_step));
  }
};

template <class S>
struct IntegratesNodes {
  MovingNodes<S> nodes;
  PINBALL_FUNCTION void operator()(std::int64_t n, MotionEnergy& sum) const {
    nodes.integrate(n, nodes.force + 4 * n, sum);
  }
};

/// In one sweep: the sums of corner forces need not be stored.
template <class S>
struct SumsAndIntegrates {
  MovingNodes<S> nodes;
  CornersOfNodes corners;
  const S* corner_force;
  PINBALL_FUNCTION void operator()(std::int64_t n, MotionEnergy& sum) const {
    alignas(4 * sizeof(S)) S force[4] = {};
    add_corner_forces<device_row>(corners, corner_force, n, force);
    nodes.integrate(n, force, sum);
  }
};

template <class S, class Space>
class SpaceStep final : public DeviceStep<S> {
  using Memory = typename Space::memory_space;

 public:
  explicit SpaceStep(const DeviceMesh<S>& mesh)
      : nodes_(mesh.nodes),
        tiles_(mesh.tiles),
        is_shared_(mesh.is_shared),
        material_numbers_(mesh.material_numbers),
        tile_(copy_of(mesh.tile)),
        corner_(copy_of(mesh.corner)),
        mass_share_(copy_of(mesh.mass_share)),
        folding_onset_(copy_of(mesh.folding_onset)),
        inverse_mass_(copy_of(mesh.inverse_mass)),
        node_mass_(copy_of(mesh.node_mass)),
        first_of_node_(copy_of(mesh.first_of_node)),
        corners_of_node_(copy_of(mesh.corners_of_node)),
        force_(4 * static_cast<std::size_t>(mesh.nodes)),
        corner_force_(24 * static_cast<std::size_t>(mesh.places)),
        left_(static_cast<std::size_t>(mesh.places)),
        volumes_(mesh.volumes) {
    for (const DevicePart<S>& part : mesh.parts) add_part(part);
    resting_.set({}, tiles_, is_shared_);
  }

  void write(const DeviceState<S>& state) override {
    state_.with(state, [](auto& mine, const auto& theirs) {
      if (mine.size() != theirs.size()) mine.reset(theirs.size());
      deep_copy(mine, theirs);
    });
    eroded_.begin(state_.mass);
  }
  void read(DeviceState<S>& state) const override {
    state.with(state_, [](auto& theirs, const auto& mine) {
      if (theirs.size() != mine.size()) theirs.renew(mine.size());
      deep_copy(theirs, mine);
    });
  }

  ElementTotals<S> update_elements(const ElementStep<S>& step) override { return update_parts(step, nullptr); }
  ElementTotals<S> update_elements(const ElementStep<S>& step, Array<S>& rates) override {
    Array<S, Memory> kept(tile_.size() * widest_pack<S>);
    const ElementTotals<S> totals = update_parts(step, kept.data());
    rates.renew(kept.size());
    deep_copy(rates, kept);
    return totals;
  }

  void set_resting(const DeviceResting<S>& tiles) override { resting_.set(tiles, tiles_, is_shared_); }
  RestingTotals<S> wake() override { return resting_.wake(state_.velocity.data()); }
  std::vector<std::uint8_t> read_resting() const override { return resting_.read(); }

  NodeArrays<S> nodes() override {
    return {state_.position.data(), state_.velocity.data(), force_.data(),
            inverse_mass_.data(),   node_mass_.data(),      state_.mass.data()};
  }

  void sum_corner_forces() override {
    parallel_for("sums of corner forces", all_nodes(),
                 SumsCornerForces<S>{corners(), corner_force_.data(), force_.data()});
    summed_ = true;
  }

  MotionEnergy integrate(const StepLengths& step) override {
    const MovingNodes<S> nodes = moving(step);
    MotionEnergy energy;
    if (summed_) {
      parallel_reduce("integration", all_nodes(), IntegratesNodes<S>{nodes}, energy);
    } else {
      parallel_reduce("sums of corner forces and integration", all_nodes(),
                      SumsAndIntegrates<S>{nodes, corners(), corner_force_.data()}, energy);
    }
    return energy;
  }

  void set_pieces(std::vector<SomePieces<S>> of_parts) override { pieces_ = std::move(of_parts); }
  std::vector<SomePieces<S>>& pieces_of_parts() override { return pieces_; }
  void set_halo(const DeviceHalo& halo) override {
    const auto places = static_cast<std::int64_t>(left_.size());
    halo_.set(halo, places);
    first_of_node_ = copy_of(halo.first_of_node);
    corners_of_node_ = copy_of(halo.corners_of_node);
    corner_force_.reset(24 * static_cast<std::size_t>(places + halo_.places_of(halo)));
  }
  const S* gather_volumes(Messages on) override {
    find_volumes();
    return volumes_.gather(on);
  }
  S* received_volumes(Messages on) override { return volumes_.received(on); }
  void scatter_volumes(Messages on) override { volumes_.scatter(on); }
  const S* gather_halo(Messages on) override { return halo_.gather(corner_force_.data(), on); }
  S* received_halo(Messages on) override { return halo_.received(on); }
  void scatter_halo(Messages on) override { halo_.scatter(corner_force_.data(), on); }
  void integrate(const StepLengths& step, PieceRange pieces, MotionEnergy* of_piece) override {
    const MovingNodes<S> nodes = moving(step);
    if (summed_) {
      reduce_pieces("integration", all_nodes(), pieces, IntegratesNodes<S>{nodes}, of_piece);
    } else {
      reduce_pieces("sums of corner forces and integration", all_nodes(), pieces,
                    SumsAndIntegrates<S>{nodes, corners(), corner_force_.data()}, of_piece);
    }
  }

  void read_nodes(S* position, S* velocity, S* force) const override {
    deep_copy(position, state_.position);
    deep_copy(velocity, state_.velocity);
    deep_copy(force, force_);
  }
  void write_nodes(const S* position, const S* velocity, const S* force) override {
    deep_copy(state_.position, position, state_.position.size());
    deep_copy(state_.velocity, velocity, state_.velocity.size());
    deep_copy(force_, force, force_.size());
  }

  void set_common(CommonSet of, const std::vector<std::int32_t>& nodes) override { records(of).set(nodes); }
  void read_common(CommonSet of, NodeNumbers which, Array<S>& numbers) override {
    records(of).read(common(which), numbers);
  }
  void write_common(CommonSet of, NodeNumbers which, const Array<S>& numbers) override {
    records(of).write(numbers, common(which));
  }
  void write_masses(const S* inverse_mass, const double* mass) override {
    deep_copy(inverse_mass_, inverse_mass, inverse_mass_.size());
    deep_copy(node_mass_, mass, node_mass_.size());
  }
  std::vector<std::int64_t> take_eroded() override { return eroded_.take(state_.mass.data()); }
  std::vector<S> read_numbers(StateNumbers of, const std::vector<std::int64_t>& places) const override {
    return numbers_at<Space>(places, array_of(of).data());
  }
  void set_bodies(BodyElements elements) override { bodies_.emplace(std::move(elements)); }
  std::vector<BodySum> body_sums() override {
    return bodies_->of({state_.velocity.data(), corner_.data(), state_.mass.data(),
                        state_.plastic_strain.empty() ? nullptr : state_.plastic_strain.data()});
  }
  const std::vector<ElementTotals<S>>& totals_of_parts() const override { return totals_of_parts_; }

  std::size_t bytes() const override {
    return corner_.bytes() + mass_share_.bytes() + folding_onset_.bytes() + inverse_mass_.bytes() + node_mass_.bytes() +
           first_of_node_.bytes() + corners_of_node_.bytes() + force_.bytes() + corner_force_.bytes() + state_.bytes() +
           left_.bytes() + tile_.bytes() + resting_.bytes() + halo_.bytes() + volumes_.bytes() + common_.bytes() +
           listed_.bytes() + own_.bytes() + eroded_.bytes() + (bodies_ ? bodies_->bytes() : 0);
  }

 private:
  SpaceRecords<S, Space>& records(CommonSet of) {
    if (of == CommonSet::own) return own_;
    return of == CommonSet::all ? common_ : listed_;
  }
  CommonRecords<S> common(NodeNumbers which) {
    return {which, state_.position.data(), state_.velocity.data(), force_.data()};
  }

  struct Part {
    ElementKernel<S> kernel;
    ElementConstants<S> constants;
    std::int64_t first, last;
  };

  ElementTotals<S> update_parts(const ElementStep<S>& step, S* rates) {
    ElementTotals<S> totals;
    totals_of_parts_.clear();
    if (volumes_.any()) {
      if (!is_shared_) find_volumes();  // else gather_volumes() has
      volumes_.average(state_.volume_ratio.data());
    }
    for (SomePieces<S>& pieces : pieces_) pieces.clear();
    for (const Part& part : parts_) {
      SomePieces<S>* const some = is_shared_ ? &pieces_[totals_of_parts_.size()] : nullptr;
      totals_of_parts_.push_back(part.kernel({elements(),
                                              {state_.position.data(), state_.velocity.data(), nullptr},
                                              part.constants,
                                              step,
                                              corner_force_.data(),
                                              {tile_.data(), resting_.rests(), resting_.updated()},
                                              rates,
                                              left_.data(),
                                              false,
                                              part.first,
                                              part.last},
                                             some));
      totals.join(totals_of_parts_.back());
    }
    summed_ = false;
    return totals;
  }

  /// Before the elements are worked: what the step before has left eroded does not count.
  void find_volumes() { volumes_.find(corner_.data(), state_.mass.data(), state_.position.data()); }

  MovingNodes<S> moving(const StepLengths& step) {
    return {state_.position.data(),     state_.velocity.data(),     force_.data(),
            inverse_mass_.data(),       node_mass_.data(),          static_cast<S>(step.velocity()),
            static_cast<S>(step.after), static_cast<S>(step.before)};
  }

  template <class T>
  static Array<T, Memory> copy_of(const Array<T>& array) {
    Array<T, Memory> copy(array.size());
    deep_copy(copy, array);
    return copy;
  }

  RangePolicy<Space> all_nodes() const { return {0, nodes_}; }
  CornersOfNodes corners() const { return {first_of_node_.data(), corners_of_node_.data()}; }
  ElementView<S> elements() {
    return {corner_.data(),
            state_.mass.data(),
            state_.stress.data(),
            state_.plastic_strain.data(),
            state_.hourglass_state.data(),
            state_.viscous_stress.data(),
            state_.internal_energy.data(),
            state_.material_state.data(),
            mass_share_.empty() ? nullptr : mass_share_.data(),
            folding_onset_.empty() ? nullptr : folding_onset_.data(),
            material_numbers_,
            state_.volume_ratio.data()};
  }

  const Array<S, Memory>& array_of(StateNumbers of) const {
    switch (of) {
      case StateNumbers::position:
        return state_.position;
      case StateNumbers::velocity:
        return state_.velocity;
      case StateNumbers::stress:
        return state_.stress;
      case StateNumbers::plastic_strain:
        break;
    }
    return state_.plastic_strain;
  }

  void add_part(const DevicePart<S>& part) {
    const bool general = is_general(part.features);
    parts_.push_back({choose_kernel(part.features), part.constants, part.first, part.last});
    if (!general) return;
    HardeningConstants<S>& h = parts_.back().constants.hardening;
    const auto points = static_cast<std::size_t>(h.points), curves = static_cast<std::size_t>(h.curves);
    h.strain = keep(h.strain, points);
    h.stress = keep(h.stress, points * curves);
    h.slope = keep(h.slope, points * curves);
    h.rate = keep(h.rate, curves);
  }
  static ElementKernel<S> choose_kernel(const ElementFeatures& f) {
    if (f.tetrahedra) return tetrahedron_kernel<S, Space>();
    return is_general(f) ? choose_general_kernel<S, Space>(f) : choose_linear_kernel<S, Space>(f);
  }
  /// A copy of a table of the host.
  const S* keep(const S* numbers, std::size_t count) {
    if (numbers == nullptr) return nullptr;
    deep_copy(tables_.emplace_back(count), numbers, count);
    return tables_.back().data();
  }

  std::int64_t nodes_;
  std::int32_t tiles_;
  bool is_shared_;
  int material_numbers_;
  Array<std::int32_t, Memory> tile_;
  Array<std::int32_t, Memory> corner_;
  Array<S, Memory> mass_share_, folding_onset_, inverse_mass_;
  Array<double, Memory> node_mass_;
  Array<std::uint32_t, Memory> first_of_node_, corners_of_node_;
  DeviceState<S, Memory> state_;
  Array<S, Memory> force_;            ///< of nodes, in records of four; zero between steps [force]
  Array<S, Memory> corner_force_;     ///< of KeptAtCorners [force]
  Array<std::uint8_t, Memory> left_;  ///< per pack; zero between steps
  SpaceResting<S, Space> resting_;
  SpaceHalo<S, Space> halo_;
  std::vector<SomePieces<S>> pieces_;  ///< of each part; empty: this process is alone
  SpaceRecords<S, Space> common_, listed_, own_;
  SpaceEroded<S, Space> eroded_;
  std::optional<SpaceBodySums<S, S, device_row, Space>> bodies_;
  SpaceVolumes<S, Space> volumes_;
  std::vector<Part> parts_;
  std::vector<ElementTotals<S>> totals_of_parts_;
  std::vector<Array<S, Memory>> tables_;
  bool summed_ = false;  ///< force_ has what the corners do
};

}  // namespace pinball
