#include <fmt/format.h>

#include <algorithm>
#include <set>

#include <solver/formats/radioss/layouts/radioss_boundary_cards.hpp>

#include "radioss_inertia.hpp"
#include "radioss_keys.hpp"

namespace pinball {

namespace {

/// Whether solids of bodies that are not in the list have nodes of a group.
bool touches_others(const RadiossData& data, const std::vector<bool>& in_group,
                    const std::vector<std::string>& own_bodies) {
  for (const RadiossBody& body : data.bodies) {
    if (std::ranges::find(own_bodies, body.name) != own_bodies.end()) continue;
    const std::ptrdiff_t part = data.part_of(body);
    for (std::size_t e = 0; e < data.mesh.part.size(); ++e) {
      if (data.mesh.part[e] != part) continue;
      for (const std::int32_t node : data.mesh.mesh.hexahedra[e]) {
        if (in_group[node]) return true;
      }
    }
  }
  return false;
}

/// Mass and inertia, where they are not those of the nodes.
void read_inertia(RadiossData& data, const RadiossFields& f, const RadiossFields& inertia,
                  const RadiossFields& products, const std::vector<bool>& in_group, RadiossRigidBody& rigid) {
  RadiossMainMass given;
  given.mass = f.number("Mass") + mass_added_to(data, rigid.main);
  given.centre = f.integer("ICoG") == 0 ? 1 : static_cast<int>(f.integer("ICoG"));
  given.is_sphere = f.integer("Ispher") == 1;
  const double xy = products.number("Jxy"), yz = products.number("Jyz"), xz = products.number("Jxz");
  given.inertia = {{{inertia.number("Jxx"), xy, xz}, {xy, inertia.number("Jyy"), yz}, {xz, yz, inertia.number("Jzz")}}};
  const std::int64_t skew = f.integer("Skew_ID");
  if (given.changes_nothing()) {
    if (skew != 0) data.report.unused(f.place(), rigid.block->title + ": Skew_ID", "inertia is that of the nodes");
    return;
  }
  if (skew != 0)
    data.report.reject(f.place(), rigid.block->title + " with Skew_ID beside a mass or an inertia",
                       "give the inertia along the global axes");
  if (given.centre == 4 && !(given.mass > 0))
    f.fail("Mass", "expected a mass above 0, for with ICoG 4 that of the nodes does not count");
  if (given.mass > 0 && (rigid.attaches || touches_others(data, in_group, rigid.bodies))) {
    data.report.reject(f.place(), "/RBODY with Mass and nodes of bodies that deform",
                       "leave it 0, and give its main node no /ADMAS");
    return;
  }
  rigid.inertia = with_main_node(data, in_group, data.mesh.mesh.nodes[rigid.main], given);
  if (given.mass == 0) rigid.inertia->mass = 0;  // that of its nodes
}

/// A rigid body has its nodes for itself.
void take_nodes(RadiossData& data, const RadiossRigidBody& rigid, const std::vector<std::int32_t>& members) {
  for (const std::int32_t node : members) {
    if (data.rigid_of_node[node] >= 0 && data.used[node])
      fail_at(rigid.card.place, fmt::format("{}: node {} is of {}, too", rigid.block->title, data.mesh.node_ids[node],
                                            data.rigid[data.rigid_of_node[node]].block->title));
    data.rigid_of_node[node] = static_cast<std::int32_t>(data.rigid.size());
  }
}

/// A part whose material is /MAT/RIGID, or one of shells that a /BCS holds, unless it is of an /RBODY as a whole.
void find_rigid_part(RadiossData& data, const RadiossBody& body, const RadiossBlock& from, bool is_held) {
  for (const RadiossRigidBody& other : data.rigid) {
    if (std::ranges::find(other.bodies, body.name) != other.bodies.end()) return;
  }
  const std::ptrdiff_t part = data.part_of(body);
  RadiossRigidBody rigid;
  rigid.block = &from;
  rigid.is_held = is_held;
  if (is_held) rigid.held = 63;
  rigid.card = {fmt::format("/PART/{}", body.part.id), body.part.place};
  rigid.name = body.name;
  rigid.bodies = {body.name};
  std::set<std::int32_t> members;
  for (std::size_t e = 0; e < data.mesh.part.size(); ++e) {
    if (data.mesh.part[e] == part)
      members.insert(data.mesh.mesh.hexahedra[e].begin(), data.mesh.mesh.hexahedra[e].end());
  }
  take_nodes(data, rigid, {members.begin(), members.end()});
  data.rigid.push_back(std::move(rigid));
}

void find_held_shells(RadiossData& data, const RadiossBody& body, const RadiossBlock& block) {
  RadiossLines lines(block);
  while (const auto line = lines.next_filled()) {
    const RadiossFields f(*line, block, radioss::held);
    const auto group = std::ranges::find(data.mesh.node_sets, f.integer("grnod_ID"), &MeshSet::id);
    if (group == data.mesh.node_sets.end() || line->text.size() < 6 || line->text.substr(3, 3) != "111") continue;
    if (data.whole_parts(data.nodes_in(*group))[data.part_of(body)]) find_rigid_part(data, body, block, true);
  }
}

void read_rigid_body(RadiossData& data, const RadiossBlock& block) {
  RadiossLines lines(block);
  const DataLine l1 = lines.require("the main node and the group"), l2 = lines.next_or_blank(),
                 l3 = lines.next_or_blank(), l4 = lines.next_or_blank();
  const RadiossFields f(l1, block, radioss::rigid_body), inertia(l2, block, radioss::rigid_inertia),
      products(l3, block, radioss::rigid_products), options(l4, block, radioss::rigid_options);
  RadiossRigidBody rigid;
  rigid.block = &block;
  rigid.card = card_of(block, l1.place);
  rigid.name = fmt::format("rbody_{}", block.id());
  rigid.group = f.integer("grnd_ID");
  rigid.main = data.nodes.find(f.integer("node_ID"));
  if (rigid.main < 0) f.fail("node_ID", fmt::format("node {} is not there", f.integer("node_ID")));
  if (data.used[rigid.main])
    data.report.reject(l1.place, "/RBODY with a main node that is one of a solid", "give a node of its own");
  const MeshSet& group = data.node_group(rigid.group, l1.place);
  take_nodes(data, rigid, group.members);
  if (!data.has_used(group)) f.fail("grnd_ID", "expected nodes of solids, there are none in the group");
  const std::vector<bool> in_group = data.nodes_in(group), whole = data.whole_parts(in_group);
  rigid.bodies = data.bodies_of(whole);
  rigid.attaches = !data.are_of_parts(in_group, whole);
  read_inertia(data, f, inertia, products, in_group, rigid);
  data.rigid.push_back(std::move(rigid));
}

}  // namespace

void find_radioss_rigid_bodies(RadiossData& data) {
  GivenOnce given;
  for (const RadiossBlock* block : data.blocks_of("RBODY")) {
    given.add(fmt::format("rigid body {}", block->id()), block->place);
    read_rigid_body(data, *block);
  }
  for (const RadiossBody& body : data.bodies) {
    for (const RadiossBlock* material : data.blocks_of("MAT/RIGID")) {
      if (material->id() == body.part.material) find_rigid_part(data, body, *material, false);
    }
  }
  for (const RadiossBody& body : data.bodies) {
    for (const RadiossBlock* block : data.blocks_of("BCS")) {
      if (body.is_of_shells && !block->engine) find_held_shells(data, body, *block);
    }
  }
}

void translate_radioss_rigid_bodies(RadiossData& data, DeckScene& scene) {
  for (const RadiossRigidBody& rigid : data.rigid) {
    const auto keys = scene.entry<RigidBody>("rigid_body", rigid.card);
    keys.set("name", rigid.name);
    if (!rigid.bodies.empty()) keys.set("bodies", rigid.bodies, "grnd_ID");
    if ((rigid.held & 7U) != 0) keys.set("held", direction_names(rigid.held));
    if (rigid.held >> 3U != 0) keys.set("held_rotations", direction_names(rigid.held >> 3U));
    if (rigid.velocity) keys.set("velocity", *rigid.velocity);
    if (rigid.angular_velocity) keys.set("angular_velocity", *rigid.angular_velocity);
    if (rigid.inertia) {
      if (rigid.inertia->mass > 0) keys.set("mass", rigid.inertia->mass, "Mass");
      keys.set("centre", rigid.inertia->centre, "ICoG");
      keys.set("inertia", given_list(rigid.inertia->about), "Jxx to Jxz, Ispher");
    }
    const std::string of_bodies =
        rigid.bodies.empty() ? "nodes alone" : fmt::format("bodies {}", fmt::join(rigid.bodies, ", "));
    data.report.understood(
        fmt::format("{} ({}): a rigid body of {}", rigid.block->title, rigid.card.place.text(), of_bodies));
  }
  for (const RadiossRigidBody& rigid : data.rigid) {
    if (!rigid.attaches) continue;
    const auto keys = scene.entry<AttachedNodes>("rigid_nodes", rigid.card);
    keys.set("rigid_body", rigid.name);
    keys.set("set", std::to_string(rigid.group), "grnd_ID");
  }
}

}  // namespace pinball
