#include "row_packs.hpp"

#include <algorithm>

namespace pinball {

namespace {

/// Entries of a colour, in packs, from which on a second thread gains more than the threads wait for each other, a
/// microsecond or, beside other work, much more. A sweep takes 2.5 ns for each entry, what is done once in a step ten
/// times as much.
constexpr std::int64_t entries_of_sweeps = 2048, entries_of_heavy_work = 256;

}  // namespace

RowPack RowPacks::pack(std::int64_t number) {
  const RowOrder::PackPlace& place = order_.packs()[static_cast<std::size_t>(number)];
  RowPack row;
  row.entries = place.entries;
  row.held = place.held;
  row.node = nodes_.data() + place.first_entry * width;
  row.entry = entries_.data() + place.first_number * width;
  row.number = numbers_.data() + number * row_numbers * width;
  row.friction = has_friction() ? frictions_.data() + number * friction_numbers * width : nullptr;
  return row;
}

void RowPacks::build(const ContactRows& rows, const std::vector<std::int32_t>& active,
                     const std::vector<ImpulseNode>& nodes, const std::vector<FrictionRow>& frictions) {
  order_.build(rows, active, nodes);
  light_.build(order_, entries_of_sweeps);
  heavy_.build(order_, entries_of_heavy_work);
  const std::size_t packs = order_.packs().size();
  nodes_.renew(order_.entry_packs() * width);
  entries_.renew(order_.number_packs() * width);
  numbers_.renew(packs * row_numbers * width);
  changes_.renew(packs * width);
  frictions_.renew(frictions.empty() ? 0 : packs * friction_numbers * width);
  coloured_heavy("rows into packs", [&](std::int64_t p) { fill(p, rows, nodes, frictions); });
}

void RowPacks::fill(std::int64_t pack_number, const ContactRows& rows, const std::vector<ImpulseNode>& nodes,
                    const std::vector<FrictionRow>& frictions) {
  const RowOrder::PackPlace& place = order_.packs()[static_cast<std::size_t>(pack_number)];
  std::int32_t* const node = nodes_.data() + place.first_entry * width;
  double* const entry = entries_.data() + place.first_number * width;
  double* const number = numbers_.data() + pack_number * row_numbers * width;
  const int stride = place.held ? 7 : 2;
  const std::int32_t spare = rows[static_cast<std::size_t>(order_.row(pack_number, 0))].node[0];
  for (int lane = 0; lane < width; ++lane) {
    const std::int32_t i = order_.row(pack_number, lane);
    const auto put = [lane](double* numbers, int which, double value) { numbers[which * width + lane] = value; };
    RowView row{nullptr, 0, &spare, nullptr};
    if (i >= 0) row = rows[static_cast<std::size_t>(i)];
    for (int k = 0; k < place.entries; ++k) {
      double* const at = entry + k * stride * width;
      node[k * width + lane] = row.node[k < row.nodes ? k : 0];
      for (int c = 0; c < stride; ++c) put(at, c, 0);
      if (k >= row.nodes) continue;
      const ImpulseNode& own = nodes[row.node[k]];
      put(at, 0, row.weight[k]);
      for (int c = 1; c < stride; ++c) put(at, c, row.weight[k] * own.inverse_mass[c - 1]);
    }
    for (int c = 0; c < row_numbers; ++c) put(number, c, 0);
    if (i < 0) continue;
    const ImpulseRow& own = rows.rows[i];
    for (int c = 0; c < 3; ++c) put(number, row_direction + c, own.direction[c]);
    put(number, row_rate, own.position_rate);
    put(number, row_inverse_mass, own.inverse_mass);
    put(number, row_mass, 1 / own.inverse_mass);
    put(number, row_impulse, own.impulse);
  }
  if (frictions.empty()) return;
  double* const friction = frictions_.data() + pack_number * friction_numbers * width;
  for (int lane = 0; lane < width; ++lane) {
    const std::int32_t i = order_.row(pack_number, lane);
    const FrictionRow own = i >= 0 ? frictions[i] : FrictionRow{};
    for (int c = 0; c < 3; ++c) friction[(friction_impulse + c) * width + lane] = own.impulse[c];
    friction[friction_inverse_mass * width + lane] = own.inverse_mass;
    friction[friction_mass * width + lane] = own.inverse_mass > 0 ? 1 / own.inverse_mass : 0.0;
    friction[friction_coefficient * width + lane] = own.coefficient;
  }
}

void RowPacks::apply(double* velocity) {
  light_.run("impulses of the step before", [&](std::int64_t p) {
    const RowPack row = pack(p);
    apply_impulses<Lanes>(row, velocity);
    if (has_friction()) apply_friction<Lanes>(row, velocity);
  });
}

double RowPacks::sweep(double* velocity) {
  light_.run("sweep over rows", [&](std::int64_t p) {
    const RowPack row = pack(p);
    Lanes change = sweep_rows<Lanes>(row, velocity);
    if (has_friction()) change = maximum(change, sweep_friction<Lanes>(row, velocity));
    store(change, changes_.data() + p * width);
  });
  Lanes largest = 0;
  for (std::size_t i = 0; i < changes_.size(); i += width) {
    largest = maximum(largest, load<Lanes>(changes_.data() + i));
  }
  return lane_maximum(largest);
}

void RowPacks::project(double* velocity) {
  light_.run("closing rows", [&](std::int64_t p) { find_closing<Lanes>(pack(p), velocity); });
  light_.run("shares of rows", [&](std::int64_t p) { add_shares<Lanes>(pack(p), velocity); });
  light_.run("shared impulses", [&](std::int64_t p) { share_impulses<Lanes>(pack(p), velocity); });
  light_.run("projection", [&](std::int64_t p) { apply_impulses<Lanes>(pack(p), velocity); });
  if (!has_friction()) return;
  light_.run("friction of the step before", [&](std::int64_t p) { apply_friction<Lanes>(pack(p), velocity); });
  light_.run("friction", [&](std::int64_t p) { sweep_friction<Lanes>(pack(p), velocity); });
}

Vec3<double> RowPacks::friction(std::int64_t number, int lane) const {
  const double* q = frictions_.data() + number * friction_numbers * width + lane;
  return {q[0], q[width], q[2 * width]};
}

std::size_t RowPacks::bytes() const {
  return order_.bytes() + light_.bytes() + heavy_.bytes() + nodes_.bytes() + entries_.bytes() + numbers_.bytes() +
         frictions_.bytes() + changes_.bytes();
}

}  // namespace pinball
