#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include <solver/results/warnings.hpp>
#include <solver/scene/units/units.hpp>
#include <solver/summary.hpp>

#include "output_file.hpp"
#include "run_files.hpp"
#include "summary_head.hpp"

namespace pinball {
namespace {

using Json = nlohmann::ordered_json;  // keys stay in the order in which a reader looks for them

Json energy_json(const RunSummary& s) {
  const Energies& e = s.energy;
  return {{"kinetic", e.kinetic},
          {"kinetic_below_zero", e.kinetic_below_zero},
          {"internal", e.internal},
          {"hourglass", e.hourglass},
          {"hourglass_plastic", e.hourglass_plastic},
          {"bulk_viscosity", e.bulk_viscosity},
          {"folding", e.folding},
          {"contact", e.contact()},
          {"contact_stored", e.contact_stored},
          {"contact_damped", e.contact_damped},
          {"eroded", e.eroded},
          {"external", e.external},
          {"initial_total", s.initial_total},
          {"final_total", s.final_total},
          {"balance_error_max", s.balance_error_max},
          {"in_motion", s.energy_in_motion},
          {"balance_error_in_motion_max", s.balance_error_in_motion.largest},
          {"contact_created_share", s.contact_created.largest},
          {"contact_swallowed_share", s.contact_swallowed.largest},
          {"hourglass_created_share", s.hourglass_created.largest},
          {"hourglass_share", s.hourglass_large.largest},
          {"hourglass_plastic_share", s.hourglass_plastic.largest},
          {"kinetic_below_zero_share", s.kinetic_below_zero.largest},
          {"internal_below_zero_share", s.internal_below_zero.largest}};
}

Json body_json(const BodyResult& body) {
  return {{"name", body.name},
          {"elements", body.elements},
          {"eroded_elements", body.eroded_elements},
          {"mass_initial", body.mass_initial},
          {"mass_remaining", body.mass_remaining},
          {"mass_added", body.mass_added},
          {"velocity", body.velocity},
          {"max_plastic_strain", body.max_plastic_strain}};
}

/// Of the mass of the materials; no bodies: null.
double added_percent(const RunSummary& s) {
  double mass = -s.mass_added;
  for (const BodyResult& body : s.bodies) mass += body.mass_initial;
  return 100 * s.mass_added / mass;
}

Json wall_json(const WallResult& wall) {
  Json json{{"name", wall.name}, {"impulse", wall.impulse}, {"force_max", wall.force_max}};
  if (wall.moves) json.update(Json{{"displacement", wall.displacement}, {"velocity", wall.velocity}});
  return json;
}

Json rigid_json(const RigidBodyResult& rigid) {
  return {{"name", rigid.name},
          {"mass", rigid.mass},
          {"inertia", rigid.inertia},
          {"centre", rigid.centre},
          {"velocity", rigid.velocity},
          {"angular_velocity", rigid.angular_velocity},
          {"angular_momentum", rigid.angular_momentum}};
}

Json joint_json(const JointResult& joint) {
  return {{"name", joint.name},
          {"force", joint.force},
          {"moment", joint.moment},
          {"work", joint.work},
          {"opening", joint.opening}};
}

Json pressure_json(const PressureResult& pressure) {
  return {{"name", pressure.name}, {"force", pressure.force}, {"work", pressure.work}};
}

Json pair_json(const PairResult& pair) {
  return {{"name", pair.name}, {"impulse", pair.impulse}, {"force_max", pair.force_max}};
}

Json overlap_json(const OverlapResult& overlap) {
  return {{"first", overlap.first}, {"second", overlap.second}, {"points", overlap.points},
          {"nodes", overlap.nodes}, {"place", overlap.place},   {"depth", overlap.depth},
          {"share", overlap.share}, {"time", overlap.time},     {"rigid_wall", overlap.rigid_wall}};
}

Json tied_json(const TiedResult& tied) {
  return {{"name", tied.name}, {"nodes", tied.nodes}, {"near", tied.near}, {"held", tied.held}, {"taken", tied.taken}};
}

Json probe_json(const ProbeResult& probe) {
  Json values = Json::object();
  for (const ProbeValue& v : probe.values) values[v.quantity] = v.value;
  return {{"name", probe.name},   {"kind", probe.element ? "element" : "node"},
          {"body", probe.body},   {"number", probe.number},
          {"point", probe.point}, {"values", values}};
}

/// Null where one process had all.
Json parallel_json(const ParallelRun& run) {
  if (run.ranks == 1) return nullptr;
  return {{"ranks", run.ranks},
          {"records", run.records},
          {"messages", run.messages},
          {"common_nodes", run.common_nodes},
          {"bytes_per_step", run.bytes_per_step},
          {"imbalance", run.imbalance},
          {"devices", run.devices}};
}

const char* status_name(RunStatus status) {
  switch (status) {
    case RunStatus::running:
      return "running";
    case RunStatus::done:
      return "done";
    case RunStatus::failed:
      return "failed";
    case RunStatus::stopped:
      return "stopped";
  }
  return "";
}

/// By quantity; those that the scene names: history.csv has its columns in them.
Json unit_names(const std::string& units) {
  const Units u = parse_units(units);
  Json names = Json::object();
  for (const auto& [quantity, unit] : {std::pair{"time", u.time},
                                       {"length", u.length},
                                       {"velocity", u.velocity},
                                       {"mass", u.mass},
                                       {"force", u.force},
                                       {"momentum", u.momentum},
                                       {"energy", u.energy},
                                       {"stress", u.stress}}) {
    if (!unit.empty()) names[quantity] = unit;
  }
  return names;
}

Json text_or_null(const std::string& text) { return text.empty() ? Json(nullptr) : Json(text); }

Json head_json(const RunSummary& s) {
  return {{"scene", s.scene},
          {"title", s.title},
          {"status", status_name(s.status)},
          {"error", text_or_null(s.error)},
          {"started", text_or_null(s.started)},
          {"units", s.units},
          {"unit_names", unit_names(s.units)},
          {"version", s.version},
          {"precision", s.precision},
          {"device", s.device},
          {"threads", s.threads},
          {"simd_width", s.simd_width},
          {"elements", s.elements},
          {"nodes", s.nodes}};
}

/// dump() turns NaN and infinity into null; bytes that are no UTF-8 (a title) are replaced, not thrown over.
std::string indented(const Json& json) { return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n'; }

}  // namespace

std::string summary_head_json(const RunSummary& summary) {
  Json json = head_json(summary);
  if (summary.elements == 0) {
    for (const char* key : {"threads", "simd_width", "elements", "nodes"}) json[key] = nullptr;
  }
  return indented(json);
}

std::string summary_json(const RunSummary& s) {
  Json phases = Json::object();
  for (const PhaseSeconds& phase : s.phases) phases[phase.name] = phases.value(phase.name, 0.0) + phase.seconds;
  Json bodies = Json::array();
  for (const BodyResult& body : s.bodies) bodies.push_back(body_json(body));
  Json walls = Json::array(), pressures = Json::array(), probes = Json::array();
  Json rigid_bodies = Json::array();
  for (const RigidBodyResult& rigid : s.rigid_bodies) rigid_bodies.push_back(rigid_json(rigid));
  Json joints = Json::array();
  for (const JointResult& joint : s.joints) joints.push_back(joint_json(joint));
  for (const WallResult& wall : s.walls) walls.push_back(wall_json(wall));
  for (const PressureResult& pressure : s.pressures) pressures.push_back(pressure_json(pressure));
  for (const ProbeResult& probe : s.probes) probes.push_back(probe_json(probe));
  Json pairs = Json::array();
  for (const PairResult& pair : s.contact_pairs) pairs.push_back(pair_json(pair));
  Json ties = Json::array();
  for (const TiedResult& tied : s.tied) ties.push_back(tied_json(tied));
  Json overlaps = Json::array();
  for (const OverlapResult& overlap : s.overlaps) overlaps.push_back(overlap_json(overlap));
  const double element_steps = static_cast<double>(s.elements) * static_cast<double>(s.steps);

  Json json = head_json(s);
  json.update(Json{
      {"steps", s.steps},
      {"end_time", s.end_time},
      {"dt", {{"min", s.dt_min}, {"max", s.dt_max}, {"limited_by", s.dt_limited_by}}},
      {"wall_seconds", s.wall_seconds},
      {"phase_seconds", phases},
      {"element_steps", s.element_steps},
      {"element_steps_skipped",
       s.element_steps_eroded + s.element_steps_resting + s.element_steps_subcycled + s.element_steps_rigid},
      {"element_steps_eroded", s.element_steps_eroded},
      {"element_steps_resting", s.element_steps_resting},
      {"element_steps_subcycled", s.element_steps_subcycled},
      {"element_steps_rigid", s.element_steps_rigid},
      {"element_steps_per_second", element_steps / s.wall_seconds},  // no wall time: null
      {"energy", energy_json(s)},
      {"momentum", {{"initial", s.momentum_initial}, {"final", s.momentum_final}}},
      {"bodies", bodies},
      {"point_mass", s.point_mass},
      {"mass_scaling", {{"added", s.mass_added}, {"percent", added_percent(s)}}},
      {"rigid_bodies", rigid_bodies},
      {"joints", joints},
      {"rigid_walls", walls},
      {"pressures", pressures},
      {"contact",
       {{"method", s.contact_method},
        {"because", text_or_null(s.contact_because)},
        {"pairs", pairs},
        {"tied", ties},
        {"overlaps", overlaps},
        {"enforcement", s.contact_enforcement},
        {"gap", s.contact_gap},
        {"pinballs", s.pinballs},
        {"pairs_max", s.pairs_max},
        {"solves", s.iterations.solutions},
        {"unconverged", s.iterations.at_bound},
        {"residual_max", s.iterations.residual},
        {"residual_share_max", s.iterations.relative},
        {"sweeps",
         {{"mean", s.iterations.mean()},
          {"largest", s.iterations.largest},
          {"solutions", s.iterations.solutions},
          {"at_bound", s.iterations.at_bound},
          {"unsolved", s.iterations.unsolved}}},
        {"searches", s.searches},
        {"searches_skipped", s.searches_skipped},
        {"max_penetration_ratio", s.max_penetration_ratio},
        {"max_penetration_time", s.max_penetration_time},
        {"max_penetration_place", s.max_penetration_place}}},
      {"inside_out",
       {{"elements", s.inside_out.elements},
        {"most", s.inside_out.most},
        {"first_time", s.inside_out.first_time},
        {"first_place", s.inside_out.first_place}}},
      {"skipped",
       {{"resting_element_steps", s.element_steps_resting},
        {"subcycled_element_steps", s.element_steps_subcycled},
        {"searches", s.searches_skipped},
        {"inner_element_steps", s.inner_element_steps},
        {"bytes_not_stored", s.bytes_not_stored}}},
      {"skipped_seconds",
       {{"resting", s.skipped_seconds.resting},
        {"subcycling", s.skipped_seconds.subcycling},
        {"searches", s.skipped_seconds.searches},
        {"inner_elements", s.skipped_seconds.inner_elements}}},
      {"parallel", parallel_json(s.parallel)},
      {"state_hash", fmt::format("{:016x}", s.state_hash)},
      {"bytes_per_element", s.bytes_per_element},
      {"probes", probes},
      {"warnings", warnings(s)},
      {"notes", s.notes},
  });
  return indented(json);
}

void write_summary(const std::string& folder, const RunSummary& summary, const std::string& converged) {
  make_folder(folder);
  OutputFile file(in_folder(folder, summary_name));
  if (converged.empty()) {
    file.write(summary_json(summary));
  } else {
    Json json = Json::parse(summary_json(summary));
    json["converged"] = Json::parse(converged);
    file.write(indented(json));
  }
  file.commit();
}

}  // namespace pinball
