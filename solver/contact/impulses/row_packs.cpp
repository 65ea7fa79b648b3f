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
  const auto width = static_cast<std::size_t>(order_.width());
  const RowOrder::PackPlace& place = order_.packs()[static_cast<std::size_t>(number)];
  RowPack row;
  row.entries = place.entries;
  row.held = place.held;
  row.node = nodes_.data() + place.first_entry * width;
  row.entry = entries_.data() + place.first_number * width;
  row.number = numbers_.data() + static_cast<std::size_t>(number) * row_numbers * width;
  row.friction =
      has_friction() ? frictions_.data() + static_cast<std::size_t>(number) * friction_numbers * width : nullptr;
  return row;
}

void RowPacks::build(const ContactRows& rows, const std::vector<std::int32_t>& active,
                     const std::vector<ImpulseNode>& nodes, const std::vector<FrictionRow>& frictions,
                     int rows_to_a_pack) {
  const auto width = static_cast<std::size_t>(rows_to_a_pack);
  order_.build(rows, active, nodes, rows_to_a_pack);
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
  const int width = order_.width();
  const RowOrder::PackPlace& place = order_.packs()[static_cast<std::size_t>(pack_number)];
  std::int32_t* const node = nodes_.data() + place.first_entry * static_cast<std::size_t>(width);
  double* const entry = entries_.data() + place.first_number * static_cast<std::size_t>(width);
  double* const number = numbers_.data() + pack_number * row_numbers * width;
  const int stride = place.held ? 7 : 2;
  const std::int32_t spare = rows[static_cast<std::size_t>(order_.row(pack_number, 0))].node[0];
  for (int lane = 0; lane < width; ++lane) {
    const std::int32_t i = order_.row(pack_number, lane);
    const auto put = [lane, width](double* numbers, int which, double value) { numbers[which * width + lane] = value; };
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
  in_lanes([&](auto t) {
    using T = decltype(t);
    light_.run("impulses of the step before", [&](std::int64_t p) {
      const RowPack row = pack(p);
      apply_impulses<T>(row, velocity);
      if (has_friction()) apply_friction<T>(row, velocity);
    });
  });
}

double RowPacks::sweep(double* velocity) {
  double largest = 0;
  in_lanes([&](auto t) {
    using T = decltype(t);
    light_.run("sweep over rows", [&](std::int64_t p) {
      const RowPack row = pack(p);
      T change = sweep_rows<T>(row, velocity);
      if (has_friction()) change = maximum(change, sweep_friction<T>(row, velocity));
      store(change, changes_.data() + p * width_of<T>);
    });
    T found(0);
    for (std::size_t i = 0; i < changes_.size(); i += width_of<T>) found = maximum(found, load<T>(changes_.data() + i));
    largest = lane_maximum(found);
  });
  return largest;
}

void RowPacks::project(double* velocity) {
  in_lanes([&](auto t) {
    using T = decltype(t);
    light_.run("closing rows", [&](std::int64_t p) { find_closing<T>(pack(p), velocity); });
    light_.run("shares of rows", [&](std::int64_t p) { add_shares<T>(pack(p), velocity); });
    light_.run("shared impulses", [&](std::int64_t p) { share_impulses<T>(pack(p), velocity); });
    light_.run("projection", [&](std::int64_t p) { apply_impulses<T>(pack(p), velocity); });
    if (!has_friction()) return;
    light_.run("friction of the step before", [&](std::int64_t p) { apply_friction<T>(pack(p), velocity); });
    light_.run("friction", [&](std::int64_t p) { sweep_friction<T>(pack(p), velocity); });
  });
}

void RowPacks::find_approach(std::int64_t number, const double* velocity, Vec3<double> (&found)[widest]) {
  in_lanes([&](auto t) {
    using T = decltype(t);
    const Vec3<T> v = approach<T>(pack(number), velocity);
    for (int l = 0; l < width_of<T>; ++l) found[l] = {lane(v.x, l), lane(v.y, l), lane(v.z, l)};
  });
}

void RowPacks::take(std::int64_t number, const double (&impulses)[widest], double* velocity) {
  in_lanes([&](auto t) {
    using T = decltype(t);
    alignas(64) double aligned[widest];
    for (int l = 0; l < widest; ++l) aligned[l] = impulses[l];
    const RowPack row = pack(number);
    take_impulse<T>(row, load<T>(aligned) * direction_of<T>(row), velocity);
  });
}

Vec3<double> RowPacks::friction(std::int64_t number, int lane) const {
  const double* q = frictions_.data() + number * friction_numbers * width() + lane;
  return {q[0], q[width()], q[2 * width()]};
}

std::size_t RowPacks::bytes() const {
  return order_.bytes() + light_.bytes() + heavy_.bytes() + nodes_.bytes() + entries_.bytes() + numbers_.bytes() +
         frictions_.bytes() + changes_.bytes();
}

}  // namespace pinball
