#include <fmt/format.h>

#include <algorithm>
#include <map>

#include <solver/base/face_corners.hpp>
#include <solver/formats/deck/face_normals.hpp>
#include <solver/formats/radioss/layouts/radioss_boundary_cards.hpp>

#include "radioss_inertia.hpp"
#include "radioss_keys.hpp"

namespace pinball {

namespace {

/// Nodes of a group without those that hexahedra of twenty nodes get, which are of no load; empty: it has none of
/// these.
std::vector<std::int64_t> without_middles(const RadiossData& data, const MeshSet& group) {
  const auto is_new = [&](std::int32_t node) { return static_cast<std::size_t>(node) >= data.given_nodes; };
  if (std::ranges::none_of(group.members, is_new)) return {};
  std::vector<std::int64_t> numbers;
  for (const std::int32_t node : group.members) {
    if (!is_new(node)) numbers.push_back(data.mesh.node_ids[node]);
  }
  return numbers;
}

/// Nodes of the group of a rigid body without those of no solid, which have no share of a force on it; empty: it has
/// none of these.
std::vector<std::int64_t> without_unused(const RadiossData& data, const MeshSet& group) {
  if (std::ranges::all_of(group.members, [&](std::int32_t node) { return data.used[node]; })) return {};
  std::vector<std::int64_t> numbers;
  for (const std::int32_t node : group.members) {
    if (data.used[node]) numbers.push_back(data.mesh.node_ids[node]);
  }
  return numbers;
}

/// Forces on each node; those on a main node act on the centre of its body.
void translate_force(RadiossData& data, const RadiossBlock& block, DeckScene& scene) {
  RadiossLines lines(block);
  const DataLine line = lines.require("a function, a direction and a group");
  const RadiossFields f(line, block, radioss::nodal_load);
  f.integer("Itypfun");
  const int degree = degree_of(f, "Dir");
  const std::int64_t id = f.integer("grnod_ID");
  const MeshSet& group = data.node_group(id, line.place);
  const auto mains = data.rigid_in(group);
  if (degree >= 3) {
    if (mains.empty()) {
      data.report.unused(line.place, block.title, "nodes of solids have no rotations");
    } else {
      data.report.reject(line.place, block.title + " with a moment on a main node", "give forces");
    }
    if (block.log != nullptr) block.log->done(&block);
    return;
  }
  const Point direction = data.axes(f.integer("skew_ID"), line.place)[degree];
  const auto add = [&](const Point& force) {
    const auto keys = scene.entry<NodalLoad>("load", card_of(block, line.place));
    keys.set("force", force, "Dir");
    data.set_function(f.integer("fct_IDT"), f.number("Ascale_x"), f.number("Fscale_y"), line.place, keys);
    return keys;
  };
  const auto begin = [&](bool each, std::int64_t set) {
    const auto keys = add(direction);
    keys.set("each", each);
    const std::vector<std::int64_t> given =
        each ? without_middles(data, group) : without_unused(data, data.node_group(set, line.place));
    if (!given.empty()) {
      keys.set("nodes", given, "grnod_ID");
    } else {
      keys.set("set", std::to_string(set), "grnod_ID");
    }
  };
  for (const RadiossRigidBody* rigid : mains) {
    if (!rigid->inertia) {
      begin(false, rigid->group);
      continue;
    }
    const auto shares = shares_at(data, *rigid, rigid->inertia->centre);
    if (shares.empty())
      data.report.reject(line.place,
                         block.title +
                             " of the main node of an /RBODY of nodes in one plane, "
                             "whose centre is not theirs",
                         "give ICoG 1 and no Mass");
    for (const auto& [node, share] : shares)
      add({share * direction[0], share * direction[1], share * direction[2]})
          .set("nodes", std::vector{data.mesh.node_ids[node]}, "grnod_ID");
  }
  if (data.has_used(group)) {
    begin(true, id);
  } else if (mains.empty()) {
    data.report.ignore(line.place, "/CLOAD of nodes of no solid");
  }
}

/// How many faces have their normal, by the order of their corners, out of their solid, and how many into it.
std::pair<std::size_t, std::size_t> orientations(const Mesh& mesh, const std::vector<DeckFace>& faces) {
  const std::map<DeckFace, std::int32_t> solids = solids_of_faces(mesh, faces);
  std::pair<std::size_t, std::size_t> count{0, 0};
  for (const DeckFace& face : faces) {
    const std::int32_t solid = solids.at(face_key(face));
    if (solid < 0) continue;
    ++(points_inwards(mesh, face, mesh.hexahedra[solid]) ? count.second : count.first);
  }
  return count;
}

/// A pressure above 0 pushes along the normal of a segment, that of its diagonals 1 to 3 and 2 to 4: into its solid or
/// out of it.
void translate_pressure(RadiossData& data, const RadiossBlock& block, DeckScene& scene) {
  RadiossLines lines(block);
  const DataLine line = lines.require("a surface and a function");
  const RadiossFields f(line, block, radioss::pressure);
  f.integer("Itypfun");
  const std::int64_t id = f.integer("surf_ID");
  for (const RadiossBlock& other : data.deck.blocks) {
    if (!other.name.starts_with("SURF/") || other.name == "SURF/SEG" || other.id() != id) continue;
    return data.report.reject(line.place, fmt::format("{} of {}", block.title, other.title),
                              "give a /SURF/SEG: the order of its nodes says where pressures push");
  }
  const auto [outwards, inwards] = orientations(data.mesh.mesh, data.surface(id, line.place).faces);
  if (outwards > 0 && inwards > 0)
    return data.report.reject(line.place,
                              block.title + " of faces whose normals point out of their solids and into them",
                              "give a surface of each");
  const auto keys = scene.entry<Pressure>("pressure", card_of(block, line.place));
  keys.set("pressure", outwards > 0 ? -1.0 : 1.0);
  data.set_function(f.integer("fct_IDT"), f.number("Ascale_x"), f.number("Fscale_y"), line.place, keys);
  keys.set("set", std::to_string(id), "surf_ID");
  data.report.understood(fmt::format(
      "{} ({}): the normal of its faces points {} the solids, along it a function above "
      "0 {}",
      block.title, line.place.text(), outwards > 0 ? "out of" : "into", outwards > 0 ? "pulls" : "presses"));
}

void translate_gravity(RadiossData& data, const RadiossBlock& block, DeckScene& scene) {
  RadiossLines lines(block);
  const DataLine line = lines.require("a function, a direction and a group");
  const RadiossFields f(line, block, radioss::gravity);
  const int degree = degree_of(f, "Dir");
  if (degree >= 3) f.fail("Dir", "expected X, Y or Z");
  std::vector<std::string> bodies;
  if (const std::int64_t id = f.integer("grnod_ID"); id != 0) {
    bodies = data.whole_bodies(data.node_group(id, line.place));
    if (bodies.empty())
      return data.report.reject(line.place, block.title + " of nodes that are not all of some parts",
                                "give a group of whole parts");
    if (bodies == data.all_bodies()) bodies.clear();
  }
  const auto keys = scene.entry<Gravity>("gravity", card_of(block, line.place));
  Point direction = data.axes(f.integer("skew_ID"), line.place)[degree];
  const std::int64_t function = f.integer("fct_IDT");
  if (function == 0) {
    const double given = f.number("Fscale_y"), factor = given == 0 ? 1.0 : given;  // as in the starter
    for (double& component : direction) component *= factor;
    f.number("Ascale_x");
  }
  keys.set("acceleration", direction, "Dir");
  if (function != 0) data.set_function(function, f.number("Ascale_x"), f.number("Fscale_y"), line.place, keys);
  if (!bodies.empty()) keys.set("bodies", bodies, "grnod_ID");
}

}  // namespace

void translate_radioss_loads(RadiossData& data, DeckScene& scene) {
  for (const RadiossBlock& block : data.deck.blocks) {
    if (block.name == "CLOAD") translate_force(data, block, scene);
    if (block.name == "PLOAD") translate_pressure(data, block, scene);
    if (block.name == "GRAV") translate_gravity(data, block, scene);
  }
}

}  // namespace pinball
