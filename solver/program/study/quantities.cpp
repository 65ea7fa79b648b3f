#include "quantities.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include <solver/base/error.hpp>
#include <solver/base/text_distance.hpp>

namespace pinball {

namespace {

constexpr double least_share = 1e-6;  ///< of its scale, of what is asked for unless the user does

/// Quantities of a run that are there and not negligible, each once.
class QuantityList {
 public:
  explicit QuantityList(const RunResults& run) : run_(run) {}

  bool add(const std::string& name) {
    const auto value = run_.value(name);
    if (!value || !(std::abs(*value) > least_share * run_.scale(name)) || !known_.insert(name).second) return false;
    names_.push_back(name);
    return true;
  }
  void add_vector(const std::string& name, const std::string& what = "") {
    for (const char axis : {'x', 'y', 'z'}) add(fmt::format("{}_{}{}", name, axis, what));
  }
  /// The larger of the two extremes, unless it is the first or the last value, or next to it.
  void add_peak(const std::string& column) {
    const auto high = run_.value(column + ":max"), low = run_.value(column + ":min");
    if (!high || !low) return;
    const bool upwards = std::abs(*high) >= std::abs(*low);
    const double peak = upwards ? *high : *low, nothing = least_share * run_.scale(column);
    const std::vector<double>& values = run_.rows.at(column);
    if (std::abs(peak - values.front()) <= nothing || std::abs(peak - values.back()) <= nothing) return;
    add(column + (upwards ? ":max" : ":min"));
  }
  const std::vector<std::string>& names() const { return names_; }

 private:
  const RunResults& run_;
  std::vector<std::string> names_;
  std::set<std::string> known_;
};

template <class Named>
void add_forces(const std::vector<Named>& items, QuantityList& list) {
  for (const Named& item : items) {
    if (item.name.empty()) continue;
    list.add_vector(item.name + "_force", ":integral");
    for (const char axis : {'x', 'y', 'z'}) list.add_peak(fmt::format("{}_force_{}", item.name, axis));
  }
}

/// A probe's columns, but for its place, of which the displacement says the same.
void add_probe(const Probe& probe, const RunResults& run, QuantityList& list) {
  for (const std::string& column : run.columns) {
    if (!column.starts_with(probe.name + '_') || column.starts_with(probe.name + "_position")) continue;
    list.add(column);
    list.add_peak(column);
  }
}

}  // namespace

std::vector<std::string> default_quantities(const Scene& scene, const RunResults& run) {
  QuantityList list(run);
  for (const char* energy : {"kinetic", "internal", "hourglass", "bulk_viscosity", "contact", "eroded", "external"}) {
    list.add(fmt::format("energy.{}", energy));
  }
  for (const Body& body : scene.bodies) {
    list.add_vector(body.name + "_velocity");
    list.add(body.name + "_max_plastic_strain");
    if (run.value(body.name + "_eroded_elements").value_or(0) > 0) list.add(body.name + "_mass_remaining");
  }
  for (const RigidWall& wall : scene.rigid_walls) {
    list.add(wall.name + "_impulse");
    list.add(fmt::format("rigid_walls.{}.force_max", wall.name));
    list.add(wall.name + "_displacement");
  }
  for (const Pressure& pressure : scene.pressures) list.add(pressure.name + "_work");
  for (const ContactPair& pair : scene.contact_pairs) {
    list.add_vector(pair.name + "_impulse");
    list.add(fmt::format("contact.pairs.{}.force_max", pair.name));
  }
  add_forces(scene.constraints, list);
  add_forces(scene.fixed_constraints, list);
  add_forces(scene.prescribed_velocities, list);
  add_forces(scene.gravities, list);
  for (const Probe& probe : scene.probes) add_probe(probe, run, list);
  return list.names();
}

void require_quantities(const std::vector<std::string>& names, const RunResults& run) {
  for (const std::string& name : names) {
    if (run.value(name) || run.curve(name)) continue;
    const std::size_t colon = std::min(name.find(':'), name.size());
    throw InputError(fmt::format(
        "--of {}: expected a column of history.csv, also with :last, :max, :min, :integral or :curve behind it, "
        "length(PROBE,PROBE) of two that record positions, or a number of summary.json, such as energy.kinetic; "
        "nearest is "
        "{}",
        name, nearest(name.substr(0, colon), run.known())));
  }
}

}  // namespace pinball
