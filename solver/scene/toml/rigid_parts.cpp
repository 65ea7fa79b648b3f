#include "rigid_parts.hpp"

#include <fmt/format.h>

#include <utility>

#include <solver/scene/schema/rigid.hpp>

#include "boundary_parts.hpp"
#include "read_keys.hpp"

namespace pinball {

namespace {

RigidBody read_rigid_body(const SceneTable& table, const std::vector<std::string>& bodies) {
  RigidBody rigid;
  rigid.where = table.place();
  read_keys(table, rigid);
  if (table.has("bodies")) rigid.bodies = table.texts("bodies", bodies);
  for (const auto& [key, directions] : {std::pair{"held", &rigid.held}, {"held_rotations", &rigid.held_rotations}}) {
    if (table.has(key)) *directions = table.directions(key, {"x", "y", "z"});
  }
  table.require_none(problem_of(rigid));
  if (rigid.name.empty() && !rigid.bodies.empty()) rigid.name = rigid.bodies.front();
  return rigid;
}

AttachedNodes read_attached_nodes(const SceneTable& table, const Names& rigid_bodies) {
  AttachedNodes attached;
  read_keys(table, attached);
  attached.nodes.where = table.place();
  require_selection(table, attached.nodes);
  table.require_none(rigid_bodies.reference_problem("rigid_body", "rigid_body", attached.rigid_body));
  return attached;
}

RigidMotion read_rigid_motion(const SceneTable& table, const Names& rigid_bodies) {
  RigidMotion motion;
  motion.where = table.place();
  read_keys(table, motion);
  table.require_none(rigid_bodies.reference_problem("rigid_body", "rigid_body", motion.rigid_body));
  table.require_none(problem_of(motion));
  table.require_none(problem_of(motion.table));
  table.require_none(problem_of(motion.when));
  return motion;
}

Joint read_joint(const SceneTable& table, const std::vector<std::string>& rigid_bodies) {
  Joint joint;
  joint.where = table.place();
  read_keys(table, joint);
  joint.bodies = table.texts("bodies", rigid_bodies);
  table.require_none(problem_of(joint));
  return joint;
}

}  // namespace

void read_rigid_bodies(const SceneTable& top, Scene& scene) {
  const std::vector<std::string> bodies = names_of(scene.bodies);
  Names names;
  const std::vector<SceneTable> tables = top.tables("rigid_body", "rigid_body");
  for (const SceneTable& table : tables) {
    const RigidBody rigid = read_rigid_body(table, bodies);
    table.require_none(names.add(rigid.name, table.has("name") ? table.where("name") : table.where("bodies")));
    scene.rigid_bodies.push_back(rigid);
  }
  for (std::size_t r = 0; r < tables.size(); ++r) tables[r].require_none(problem_of(scene.rigid_bodies[r], scene));
  for (const SceneTable& table : top.tables("rigid_nodes", "rigid_nodes"))
    scene.attached_nodes.push_back(read_attached_nodes(table, names));
  for (const SceneTable& table : top.tables("rigid_motion", "rigid_motion"))
    scene.rigid_motions.push_back(read_rigid_motion(table, names));
  std::vector<std::string> jointed = names_of(scene.rigid_bodies);
  jointed.emplace_back(ground);
  Names joints;
  for (const SceneTable& table : top.tables("joint", "joint")) {
    Joint joint = read_joint(table, jointed);
    if (joint.name.empty()) joint.name = fmt::format("joint_{}", scene.joints.size());
    table.require_none(joints.add(joint.name, table.has("name") ? table.where("name") : table.place()));
    table.require_none(problem_of(joint, scene));
    scene.joints.push_back(std::move(joint));
  }
}

}  // namespace pinball
