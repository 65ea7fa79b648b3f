#include "body_energies.hpp"

#include <array>
#include <numeric>

#include <kernels/exec.hpp>

namespace pinball {

template <class S>
BodyEnergies<S>::BodyEnergies(const Model<S>& model, Subdomain<S>* domain) {
  if (!model.scene.output.body_energies) return;
  const std::size_t bodies = model.scene.bodies.size();
  std::vector<std::int32_t> group(bodies);
  std::iota(group.begin(), group.end(), 0);
  shares_ = mass_shares(model, group, bodies);
  for (const MassShares& body : shares_) {
    std::vector<double>& mass = mass_.emplace_back();
    for (std::size_t i = 0; i < body.nodes.size(); ++i) mass.push_back(body.share[i] * model.node_mass[body.nodes[i]]);
  }
  energies_.resize(bodies);
  if (domain == nullptr) return;
  for (const MassShares& body : shares_) {
    pieces_.push_back(domain->blocks(fixed_pieces, [&body](std::int64_t p, const auto& take) {
      const std::int64_t count = std::ssize(body.nodes);
      for (std::int64_t i = count * p / fixed_pieces; i < count * (p + 1) / fixed_pieces; ++i) take(body.nodes[i]);
    }));
  }
}

template <class S>
void BodyEnergies<S>::book(const Model<S>& model, const std::vector<TileResult<S>>& tiles) {
  if (!any()) return;
  for (std::size_t t = 0; t < tiles.size(); ++t) {
    Sums& body = energies_[model.tile_body[t]];
    body.internal += tiles[t].internal - tiles[t].eroded;
    body.hourglass += tiles[t].hourglass;
    body.bulk_viscosity += tiles[t].viscous;
  }
}

namespace {

/// Twice the kinetic energy of some nodes of a body, first ... end - 1; there once in machine code, whoever adds up the
/// pieces.
template <class S>
PINBALL_ONE_COPY double kinetic_of_nodes(const Model<S>& model, const MassShares& body, std::int64_t first,
                                         std::int64_t end, S energy_step) {
  const NodeStore<S>& nodes = model.nodes;
  double sum = 0;
  for (std::int64_t index = first; index < end; ++index) {
    const std::size_t i = index, n = body.nodes[i];
    const S factor = energy_step * nodes.inverse_mass[n];
    S v2 = 0;
    for (std::size_t k = 4 * n; k < 4 * n + 3; ++k)
      v2 += nodes.velocity[k] * (nodes.velocity[k] + factor * nodes.force[k]);
    sum += body.share[i] * model.node_mass[n] * static_cast<double>(v2);
  }
  return sum;
}

}  // namespace

template <class S>
void BodyEnergies<S>::take_kinetic(const Model<S>& model, const StepLengths& step) {
  const auto energy_step = static_cast<S>(step.before);
  for (std::size_t b = 0; b < shares_.size(); ++b) {
    const MassShares& body = shares_[b];
    std::array<double, fixed_pieces> of_piece{};
    const auto sum = [&](std::int64_t p) {
      const std::int64_t count = std::ssize(body.nodes);
      of_piece[p] =
          kinetic_of_nodes(model, body, count * p / fixed_pieces, count * (p + 1) / fixed_pieces, energy_step);
    };
    if (pieces_.empty()) {
      parallel_for("energy of a body", RangePolicy<>{0, fixed_pieces}, sum);
    } else {
      for (const SharedBlocks::Run& run : pieces_[b]->worked())
        parallel_for("energy of a body", RangePolicy<>{run.begin, run.end}, sum);
      pieces_[b]->gather(of_piece.data());
    }
    double twice = 0;
    for (const double piece : of_piece) twice += piece;
    energies_[b].kinetic = 0.5 * twice;
  }
}

template <class S>
std::vector<BodyShare> BodyEnergies<S>::results(const Model<S>& model) const {
  std::vector<BodyShare> results;
  for (std::size_t b = 0; b < shares_.size(); ++b) {
    const Sums& e = energies_[b];
    BodyShare& body = results.emplace_back(BodyShare{e.kinetic, e.internal, e.hourglass, e.bulk_viscosity, 0, {}});
    for (std::size_t i = 0; i < shares_[b].nodes.size(); ++i) {
      const S* v = model.nodes.velocity_of(shares_[b].nodes[i]);
      body.mass += mass_[b][i];
      for (std::size_t k = 0; k < 3; ++k) body.momentum[k] += mass_[b][i] * v[k];
    }
  }
  return results;
}

template <class S>
std::size_t BodyEnergies<S>::bytes() const {
  std::size_t sum = 0;
  for (const MassShares& body : shares_) sum += body.nodes.size() * (sizeof(std::int32_t) + 2 * sizeof(double));
  return sum;
}

template class BodyEnergies<double>;
template class BodyEnergies<float>;

}  // namespace pinball
