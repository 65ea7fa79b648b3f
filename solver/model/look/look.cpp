#include "look.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include <solver/model/initial_overlap.hpp>
#include <solver/model/interfaces/overlapping_bodies.hpp>
#include <solver/model/model.hpp>
#include <solver/scene/material/known_solids.hpp>
#include <solver/scene/units/earth_gravity.hpp>
#include <solver/scene/units/units.hpp>

#include "displacement_jumps.hpp"
#include "idle_keys.hpp"
#include "meetings.hpp"
#include "never_begun.hpp"
#include "opposed_motions.hpp"
#include "passed_walls.hpp"
#include "stopped_rigid.hpp"
#include "thin_bodies.hpp"

namespace pinball {

namespace {

constexpr double far_away = 0.1;  ///< of a probe's point from the box of what it watches, over the size of that [-]

std::string number(double value, const std::string& unit) {
  return unit.empty() ? fmt::format("{:.4g}", value) : fmt::format("{:.4g} {}", value, unit);
}

/// Of elements that hang together by nodes.
std::size_t pieces_of(const ModelMesh& mesh) {
  std::vector<std::int32_t> root(mesh.nodes.size());
  std::iota(root.begin(), root.end(), 0);
  const auto find = [&root](std::int32_t n) {
    while (root[n] != n) n = root[n] = root[root[n]];
    return n;
  };
  for (const auto& corners : mesh.hexahedra) {
    for (const std::int32_t n : corners) root[find(n)] = find(corners[0]);
  }
  std::set<std::int32_t> roots;
  for (const auto& corners : mesh.hexahedra) roots.insert(find(corners[0]));
  return roots.size();
}

/// Whether cards of a deck say what touches and what acts: its meshes are of one.
bool is_translated(const Scene& scene) {
  return std::ranges::any_of(scene.bodies, [](const Body& body) {
    const auto* file = std::get_if<FileMesh>(&body.mesh);
    return file != nullptr && is_of_decks(file->format);
  });
}

/// Whether the scene is made of a deck, whose mesh was read with it.
bool is_deck(const Scene& scene) {
  return std::ranges::any_of(scene.bodies, [](const Body& body) {
    const auto* file = std::get_if<FileMesh>(&body.mesh);
    return file != nullptr && file->held != nullptr;
  });
}

/// One look at one scene.
class LookAt {
 public:
  LookAt(Scene& scene, const ModelMesh& mesh) : scene_(scene), mesh_(mesh), units_(parse_units(scene.units)) {}

  Look look() {
    check_materials();
    check_gravity();
    const bool lone = scene_.bodies.size() == 1 && scene_.rigid_walls.empty();
    if (!lone) movers_ = find_movers(scene_, mesh_);
    if (movers_.all.size() > 1)
      meetings_ = find_meetings(movers_, mesh_, [this](std::int32_t a, std::int32_t b) {
        return may_touch(scene_.contact_pairs, mesh_.body_names[a], mesh_.body_names[b]);
      });
    decide_contact();
    check_speeds();
    check_whether_anything_meets();
    for (std::string& sentence : opposed_motions(scene_, mesh_)) report(std::move(sentence));
    for (std::string& sentence : passed_walls(scene_, mesh_)) report(std::move(sentence));
    for (std::string& sentence : walls_begun_late(scene_, mesh_, movers_)) report(std::move(sentence));
    for (std::string& sentence : stopped_rigid_bodies(scene_, mesh_)) report(std::move(sentence));
    for (std::string& sentence : displacement_jumps(scene_)) report(std::move(sentence));
    if (!is_deck(scene_)) {  // whose cards set keys for others, and are reported themselves
      for (std::string& sentence : idle_keys(scene_)) report(std::move(sentence));
    }
    if (!is_translated(scene_)) {  // where a late birth turns a card off
      for (std::string& sentence : never_begun(scene_)) report(std::move(sentence));
    }
    if (meetings_.possible || meets_wall()) report(find_thin_body(scene_, mesh_));
    check_probes();
    return std::move(look_);
  }

 private:
  void report(std::string sentence) {
    if (!sentence.empty()) look_.unlikely.push_back(std::move(sentence));
  }
  /// What makes a run fail, too. The first one counts.
  void report_cause(const std::string& sentence) {
    if (look_.cause.empty()) look_.cause = sentence;
    report(sentence);
  }

  void check_materials() {
    for (const Material& material : scene_.materials) report_cause(unlikely_material(material, units_));
  }

  /// A probe watches what is nearest to its point, however far that is.
  void check_probes() {
    for (const Probe& probe : scene_.probes) {
      if (probe.number) continue;
      Extent box;
      for (std::size_t n = 0; n < mesh_.nodes.size(); ++n) {
        if (probe.body.empty() || probe.body == mesh_.body_names[mesh_.body_of_node[n]]) box.take(mesh_.nodes[n]);
      }
      for (std::size_t b = 0; b < mesh_.shared.size(); ++b) {
        if (probe.body != mesh_.body_names[b]) continue;
        for (const std::int32_t n : mesh_.shared[b]) box.take(mesh_.nodes[n]);
      }
      Point out{};
      for (std::size_t k = 0; k < 3; ++k)
        out[k] = std::max({0.0, box.low[k] - probe.point[k], probe.point[k] - box.high[k]});
      const double size = norm(minus(box.high, box.low));
      if (!(norm(out) > far_away * size)) continue;
      report(fmt::format("probe {}: its point lies {} away from {}, whose diagonal is {}: what is nearest is watched",
                         probe.name, number(norm(out), units_.length),
                         probe.body.empty() ? "all bodies" : "body " + probe.body, number(size, units_.length)));
    }
  }

  void check_gravity() {
    for (std::size_t g = 0; g < scene_.gravities.size(); ++g) {
      const Gravity& gravity = scene_.gravities[g];
      double most = gravity.table.factors.empty() ? 1.0 : 0.0;
      for (const double factor : gravity.table.factors) most = std::max(most, std::abs(factor));
      const std::string wrong = unlikely_gravity(most * norm(gravity.acceleration), units_);
      if (wrong.empty()) continue;
      report_cause(fmt::format("gravity {}: {}", gravity.name.empty() ? fmt::format("{}", g) : gravity.name, wrong));
    }
  }

  std::string names(const Meeting& met) const {
    return fmt::format("{} and {}", mesh_.body_names[met.first], mesh_.body_names[met.second]);
  }
  std::string when(const Meeting& met) const {
    return met.time > 0 ? fmt::format("from time {} on", number(met.time, units_.time)) : "from the start on";
  }

  void decide_contact() {
    ContactMethod& method = scene_.contact.method;
    if (scene_.of_deck && method == ContactMethod::none && meetings_.expected) {
      report(
          fmt::format("bodies {} meet {}, and no card of the deck has them touch: they go through each other; "
                      "--set contact.method=pinball makes all bodies touch",
                      names(*meetings_.expected), when(*meetings_.expected)));
    }
    if (!is_translated(scene_) && method != ContactMethod::none && meetings_.passing) {
      report(fmt::format("bodies {} meet {}, and no contact.pair lets them touch: they go through each other",
                         names(*meetings_.passing), when(*meetings_.passing)));
    }
    if (method != ContactMethod::not_set) return;
    const std::string overlapping = meetings_.possible ? "" : overlapping_movers();
    method = meetings_.possible || !overlapping.empty() ? ContactMethod::pinball : ContactMethod::none;
    if (!overlapping.empty()) {
      look_.contact_because =
          fmt::format("contact is on (contact.method is left out): bodies {} overlap at the start", overlapping);
    } else if (meetings_.possible) {
      look_.contact_because = fmt::format("contact is on (contact.method is left out): bodies {} can meet {}",
                                          names(*meetings_.possible), when(*meetings_.possible));
    } else if (movers_.all.size() > 1) {
      look_.contact_because = "contact is off (contact.method is left out): no two bodies can meet";
    } else if (const std::size_t pieces = pieces_of(mesh_); pieces > 1) {
      look_.contact_because = fmt::format(
          "contact is off (contact.method is left out): all {} pieces of the mesh are one body: contact.method = "
          "\"pinball\" lets them touch, or make them bodies of their own",
          pieces);
    }
  }

  /// Bodies that rest in each other, as a pin in a hole that is too narrow, meet nowhere: they have met. "a and b", the
  /// first two that do not go together anyway; empty: there are none.
  std::string overlapping_movers() const {
    if (movers_.all.size() < 2) return "";
    std::map<std::string, std::size_t> mover_of;
    for (std::size_t m = 0; m < movers_.all.size(); ++m) {
      for (const std::int32_t body : movers_.all[m].bodies) mover_of[mesh_.body_names[body]] = m;
    }
    for (const InitialOverlap& pair : find_initial_overlaps(scene_, mesh_)) {
      if (mover_of[pair.first] != mover_of[pair.second]) return fmt::format("{} and {}", pair.first, pair.second);
    }
    return "";
  }

  double wave_of_body(std::int32_t body) const {
    for (const Material& material : scene_.materials) {
      if (material.name == scene_.bodies[body].material) return wave_speed(material);
    }
    return 0;
  }

  bool is_held(std::int32_t body) const {
    return std::ranges::any_of(movers_.all, [body](const Mover& mover) {
      return mover.held && std::ranges::find(mover.bodies, body) != mover.bodies.end();
    });
  }

  /// Beyond the speed of waves nothing of what a body does in front of the impact reaches what lies behind.
  void check_speeds() {
    if (meetings_.fastest) {
      const Meeting& met = *meetings_.fastest;
      const double share = is_held(met.first) || is_held(met.second) ? 1.0 : 0.5;  // of free bodies each takes half
      if (scene_.contact.method != ContactMethod::none) {
        if (scene_.contact.enforcement != Enforcement::penalty) look_.closing_speed = met.speed;
        look_.impact_speed = share * met.speed;
      }
      const double wave = std::min(wave_of_body(met.first), wave_of_body(met.second));
      if (met.speed > wave) report_speed(fmt::format("bodies {} meet", names(met)), met.speed, wave);
    }
    bool reported = false;
    for (const Mover& mover : movers_.all) {
      const double wave = wave_of_body(mover.bodies.front());
      if (mover.meets_wall) {
        look_.closing_speed = std::max(look_.closing_speed, mover.speed);
        look_.impact_speed = std::max(look_.impact_speed, mover.speed);
      }
      if (!mover.meets_wall || mover.speed <= wave || reported) continue;
      reported = true;
      report_speed(fmt::format("body {} and a rigid wall meet", mesh_.body_names[mover.bodies.front()]), mover.speed,
                   wave);
    }
  }
  void report_speed(const std::string& who, double speed, double wave) {
    report_cause(
        fmt::format("{} at {}, {:.3g} times the speed of waves in them, {}: look at velocities, densities and moduli",
                    who, number(speed, units_.velocity), speed / wave, number(wave, units_.velocity)));
  }

  bool meets_wall() const {
    return std::ranges::any_of(movers_.all, [](const Mover& mover) { return mover.meets_wall; });
  }
  /// Whether anything can come of contact, or of walls, that the scene asks for.
  void check_whether_anything_meets() {
    const bool alone = movers_.all.size() < 2;
    if (meetings_.possible || meets_wall() || !movers_.anything_moves) return;
    // Balls reach out of the faces that are looked at here.
    const bool balls = scene_.contact.method == ContactMethod::pinball && scene_.contact.gap == ContactGap::pinball;
    if (!alone && scene_.contact.method != ContactMethod::none && !balls) {
      report(fmt::format(
          "contact.method is on, and no two of the {} bodies can meet until time.end = {}: look at positions "
          "and velocities",
          scene_.bodies.size(), number(scene_.time.end, units_.time)));
    }
    if (!scene_.rigid_walls.empty()) {
      report(
          fmt::format("no body can reach a rigid wall until time.end = {}: look at positions, velocities and normals",
                      number(scene_.time.end, units_.time)));
    }
  }

  Scene& scene_;
  const ModelMesh& mesh_;
  Units units_;
  Movers movers_;
  Meetings meetings_;
  Look look_;
};

}  // namespace

Look look_at(Scene& scene, const ModelMesh& mesh) { return LookAt(scene, mesh).look(); }

}  // namespace pinball
