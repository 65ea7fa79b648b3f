#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>

#include <solver/formats/radioss/layouts/radioss_boundary_cards.hpp>

#include "radioss_inertia.hpp"
#include "radioss_keys.hpp"

namespace pinball {

namespace {

/// What a joint leaves free does not resist here: a spring that would change how its bodies turn by less than this, as
/// a part of it, is passed over with a word.
constexpr double next_to_nothing = 0.01;

enum class RadiossJointType : std::int64_t { spherical = 1, fixed = 8 };

/// Three lines for each direction about which a joint is free: stiffness, damping, friction.
void read_resistance(const RadiossBlock& block, RadiossLines& lines, RadiossJoint& joint) {
  const DataLine first = lines.next_or_blank(), second = lines.next_or_blank(), third = lines.next_or_blank();
  const RadiossFields spring(first, block, radioss::joint_stiffness), damper(second, block, radioss::joint_damping),
      friction(third, block, radioss::joint_friction);
  if (const double stiffness = spring.number("Kri"); stiffness > 0) joint.stiffness.push_back(stiffness);
}

/// What the property of a part of springs says; nothing where it is refused.
std::optional<RadiossJoint> read_property(RadiossData& data, const RadiossBlock& block) {
  RadiossLines lines(block);
  const DataLine first = lines.require("the type of the joint");
  const RadiossFields f(first, block, radioss::joint);
  const std::int64_t type = f.integer("Type");
  if (type < 1 || type > 9) f.fail("Type", fmt::format("expected 1 to 9, got {}", type));
  RadiossJoint joint;
  joint.property = card_of(block, first.place);
  joint.is_fixed = type == static_cast<std::int64_t>(RadiossJointType::fixed);
  if (!joint.is_fixed && type != static_cast<std::int64_t>(RadiossJointType::spherical)) {
    data.report.reject(first.place, fmt::format("{} with Type {}", block.title, type),
                       "1 and 8 have no axes, and are read");
    if (block.log != nullptr) block.log->done(&block);
    return std::nullopt;
  }
  for (int about = 0; about < 3 && !joint.is_fixed; ++about) read_resistance(block, lines, joint);
  return joint;
}

const RadiossBlock* property_of(const RadiossData& data, const RadiossBlock& spring) {
  const auto part = data.parts.all().find(spring.id());
  if (part == data.parts.all().end()) return nullptr;
  for (const RadiossBlock* block : data.blocks_of("PROP/KJOINT2")) {
    if (block->id() == part->second.property) return block;
  }
  return nullptr;
}

std::int32_t node_of(const RadiossData& data, const RadiossFields& f, const char* name) {
  const std::int32_t node = data.nodes.find(f.integer(name));
  if (node < 0) f.fail(name, fmt::format("node {} is not there", f.integer(name)));
  return node;
}

/// Diagonal of the box of all nodes of solids.
double size_of_mesh(const RadiossData& data) {
  constexpr double far = std::numeric_limits<double>::max();
  Point low{far, far, far}, high{-far, -far, -far};
  for (std::size_t n = 0; n < data.used.size(); ++n) {
    for (std::size_t k = 0; k < 3 && data.used[n]; ++k) {
      low[k] = std::min(low[k], data.mesh.mesh.nodes[n][k]);
      high[k] = std::max(high[k], data.mesh.mesh.nodes[n][k]);
    }
  }
  return norm(minus(high, low));
}

/// No principal inertia is below this: of three with the product d and the sum t, the least is above d / (t/2)^2.
double least_inertia(const std::array<Point, 3>& about) {
  const double trace = about[0][0] + about[1][1] + about[2][2];
  return 4 * dot(about[0], cross(about[1], about[2])) / (trace * trace);
}

/// Part by which a spring changes how a body turns until the end of the run, at most: K T^2 / I.
double change_by_spring(const RadiossData& data, const RadiossRigidBody& rigid, double stiffness) {
  if ((rigid.held >> 3U) == 7U) return 0;  // it does not turn
  const RadiossInertia inertia = rigid.inertia ? *rigid.inertia : radioss_inertia(data, nodes_of(data, rigid));
  const double end = data.run_end(), least = least_inertia(inertia.about);
  return least > 0 ? stiffness * end * end / least : 2 * next_to_nothing;
}

void require_weak(RadiossData& data, const RadiossJoint& joint, const RadiossRigidBody& a, const RadiossRigidBody& b) {
  for (const double stiffness : joint.stiffness) {
    const double change = std::max(change_by_spring(data, a, stiffness), change_by_spring(data, b, stiffness));
    if (change < next_to_nothing) {
      data.report.unused(joint.property.place, joint.property.keyword + ": Kri",
                         fmt::format("it would change how the bodies turn by less than {:.2g} %", 100 * change));
    } else {
      data.report.reject(joint.property.place, joint.property.keyword + " with a stiffness that counts (Kri)",
                         "joints have no resistance in what they leave free: leave it 0");
    }
  }
}

}  // namespace

bool is_property_of_springs(const RadiossData& data, std::int64_t id) {
  return std::ranges::any_of(data.blocks_of("SPRING"), [&](const RadiossBlock* spring) {
    const auto part = data.parts.all().find(spring->id());
    return part != data.parts.all().end() && part->second.property == id;
  });
}

std::vector<RadiossJoint> find_radioss_joints(RadiossData& data) {
  std::vector<RadiossJoint> joints;
  GivenOnce given;
  for (const RadiossBlock* block : data.blocks_of("SPRING")) {
    const RadiossBlock* property = property_of(data, *block);
    const std::optional<RadiossJoint> kind = property == nullptr ? std::nullopt : read_property(data, *property);
    if (property == nullptr) data.report.reject(block->place, "/SPRING", "springs and dampers: give /PROP/KJOINT2");
    if (!kind) {
      if (block->log != nullptr) block->log->done(block);
      continue;
    }
    RadiossLines lines(*block);
    while (const auto line = lines.next_filled()) {
      const RadiossFields f(*line, *block, radioss::spring);
      RadiossJoint joint = *kind;
      joint.card = card_of(*block, line->place);
      joint.number = f.integer("sprg_ID");
      given.add(fmt::format("spring {}", joint.number), line->place);
      joint.nodes = {node_of(data, f, "node_ID1"), node_of(data, f, "node_ID2")};
      joints.push_back(std::move(joint));
    }
  }
  return joints;
}

void translate_radioss_joints(RadiossData& data, const std::vector<RadiossJoint>& joints, DeckScene& scene) {
  for (const RadiossJoint& joint : joints) {
    const std::array<std::int32_t, 2> rigid{data.rigid_of_node[joint.nodes[0]], data.rigid_of_node[joint.nodes[1]]};
    if (rigid[0] < 0 || rigid[1] < 0 || rigid[0] == rigid[1]) {
      data.report.reject(joint.card.place, "/SPRING that does not join two /RBODY", "give each body one of its nodes");
      continue;
    }
    const RadiossRigidBody &a = data.rigid[rigid[0]], &b = data.rigid[rigid[1]];
    require_weak(data, joint, a, b);
    const auto keys = scene.entry<Joint>("joint", joint.card);
    keys.set("name", fmt::format("spring_{}", joint.number), "sprg_ID");
    keys.set("kind", joint.is_fixed ? "locking" : "spherical", "Type");
    keys.set("bodies", std::vector<std::string>{a.name, b.name}, "node_ID1, node_ID2");
    const Point &p = data.mesh.mesh.nodes[joint.nodes[0]], &q = data.mesh.mesh.nodes[joint.nodes[1]];
    if (!joint.is_fixed && norm(minus(p, q)) > 1e-5 * size_of_mesh(data))
      data.report.reject(joint.card.place, "/SPRING of a spherical joint whose nodes lie apart",
                         "give both bodies a node in one place");
    keys.set("point", p, "node_ID1");
  }
}

}  // namespace pinball
