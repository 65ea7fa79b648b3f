#include <fmt/format.h>

#include <algorithm>
#include <set>

#include <solver/formats/radioss/layouts/radioss_boundary_cards.hpp>

#include "radioss_keys.hpp"

namespace pinball {

namespace {

void read_rigid_body(RadiossData& data, const RadiossBlock& block) {
  RadiossLines lines(block);
  const DataLine l1 = lines.require("the main node and the group"), l2 = lines.next_or_blank(),
                 l3 = lines.next_or_blank(), l4 = lines.next_or_blank();
  const RadiossFields f(l1, block, radioss::rigid_body), inertia(l2, block, radioss::rigid_inertia),
      products(l3, block, radioss::rigid_products), options(l4, block, radioss::rigid_options);
  f.integer("Ispher");
  RadiossRigidBody rigid;
  rigid.block = &block;
  rigid.card = card_of(block, l1.place);
  rigid.name = fmt::format("rbody_{}", block.id());
  rigid.group = f.integer("grnd_ID");
  rigid.main = data.nodes.find(f.integer("node_ID"));
  if (rigid.main < 0) f.fail("node_ID", fmt::format("node {} is not there", f.integer("node_ID")));
  if (data.used[rigid.main])
    data.report.reject(l1.place, "/RBODY with a main node that is one of a solid", "give a node of its own");
  if (const std::int64_t centre = f.integer("ICoG"); centre > 2)
    data.report.reject(l1.place, fmt::format("/RBODY with ICoG {}", centre), "give 1: its centre is that of its nodes");
  const MeshSet& group = data.node_group(rigid.group, l1.place);
  for (const std::int32_t node : group.members) {
    if (data.rigid_of_node[node] >= 0 && data.used[node])
      fail_at(l1.place, fmt::format("{}: node {} is of {}, too", block.title, data.mesh.node_ids[node],
                                    data.rigid[data.rigid_of_node[node]].block->title));
    data.rigid_of_node[node] = static_cast<std::int32_t>(data.rigid.size());
  }
  if (!data.has_used(group)) f.fail("grnd_ID", "expected nodes of solids, there are none in the group");
  const std::vector<bool> in_group = data.nodes_in(group), whole = data.whole_parts(in_group);
  rigid.bodies = data.bodies_of(whole);
  rigid.attaches = !data.are_of_parts(in_group, whole);
  data.rigid.push_back(std::move(rigid));
}

}  // namespace

void find_radioss_rigid_bodies(RadiossData& data) {
  GivenOnce given;
  for (const RadiossBlock* block : data.blocks_of("RBODY")) {
    given.add(fmt::format("rigid body {}", block->id()), block->place);
    read_rigid_body(data, *block);
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
