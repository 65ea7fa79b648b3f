#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <pinball/kernels/exec.hpp>
#include <pinball/solver/contact_impulses.hpp>
#include <tuple>

namespace pinball {

namespace {

/// Share of a penetration that is pushed out in a step. Gaps close exactly; what is overlapping nevertheless (a normal
/// has turned, rows beside each other disagree) leaves gently, because pushing it out at once gives the nodes a
/// velocity of g/dt.
constexpr double push_out = 0.1;

constexpr int most_sweeps = 200;
constexpr double tolerance = 1e-9;  ///< of the sweeps, relative to the largest closing velocity

std::array<Vec3<double>, 8> corners_of(const auto& model, const std::array<std::int32_t, 8>& nodes) {
  std::array<Vec3<double>, 8> x;
  for (std::size_t i = 0; i < 8; ++i) {
    const auto* p = model.nodes.position.data() + 4 * static_cast<std::int64_t>(nodes[i]);
    x[i] = {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
  }
  return x;
}

ContactFace face_of(const auto& model, const std::array<std::int32_t, 8>& nodes, unsigned exposed,
                    const Vec3<double>& direction) {
  const std::array<Vec3<double>, 8> corners = corners_of(model, nodes);
  Vec3<double> x[8];
  std::copy(corners.begin(), corners.end(), x);
  return face_towards(x, exposed, direction);
}

template <class S>
Vec3<double> vector_at(const AlignedArray<S>& records, std::int32_t p) {
  const S* r = records.data() + 4 * static_cast<std::int64_t>(p);
  return {static_cast<double>(r[0]), static_cast<double>(r[1]), static_cast<double>(r[2])};
}

template <class S>
PinballNormal<double> normal_of(const PinballStore<S>& pinballs, std::int32_t p) {
  return {vector_at(pinballs.outward, p), vector_at(pinballs.two_sided, p)};
}

}  // namespace

template <class S>
ContactImpulses<S>::ContactImpulses(const Model<S>& model)
    : lagrange_(model.scene.contact.enforcement == Enforcement::lagrange),
      face_gap_(model.scene.contact.gap == ContactGap::face),
      node_place_(model.node_mass.size(), -1),
      held_first_(model.node_mass.size() + 1, 0) {
  std::vector<std::vector<std::array<double, 3>>> of_node(model.node_mass.size());
  const auto hold = [&of_node](std::int32_t node, const S* n) {
    of_node[static_cast<std::size_t>(node)].push_back(
        {static_cast<double>(n[0]), static_cast<double>(n[1]), static_cast<double>(n[2])});
  };
  for (const NodeConstraint<S>& c : model.constraints) hold(c.node, c.normal);
  for (const NodePrescription<S>& p : model.prescribed) hold(p.node, p.normal);
  for (std::size_t n = 0; n < of_node.size(); ++n) {
    held_.insert(held_.end(), of_node[n].begin(), of_node[n].end());
    held_first_[n + 1] = static_cast<std::int32_t>(held_.size());
  }
}

template <class S>
void ContactImpulses<S>::collect(const Model<S>& model, PinballStore<S>& pinballs, const NeighbourList<S>& list,
                                 const Surface& surface, double dt) {
  const auto takes_part = [&pinballs](std::int32_t p) {
    return pinballs.outward[4 * static_cast<std::size_t>(p) + 3] > S(0);
  };
  // Geometry of the pair p, q; p < q, so that each pair is met once.
  const auto row_of = [&](std::int32_t p, std::int32_t q, ContactRow& row) {
    const auto i = static_cast<std::size_t>(p), j = static_cast<std::size_t>(q);
    const Vec3<double> d = vector_at(pinballs.centre, p) - vector_at(pinballs.centre, q);
    const double reach = static_cast<double>(pinballs.centre[4 * i + 3] + pinballs.centre[4 * j + 3]);
    // Two cubes whose faces touch, the centre of one beside the corner of the other, are 1.25 radii apart if one is
    // five times as large. Balls have to overlap, but for what they approach within a step.
    const double far = (face_gap_ ? 1.35 : 1.1) * reach;
    if (dot(d, d) > far * far || !takes_part(q)) return false;
    if (face_gap_) {
      const ContactFace face1 = face_of(model, pinballs.corners[i], surface.exposed(pinballs.slot[i]), (-1.0) * d);
      const ContactFace face2 = face_of(model, pinballs.corners[j], surface.exposed(pinballs.slot[j]), d);
      row = face_row(face1, face2);
      // Faces that look at each other are told by their own gap alone; edges and corners by the balls.
      if (row.nodes1 == 0 && face1.face >= 0 && face2.face >= 0 && dot(face1.normal, face2.normal) <= -0.5)
        return false;
    }
    if (row.nodes1 == 0) {
      const Vec3<double> n1 = unit_normal_towards(normal_of(pinballs, p), (-1.0) * d);
      const Vec3<double> n2 = unit_normal_towards(normal_of(pinballs, q), d);
      row = pinball_row(d, reach, n1, n2);
    }
    return row.nodes1 > 0 && row.depth > -0.25 * reach;
  };

  struct Found {
    std::int32_t pinball1, pinball2;
    ContactRow row;
  };
  constexpr std::int64_t pieces = 64;
  std::array<std::vector<Found>, pieces> found;
  parallel_for("contact rows", RangePolicy<>{0, pieces}, [&](std::int64_t piece) {
    const std::int64_t n = pinballs.count;
    for (auto p = static_cast<std::int32_t>(n * piece / pieces); p < n * (piece + 1) / pieces; ++p) {
      if (!takes_part(p)) continue;
      const std::int32_t* neighbour = list.neighbours(p);
      for (std::int32_t k = 0; k < list.count(p); ++k) {
        Found f{p, neighbour[k], {}};
        if (f.pinball2 > p && row_of(p, f.pinball2, f.row)) found[static_cast<std::size_t>(piece)].push_back(f);
      }
    }
  });

  rows_.clear();
  pairs_.clear();
  nodes_.clear();
  node_.clear();
  for (const std::vector<Found>& some : found) {
    for (const Found& f : some) add_row(pinballs, f.pinball1, f.pinball2, f.row);
  }
  for (const std::int32_t n : node_) node_place_[static_cast<std::size_t>(n)] = -1;
  for (std::size_t i = 0; i < rows_.size(); ++i) limit_depth(model, i, dt);
}

template <class S>
void ContactImpulses<S>::add_row(const PinballStore<S>& pinballs, std::int32_t p, std::int32_t q,
                                 const ContactRow& contact) {
  const auto i = static_cast<std::size_t>(p), j = static_cast<std::size_t>(q);
  ImpulseRow row{};
  row.nodes = contact.nodes1 + contact.nodes2;
  for (int k = 0; k < row.nodes; ++k) {
    const bool first = k < contact.nodes1;
    const int at = first ? k : k - contact.nodes1;
    const std::int32_t node = first ? pinballs.corners[i][static_cast<std::size_t>(contact.corner1[at])]
                                    : pinballs.corners[j][static_cast<std::size_t>(contact.corner2[at])];
    std::int32_t& place = node_place_[static_cast<std::size_t>(node)];
    if (place < 0) {
      place = static_cast<std::int32_t>(node_.size());
      node_.push_back(node);
    }
    row.node[k] = place;
    row.weight[k] = first ? -contact.weight1[at] : contact.weight2[at];
  }
  row.direction[0] = contact.direction.x;
  row.direction[1] = contact.direction.y;
  row.direction[2] = contact.direction.z;
  Pair pair{p, q, contact.depth, 0, 0, {pinballs.slot[i], pinballs.slot[j], 0, 0, 0}};
  const auto before = std::lower_bound(memory_.begin(), memory_.end(), pair.memory, Memory::earlier);
  if (before != memory_.end() && !Memory::earlier(pair.memory, *before)) pair.memory = *before;
  rows_.push_back(row);
  pairs_.push_back(pair);
}

/// The depth of a pair grows by approach alone. Erosion exposes a face deep inside another body, a distorted element
/// turns another face to its partner: such depths are not pushed out.
template <class S>
void ContactImpulses<S>::limit_depth(const Model<S>& model, std::size_t i, double dt) {
  const ImpulseRow& row = rows_[i];
  double approach = 0;
  for (int k = 0; k < row.nodes; ++k) {
    const auto place = 4 * static_cast<std::size_t>(node_[static_cast<std::size_t>(row.node[k])]);
    for (std::size_t c = 0; c < 3; ++c) {
      approach += row.weight[k] * row.direction[c] * static_cast<double>(model.nodes.velocity[place + c]);
    }
  }
  Pair& pair = pairs_[i];
  pair.rate_before = approach;
  if (pair.depth > 0) pair.depth = std::min(pair.depth, pair.memory.depth + std::max(0.0, approach) * dt);
  pair.memory.depth = std::max(0.0, pair.depth);
}

/// Velocities v* and what held directions leave of the inverse masses.
template <class S>
void ContactImpulses<S>::load_nodes(const Model<S>& model, double velocity_step) {
  nodes_.assign(node_.size(), {});
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const auto n = static_cast<std::size_t>(node_[i]);
    const auto m = static_cast<double>(model.nodes.inverse_mass[n]);
    double* a = nodes_[i].inverse_mass;
    a[0] = a[1] = a[2] = m;
    for (std::int32_t h = held_first_[n]; h < held_first_[n + 1]; ++h) {
      const auto [x, y, z] = held_[static_cast<std::size_t>(h)];
      a[0] -= m * x * x;
      a[1] -= m * y * y;
      a[2] -= m * z * z;
      a[3] -= m * x * y;
      a[4] -= m * y * z;
      a[5] -= m * z * x;
    }
    for (std::size_t c = 0; c < 3; ++c) {
      nodes_[i].velocity[c] = static_cast<double>(model.nodes.velocity[4 * n + c]) +
                              velocity_step * m * static_cast<double>(model.nodes.force[4 * n + c]);
    }
  }
}

/// Rows that nothing drives together only cost time.
template <class S>
void ContactImpulses<S>::drop_rows_apart() {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const Pair& pair = pairs_[i];
    const bool known = pair.memory.force > 0 || pair.depth > 0;
    const bool near = known || pair.rate_free + rows_[i].position_rate > -std::abs(pair.rate_free);
    if (!near || !(rows_[i].inverse_mass > 0)) continue;
    rows_[kept] = rows_[i];
    pairs_[kept++] = pair;
  }
  rows_.resize(kept);
  pairs_.resize(kept);
}

template <class S>
void ContactImpulses<S>::solve_coupled() {
  double scale = 0;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    scale = std::max({scale, pairs_[i].rate_free + rows_[i].position_rate, pairs_[i].rate_before});
    apply_impulse(rows_[i], rows_[i].impulse, nodes_.data());  // begin with those of the step before
  }
  const auto count = static_cast<std::int64_t>(rows_.size());
  for (int sweep = 0; sweep < most_sweeps; ++sweep) {
    if (gauss_seidel_sweep(rows_.data(), count, nodes_.data()) <= tolerance * scale) break;
  }
}

template <class S>
void ContactImpulses<S>::release(double velocity_step) {
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    ImpulseRow& row = rows_[i];
    Pair& pair = pairs_[i];
    if (!(pair.memory.force > 0) || row.impulse > 0 || pair.rate_free + row.position_rate > 0) continue;
    // Largest p for which 1/2 p (rate_before + rate - p inverse_mass) >= -lost.
    const double sum = pair.rate_before + closing_rate(row, nodes_.data());
    const double root = std::sqrt(sum * sum + 8 * std::max(0.0, pair.memory.lost) * row.inverse_mass);
    const double missing = std::min(0.5 * pair.memory.force * velocity_step, (sum + root) / (2 * row.inverse_mass));
    if (!(missing > 0)) continue;
    apply_impulse(row, missing, nodes_.data());
    row.impulse = missing;
    pair.memory.force = -1;  // so that it does not count as a contact at the next step
  }
}

template <class S>
ImpulseResult ContactImpulses<S>::solve(Model<S>& model, PinballStore<S>& pinballs, const StepLengths& step) {
  ImpulseResult result;
  result.dissipated = pending_;
  pending_ = 0;
  std::fill(pinballs.force.data(), pinballs.force.data() + pinballs.force.size(), S(0));
  const double velocity_step = step.velocity(), dt = step.after;
  if (velocity_step == 0) rows_.clear();
  load_nodes(model, velocity_step);
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    ImpulseRow& row = rows_[i];
    Pair& pair = pairs_[i];
    const double reach = static_cast<double>(pinballs.centre[4 * static_cast<std::size_t>(pair.pinball1) + 3] +
                                             pinballs.centre[4 * static_cast<std::size_t>(pair.pinball2) + 3]);
    result.penetration_ratio = std::max(result.penetration_ratio, pair.depth / reach);
    row.inverse_mass = row_inverse_mass(row, nodes_.data());
    if (dt > 0 && pair.depth > 0) {  // with no more energy than the pair has taken out
      const double energy_limit = std::sqrt(2 * std::max(0.0, pair.memory.lost) * row.inverse_mass);
      row.position_rate = std::min(push_out * pair.depth / dt, energy_limit);
    } else if (dt > 0) {
      row.position_rate = pair.depth / dt;
    } else {  // nothing moves any more: an open gap asks for nothing
      row.position_rate = pair.depth < -1e-9 * reach ? -std::numeric_limits<double>::infinity() : 0.0;
    }
    pair.rate_free = closing_rate(row, nodes_.data());
    row.impulse = std::max(0.0, pair.memory.force) * velocity_step;
  }
  drop_rows_apart();
  if (lagrange_) {
    solve_coupled();
  } else {
    project_velocities(rows_.data(), static_cast<std::int64_t>(rows_.size()), nodes_.data());
  }
  release(velocity_step);

  for (std::size_t i = 0; i < rows_.size(); ++i) {
    Pair& pair = pairs_[i];
    const double force = rows_[i].impulse / velocity_step, after = closing_rate(rows_[i], nodes_.data());
    const double in_step_before = 0.5 * force * step.before * pair.rate_before,
                 in_step_after = 0.5 * force * dt * after;
    result.dissipated += in_step_before;
    pending_ += in_step_after;
    result.pairs += force > 0;
    pair.memory.lost += in_step_before + in_step_after;
    pair.memory.force = pair.memory.force < 0 ? 0 : force;
  }
  add_forces(model, pinballs, velocity_step);
  remember();
  return result;
}

/// Forces that give the impulses within the step.
template <class S>
void ContactImpulses<S>::add_forces(Model<S>& model, PinballStore<S>& pinballs, double velocity_step) {
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const ImpulseRow& row = rows_[i];
    const double force = row.impulse / velocity_step;
    if (!(force > 0)) continue;
    S* force1 = pinballs.force.data() + 4 * static_cast<std::int64_t>(pairs_[i].pinball1);
    S* force2 = pinballs.force.data() + 4 * static_cast<std::int64_t>(pairs_[i].pinball2);
    for (int c = 0; c < 3; ++c) {
      force1[c] += static_cast<S>(force * row.direction[c]);
      force2[c] -= static_cast<S>(force * row.direction[c]);
    }
    for (int k = 0; k < row.nodes; ++k) {
      const auto n = static_cast<std::size_t>(node_[static_cast<std::size_t>(row.node[k])]);
      for (std::size_t c = 0; c < 3; ++c) {
        model.nodes.force[4 * n + c] -= static_cast<S>(force * row.weight[k] * row.direction[c]);
      }
    }
  }
}

template <class S>
void ContactImpulses<S>::remember() {
  memory_.clear();
  for (const Pair& pair : pairs_) {
    if (pair.memory.force > 0 || pair.memory.depth > 0) memory_.push_back(pair.memory);
  }
  std::sort(memory_.begin(), memory_.end(), Memory::earlier);
}

template <class S>
std::size_t ContactImpulses<S>::bytes() const {
  const auto of = [](const auto& v) { return v.capacity() * sizeof(v[0]); };
  return of(rows_) + of(pairs_) + of(nodes_) + of(node_) + of(memory_) + of(node_place_) + of(held_) + of(held_first_);
}

template class ContactImpulses<double>;
template class ContactImpulses<float>;

}  // namespace pinball
